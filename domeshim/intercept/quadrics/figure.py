"""A quadric as a run: the strips of which GLU draws it, taken from a surface."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from domeshim.record.runs import Block, Run

Numbers = NDArray[np.float64]
Function = Callable[[Numbers, Numbers], Numbers]

POINTS, LINE_STRIP, TRIANGLE_FAN, QUAD_STRIP = 0, 3, 6, 8


@dataclass(frozen=True)
class Surface:
    """A surface over slices u and stacks v, both counted from 0 and not only at whole numbers.

    place, normal: (u, v) -> (..., 3), object space; texture: (u, v) -> (..., 2).
    """

    place: Function
    normal: Function
    texture: Function


@dataclass(frozen=True, eq=False)
class Part:
    """Strips of one mode: k rows of n vertices, and where on the surface each vertex has its normal.

    u, v, normal_u, normal_v: (k, n); a vertex whose normal is at nan has the normal of the one before.
    """

    mode: int
    u: Numbers
    v: Numbers
    normal_u: Numbers
    normal_v: Numbers
    level: bool = False
    """The normals lose their z and stay shorter than 1: GLU's way with the lines along a cylinder."""

    @classmethod
    def of(
        cls,
        mode: int,
        at: tuple[Numbers, Numbers],
        normal: tuple[Numbers, Numbers] | None = None,
        *,
        level: bool = False,
    ) -> Part:
        """The strips at (u, v); normal: where the normals are taken, if elsewhere. All are broadcast."""
        u, v = np.broadcast_arrays(*at)
        normal_u, normal_v = (u, v) if normal is None else (np.broadcast_to(of, u.shape) for of in normal)
        return cls(mode, u, v, normal_u, normal_v, level)


def run_of(surface: Surface, parts: Sequence[Part], *, normals: bool, texture: bool) -> Run:
    """The parts in the order in which they are drawn; it leaves the last normal and texture place current."""
    attributes = {}
    if normals:
        attributes["normal"] = _carried(_all(_normals(surface, part) for part in parts))
    if texture:
        places = _all(surface.texture(part.u, part.v) for part in parts)
        rest = np.broadcast_to(np.array((0, 1), np.float32), places.shape)
        attributes["texture0"] = np.hstack([places, rest])
    return Run(
        _all(surface.place(part.u, part.v) for part in parts),
        attributes,
        tuple(_blocks(parts)),
        tuple((name, tuple(values[-1].tolist())) for name, values in attributes.items()),
    )


def _all(arrays: Iterable[Numbers]) -> NDArray[np.float32]:
    """Arrays (k, n, size) below each other: (all vertices, size)."""
    return np.concatenate([array.reshape(-1, array.shape[-1]) for array in arrays]).astype(np.float32)


def _normals(surface: Surface, part: Part) -> Numbers:
    normals = surface.normal(part.normal_u, part.normal_v)
    return normals * (1.0, 1.0, 0.0) if part.level else normals


def _carried(normals: NDArray[np.float32]) -> NDArray[np.float32]:
    """Each nan row becomes the last row before it that is none; the first rows may stay nan."""
    given = ~np.isnan(normals.sum(1))
    source = np.maximum.accumulate(np.where(given, np.arange(len(normals)), 0))
    carried: NDArray[np.float32] = np.where(given[source, None], normals[source], np.float32(np.nan))
    return carried


def _blocks(parts: Sequence[Part]) -> Iterator[Block]:
    """One a strip; all points of a part together."""
    first = 0
    for part in parts:
        rows, count = (1, part.u.size) if part.mode == POINTS else part.u.shape
        for _ in range(rows):
            yield Block(part.mode, first, first + count)
            first += count
