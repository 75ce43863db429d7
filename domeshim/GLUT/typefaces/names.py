"""GLUT's fonts by name, and what a program may pass for one."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

from OpenGL.platform import PLATFORM

from domeshim.GLUT.typefaces.load import glut_library

Kind = Literal["bitmap", "stroke"]


@dataclass(frozen=True)
class Font:
    """One of GLUT's fonts, by its kind and the end of its constant's name."""

    kind: Kind
    name: str

    def __repr__(self) -> str:
        return f"GLUT_{self.kind.upper()}_{self.name}"


# In the order of the numbers that stand for them in GLUT's header on Windows.
FONTS = (
    Font("stroke", "ROMAN"),
    Font("stroke", "MONO_ROMAN"),
    Font("bitmap", "9_BY_15"),
    Font("bitmap", "8_BY_13"),
    Font("bitmap", "TIMES_ROMAN_10"),
    Font("bitmap", "TIMES_ROMAN_24"),
    Font("bitmap", "HELVETICA_10"),
    Font("bitmap", "HELVETICA_12"),
    Font("bitmap", "HELVETICA_18"),
)


def font_of(argument: object, kind: Kind) -> Font | None:
    """The font that a program means: a Font, the installed GLUT's pointer to one, or a number from 0 to 8.

    Where it is none, or one of the other kind, warn and answer None: GLUT goes on without the text.
    """
    found = argument if isinstance(argument, Font) else _font_by_value(getattr(argument, "value", argument))
    if found is not None and found.kind == kind:
        return found
    given = argument if found is None else found
    warnings.warn(f"{given!r} is no {kind} font; nothing is drawn or measured", RuntimeWarning, stacklevel=4)
    return None


def _font_by_value(value: object) -> Font | None:
    if not isinstance(value, int):
        return None
    return FONTS[value] if 0 <= value < len(FONTS) else _pointers().get(value)


@lru_cache(maxsize=1)
def _pointers() -> dict[int, Font]:
    """The fonts by the addresses that OpenGL.GLUT's constants hold."""
    if glut_library() is None:
        return {}
    return {PLATFORM.getGLUTFontPointer(repr(font)).value: font for font in FONTS}
