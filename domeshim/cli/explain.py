"""domeshim explain: what a program's draws need on the dome, and what was left out."""

from __future__ import annotations

import json
from dataclasses import asdict
from typing import Any

import click

from domeshim.cli.settings import (
    AS_TYPED,
    FIELDS_OFF_SCREEN,
    as_json,
    dome_options,
    in_own_colours,
    options_given,
    positive,
    program,
    size,
    timeout,
)


@click.command(context_settings=AS_TYPED)
@click.option("--frame", type=click.IntRange(min=1), default=1, show_default=True, help="1 is the first.")
@click.option("--size", default="512", show_default=True, callback=size, help="S or WxH in pixels.")
@as_json
@click.option("--fps", **positive(60.0))
@timeout()
@dome_options(FIELDS_OFF_SCREEN)
@program
def explain(
    prog: str,
    args: tuple[str, ...],
    module: bool,
    frame: int,
    size: tuple[int, int],
    as_json: bool,
    fps: float,
    timeout: float,
    **given: str | None,
) -> None:
    """Tell what a program's draws need on the dome: lights, textures, subdivision, and what is left out."""
    from domeshim.diagnosis.report import explained  # noqa: PLC0415 - numpy and more, for this command alone
    from domeshim.diagnosis.watching import watched  # noqa: PLC0415
    from domeshim.measure.apart import Program  # noqa: PLC0415

    in_own_colours(options_given(True, given), "explain")  # a malformed one is told before anything runs
    settings: dict[str, Any] = {field: text for field, text in given.items() if text is not None}
    seen = watched(Program(prog, args, module, fps, timeout), frame, size, settings)
    click.echo(json.dumps(asdict(seen), indent=2) if as_json else explained(prog, seen))
