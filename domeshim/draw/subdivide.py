"""A run with long edges is drawn as patches, which the GPU subdivides until each bends as it should."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import AbstractContextManager
from typing import TYPE_CHECKING, Protocol

import numpy as np

from domeshim.draw.extent import Extent
from domeshim.draw.patches import Indices, Kind, corners, kind_of, outlines
from domeshim.record.immediate import Block, Run

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext

_POINTS, _PATCHES = 0x0000, 0x000E
_POLYGON_MODE, _POINT, _LINE, _CULL_FACE = 0x0B40, 0x1B00, 0x1B01, 0x0B44


class Uploader(Protocol):
    """What can put a run's arrays into GL."""

    def uploaded(self, run: Run) -> AbstractContextManager[None]:
        """Within it, GL's arrays are the run's."""


def subdivide(run: Run, context: DomeContext, uploader: Uploader) -> bool:
    """Draw the run in patches if some edge of it is too long for one piece; False where none is."""
    if "edge" in run.attributes:
        return False  # which edges of a polygon show is lost in its triangles
    primitives = list(_primitives(run.blocks, polygon_mode=_FILL))
    edges = [indices for _, indices in primitives if indices.shape[1] > 1]
    if not edges:
        return False
    extents = [Extent.of(run.positions, indices) for indices in edges]
    whole = Extent(extents[0].centre, extents[0].radius, max(extent.longest for extent in extents))
    if not context.must_subdivide(whole):
        return False
    polygon_mode = _shown_polygon_mode(context)
    if polygon_mode is None:
        return False
    if polygon_mode != _FILL:
        primitives = list(_primitives(run.blocks, polygon_mode))
    for kind, indices in _joined(primitives):
        context.dress(None if kind == "points" else kind)
        chosen = indices.ravel()
        expanded = Run(run.positions[chosen], {n: values[chosen] for n, values in run.attributes.items()}, (), ())
        with uploader.uploaded(expanded):
            context.driver.glDrawArrays(_POINTS if kind == "points" else _PATCHES, 0, len(chosen))
    return True


_FILL = 0x1B02


def _shown_polygon_mode(context: DomeContext) -> int | None:
    """GL_FILL, GL_LINE or GL_POINT; None where the two faces differ or one is culled while outlined."""
    front, back = context.driver.integers(_POLYGON_MODE, 2)
    culled = bool(context.driver.glIsEnabled(_CULL_FACE))
    if front == _FILL and back in (_FILL, 0):
        return _FILL
    return None if front != back or culled else front


def _primitives(blocks: tuple[Block, ...], polygon_mode: int) -> Iterator[tuple[Kind, Indices]]:
    """Each block's primitives, polygons as filled, outlined or as points."""
    for block in blocks:
        count = block.end - block.first
        kind = kind_of(block.mode)
        if kind == "triangles" and polygon_mode == _LINE:
            yield "lines", outlines(block.mode, count) + block.first
        elif kind == "triangles" and polygon_mode == _POINT:
            yield "points", np.arange(block.first, block.end)[:, None]
        else:
            yield kind, corners(block.mode, count) + block.first


def _joined(primitives: list[tuple[Kind, Indices]]) -> Iterator[tuple[Kind, Indices]]:
    """Neighbours of one kind together, in the order of drawing."""
    waiting: list[Indices] = []
    for i, (kind, indices) in enumerate(primitives):
        waiting.append(indices)
        if i + 1 == len(primitives) or primitives[i + 1][0] != kind:
            yield kind, np.concatenate(waiting)
            waiting = []
