"""What a typeface is made of: bitmaps, or strokes, one glyph a character code."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class BitmapGlyph:
    """A character as glBitmap takes it: rows from the bottom up, in whole bytes, the leftmost pixel first."""

    width: int
    rows: bytes

    @cached_property
    def pixels(self) -> ctypes.Array[ctypes.c_ubyte]:
        """The rows in the form that PyOpenGL hands on fastest."""
        return (ctypes.c_ubyte * len(self.rows)).from_buffer_copy(self.rows)


@dataclass(frozen=True, eq=False)
class BitmapFace:
    """256 bitmaps of one height, in pixels; origin is the baseline's start, from each bitmap's lower left."""

    height: int
    origin: tuple[float, float]
    glyphs: tuple[BitmapGlyph, ...]


@dataclass(frozen=True, eq=False)
class StrokeGlyph:
    """A character in lines: how far it moves on; strips, float32 (n, 2) each, the baseline on y = 0."""

    advance: float
    strips: tuple[NDArray[np.float32], ...]


_NO_STROKES = StrokeGlyph(0.0, ())


@dataclass(frozen=True, eq=False)
class StrokeFace:
    """128 characters in lines, some of them missing, and the height of a line of text."""

    height: float
    glyphs: tuple[StrokeGlyph | None, ...]

    def glyph(self, code: int) -> StrokeGlyph:
        """A character by its code; one that the face has not is empty and moves on by nothing."""
        found = self.glyphs[code] if 0 <= code < len(self.glyphs) else None
        return _NO_STROKES if found is None else found


@dataclass(frozen=True, eq=False)
class Typefaces:
    """All of GLUT's faces by their fonts' names, and where they come from."""

    source: str
    bitmaps: Mapping[str, BitmapFace]
    strokes: Mapping[str, StrokeFace]
