"""domeshim run: a program on the dome, on the screen."""

from __future__ import annotations

import click

from domeshim import startup
from domeshim.cli.settings import AS_TYPED, FIELDS, Job, dome_options, options_given, program
from domeshim.program import run_program
from domeshim.session import Session


@click.command(context_settings=AS_TYPED)
@dome_options(FIELDS)
@program
def run(prog: str, args: tuple[str, ...], module: bool, **given: str | None) -> Job:
    """Run a program on the dome."""
    session = Session(options_given(True, given))

    def job() -> None:
        startup.run_under(session)
        run_program(prog, args, module=module)

    return job
