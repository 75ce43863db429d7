"""A recipe becomes the two shaders of method geometry: vertex, and geometry, which makes the pieces."""

from __future__ import annotations

import math
from functools import lru_cache

from domeshim.shading.draft import Draft, Source
from domeshim.shading.pieces import (
    Stages,
    add_edges,
    add_place,
    add_vertex,
    add_weights,
    patch_of,
    shape,
    unbent_vertex,
    varyings,
)
from domeshim.shading.recipe import Recipe, Scene

VERSION = "#version 150 compatibility"
_COMPONENTS, _VERTICES = 1024, 256
"""What every geometry shader may give out in all, and how many vertices: the least that GL 3.2 allows."""

_DISTANCES = 5
"""The clip distances of any mapping: at most the lens's own and the scissor's four sides."""
_PRECISE = """#extension GL_ARB_gpu_shader5 : enable
#ifndef GL_ARB_gpu_shader5
#define precise
#endif"""
"""Drivers without the word may let neighbours differ by a rounding error."""


def compose_geometry(recipe: Recipe) -> Stages:
    """The shaders for a recipe whose patch a geometry shader subdivides."""
    return Stages(unbent_vertex(recipe).source(VERSION), geometry=_geometry(recipe))


@lru_cache(maxsize=64)
def most_pieces(scene: Scene, kind: str) -> int:
    """How many pieces an edge may have: the more a scene's vertices carry, the fewer of them come out."""
    vertices = _most_vertices(Recipe(scene=scene))
    return vertices - 1 if kind == "lines" else math.isqrt(vertices + 1) - 1  # n rows have n (n + 2) vertices


def _most_vertices(recipe: Recipe) -> int:
    carried, scene = varyings(recipe), recipe.scene
    units = 1 + max((texture.unit for texture in scene.textures), default=-1)
    distances = max(_DISTANCES + len(scene.clip_planes), 1 + max(scene.clip_planes, default=0))
    colors = sum("Color" in varying for varying in carried)
    colors, seen = (colors, 0) if recipe.levels is None else (1, 3)
    components = 4 + 4 * colors + seen + 4 * units + ("gl_FogFragCoord" in carried) + distances
    return min(_COMPONENTS // components, _VERTICES)


def _geometry(recipe: Recipe) -> Source:
    patch = patch_of(recipe)
    draft = Draft(opening=f"void vertexAt(vec{patch.corners} b) {{")
    add_place(draft, recipe)
    add_edges(draft, recipe)
    add_weights(draft, recipe)
    draft.need(f"tessellate/{'lengthened_' if patch.lengthened else ''}{shape(recipe)}.geom")
    if patch.split:
        draft.need("tessellate/piece.geom")
    add_vertex(draft, recipe, "domeShare")
    if not patch.lengthened:
        draft.add("EmitVertex();")
    return draft.source(VERSION, _limits(recipe))


def _limits(recipe: Recipe) -> str:
    pieces = most_pieces(recipe.scene, patch_of(recipe).kind)
    return "\n".join(
        [
            _PRECISE,
            f"#define DOME_MOST_PIECES {pieces}.0",
            f"#define DOME_MOST_VERTICES {_most_vertices(recipe)}",
        ]
    )
