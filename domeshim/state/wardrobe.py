"""The dome's programs of one GL context, each with what must be on while it draws; found again at once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

from domeshim.driver import Driver
from domeshim.lens.detail import cone
from domeshim.lens.landing import Lens
from domeshim.lens.orientation import Orientation
from domeshim.options import Options
from domeshim.shading.compose import compose, levels_fragment
from domeshim.shading.program import Program
from domeshim.shading.recipe import PIECE_ATTRIBUTES, Levels, Mapping, Patch, Recipe, Scene
from domeshim.state.clip_planes import NOTHING, PARTS, Equation
from domeshim.state.perspective import planar
from domeshim.state.placement import Placement
from domeshim.state.scene import GL_CLIP_PLANE0, GL_COLOR_SUM
from domeshim.state.scissor import Edges
from domeshim.state.subdivision import Tolerance
from domeshim.state.views import View
from domeshim.window.frame import Frame

if TYPE_CHECKING:
    from domeshim.shading.fragments import FragmentStage
    from domeshim.shading.pieces import Stages

_VERTEX_PROGRAM_TWO_SIDE, _PROGRAM_POINT_SIZE, _RASTERIZER_DISCARD = 0x8643, 0x8642, 0x8C89
_PIECE = {f"dome{name.capitalize()}": number for name, number in PIECE_ATTRIBUTES.items()}
_MOST = 1000
"""So many outfits are remembered."""


class Look(NamedTuple):
    """All that decides which program draws, and its uniforms."""

    placement: Placement
    scene: Scene
    edges: Edges
    patch: Patch | None
    raster: bool
    flat: bool
    """One vertex of each primitive gives its colour; asked where that makes a difference."""
    fragments: FragmentStage | None
    levels: Levels | None = None


@dataclass
class Outfit:
    """A program of the dome's, and the capabilities that it needs."""

    program: Program
    mapping: Mapping
    scene: Scene
    """Kept: outfits are found by its identity."""
    enables: tuple[int, ...]
    planes: tuple[tuple[int, Equation], ...]
    """What GL's clip planes hold meanwhile: on OpenGL 2 each picks a part of gl_ClipVertex."""
    left_out: bool
    """OpenGL 2 has too few of those."""


class Wardrobe:
    """Makes and remembers programs."""

    def __init__(
        self,
        driver: Driver,
        options: Options,
        lens: Lens,
        orientation: Orientation,
        frame: Frame,
    ) -> None:
        self._driver = driver
        self._options = options
        self._lens = lens
        self._orientation = orientation.turned_only if options.cubemap else orientation
        self._frame = frame
        self._programs: dict[Recipe, Program] = {}
        self._outfits: dict[tuple[object, ...], Outfit] = {}
        self._sent: dict[int, tuple[Placement, Edges, Tolerance]] = {}
        """What the uniforms of each program say."""

    @property
    def programs(self) -> dict[Recipe, Program]:
        """All that were made, by what they are for."""
        return self._programs

    def outfit(self, look: Look) -> Outfit:
        """What to put on for a draw."""
        placement, edges = look.placement, look.edges
        hidden = self.hides(placement)
        if look.fragments is not None:
            return self._make(look, hidden=hidden)
        key = (
            id(look.scene),
            placement.place,
            edges.inner,
            edges.empty,
            look.patch,
            look.raster,
            look.levels,
            look.flat,
            hidden,
        )
        found = self._outfits.get(key)
        if found is None:
            if len(self._outfits) >= _MOST:
                self._outfits.clear()
            found = self._outfits[key] = self._make(look, hidden=hidden)
        return found

    def hides(self, placement: Placement) -> bool:
        """The user wants nothing of what is drawn there."""
        return placement.hud and self._options.hud == "off"

    def discard(self, look: Look) -> tuple[int, ...]:
        """The capability that keeps all from being drawn, where it shall not be."""
        return (_RASTERIZER_DISCARD,) if self._unseen(look) and not self._driver.legacy else ()

    def views(self, look: Look, views: tuple[View, ...]) -> tuple[View, ...]:
        """The views to draw in; OpenGL 2, which has no such capability, draws to nothing of them."""
        if not (self._driver.legacy and self._unseen(look)):
            return views
        return tuple(view._replace(scissor=(0, 0, 0, 0)) for view in views)

    def _unseen(self, look: Look) -> bool:
        return look.edges.empty or (self.hides(look.placement) and not look.raster)

    def send(self, outfit: Outfit, look: Look, tolerance: Tolerance) -> None:
        """Give the outfit's program, which is bound, its uniforms."""
        if look.fragments is not None:
            look.fragments.send_to(outfit.program)
        sent = self._sent.get(outfit.program.name)
        if sent and sent[0] is look.placement and sent[1] is look.edges and sent[2] is tolerance:
            return
        self._sent[outfit.program.name] = (look.placement, look.edges, tolerance)
        if look.patch is not None:
            outfit.program.set("domeDetail", (tolerance.detail,))
            if look.patch.lengthened:
                outfit.program.set("domeHalf", tolerance.half)
            if outfit.mapping.near_behind:
                outfit.program.set("domeAft", (*tolerance.aft, tolerance.least))
        if look.levels is not None:
            from domeshim.draw.levels import RAMP  # noqa: PLC0415 - for those who look at levels

            outfit.program.set("domeRamp", RAMP)
        for name, values in self._uniforms(outfit.mapping, look, tolerance):
            outfit.program.set(name, values)

    def _make(self, look: Look, *, hidden: bool) -> Outfit:
        recipe = self._recipe(look, hidden=hidden)
        programs = self._programs if look.fragments is None else look.fragments.programs
        program = programs.get(recipe)
        if program is None:
            program = programs[recipe] = self._build(recipe, look.fragments)
        enables = (*_enables(recipe), *self.discard(look))
        left_out = recipe.legacy and recipe.left_out
        return Outfit(program, recipe.mapping, look.scene, enables, _planes(recipe), left_out)

    def _recipe(self, look: Look, *, hidden: bool) -> Recipe:
        place = look.placement.place
        paper = self._options.method == "paper" and place != "panel"
        mapping = Mapping(
            method="paper" if paper else "vertex",
            lens=self._lens.snippets,
            place=place,
            aim=self._orientation.aim,
            clip=self._lens.clip(exact=self._options.method != "vertex"),
            near_behind=self._lens.singular and (self._options.fov > 180 or self._orientation.off_centre),
            face=self._options.cubemap,
            beside=self._options.stereo != "off" and place != "panel",
            keystone=self._frame.keystone is not None,
            grid=self._frame.on_grid and not self._options.cubemap,
            sides=() if place == "panel" else look.edges.inner,
            raster=None if not look.raster else "nowhere" if hidden else "point",
        )
        scene = look.scene if look.levels is None else look.scene.uncoloured
        return Recipe(mapping, scene, look.patch, look.levels, flat=look.flat, legacy=self._driver.legacy)

    def _build(self, recipe: Recipe, fragments: FragmentStage | None) -> Program:
        shaders = fragments.shaders if fragments else ()
        fragment = levels_fragment(legacy=recipe.legacy) if recipe.levels is not None else None
        numbered = recipe.levels == "cut" or (recipe.patch is not None and recipe.patch.split)
        attributes = _PIECE if numbered else None
        if recipe.patch is None:
            vertex = compose(recipe)
            return Program(self._driver, vertex, fragment, attached=shaders, attributes=attributes)
        stages = _compose_pieces(recipe, recipe.patch)
        return Program(
            self._driver,
            stages.vertex,
            fragment,
            control=stages.control,
            evaluation=stages.evaluation,
            geometry=stages.geometry,
            attached=shaders,
            attributes=attributes,
        )

    def _uniforms(
        self, mapping: Mapping, look: Look, tolerance: Tolerance
    ) -> list[tuple[str, tuple[float, ...]]]:
        uniforms: list[tuple[str, tuple[float, ...]]] = []
        if not mapping.face:
            uniforms.append(("domeLens", self._lens.uniform))
        if mapping.place == "panel" or mapping.sides:
            uniforms.append(("domeEdges", look.edges.bounds))
        if mapping.place != "modelview":
            uniforms.append(("domeView", look.placement.view))
        if mapping.place != "panel" and mapping.method == "vertex":
            depth = look.placement.depth
            uniforms.append(("domeDepth", planar(depth) if mapping.face else depth))
            if mapping.clip != "behind" and not mapping.face:
                uniforms.append(("domeRim", cone(tolerance.left_out)))
        return [*uniforms, *self._frame.uniforms, *self._orientation.uniforms]


def _compose_pieces(recipe: Recipe, patch: Patch) -> Stages:
    if patch.method == "geometry":
        from domeshim.shading.geometry import compose_geometry  # noqa: PLC0415 - only what subdivides pays

        return compose_geometry(recipe)
    from domeshim.shading.tessellation import compose_tessellated  # noqa: PLC0415 - as above

    return compose_tessellated(recipe)


def _planes(recipe: Recipe) -> tuple[tuple[int, Equation], ...]:
    """What GL's clip planes hold while this draws."""
    if not recipe.legacy:
        return ()
    idle = ((plane, NOTHING) for plane in recipe.scene.clip_planes if plane not in recipe.distances)
    return (*zip(recipe.distances, PARTS, strict=False), *idle)


def _enables(recipe: Recipe) -> tuple[int, ...]:
    lighting = recipe.scene.lighting
    dome = (*recipe.clip_distances, *recipe.side_distances)
    wanted = [GL_CLIP_PLANE0 + i for i in dome if i in recipe.distances]
    if lighting is not None and lighting.two_sided:
        wanted.append(_VERTEX_PROGRAM_TWO_SIDE)
    if lighting is not None and lighting.separate_specular and not recipe.scene.secondary_color:
        wanted.append(GL_COLOR_SUM)
    if recipe.scene.point_attenuation:
        wanted.append(_PROGRAM_POINT_SIZE)
    return tuple(wanted)
