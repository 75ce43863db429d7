"""What several commands are told: the dome's settings, the program, a size."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import click

from domeshim.cli.meanings import MEANINGS
from domeshim.errors import OptionError
from domeshim.options import Options
from domeshim.settings import ACCEPTED, LARGEST_SIDE, parse_size

Job = Callable[[], None]
"""What a command found to be done. Run outside of click, which has its own ideas of how a program may end."""
Command = Callable[..., Job | int | None]
"""A command gives its job, or its exit status where it is done already."""

FIELDS = (
    *("config", "preset", "fov", "tilt", "heading", "roll", "seat", "projector", "radius", "lens"),
    *("method", "tolerance", "hud", "panel", "fill", "stereo", "eyes"),
    *("surface", "disc", "mirror", "fade", "brightness", "gamma", "max_turn"),
    *("frame", "display", "vsync", "record", "preview", "debug"),
)
"""The fields of Options that domeshim run can be told."""
FIELDS_OFF_SCREEN = tuple(
    field for field in FIELDS if field not in ("frame", "display", "vsync", "record", "preview", "debug")
)
"""Those that mean something where no window is shown, and colours are the program's."""
FINISHES = ("stereo", "eyes", "surface", "disc", "mirror", "fade", "brightness", "gamma")
"""Those that make another picture of the dome's: for two eyes, another surface, another projector."""
AS_TYPED = {"allow_interspersed_args": False}
"""Context settings of a command that runs a program: what follows the program's name is the program's."""


def dome_options(fields: tuple[str, ...]) -> Callable[[Command], Command]:
    """The options that go by the name of a DOME_* variable, and win over it."""

    def add(command: Command) -> Command:
        for field in reversed(fields):
            name = f"--{field.replace('_', '-')}"
            said = f"{MEANINGS[field]}: {ACCEPTED[field]}."
            command = click.option(name, field, metavar="VALUE", help=said)(command)
        return command

    return add


def program(command: Command) -> Command:
    """The arguments that name a program to run: prog, args and module."""
    for argument in (
        click.argument("args", nargs=-1, type=click.UNPROCESSED),
        click.argument("prog"),
        as_module,
    ):
        command = argument(command)
    return command


def options_given(enabled: bool, given: Mapping[str, str | None]) -> Options:
    """The Options by the environment and by a command's own options, which win.

    Raises OptionError.
    """
    texts = {field: text for field, text in given.items() if text is not None}
    return Options.from_environment(given={**texts, "enabled": str(int(enabled))})


def in_own_colours(options: Options, command: str) -> Options:
    """The options, which a command takes that looks at the program's own colours.

    Raises OptionError where DOME_DEBUG shows others.
    """
    if options.debug != "off":
        raise OptionError(
            f"DOME_DEBUG={options.debug}: domeshim {command} is for a program's own colours; accepted: off"
        )
    return options


def timeout(default: float = 60.0) -> Callable[[Command], Command]:
    """The option --timeout."""
    said = "Give up after so many real seconds without a picture."
    return click.option("--timeout", **positive(default), help=said)


as_json = click.option("--json", "as_json", is_flag=True, help="Print JSON instead of text.")
as_module = click.option("-m", "module", is_flag=True, help="PROG is a module's name, as for python -m.")


def parse_window_size(option: str, text: str) -> tuple[int, int]:
    """Width and height in pixels from S or WxH.

    Raises OptionError, in the name of the option.
    """
    try:
        return parse_size(f"{text}x{text}" if text.strip().isdecimal() else text.lower())
    except ValueError as error:
        accepted = f"S or WxH in pixels, each 1 to {LARGEST_SIDE}"
        raise OptionError(f"{option}={text}: {error}; accepted: {accepted}") from None


def size(_context: click.Context, parameter: click.Parameter, text: str) -> tuple[int, int]:
    """The callback of an option that takes a window's size."""
    return parse_window_size(parameter.opts[0], text)


def positive(default: float) -> dict[str, Any]:
    """The arguments of an option that takes a number over 0, and shows its default."""
    return {"type": click.FloatRange(min=0, min_open=True), "default": default, "show_default": True}
