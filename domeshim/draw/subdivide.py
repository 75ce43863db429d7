"""A run with long edges is drawn in pieces: as patches, which the GPU subdivides, or cut on the CPU."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Literal, Protocol

from domeshim.draw.order import alike, order_shows
from domeshim.draw.patches import LINES, POINTS, TRIANGLES, Edged, Indices, Kind
from domeshim.draw.primitives import FILL, Primitives, extent_of, primitives_of, taken
from domeshim.draw.quads import as_quads
from domeshim.draw.split import split_wide, triangles_under
from domeshim.draw.strips import line_strips
from domeshim.record.runs import Block, Run
from domeshim.shading.recipe import Patch, PatchMethod
from domeshim.state.subdivision import FEW_PIECES
from domeshim.window.contract import processor_draws

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext
    from domeshim.state.subdivision import Choice, Subdivision

_LINE_STIPPLE, _LINE_SMOOTH, _SHADE_MODEL, _FLAT = 0x0B24, 0x0B20, 0x0B54, 0x1D00
_MULTISAMPLE, _SAMPLES = 0x809D, 0x80A9
_POLYGON_MODE, _CULL_FACE = 0x0B40, 0x0B44

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

    def draw_some(self, mode: int, run: Run, indices: Indices, made: Making) -> None:
        """Draw those of a run's vertices by one mode."""

    def completed(self, run: Run) -> Run:
        """The run with every attribute of every vertex known."""


def subdivision_of(run: Run, context: DomeContext) -> Subdivision | None:
    """What the run needs to keep the tolerance."""
    extent = extent_of(run) if context.subdividing.minds_edges else None
    return context.subdividing.subdivision(extent) if extent is not None else None


def subdivide(
    run: Run,
    context: DomeContext,
    drawer: Drawer,
    subdivision: Subdivision,
    primitives: Primitives | None,
) -> bool:
    """Draw the run in pieces; False where it is to be drawn whole.

    That is where no edge needs more, or where pieces could not show what the program asked for. primitives:
    the run's, where there are enough to choose among.
    """
    polygon_mode = shown_polygon_mode(context)
    if polygon_mode is None or "edge" in run.attributes:
        return False  # which edges of a polygon show is lost in its triangles
    if primitives is not None and _chosen_from(primitives, polygon_mode, context):
        choice = context.subdividing.choice(primitives, lengthened=subdivision.lengthened)
        if choice is not None:
            return _draw_chosen(run, primitives, choice, context, drawer)
    for kind, indices in primitives_of(run, polygon_mode):
        if kind == "points":
            drawer.draw_all(POINTS, taken(run, indices), context.draw)
        elif kind == "lines" and (subdivision.method == "cpu" or in_strips(context)):
            draw_strips(run, indices, context, drawer)
        elif subdivision.method is None and kind == "triangles":
            drawer.draw_all(TRIANGLES, taken(run, indices), context.draw)
        elif subdivision.method == "cpu":
            draw_cut(taken(run, indices), context, drawer)
        elif kind == "triangles" and takes_quads(context, subdivision):
            for shape, chosen in as_quads(run, indices, flat=is_flat(context)):
                draw_patches(taken(run, chosen), shape, context, drawer, subdivision)
        else:
            draw_patches(taken(run, indices), kind, context, drawer, subdivision)
    return True


def _chosen_from(primitives: Primitives, polygon_mode: int, context: DomeContext) -> bool:
    """Each primitive may be drawn in its own way."""
    return not in_strips(context) if primitives.kind == "lines" else polygon_mode == FILL


def _draw_chosen(
    run: Run, primitives: Primitives, choice: Choice, context: DomeContext, drawer: Drawer
) -> bool:
    """Draw the primitives each as it needs; False where all may stay whole."""
    if not choice.levels.any() and choice.subdivisions[0] is None:
        return False
    mode = LINES if primitives.kind == "lines" else TRIANGLES
    for level, numbers in alike(choice.levels, ordered=order_shows(context.driver)):
        indices, subdivision = primitives.indices[numbers], choice.subdivisions[level]
        if subdivision is None:
            drawer.draw_some(mode, run, indices, context.draw)
        elif level == 1 and choice.pieces <= FEW_PIECES and subdivision.method == "tessellate":
            draw_patches(taken(run, indices), primitives.kind, context, drawer, subdivision)
        else:
            piece = replace(taken(run, indices), blocks=(Block(mode, 0, indices.size),))
            subdivide(piece, context, drawer, subdivision, None)
    return True


def draw_patches(
    piece: Run,
    kind: Edged | Literal["quads"],
    context: DomeContext,
    drawer: Drawer,
    subdivision: Subdivision,
) -> None:
    """Draw a piece of a run, primitive after primitive, as patches."""
    patch = patch_for(kind, subdivision)
    if patch.split:
        piece = split_wide(piece, patch.corners, context.subdividing.to_eye, subdivision.limit)
    drawer.draw_all(patch.mode, piece, partial(context.draw, patch=patch))


def patch_for(kind: Edged | Literal["quads"], subdivision: Subdivision) -> Patch:
    """What a draw of such primitives hands over to a shader that subdivides."""
    lengthened = subdivision.lengthened and kind == "lines"
    method: PatchMethod = "geometry" if subdivision.method == "geometry" or lengthened else "tessellate"
    return Patch(kind, method, subdivision.split, lengthened)


def takes_quads(context: DomeContext, subdivision: Subdivision) -> bool:
    """Parallelograms may be subdivided as quads now; what passes a small view's viewer as triangles."""
    return subdivision.method == "tessellate" and context.subdividing.even_w


def shader_subdivides(kinds: Collection[Kind], context: DomeContext, subdivision: Subdivision) -> bool:
    """Primitives of these kinds go to a shader as they are, none split nor cut on the CPU."""
    if subdivision.split or subdivision.method in (None, "cpu"):
        return False
    return ("lines" not in kinds or not in_strips(context)) and ("triangles" not in kinds or filled(context))


def draw_cut(piece: Run, context: DomeContext, drawer: Drawer) -> None:
    """Draw triangles of a run, one after the other, cut on the CPU."""
    if context.scene_now().lighting is not None:
        context.say_once("method cpu lights large polygons at more places than their own corners")
    limit = context.subdividing.tolerance.limit(1 / context.subdividing.tolerance.detail)
    piece = triangles_under(
        drawer.completed(piece),
        context.subdividing.to_eye,
        limit,
        flat=is_flat(context),
        counting=context.shows_levels,
    )
    drawer.draw_all(TRIANGLES, piece, _drawing_cut("triangles", context))


def draw_strips(run: Run, lines: Indices, context: DomeContext, drawer: Drawer) -> None:
    """Draw lines of a run cut on the CPU; lines: (n, 2) indices."""
    limit = context.subdividing.tolerance.limit(1 / context.subdividing.tolerance.detail)
    strips = line_strips(
        drawer.completed(run),
        lines,
        context.subdividing.to_eye,
        limit,
        flat=is_flat(context),
        counting=context.shows_levels,
    )
    drawer.draw_whole(strips, _drawing_cut("lines", context))


def _drawing_cut(kind: Edged, context: DomeContext) -> Making:
    """What draws pieces that the CPU has made."""
    return partial(context.draw, patch=Patch(kind, "cpu")) if context.shows_levels else context.draw


def manner(context: DomeContext) -> tuple[object, ...]:
    """All that decides into which pieces a run is cut, beside the view."""
    return shown_polygon_mode(context), in_strips(context), is_flat(context)


def in_strips(context: DomeContext) -> bool:
    """Lines that need pieces are cut on the CPU now: their pattern goes on, or shaders' pieces get lost."""
    return stippled(context) or loses_smooth_lines(context)


def stippled(context: DomeContext) -> bool:
    """Lines are drawn in a pattern now."""
    return bool(context.driver.glIsEnabled(_LINE_STIPPLE))


def loses_smooth_lines(context: DomeContext) -> bool:
    """Lines are smoothed now by a driver that misplaces those which shaders subdivide.

    Mesa's llvmpipe does where the picture has no samples (22.3).
    """
    gl = context.driver
    if not gl.glIsEnabled(_LINE_SMOOTH) or not processor_draws(gl.renderer):
        return False
    return not (gl.integer(_SAMPLES) and gl.glIsEnabled(_MULTISAMPLE))


def is_flat(context: DomeContext) -> bool:
    """One vertex of each primitive gives its colour now."""
    return context.driver.integer(_SHADE_MODEL) == _FLAT


def filled(context: DomeContext) -> bool:
    """Polygons are drawn filled now."""
    return shown_polygon_mode(context) == FILL


def shown_polygon_mode(context: DomeContext) -> int | None:
    """GL_FILL, GL_LINE or GL_POINT; None where the two faces differ or one is culled while outlined."""
    front, back = context.driver.integers(_POLYGON_MODE, 2)
    if front == FILL and back in (FILL, 0):
        return FILL
    return None if front != back or context.driver.glIsEnabled(_CULL_FACE) else front
