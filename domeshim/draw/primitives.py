"""What a run consists of: its points, lines and triangles, how large it is, and its parts."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby
from operator import itemgetter

import numpy as np

from domeshim.draw.extent import Boxes, Extent
from domeshim.draw.patches import (
    POINTS,
    TRIANGLES,
    Indices,
    Kind,
    corners,
    kind_of,
    longest_edge,
    longest_edges,
    outlines,
    shortest_line,
)
from domeshim.record.runs import Block, Run, stretches

_LINE, _POINT, FILL = 0x1B01, 0x1B00, 0x1B02
_OF_A_PART = 256
"""So many triangles are judged together where the whole mesh will not do in one piece."""


@dataclass(frozen=True)
class Parts:
    """Triangles of a run that follow each other, part by part, and how large each part is."""

    run: Run
    """All of them, each with its own three vertices."""
    boxes: Boxes
    """One a part."""

    def joined(self, first: int, end: int) -> Run:
        """The parts from the first up to, without, the end."""
        chosen = slice(3 * _OF_A_PART * first, 3 * _OF_A_PART * end)
        positions = self.run.positions[chosen]
        attributes = {name: values[chosen] for name, values in self.run.attributes.items()}
        return Run(positions, attributes, (Block(TRIANGLES, 0, len(positions)),), constant=self.run.constant)


def parts_of(run: Run) -> Parts | None:
    """A large run of nothing but triangles in parts, in the order of drawing; of any other run none.

    A long edge costs only where it is: the other parts need no subdivision.
    """
    if "edge" in run.attributes or run.positions.shape[1] == 4:
        return None
    kinds = list(primitives_of(run))
    if len(kinds) != 1 or kinds[0][0] != "triangles" or len(kinds[0][1]) <= 2 * _OF_A_PART:
        return None
    triangles = kinds[0][1]
    starts = np.arange(0, len(triangles), _OF_A_PART)
    points = run.positions[triangles]
    boxes = Boxes(
        np.minimum.reduceat(points.min(1), starts),
        np.maximum.reduceat(points.max(1), starts),
        np.maximum.reduceat(longest_edges(points), starts),
    )
    return Parts(taken(run, triangles), boxes)


def extent_of(run: Run) -> Extent | None:
    """How large the run is; None where it has no edges, or shows only some of them."""
    primitives = [indices for kind, indices in primitives_of(run) if kind != "points"]
    if not primitives or "edge" in run.attributes:
        return None
    if run.positions.shape[1] == 4:
        return Extent.unknown()
    longest = max(longest_edge(run.positions, indices) for indices in primitives)
    shortest = min(shortest_line(run.positions, indices) for indices in primitives)
    return Extent.of(run.positions, longest, shortest)


def taken(run: Run, indices: Indices) -> Run:
    """Some vertices of a run, without its blocks."""
    chosen = indices.ravel()
    attributes = {name: values[chosen] for name, values in run.attributes.items()}
    return Run(run.positions[chosen], attributes, (), constant=run.constant)


def primitives_of(run: Run, polygon_mode: int = FILL) -> Iterator[tuple[Kind, Indices]]:
    """The run's points, lines and triangles, neighbours of one kind together, in the order of drawing."""
    for kind, group in groupby(_stretches(run.blocks, polygon_mode), key=itemgetter(0)):
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
