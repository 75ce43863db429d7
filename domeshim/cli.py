"""The domeshim command."""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import click

from domeshim import __version__, startup
from domeshim.errors import DomeError, OptionError
from domeshim.options import ACCEPTED, LARGEST_SIDE, Options, parse_size
from domeshim.program import run_program
from domeshim.session import Session

Job = Callable[[], None]
"""What a command found to be done. Run outside of click, which has its own ideas of how a program may end."""

_FIELDS = ("fov", "tilt", "lens", "method", "tolerance", "hud", "panel", "fill", "frame", "display")
_FIELDS_OF_CAPTURE = tuple(field for field in _FIELDS if field not in ("frame", "display"))


def main() -> None:
    """Run the domeshim command with the process's arguments, and end the process with its exit status."""
    try:
        job = commands.main(args=sys.argv[1:] or ["--help"], prog_name="domeshim", standalone_mode=False)
        if callable(job):
            job()
        elif job:
            sys.exit(job)
    except click.ClickException as error:
        startup.say(error.format_message())
        sys.exit(error.exit_code)
    except DomeError as error:
        startup.say(str(error))
        sys.exit(error.exit_status)


def _dome_options(fields: tuple[str, ...]) -> Callable[[Callable[..., Job]], Callable[..., Job]]:
    """The options that go by the name of a DOME_* variable, and win over it."""

    def add(command: Callable[..., Job]) -> Callable[..., Job]:
        for field in reversed(fields):
            command = click.option(f"--{field}", metavar="VALUE", help=f"{ACCEPTED[field]}.")(command)
        return command

    return add


def _options(enabled: bool, given: dict[str, str | None]) -> Options:
    texts = {field: text for field, text in given.items() if text is not None}
    return Options.from_environment(given={**texts, "enabled": str(int(enabled))})


def _size(_context: click.Context, _parameter: click.Parameter, text: str) -> tuple[int, int]:
    try:
        return parse_size(f"{text}x{text}" if text.strip().isdecimal() else text.lower())
    except ValueError as error:
        accepted = f"S or WxH in pixels, each 1 to {LARGEST_SIDE}"
        raise OptionError(f"--size={text}: {error}; accepted: {accepted}") from None


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, message="%(prog)s %(version)s")
def commands() -> None:
    """Existing PyOpenGL programs on a planetarium dome, without a changed line.

    Each command also hears the DOME_* variables.
    """


_AS_TYPED = {"allow_interspersed_args": False}  # what stands after the program's name is the program's


@commands.command(context_settings=_AS_TYPED)
@_dome_options(_FIELDS)
@click.option("-m", "module", is_flag=True, help="PROG is a module's name, as for python -m.")
@click.argument("prog")
@click.argument("args", nargs=-1, type=click.UNPROCESSED)
def run(prog: str, args: tuple[str, ...], module: bool, **given: str | None) -> Job:
    """Run a program on the dome."""
    session = Session(_options(True, given))

    def job() -> None:
        startup.run_under(session)
        run_program(prog, args, module=module)

    return job


@commands.command(context_settings=_AS_TYPED)
@click.option("--mode", type=click.Choice(["dome", "monitor"]), default="dome", show_default=True)
@click.option("--frame", type=click.IntRange(min=1), default=1, show_default=True, help="1 is the first.")
@click.option("--size", default="1024", show_default=True, callback=_size, help="S or WxH in pixels.")
@click.option("--output", required=True, type=click.Path(path_type=Path, dir_okay=False), help="A PNG file.")
@click.option("--fps", type=click.FloatRange(min=0, min_open=True), default=60.0, show_default=True)
@click.option(
    "--timeout",
    type=click.FloatRange(min=0, min_open=True),
    default=60.0,
    show_default=True,
    help="Give up after so many real seconds without a picture.",
)
@_dome_options(_FIELDS_OF_CAPTURE)
@click.option("-m", "module", is_flag=True, help="PROG is a module's name, as for python -m.")
@click.argument("prog")
@click.argument("args", nargs=-1, type=click.UNPROCESSED)
def capture(prog: str, args: tuple[str, ...], module: bool, mode: str, **given: Any) -> Job:
    """Write one picture of a program, without a display, on a clock that counts frames."""
    from domeshim.measure.capture import Shot, take  # noqa: PLC0415 - run has no use for it

    shot = Shot(*(given.pop(name) for name in ("frame", "size", "output", "fps", "timeout")))
    options = _options(mode == "dome", given)
    return partial(take, shot, options, partial(run_program, prog, args, module=module))
