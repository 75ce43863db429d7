"""What a run consists of: its points, lines and triangles, how large it is, and its parts."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby
from operator import itemgetter

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.extent import Extent, Spheres
from domeshim.draw.patches import (
    POINTS,
    Edged,
    Indices,
    Kind,
    corners,
    kind_of,
    longest_edge,
    outlines,
    shortest_line,
)
from domeshim.record.runs import Block, Run, stretches

_LINE, _POINT, FILL = 0x1B01, 0x1B00, 0x1B02
_MANY = 96
"""Up to so many primitives are subdivided together: to choose among them costs as much."""


@dataclass(frozen=True)
class Primitives:
    """The lines or triangles that make up a run, in the order of drawing, and how large each is."""

    kind: Edged
    indices: Indices
    """(n, 2 or 3), of the run's vertices."""
    corners: NDArray[np.float32]
    """(n, 2 or 3, 3), the positions."""
    spheres: Spheres
    """One a primitive."""


def many_primitives(run: Run) -> Primitives | None:
    """A large run's primitives, where all are lines or all triangles; else None.

    A long edge costs only where it is: the other primitives need no subdivision.
    """
    if "edge" in run.attributes or run.positions.shape[1] == 4:
        return None
    kinds = list(primitives_of(run))
    if len(kinds) != 1 or len(kinds[0][1]) <= _MANY:
        return None
    kind, indices = kinds[0]
    if kind == "points":
        return None
    corners = run.positions[indices]
    return Primitives(kind, indices, corners, Spheres.of(corners))


def extent_of(run: Run) -> Extent | None:
    """How large the run is; None where it has no edges, or shows only some of them."""
    primitives = [indices for kind, indices in primitives_of(run) if kind != "points"]
    if not primitives or "edge" in run.attributes:
        return None
    places = _finite_places(run.positions)
    if places is None:
        return Extent.unknown()
    longest = max(longest_edge(places, indices) for indices in primitives)
    shortest = min(shortest_line(places, indices) for indices in primitives)
    return Extent.of(places, longest, shortest)


def _finite_places(positions: NDArray[np.float32]) -> NDArray[np.float32] | None:
    """(n, 3): where (n, 3 or 4) positions are; None where the fourth coordinate puts one anywhere."""
    if positions.shape[1] == 3:
        return positions
    if not (positions[:, 3] > 0).all():
        return None
    with np.errstate(over="ignore"):
        places: NDArray[np.float32] = positions[:, :3] / positions[:, 3:]
    return places if np.isfinite(places).all() else None


def taken(run: Run, indices: Indices) -> Run:
    """Some vertices of a run, without its blocks."""
    chosen = indices.ravel()
    attributes = {name: values[chosen] for name, values in run.attributes.items()}
    return Run(run.positions[chosen], attributes, (), constant=run.constant)


def primitives_of(run: Run, polygon_mode: int = FILL) -> Iterator[tuple[Kind, Indices]]:
    """The run's points, lines and triangles, neighbours of one kind together, in the order of drawing."""
    yield from primitives_in(run.blocks, polygon_mode)


def primitives_in(blocks: tuple[Block, ...], polygon_mode: int = FILL) -> Iterator[tuple[Kind, Indices]]:
    """The same of the blocks of a run."""
    for kind, group in groupby(_stretches(blocks, polygon_mode), key=itemgetter(0)):
        together = [indices for _, indices in group]
        yield kind, together[0] if len(together) == 1 else np.concatenate(together)


def _stretches(blocks: tuple[Block, ...], polygon_mode: int) -> Iterator[tuple[Kind, Indices]]:
    """Each stretch of primitives, polygons as filled, outlined or as points."""
    for mode, first, count in stretches(blocks):
        kind = kind_of(mode)
        if kind == "triangles" and polygon_mode == _LINE:
            yield "lines", outlines(mode, count) + first
        elif kind == "triangles" and polygon_mode == _POINT:
            yield "points", corners(POINTS, count) + first
        else:
            yield kind, corners(mode, count) + first
