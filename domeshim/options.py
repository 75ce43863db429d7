"""The user's settings: DOME* variables become one frozen Options. The only reader of os.environ."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass

from domeshim.errors import OptionError

Lens = tuple[str, tuple[float, ...]]
"""A lens model's name and its coefficients: ("equidistant", ()) or ("polynomial", (c1, .., c5))."""


@dataclass(frozen=True)
class Options:
    """What the user set, checked. Angles in degrees, sizes in pixels."""

    enabled: bool = False
    fov: float = 180.0
    tilt: float = 0.0
    lens: Lens = ("equidistant", ())
    method: str = "auto"
    tolerance: float = 0.5
    hud: str = "panel"
    panel: float = 60.0
    fill: float | None = None
    frame: tuple[int, int] | None = None
    display: int | None = None
    keep_going: bool = False

    @classmethod
    def from_environment(
        cls, environ: Mapping[str, str] | None = None, given: Mapping[str, str] | None = None
    ) -> Options:
        """Read the DOME* variables; given holds a command's own options by field name, and wins over them.

        Raises OptionError for the first malformed one.
        """
        environ = os.environ if environ is None else environ
        _reject_misspelt(environ)
        texts = {field: (variable, environ.get(variable, "")) for field, variable in VARIABLES.items()}
        texts |= {field: (f"--{field}", text) for field, text in (given or {}).items()}
        for variable, default in _LATER.items():
            _Setting(default, _choice((default,), later=None)).read(variable, environ.get(variable, ""))
        values = {
            field: _SETTINGS[field].read(name, text) for field, (name, text) in texts.items() if text.strip()
        }
        options = cls(**values)  # type: ignore[arg-type] # each setting's parser gives its field's type
        _check_lens(options, *texts["lens"])
        return options


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


@dataclass(frozen=True)
class _Setting:
    """One setting: what is accepted, in words, and the parser that gives its value or raises ValueError."""

    accepted: str
    parse: Callable[[str], object]

    def read(self, name: str, text: str) -> object:
        """The value of the setting that the user knows by this name; None for an empty text."""
        wanted = text.strip().lower()
        try:
            return self.parse(wanted) if wanted else None
        except ValueError as error:
            raise _malformed(name, text, str(error), self.accepted) from None


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


def _choice(names: Collection[str], later: Collection[str] | None = ()) -> Callable[[str], str]:
    """A parser for one of the names; those in later (None: all others) are to come."""

    def parse(text: str) -> str:
        if text in names:
            return text
        raise ValueError("not available in this version" if later is None or text in later else "not known")

    return parse


def _flag(text: str) -> bool:
    if text not in ("1", "on", "yes", "true", "0", "off", "no", "false"):
        raise ValueError("neither on nor off")
    return text in ("1", "on", "yes", "true")


def _fill(text: str) -> float | None:
    return None if text == "off" else _number(lambda degrees: 0 < degrees < 180)(text)


def _lens(text: str) -> Lens:
    name, colon, numbers = (part.strip() for part in text.partition(":"))
    later = ("equisolid", "stereographic", "orthographic", "opencv")
    _choice(("equidistant", "polynomial"), later)(name)
    coefficients = tuple(_finite(number) for number in numbers.split(",")) if colon else ()
    if name == "equidistant" and colon:
        raise ValueError("equidistant takes no numbers")
    if name == "polynomial" and not 1 <= len(coefficients) <= 5:
        raise ValueError(f"polynomial takes 1 to 5 numbers, not {len(coefficients)}")
    return name, coefficients


_SETTINGS = {
    "enabled": _Setting("0 or 1", _flag),
    "fov": _Setting("degrees over 0 to 360", _number(lambda degrees: 0 < degrees <= 360)),
    "tilt": _Setting("degrees from -180 to 180", _number(lambda degrees: -180 <= degrees <= 180)),
    "lens": _Setting("equidistant, or polynomial:c1,..,c5", _lens),
    "method": _Setting(
        "auto, paper, vertex, tessellate, geometry, cpu",
        _choice(("auto", "paper", "vertex", "tessellate", "geometry", "cpu"), later=("cubemap",)),
    ),
    "tolerance": _Setting("pixels, at least 0.01", _number(lambda pixels: pixels >= 0.01)),
    "hud": _Setting("panel, flat, off", _choice(("panel", "flat", "off"), later=("side",))),
    "panel": _Setting("degrees over 0 and under 180", _number(lambda degrees: 0 < degrees < 180)),
    "fill": _Setting("off, or degrees over 0 and under 180", _fill),
    "frame": _Setting(f"WxH in pixels, each 1 to {LARGEST_SIDE}", parse_size),
    "display": _Setting("a display's number, 0 the first", _display),
    "keep_going": _Setting("0 or 1", _flag),
}

VARIABLES = {field: "DOME" if field == "enabled" else f"DOME_{field.upper()}" for field in _SETTINGS}
"""The variable of each field of Options."""

ACCEPTED = {field: setting.accepted for field, setting in _SETTINGS.items()}
"""What each field of Options accepts, in words."""

_LATER = {
    "DOME_SURFACE": "dome",
    "DOME_STEREO": "off",
    "DOME_EYES": "0.065",
    "DOME_CONFIG": "none",
}
"""Variables of versions to come, with the one value that is true of this version."""


def _reject_misspelt(environ: Mapping[str, str]) -> None:
    """Raise OptionError for a DOME_* variable that is nearly, but not quite, one of ours."""
    known = {*VARIABLES.values(), *_LATER}
    strangers = sorted(name for name in environ if name.startswith("DOME_") and name not in known)
    if not strangers:
        return
    from difflib import get_close_matches  # noqa: PLC0415 - hardly ever needed

    for name in strangers:
        # 0.86 tells DOME_FVO from DOME_FOV, and leaves alone what other software may call DOME_NAME.
        for meant in get_close_matches(name, known, n=1, cutoff=0.86):
            raise OptionError(f"{name}: no such variable; probably meant: {meant}")


def _check_lens(options: Options, name: str, text: str) -> None:
    """Raise OptionError where the lens's radius does not rise all the way to the rim."""
    stop = _stops_rising(options.lens[1], math.radians(options.fov) / 2) if options.lens[1] else None
    if stop is not None:
        reason = f"the radius stops rising {math.degrees(stop):.4g} degrees from the axis"
        half = f"{options.fov / 2:g} degrees, half of DOME_FOV"
        raise _malformed(name, text, reason, f"polynomials that rise from 0 to {half}")


def _stops_rising(coefficients: tuple[float, ...], rim: float) -> float | None:
    """The first angle in 0..rim, radians, where sum c_i phi^i no longer rises; None where it always does."""
    largest = max(map(abs, coefficients))
    if coefficients[0] <= 0:
        return 0.0
    import numpy as np  # noqa: PLC0415 - a lens of this kind is rare, and the start of Python must stay quick

    slope = np.polynomial.Polynomial([i * (c / largest) for i, c in enumerate(coefficients, 1)])
    zeros = slope.roots()
    real = zeros.real[(abs(zeros.imag) < 1e-9) & (zeros.real > 0) & (zeros.real <= rim)]
    return float(real.min()) if real.size else None
