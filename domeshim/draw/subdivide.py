"""A run with long edges is drawn as patches, which the GPU subdivides until each bends as it should."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import AbstractContextManager
from itertools import groupby
from operator import itemgetter
from typing import TYPE_CHECKING, Protocol

import numpy as np

from domeshim.draw.extent import Extent
from domeshim.draw.patches import Indices, Kind, corners, kind_of, longest_edge, outlines
from domeshim.record.immediate import Block, Run, stretches

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext

_POINTS, _PATCHES = 0x0000, 0x000E
_POLYGON_MODE, _POINT, _LINE, _FILL, _CULL_FACE = 0x0B40, 0x1B00, 0x1B01, 0x1B02, 0x0B44


class Uploader(Protocol):
    """What can put a run's arrays into GL."""

    def uploaded(self, run: Run) -> AbstractContextManager[None]:
        """Within it, GL's arrays are the run's."""


def has_long_edges(run: Run, context: DomeContext) -> bool:
    """Some edge of the run is too long to be drawn in one piece."""
    primitives = [indices for kind, indices in _joined(_primitives(run.blocks, _FILL)) if kind != "points"]
    if not primitives:
        return False
    longest = max(longest_edge(run.positions, indices) for indices in primitives)
    return context.must_subdivide(Extent.of(run.positions, longest))


def subdivide(run: Run, context: DomeContext, uploader: Uploader) -> bool:
    """Draw the run in patches; False where they could not show what the program asked for."""
    polygon_mode = _shown_polygon_mode(context)
    if polygon_mode is None or "edge" in run.attributes:
        return False  # which edges of a polygon show is lost in its triangles
    for kind, indices in _joined(_primitives(run.blocks, polygon_mode)):
        context.dress(None if kind == "points" else kind)
        chosen = indices.ravel()
        expanded = Run(run.positions[chosen], {n: values[chosen] for n, values in run.attributes.items()}, (), ())
        with uploader.uploaded(expanded):
            context.driver.glDrawArrays(_POINTS if kind == "points" else _PATCHES, 0, len(chosen))
    return True


def _shown_polygon_mode(context: DomeContext) -> int | None:
    """GL_FILL, GL_LINE or GL_POINT; None where the two faces differ or one is culled while outlined."""
    front, back = context.driver.integers(_POLYGON_MODE, 2)
    culled = bool(context.driver.glIsEnabled(_CULL_FACE))
    if front == _FILL and back in (_FILL, 0):
        return _FILL
    return None if front != back or culled else front


def _primitives(blocks: tuple[Block, ...], polygon_mode: int) -> Iterator[tuple[Kind, Indices]]:
    """Each stretch of primitives, polygons as filled, outlined or as points."""
    for mode, first, count in stretches(blocks):
        kind = kind_of(mode)
        if kind == "triangles" and polygon_mode == _LINE:
            yield "lines", outlines(mode, count) + first
        elif kind == "triangles" and polygon_mode == _POINT:
            yield "points", corners(_POINTS, count) + first
        else:
            yield kind, corners(mode, count) + first


def _joined(primitives: Iterator[tuple[Kind, Indices]]) -> Iterator[tuple[Kind, Indices]]:
    """Neighbours of one kind together, in the order of drawing."""
    for kind, group in groupby(primitives, key=itemgetter(0)):
        together = [indices for _, indices in group]
        yield kind, together[0] if len(together) == 1 else np.concatenate(together)
