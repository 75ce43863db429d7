"""A run with long edges is drawn in pieces: as patches, which the GPU subdivides, or cut on the CPU."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from itertools import groupby
from operator import itemgetter
from typing import TYPE_CHECKING, Protocol

import numpy as np

from domeshim.draw.extent import Extent
from domeshim.draw.patches import Edged, Indices, Kind, corners, kind_of, longest_edge, outlines
from domeshim.draw.split import split_wide, triangles_under
from domeshim.draw.strips import line_strips
from domeshim.record.immediate import Block, Run, stretches
from domeshim.shading.recipe import Patch

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext
    from domeshim.state.subdivision import Subdivision

_POINTS, _TRIANGLES = 0x0000, 0x0004
_LINE_STIPPLE, _SHADE_MODEL, _FLAT = 0x0B24, 0x0B54, 0x1D00
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

    def draw_whole(self, run: Run, made: Making) -> None:
        """Draw a run's blocks."""

    def completed(self, run: Run) -> Run:
        """The run with every attribute of every vertex known."""


def subdivision_of(run: Run, context: DomeContext) -> Subdivision | None:
    """What the run needs to keep the tolerance."""
    extent = extent_of(run) if context.minds_edges else None
    return context.subdivision(extent) if extent is not None else None


def extent_of(run: Run) -> Extent | None:
    """How large the run is; None where it has no edges, or shows only some of them."""
    primitives = [indices for kind, indices in primitives_of(run) if kind != "points"]
    if not primitives or "edge" in run.attributes:
        return None
    if run.positions.shape[1] == 4:
        return Extent.unknown()
    return Extent.of(run.positions, max(longest_edge(run.positions, indices) for indices in primitives))


def subdivide(run: Run, context: DomeContext, drawer: Drawer, subdivision: Subdivision) -> bool:
    """Draw the run in pieces; False where they could not show what the program asked for."""
    polygon_mode = _shown_polygon_mode(context)
    if polygon_mode is None or "edge" in run.attributes:
        return False  # which edges of a polygon show is lost in its triangles
    for kind, indices in primitives_of(run, polygon_mode):
        if kind == "points":
            drawer.draw_all(_POINTS, taken(run, indices), context.draw)
        elif kind == "lines" and (subdivision.method == "cpu" or stippled(context)):
            _draw_strips(run, indices, context, drawer)
        elif subdivision.method == "cpu":
            _draw_triangles(taken(run, indices), context, drawer)
        else:
            _draw_patches(taken(run, indices), kind, context, drawer, subdivision)
    return True


def _draw_patches(
    piece: Run, kind: Edged, context: DomeContext, drawer: Drawer, subdivision: Subdivision
) -> None:
    patch = Patch(kind, "geometry" if subdivision.method == "geometry" else "tessellate", subdivision.split)
    if patch.split:
        piece = split_wide(piece, patch.corners, context.to_eye, subdivision.limit)
    drawer.draw_all(patch.mode, piece, partial(context.draw, patch=patch))


def _draw_triangles(piece: Run, context: DomeContext, drawer: Drawer) -> None:
    if context.scene.scene().lighting is not None:
        context.say_once("method cpu lights large polygons at more places than their own corners")
    limit = context.tolerance.limit(1 / context.tolerance.detail)
    piece = triangles_under(drawer.completed(piece), context.to_eye, limit, flat=_flat(context))
    drawer.draw_all(_TRIANGLES, piece, context.draw)


def _draw_strips(run: Run, lines: Indices, context: DomeContext, drawer: Drawer) -> None:
    limit = context.tolerance.limit(1 / context.tolerance.detail)
    strips = line_strips(drawer.completed(run), lines, context.to_eye, limit, flat=_flat(context))
    drawer.draw_whole(strips, context.draw)


def taken(run: Run, indices: Indices) -> Run:
    """Some vertices of a run, without its blocks."""
    chosen = indices.ravel()
    attributes = {name: values[chosen] for name, values in run.attributes.items()}
    return Run(run.positions[chosen], attributes, (), constant=run.constant)


def stippled(context: DomeContext) -> bool:
    """Lines are drawn in a pattern now."""
    return bool(context.driver.glIsEnabled(_LINE_STIPPLE))


def _flat(context: DomeContext) -> bool:
    return context.driver.integer(_SHADE_MODEL) == _FLAT


def filled(context: DomeContext) -> bool:
    """Polygons are drawn filled now."""
    return _shown_polygon_mode(context) == _FILL


def _shown_polygon_mode(context: DomeContext) -> int | None:
    """GL_FILL, GL_LINE or GL_POINT; None where the two faces differ or one is culled while outlined."""
    front, back = context.driver.integers(_POLYGON_MODE, 2)
    if front == _FILL and back in (_FILL, 0):
        return _FILL
    return None if front != back or context.driver.glIsEnabled(_CULL_FACE) else front


def primitives_of(run: Run, polygon_mode: int = _FILL) -> Iterator[tuple[Kind, Indices]]:
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
            yield "points", corners(_POINTS, count) + first
        else:
            yield kind, corners(mode, count) + first
