"""A run with long edges is drawn as patches, which the GPU subdivides until each bends as it should."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from itertools import groupby
from operator import itemgetter
from typing import TYPE_CHECKING, Protocol

import numpy as np

from domeshim.draw.extent import Extent
from domeshim.draw.patches import Indices, Kind, corners, kind_of, longest_edge, outlines
from domeshim.draw.split import split_wide
from domeshim.record.immediate import Block, Run, stretches
from domeshim.shading.recipe import Patch

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext
    from domeshim.state.subdivision import Subdivision

_POINTS = 0x0000
_POLYGON_MODE, _POINT, _LINE, _FILL, _CULL_FACE = 0x0B40, 0x1B00, 0x1B01, 0x1B02, 0x0B44


Making = Callable[[Callable[[], object]], object]
"""Makes a draw where it belongs, as often as there are views."""


def at_once(draw: Callable[[], object]) -> object:
    """Make a draw as it is, say into a display list."""
    return draw()


class Drawer(Protocol):
    """What can draw a run's arrays."""

    def draw_all(self, mode: int, run: Run, made: Making) -> None:
        """Draw all of a run's vertices by one mode."""


def subdivision_of(run: Run, context: DomeContext) -> Subdivision:
    """What the run needs to keep the tolerance."""
    extent = extent_of(run) if context.minds_edges else None
    return context.subdivision(extent) if extent is not None else None


def extent_of(run: Run) -> Extent | None:
    """How large the run is; None where it has no edges, or shows only some of them."""
    primitives = [indices for kind, indices in _joined(_primitives(run.blocks, _FILL)) if kind != "points"]
    if not primitives or "edge" in run.attributes:
        return None
    if run.positions.shape[1] == 4:
        return Extent.unknown()
    return Extent.of(run.positions, max(longest_edge(run.positions, indices) for indices in primitives))


def subdivide(run: Run, context: DomeContext, drawer: Drawer, subdivision: Subdivision) -> bool:
    """Draw the run in patches; False where they could not show what the program asked for."""
    polygon_mode = _shown_polygon_mode(context)
    if polygon_mode is None or "edge" in run.attributes:
        return False  # which edges of a polygon show is lost in its triangles
    for kind, whole in pieces(run, polygon_mode):
        if kind == "points":
            drawer.draw_all(_POINTS, whole, context.draw)
            continue
        patch = Patch(kind, split=subdivision == "split")
        piece = _split(whole, patch, context) if patch.split else whole
        drawer.draw_all(patch.mode, piece, partial(context.draw, patch=patch))
    return True


def _split(run: Run, patch: Patch, context: DomeContext) -> Run:
    return split_wide(run, patch.corners, context.to_eye, context.tolerance.widest)


def pieces(run: Run, polygon_mode: int = _FILL) -> Iterator[tuple[Kind, Run]]:
    """The run's points, lines and triangles, as far as they are alike together, in the order of drawing."""
    for kind, indices in _joined(_primitives(run.blocks, polygon_mode)):
        chosen = indices.ravel()
        attributes = {name: values[chosen] for name, values in run.attributes.items()}
        yield kind, Run(run.positions[chosen], attributes, (), constant=run.constant)


def filled(context: DomeContext) -> bool:
    """Polygons are drawn filled now."""
    return _shown_polygon_mode(context) == _FILL


def _shown_polygon_mode(context: DomeContext) -> int | None:
    """GL_FILL, GL_LINE or GL_POINT; None where the two faces differ or one is culled while outlined."""
    front, back = context.driver.integers(_POLYGON_MODE, 2)
    if front == _FILL and back in (_FILL, 0):
        return _FILL
    return None if front != back or context.driver.glIsEnabled(_CULL_FACE) else front


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
