"""Each setting: what is accepted, in words, and how its text becomes a value. Light: every start reads it."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from domeshim.errors import OptionError
from domeshim.lens import catalogue, surfaces
from domeshim.wording import counted

Place = tuple[float, float, float]

Stereo = Literal["off", "left", "right", "top-bottom", "left-right", "quad"]
STEREO: tuple[Stereo, ...] = ("off", "left", "right", "top-bottom", "left-right", "quad")

DEBUG = ("off", "levels")


@dataclass(frozen=True)
class Said:
    """A setting as the user gave it: the name that the user knows it by, and the text."""

    name: str
    text: str
    folder: Path = Path()
    """Where files are looked for that it names."""


def parse_size(text: str) -> tuple[int, int]:
    """Width and height in pixels from "1024x768".

    Raises ValueError with the reason.
    """
    parts = text.split("x")
    if len(parts) != 2 or not all(part.strip().isdecimal() for part in parts):
        raise ValueError("not a size")
    width, height = (int(part) for part in parts)
    if not (0 < width <= LARGEST_SIDE and 0 < height <= LARGEST_SIDE):
        raise ValueError("out of range")
    return width, height


LARGEST_SIDE = 16384
"""The most pixels a side may have: the largest frame buffer that today's drivers offer."""
_SMALLEST_FACE = 16


@dataclass(frozen=True)
class Setting:
    """One setting: what is accepted, in words, and the parser that gives its value or raises ValueError."""

    accepted: str
    parse: Callable[[str], object]
    parse_file: Callable[[str, Path], object] | None = None
    """For a text that may name a file: the parser for it as it was typed, and the folder of such a file."""

    def read(self, said: Said) -> object:
        """The value; None for an empty text."""
        wanted = said.text.strip()
        try:
            if self.parse_file is not None and wanted:
                return self.parse_file(wanted, said.folder)
            return self.parse(wanted.lower()) if wanted else None
        except ValueError as error:
            raise malformed(said.name, said.text, str(error), self.accepted) from None


def malformed(name: str, text: str, reason: str, accepted: str) -> OptionError:
    """The error for a setting that the user knows by this name, and gave this text."""
    shown = text if text.isprintable() else repr(text)
    return OptionError(f"{name}={shown}: {reason}; accepted: {accepted}")


def _finite(text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        raise ValueError("not a number") from None
    if not math.isfinite(number):
        raise ValueError("not a finite number")
    return number


def _number(fits: Callable[[float], bool]) -> Callable[[str], float]:
    def parse(text: str) -> float:
        number = _finite(text)
        if not fits(number):
            raise ValueError("out of range")
        return number

    return parse


def _display(text: str) -> int:
    if not text.isdecimal():
        raise ValueError("not a display's number")
    return int(text)


def _choice(names: Collection[str]) -> Callable[[str], str]:
    """A parser for one of the names."""

    def parse(text: str) -> str:
        if text in names:
            return text
        raise ValueError("not known")

    return parse


def _method(text: str) -> str:
    name, colon, size = (part.strip() for part in text.partition(":"))
    _choice(("auto", "paper", "vertex", "tessellate", "geometry", "cpu", "cubemap"))(name)
    if colon and name != "cubemap":
        raise ValueError(f"{name} takes no numbers")
    if colon and not (size.isdecimal() and _SMALLEST_FACE <= int(size) <= LARGEST_SIDE):
        raise ValueError("not the size of a cube's face")
    return f"{name}:{int(size)}" if colon else name


def _flag(text: str) -> bool:
    if text not in ("1", "on", "yes", "true", "0", "off", "no", "false"):
        raise ValueError("neither on nor off")
    return text in ("1", "on", "yes", "true")


def _fill(text: str) -> float | None:
    return None if text == "off" else _number(lambda degrees: 0 < degrees < 180)(text)


def _max_turn(text: str) -> float | None:
    return None if text == "off" else _number(lambda speed: speed > 0)(text)


def _place(text: str) -> Place:
    numbers = [_finite(number) for number in text.split(",")]
    if len(numbers) != 3:
        raise ValueError(counted(len(numbers), "number"))
    return numbers[0], numbers[1], numbers[2]


def _disc(text: str) -> Place:
    x, y, radius = _place(text)
    if radius <= 0:
        raise ValueError("a radius over 0 is needed")
    return x, y, radius


def _film(text: str, folder: Path) -> str:
    path = folder / text
    if path.suffix.lower() not in (".mp4", ".mov", ".webm"):
        raise ValueError("not a kind of video known here")
    if not path.absolute().parent.is_dir():
        raise ValueError("no such folder")
    return str(path)


PRESETS = {"domemaster": {"fov": "180", "tilt": "90", "lens": "equidistant"}}
"""What each DOME_PRESET stands for. A dome master looks straight up, and its front is at the bottom edge."""

_half_turn = _number(lambda degrees: -180 <= degrees <= 180)
_PLACE = "right,top,pole from the dome's centre, within DOME_RADIUS"
SETTINGS = {
    "enabled": Setting("0 or 1", _flag),
    "fov": Setting("degrees over 0 to 360", _number(lambda degrees: 0 < degrees <= 360)),
    "tilt": Setting("degrees from -180 to 180", _half_turn),
    "heading": Setting("degrees from -180 to 180", _half_turn),
    "roll": Setting("degrees from -180 to 180", _half_turn),
    "seat": Setting(_PLACE, _place),
    "projector": Setting(_PLACE, _place),
    "radius": Setting("a length over 0", _number(lambda length: length > 0)),
    "preset": Setting(", ".join(PRESETS), _choice(PRESETS)),
    "config": Setting("a dome.toml", str),
    "lens": Setting(catalogue.ACCEPTED, str, catalogue.lens_named),
    "method": Setting(
        "auto, paper, vertex, tessellate, geometry, cpu, cubemap, cubemap:SIZE (pixels from 16 to 16384)",
        _method,
    ),
    "tolerance": Setting("pixels, at least 0.01", _number(lambda pixels: pixels >= 0.01)),
    "hud": Setting("panel, flat, side, off", _choice(("panel", "flat", "side", "off"))),
    "panel": Setting("degrees over 0 and under 180", _number(lambda degrees: 0 < degrees < 180)),
    "fill": Setting("off, or degrees over 0 and under 180", _fill),
    "stereo": Setting(", ".join(STEREO), _choice(STEREO)),
    "eyes": Setting("a length of at least 0", _number(lambda length: length >= 0)),
    "surface": Setting(surfaces.ACCEPTED, str, surfaces.surface_named),
    "disc": Setting("x,y,radius in pixels of the frame, from its top left", _disc),
    "mirror": Setting("off, horizontal, vertical, both", _choice(("off", "horizontal", "vertical", "both"))),
    "fade": Setting("degrees from 0 to 90", _number(lambda degrees: 0 <= degrees <= 90)),
    "brightness": Setting("over 0 to 10", _number(lambda factor: 0 < factor <= 10)),
    "gamma": Setting("0.1 to 10", _number(lambda power: 0.1 <= power <= 10)),
    "max_turn": Setting("off, or degrees a second, over 0", _max_turn),
    "vsync": Setting("0 or 1", _flag),
    "frame": Setting(f"WxH in pixels, each 1 to {LARGEST_SIDE}", parse_size),
    "display": Setting("a display's number, 0 the first", _display),
    "keep_going": Setting("0 or 1", _flag),
    "record": Setting("a file to write, .mp4, .mov or .webm, in a folder that is there", str, _film),
    "preview": Setting("0 or 1", _flag),
    "debug": Setting(", ".join(DEBUG), _choice(DEBUG)),
}

VARIABLES = {field: "DOME" if field == "enabled" else f"DOME_{field.upper()}" for field in SETTINGS}
"""The variable of each setting."""

ACCEPTED = {field: setting.accepted for field, setting in SETTINGS.items()}
"""What each setting accepts, in words."""
