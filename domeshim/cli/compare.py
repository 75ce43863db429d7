"""domeshim compare: a program's dome picture beside its monitor picture."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import click

from domeshim.cli.settings import (
    AS_TYPED,
    FIELDS_OFF_SCREEN,
    FINISHES,
    as_json,
    dome_options,
    in_own_colours,
    options_given,
    parse_window_size,
    positive,
    program,
    timeout,
)
from domeshim.errors import OptionError
from domeshim.extras import require

_FIELDS = tuple(field for field in FIELDS_OFF_SCREEN if field not in FINISHES)


def _frames(_context: click.Context, _parameter: click.Parameter, text: str) -> tuple[int, ...]:
    parts = [part.strip() for part in text.split(",")]
    if not all(part.isdecimal() and int(part) > 0 for part in parts):
        raise OptionError(f"--frames={text}: accepted: numbers from 1 on, as in 1,10,60")
    return tuple(sorted({int(part) for part in parts}))


def _sizes(_context: click.Context, _parameter: click.Parameter, text: str) -> list[tuple[int, int]]:
    return [parse_window_size("--size", part) for part in text.split(",")]


@click.command(context_settings=AS_TYPED)
@click.option("--frames", default="1", show_default=True, callback=_frames, help="Numbers, as in 1,10,60.")
@click.option(
    "--size",
    "sizes",
    default="512",
    show_default=True,
    callback=_sizes,
    help="The monitor window's size, S or WxH in pixels; several as in 512,800x600.",
)
@click.option("--output", type=click.Path(path_type=Path, file_okay=False), help="A folder for the pictures.")
@click.option(
    "--baseline",
    type=click.Path(path_type=Path, file_okay=False),
    help="Hold the dome's pictures against those in this folder as well.",
)
@click.option("--update", is_flag=True, help="Store the dome's pictures in the baseline's folder.")
@as_json
@click.option("--fps", **positive(60.0))
@timeout()
@dome_options(_FIELDS)
@program
def compare(
    prog: str,
    args: tuple[str, ...],
    module: bool,
    frames: tuple[int, ...],
    sizes: list[tuple[int, int]],
    output: Path | None,
    baseline: Path | None,
    update: bool,
    as_json: bool,
    fps: float,
    timeout: float,
    **given: str | None,
) -> int:
    """Compare a program's picture on the dome with its picture on the monitor.

    Both are captured without a display, and the dome's picture is brought back into the program's own
    perspective. Exit status: 0 they are alike, 1 they differ, 2 it could not be told, for the reason given.
    """
    require("scipy", "measure", "domeshim compare")
    from domeshim.measure.apart import Program  # noqa: PLC0415
    from domeshim.measure.baseline import Baseline  # noqa: PLC0415 - once it is known to be installed
    from domeshim.measure.comparison import Comparison  # noqa: PLC0415
    from domeshim.measure.verdicts import Report, judged  # noqa: PLC0415

    if update and baseline is None:
        raise OptionError("--update: stores pictures in the folder of --baseline, which is not given")
    in_own_colours(options_given(True, given), "compare")  # a malformed one is told before anything runs
    settings = {field: text for field, text in given.items() if text is not None}
    stored = Baseline(baseline, update) if baseline is not None else None
    run = Program(prog, args, module, fps, timeout)

    def reports() -> Iterator[Report]:
        for size in sizes:
            for result in Comparison(run, frames, size, settings).results():
                yield judged(result, run, stored, output)

    found = []
    for report in reports():
        found.append(report)
        if not as_json:
            click.echo(report.text())
    if as_json:
        click.echo(json.dumps([report.as_json() for report in found], indent=2))
    return Report.status(found)
