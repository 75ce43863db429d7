"""The user's settings become one frozen Options. The only reader of os.environ.

A setting is looked for in a command's own options, then in the DOME* variables, then in the file DOME_CONFIG,
then in what DOME_PRESET stands for.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from domeshim.errors import OptionError
from domeshim.lens import catalogue, surfaces
from domeshim.lens.catalogue import LensName
from domeshim.lens.surfaces import DOME, SurfaceName

Place = tuple[float, float, float]

Stereo = Literal["off", "left", "right", "top-bottom", "left-right", "quad"]
STEREO: tuple[Stereo, ...] = ("off", "left", "right", "top-bottom", "left-right", "quad")


@dataclass(frozen=True)
class Options:
    """What the user set, checked. Angles in degrees, sizes in pixels."""

    enabled: bool = False
    fov: float = 180.0
    tilt: float = 0.0
    heading: float = 0.0
    roll: float = 0.0
    seat: Place | None = None
    """Where the viewer is, from the dome's centre: to the disc's right, to its top, to the dome's pole."""
    projector: Place | None = None
    radius: float = 1.0
    """The dome's, in the unit of seat and projector."""
    lens: LensName = ("equidistant", ())
    method: str = "auto"
    tolerance: float = 0.5
    surface: SurfaceName = DOME
    hud: str = "panel"
    panel: float = 60.0
    fill: float | None = None
    stereo: Stereo = "off"
    eyes: float = 0.065
    frame: tuple[int, int] | None = None
    disc: tuple[float, float, float] | None = None
    """The disc's centre, from the frame's top left, and its radius."""
    mirror: str = "off"
    fade: float = 0.0
    """Over so many degrees the picture fades to black at the rim."""
    brightness: float = 1.0
    gamma: float = 1.0
    max_turn: float | None = None
    """The fastest that the view may turn on the dome, degrees a second; None: as fast as it does."""
    vsync: bool | None = None
    """None: as the program and the driver have it."""
    display: int | None = None
    keep_going: bool = False

    @property
    def flat_hud(self) -> bool:
        """The HUD is drawn undistorted, over the disc or beside it."""
        return self.hud in ("flat", "side")

    @property
    def cubemap(self) -> bool:
        """The method is cubemap."""
        return self.method.startswith("cubemap")

    @property
    def face_size(self) -> int | None:
        """Pixels across a face of the cube where the user says so."""
        size = self.method.partition(":")[2]
        return int(size) if size else None

    @classmethod
    def from_environment(
        cls, environ: Mapping[str, str] | None = None, given: Mapping[str, str] | None = None
    ) -> Options:
        """Read the DOME* variables; given holds a command's own options by field name, and wins over them.

        Raises OptionError for the first malformed one.
        """
        environ = os.environ if environ is None else environ
        _reject_misspelt(environ)
        said = _said_in(environ, given or {})
        values = {field: _SETTINGS[field].read(text) for field, text in said.items() if field in _FIELDS}
        options = cls(**values)  # type: ignore[arg-type] # each setting's parser gives its field's type
        _check_lens(options, said.get("lens"))
        _check_places(options, said)
        _check_stereo(options, said)
        _check_surface(options, said)
        return options


@dataclass(frozen=True)
class _Said:
    """A setting as the user gave it: the name that the user knows it by, and the text."""

    name: str
    text: str
    folder: Path = Path()
    """Where files are looked for that it names."""


def _said_in(environ: Mapping[str, str], given: Mapping[str, str]) -> dict[str, _Said]:
    """What was said of each setting, the strongest word only."""
    said = {
        field: _Said(variable, environ[variable])
        for field, variable in VARIABLES.items()
        if environ.get(variable, "").strip()
    }
    said |= {
        field: _Said(f"--{field.replace('_', '-')}", text) for field, text in given.items() if text.strip()
    }
    if "config" in said:
        said = _in_file(said["config"]) | said
    if "preset" in said:
        preset = str(_SETTINGS["preset"].read(said["preset"]))
        said = {field: _Said(f"the preset's {field}", text) for field, text in PRESETS[preset].items()} | said
    return said


def _in_file(config: _Said) -> dict[str, _Said]:
    from domeshim.config import read_config  # noqa: PLC0415 - only where there is one

    path = config.folder / config.text.strip()
    names = {variable: field for field, variable in VARIABLES.items() if field not in ("enabled", "config")}
    found = read_config(path, config.name, names)
    return {field: _Said(name, text, path.parent) for field, (name, text) in found.items() if text.strip()}


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
class _Setting:
    """One setting: what is accepted, in words, and the parser that gives its value or raises ValueError."""

    accepted: str
    parse: Callable[[str], object]
    parse_file: Callable[[str, Path], object] | None = None
    """For a text that may name a file: the parser for it as it was typed, and the folder of such a file."""

    def read(self, said: _Said) -> object:
        """The value; None for an empty text."""
        wanted = said.text.strip()
        try:
            if self.parse_file is not None and wanted:
                return self.parse_file(wanted, said.folder)
            return self.parse(wanted.lower()) if wanted else None
        except ValueError as error:
            raise _malformed(said.name, said.text, str(error), self.accepted) from None


def _malformed(name: str, text: str, reason: str, accepted: str) -> OptionError:
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
        raise ValueError(f"{len(numbers)} numbers")
    return numbers[0], numbers[1], numbers[2]


def _disc(text: str) -> Place:
    x, y, radius = _place(text)
    if radius <= 0:
        raise ValueError("a radius over 0 is needed")
    return x, y, radius


PRESETS = {"domemaster": {"fov": "180", "tilt": "90", "lens": "equidistant"}}
"""What each DOME_PRESET stands for. A dome master looks straight up, and its front is at the bottom edge."""

_half_turn = _number(lambda degrees: -180 <= degrees <= 180)
_PLACE = "right,top,pole from the dome's centre, within DOME_RADIUS"
_SETTINGS = {
    "enabled": _Setting("0 or 1", _flag),
    "fov": _Setting("degrees over 0 to 360", _number(lambda degrees: 0 < degrees <= 360)),
    "tilt": _Setting("degrees from -180 to 180", _half_turn),
    "heading": _Setting("degrees from -180 to 180", _half_turn),
    "roll": _Setting("degrees from -180 to 180", _half_turn),
    "seat": _Setting(_PLACE, _place),
    "projector": _Setting(_PLACE, _place),
    "radius": _Setting("a length over 0", _number(lambda length: length > 0)),
    "preset": _Setting(", ".join(PRESETS), _choice(PRESETS)),
    "config": _Setting("a dome.toml", str),
    "lens": _Setting(catalogue.ACCEPTED, str, catalogue.lens_named),
    "method": _Setting(
        "auto, paper, vertex, tessellate, geometry, cpu, cubemap, cubemap:SIZE (pixels from 16 to 16384)",
        _method,
    ),
    "tolerance": _Setting("pixels, at least 0.01", _number(lambda pixels: pixels >= 0.01)),
    "hud": _Setting("panel, flat, side, off", _choice(("panel", "flat", "side", "off"))),
    "panel": _Setting("degrees over 0 and under 180", _number(lambda degrees: 0 < degrees < 180)),
    "fill": _Setting("off, or degrees over 0 and under 180", _fill),
    "stereo": _Setting(", ".join(STEREO), _choice(STEREO)),
    "eyes": _Setting("a length of at least 0", _number(lambda length: length >= 0)),
    "surface": _Setting(surfaces.ACCEPTED, str, surfaces.surface_named),
    "disc": _Setting("x,y,radius in pixels of the frame, from its top left", _disc),
    "mirror": _Setting("off, horizontal, vertical, both", _choice(("off", "horizontal", "vertical", "both"))),
    "fade": _Setting("degrees from 0 to 90", _number(lambda degrees: 0 <= degrees <= 90)),
    "brightness": _Setting("over 0 to 10", _number(lambda factor: 0 < factor <= 10)),
    "gamma": _Setting("0.1 to 10", _number(lambda power: 0.1 <= power <= 10)),
    "max_turn": _Setting("off, or degrees a second, over 0", _max_turn),
    "vsync": _Setting("0 or 1", _flag),
    "frame": _Setting(f"WxH in pixels, each 1 to {LARGEST_SIDE}", parse_size),
    "display": _Setting("a display's number, 0 the first", _display),
    "keep_going": _Setting("0 or 1", _flag),
}

VARIABLES = {field: "DOME" if field == "enabled" else f"DOME_{field.upper()}" for field in _SETTINGS}
"""The variable of each setting."""

_FIELDS = {field for field in _SETTINGS if field not in ("preset", "config")}
"""The settings that are fields of Options; the others stand for some of them."""

ACCEPTED = {field: setting.accepted for field, setting in _SETTINGS.items()}
"""What each setting accepts, in words."""


def settings_in_environment() -> dict[str, str]:
    """The user's DOME_* variables as texts, by the field of Options; for a process elsewhere."""
    found = {field: os.environ.get(variable, "") for field, variable in VARIABLES.items()}
    return {field: text for field, text in found.items() if text.strip() and field != "enabled"}


def _reject_misspelt(environ: Mapping[str, str]) -> None:
    """Raise OptionError for a DOME_* variable that is nearly, but not quite, one of ours."""
    known = set(VARIABLES.values())
    strangers = sorted(name for name in environ if name.startswith("DOME_") and name not in known)
    if not strangers:
        return
    from difflib import get_close_matches  # noqa: PLC0415 - hardly ever needed

    for name in strangers:
        # 0.86 tells DOME_FVO from DOME_FOV, and leaves alone what other software may call DOME_NAME.
        for meant in get_close_matches(name, known, n=1, cutoff=0.86):
            raise OptionError(f"{name}: no such variable; probably meant: {meant}")


def _check_lens(options: Options, said: _Said | None) -> None:
    """Raise OptionError where there is no such lens of that field of view."""
    if options.lens == ("equidistant", ()):
        return
    from domeshim.lens.models import LensError, lens_of  # noqa: PLC0415 - numpy, which most starts do without

    try:
        lens_of(*options.lens, options.fov)
    except LensError as error:
        assert said is not None
        raise _malformed(said.name, said.text, str(error), catalogue.ACCEPTED) from None


def _check_stereo(options: Options, said: Mapping[str, _Said]) -> None:
    """Raise OptionError for two eyes on the faces of a cube, which are seen from one place each."""
    if options.cubemap and options.stereo != "off":
        method = said["method"]
        accepted = f"with {said['stereo'].name}={options.stereo} any other method"
        raise _malformed(method.name, method.text, "its faces are seen by one eye", accepted)


def _check_surface(options: Options, said: Mapping[str, _Said]) -> None:
    """Raise OptionError for what a surface or a finish cannot be had with."""
    shared = options.stereo in ("top-bottom", "left-right")
    if options.cubemap and options.surface[0] == "keystone":
        reason = "method cubemap knows no keystone; take another method, or a warp mesh"
    elif shared and options.surface[0] == "mesh":
        reason = f"one mesh for two discs, where DOME_STEREO is {options.stereo}; take left or right"
    else:
        if shared and options.fade:
            fade = said["fade"]
            raise _malformed(fade.name, fade.text, f"DOME_STEREO is {options.stereo}", "0 with two discs")
        return
    raise _malformed(said["surface"].name, said["surface"].text, reason, surfaces.ACCEPTED)


def _check_places(options: Options, said: Mapping[str, _Said]) -> None:
    """Raise OptionError for a seat or a projector that is not within the dome."""
    for field, place in (("seat", options.seat), ("projector", options.projector)):
        if place is not None and math.hypot(*place) > NEAREST_TO_DOME * options.radius:
            reason = (
                f"{math.hypot(*place):.4g} from the dome's centre, where DOME_RADIUS is {options.radius:g}"
            )
            raise _malformed(said[field].name, said[field].text, reason, _SETTINGS[field].accepted)


NEAREST_TO_DOME = 0.95
"""A seat or projector may be off the dome's centre by so much of its radius."""
