"""What the next draw wears: one of the dome's programs, or the program's own bent or left straight."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from domeshim.options import Options
from domeshim.shading.recipe import Levels, Patch, Scene
from domeshim.state.views import Dressing, View, Worn
from domeshim.state.wardrobe import Look, Outfit, Wardrobe
from domeshim.state.whereabouts import Seen

if TYPE_CHECKING:
    from domeshim.draw.canvas import Canvas
    from domeshim.state.context import DomeContext

_FOUR = (
    "OpenGL 2: at most four of the clip planes and the viewport's and scissor's edges cut at a time; "
    "the last do not"
)


_SHADE_MODEL, _FLAT = 0x0B54, 0x1D00
_MOST = 64
"""So many dressings are remembered."""


class _Chosen(NamedTuple):
    """A dressing with one of the dome's programs, and what it was chosen for."""

    seen: Seen
    """Kept, as the look keeps the scene: dressings are found by their identity."""
    canvas: Canvas
    look: Look
    outfit: Outfit
    dressing: Dressing


class Dresser:
    """Dresses the draws of one context, and undresses it."""

    def __init__(self, context: DomeContext, options: Options) -> None:
        self._context = context
        self._options = options
        self.wardrobe = Wardrobe(context.driver, options, context.lens, context.orientation, context.frame)
        self.worn = Worn(context.driver)
        self._known: dict[tuple[object, ...], _Chosen] = {}

    def put_on(self, seen: Seen, scene: Scene, patch: Patch | None, *, raster: bool) -> None:
        """Put on what a draw of this scene needs; patch, raster: as for DomeContext.dress."""
        context, placement = self._context, seen.placement
        canvas, own = context.canvas, context.own
        if placement.hud and self._options.flat_hud:
            context.undress()
            own.leave_straight()
            canvas.settle(deep=True, straight=True)
            self._wear(Dressing(0, (), tuple(self._flat_views(seen))), seen)
        elif own.current is not None:
            look = self._look(seen, scene, patch, raster=raster, flat=False)
            self._say_uncut(seen, scene)
            if context.shows_levels:
                context.say_once("DOME_DEBUG=levels: what the program's own GLSL draws keeps its colours")
            self._put_on_own(seen, scene, look, patch)
        else:
            chosen = self._chosen(seen, scene, patch, raster=raster)
            outfit = chosen.outfit
            if chosen.dressing is self.worn.dressing:
                return
            self._wear(chosen.dressing, seen)
            if outfit.planes and scene.clip_planes:
                outfit.program.set("domePlanes", self.worn.clip_planes.own)
            if outfit.left_out:
                context.say_once(_FOUR)
            self.wardrobe.send(outfit, chosen.look, context.subdividing.tolerance)

    def _chosen(self, seen: Seen, scene: Scene, patch: Patch | None, *, raster: bool) -> _Chosen:
        """One of the dome's programs; programs switch to and fro between the same few."""
        context, canvas = self._context, self._context.canvas
        flat = patch is not None and context.driver.integer(_SHADE_MODEL) == _FLAT
        key = id(seen), id(scene), patch, raster, flat
        known = self._known.get(key)
        if known is not None and known.canvas is canvas and context.own.fragments is None:
            return known
        look = self._look(seen, scene, patch, raster=raster, flat=flat)
        outfit = self.wardrobe.outfit(look)
        program, views = outfit.program, self.wardrobe.views(look, canvas.views)
        dressing = Dressing(program.name, outfit.enables, views, program, canvas.framebuffer, outfit.planes)
        if len(self._known) >= _MOST:
            self._known.clear()
        self._known[key] = found = _Chosen(seen, canvas, look, outfit, dressing)
        return found

    def _put_on_own(self, seen: Seen, scene: Scene, look: Look, patch: Patch | None) -> None:
        """Put on a program of the program's own, or what subdivides in its place."""
        context, own = self._context, self._context.own
        assert own.current is not None
        cut = own.cut(seen, scene.clip_planes)
        enables = (*cut.enables, *self.wardrobe.discard(look))
        views = self.wardrobe.views(look, context.canvas.views)
        pieces = None if patch is None or patch.kind == "quads" else own.subdividing(patch.kind)
        worn, name = (own.current, 0) if pieces is None else (pieces, pieces.name)
        self._wear(Dressing(name, enables, views, worn, context.canvas.framebuffer, cut.planes), seen)
        if pieces is None:
            own.bend(worn, seen)
            return
        own.bend(worn, seen, context.subdividing.tolerance)
        worn.set("domeFlat", (float(context.driver.integer(_SHADE_MODEL) == _FLAT),))
        own.current.subdivided.send_to(worn)

    def _say_uncut(self, seen: Seen, scene: Scene) -> None:
        """Say what of the program's does not cut what its own GLSL draws."""
        context, own = self._context, self._context.own.current
        assert own is not None
        if context.driver.legacy:
            if own.cut and (scene.clip_planes or (seen.edges.inner and seen.placement.place != "panel")):
                context.say_once("OpenGL 2: no clip plane and no glScissor cuts under the program's own GLSL")
        elif any(plane >= own.planes for plane in scene.clip_planes):
            context.say_once(
                "under the program's own GLSL only GL_CLIP_PLANE0 to 2 cut, and only by its gl_ClipVertex"
            )

    def take_off(self) -> None:
        """Give GL back to the program just as it left it."""
        self.worn.take_off(self._programs_own)

    def _look(self, seen: Seen, scene: Scene, patch: Patch | None, *, raster: bool, flat: bool) -> Look:
        cut = patch is not None and patch.method == "cpu"
        handed = None if cut else patch
        if not self._context.shows_levels:
            return Look(seen.placement, scene, seen.edges, handed, raster, flat, self._context.own.fragments)
        levels: Levels = "cut" if cut else "whole" if handed is None else "patch"
        return Look(seen.placement, scene, seen.edges, handed, raster, flat, None, levels)

    def _flat_views(self, seen: Seen) -> Iterator[View]:
        """The program's window, undistorted, in each eye's part of the frame."""
        frame, canvas = self._context.frame, self._context.canvas
        for number, view in enumerate(canvas.views if canvas.kind == "disc" else (None,)):
            eye = min(number, len(frame.squares) - 1)
            part = None if seen.scissor is None else frame.flat(seen.scissor, eye)
            yield View(frame.flat(seen.viewport, eye), part, buffer=view.buffer if view else None)

    def _wear(self, dressing: Dressing, seen: Seen) -> None:
        if dressing.uniforms is not None:
            self._context.canvas.drawn(seen.placement.depth)
        self.worn.put_on(dressing, seen.view, self._programs_own)

    @property
    def _programs_own(self) -> int:
        """What is bound where the dome's program is not, as far as the dome binds it."""
        own = self._context.own
        bound = own.fragments or own.current
        return bound.name if bound else 0
