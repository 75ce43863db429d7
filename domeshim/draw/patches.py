"""Primitives become patches: the triangles or lines that GL itself would make of each mode, and their edges.

The last vertex of each is the one that gives a flat-shaded primitive its colour.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Indices = NDArray[np.int64]
Edged = Literal["lines", "triangles"]
Kind = Literal["points"] | Edged

POINTS, LINES, LINE_LOOP, LINE_STRIP, TRIANGLES, TRIANGLE_STRIP, TRIANGLE_FAN, QUADS, QUAD_STRIP, POLYGON = (
    range(10)
)


def kind_of(mode: int) -> Kind:
    """What a mode draws."""
    return "points" if mode == POINTS else "lines" if mode <= LINE_STRIP else "triangles"


@lru_cache(maxsize=256)
def corners(mode: int, count: int) -> Indices:  # noqa: PLR0911 - one return a mode
    """The vertices of each primitive of a mode: (n, 1), (n, 2) or (n, 3) indices into its count vertices."""
    i = np.arange(count)
    match mode:
        case 0:  # points
            return i[:, None]
        case 1:  # lines
            return i[: count - count % 2].reshape(-1, 2)
        case 2:  # line loop
            return np.stack([i, np.roll(i, -1)], -1) if count > 1 else i[:0].reshape(0, 2)
        case 3:  # line strip
            return np.stack([i[:-1], i[1:]], -1)
        case 4:  # triangles
            return i[: count - count % 3].reshape(-1, 3)
        case 5:  # triangle strip: every second one turned round
            strip = np.stack([i[:-2], i[1:-1], i[2:]], -1)
            strip[1::2, :2] = strip[1::2, 1::-1]
            return strip
        case 6:  # triangle fan
            return np.stack([np.zeros_like(i[2:]), i[1:-1], i[2:]], -1)
        case 7:  # quads
            quads = i[: count - count % 4].reshape(-1, 4)
            return np.stack([quads[:, [0, 1, 3]], quads[:, [1, 2, 3]]], 1).reshape(-1, 3)
        case 8:  # quad strip: a, b, d, c with d = the last of each quad
            a = i[: max(count - count % 2 - 2, 0) : 2]
            return np.stack([np.stack([a, a + 1, a + 3], -1), np.stack([a + 2, a, a + 3], -1)], 1).reshape(
                -1, 3
            )
        case _:  # polygon: its first vertex gives the colour
            return np.stack([i[1:-1], i[2:], np.zeros_like(i[2:])], -1)


@lru_cache(maxsize=256)
def outlines(mode: int, count: int) -> Indices:
    """The program's own edges of each polygon of a mode, as GL_LINE draws them: (n, 2) indices."""
    i = np.arange(count)
    match mode:
        case 7:
            quads = i[: count - count % 4].reshape(-1, 4)
            return np.stack([quads, np.roll(quads, -1, 1)], -1).reshape(-1, 2)
        case 8:
            a = i[: max(count - count % 2 - 2, 0) : 2]
            quads = np.stack([a, a + 1, a + 3, a + 2], -1)
            return np.stack([quads, np.roll(quads, -1, 1)], -1).reshape(-1, 2)
        case 9:
            return corners(LINE_LOOP, count)
        case _:
            triangles = corners(mode, count)
            return np.stack([triangles, np.roll(triangles, -1, 1)], -1).reshape(-1, 2)


def longest_edge(positions: NDArray[np.floating], primitives: Indices) -> float:
    """The length of the longest edge. positions: (n, 3 or 4); primitives: (m, 1, 2 or 3) indices."""
    if primitives.shape[1] == 1 or not len(primitives):
        return 0.0
    longest = longest_edges(positions[primitives, :3]).max()
    return float(longest) if np.isfinite(longest) else np.inf


def shortest_line(positions: NDArray[np.floating], primitives: Indices) -> float:
    """The length of the shortest line that has a length; infinite where there is none. As longest_edge."""
    if primitives.shape[1] != 2:
        return np.inf
    lengths = longest_edges(positions[primitives, :3])
    return float(lengths.min(initial=np.inf, where=lengths > 0))


def longest_edges(corners: NDArray[np.floating]) -> NDArray[np.floating]:
    """The length of each primitive's longest edge; nan or inf without a place. corners: (m, 2 or 3, 3)."""
    with np.errstate(invalid="ignore"):
        edges = corners - np.roll(corners, 1, 1)
    longest: NDArray[np.floating] = np.sqrt(np.einsum("pij,pij->pi", edges, edges).max(1))
    return longest
