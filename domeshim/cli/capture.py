"""domeshim capture: one picture of a program."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any

import click

from domeshim.cli.settings import (
    AS_TYPED,
    FIELDS_OFF_SCREEN,
    Job,
    dome_options,
    options_given,
    positive,
    program,
    size,
    timeout,
)
from domeshim.measure.capture import Shot, take
from domeshim.program import run_program


@click.command(context_settings=AS_TYPED)
@click.option("--mode", type=click.Choice(["dome", "monitor"]), default="dome", show_default=True)
@click.option("--frame", type=click.IntRange(min=1), default=1, show_default=True, help="1 is the first.")
@click.option("--size", default="1024", show_default=True, callback=size, help="S or WxH in pixels.")
@click.option("--output", required=True, type=click.Path(path_type=Path, dir_okay=False), help="A PNG file.")
@click.option("--fps", **positive(60.0))
@timeout()
@dome_options((*FIELDS_OFF_SCREEN, "debug"))
@program
def capture(prog: str, args: tuple[str, ...], module: bool, mode: str, **given: Any) -> Job:
    """Write one picture of a program, without a display, on a clock that counts frames."""
    shot = Shot(*(given.pop(name) for name in ("frame", "size", "output", "fps", "timeout")))
    options = options_given(mode == "dome", given)
    return partial(take, shot, options, partial(run_program, prog, args, module=module))
