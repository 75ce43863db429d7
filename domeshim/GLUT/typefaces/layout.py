"""Stroke text as one set of lines, so that it takes one draw however long it is."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from domeshim.GLUT.shapes.mesh import Floats, Indices, Strips
from domeshim.GLUT.typefaces.faces import StrokeFace


@dataclass(frozen=True, eq=False)
class Lettering:
    """Text laid out: vertices (n, 2), lines (m, 2), the strips they are cut from, the next letter's place."""

    vertices: Floats
    lines: Indices
    strips: tuple[Strips, ...]
    end: tuple[float, float]


@lru_cache(maxsize=512)
def lettering(face: StrokeFace, lines: tuple[bytes, ...]) -> Lettering:
    """Lay lines of text out, the first on y = 0 and each next one below; leave out what the face has not."""
    x = y = 0.0
    strips: list[NDArray[np.float32]] = []
    for number, line in enumerate(lines):
        x, y = 0.0, -number * face.height
        for glyph in map(face.glyph, line):
            strips += [strip + np.array([x, y], np.float32) for strip in glyph.strips]
            x += glyph.advance
    return _joined(strips, (x, y))


def _joined(strips: list[NDArray[np.float32]], end: tuple[float, float]) -> Lettering:
    firsts = np.cumsum([0, *map(len, strips)], dtype=np.uint32)
    rows = [np.arange(a, b, dtype=np.uint32)[None] for a, b in pairwise(firsts)]
    parts = tuple(Strips(row, closed=False) for row in rows)
    lines = np.concatenate([np.zeros((0, 2), np.uint32), *(part.lines for part in parts)])
    return Lettering(np.concatenate([np.zeros((0, 2), np.float32), *strips]), lines, parts, end)
