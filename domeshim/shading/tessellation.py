"""A recipe becomes the three shaders of method tessellate: vertex, control and evaluation.

The control shader finds each edge's pieces by its angle; the evaluation shader makes their vertices.
"""

from __future__ import annotations

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
from domeshim.shading.recipe import Recipe

VERSION = "#version 400 compatibility"
_LIMITS = "#define DOME_MOST_PIECES 64.0"
"""What every tessellator has."""


def compose_tessellated(recipe: Recipe) -> Stages:
    """The shaders for a recipe whose patch is tessellated."""
    return Stages(
        unbent_vertex(recipe).source(VERSION), control=_control(recipe), evaluation=_evaluation(recipe)
    )


def _control(recipe: Recipe) -> Source:
    draft = Draft()
    add_place(draft, recipe)
    add_edges(draft, recipe)
    draft.need(f"tessellate/{shape(recipe)}_levels")
    draft.need(f"tessellate/{shape(recipe)}.tesc")
    for varying in ("gl_Position", *varyings(recipe)):
        draft.add(f"gl_out[gl_InvocationID].{varying} = gl_in[gl_InvocationID].{varying};")
    if patch_of(recipe).split:
        draft.need("tessellate/piece.tesc")
        draft.add("domeShares[gl_InvocationID] = domeShare[gl_InvocationID];")
    draft.add("if (gl_InvocationID == 0)", "    subdivide();")
    return draft.source(VERSION, _LIMITS)


def _evaluation(recipe: Recipe) -> Source:
    draft = Draft()
    add_place(draft, recipe)
    add_weights(draft, recipe)
    draft.need(f"tessellate/{shape(recipe)}.tese")
    if patch_of(recipe).split:
        draft.need("tessellate/piece.tese")
    draft.add(f"vec{patch_of(recipe).corners} b = weights();")
    add_vertex(draft, recipe, "domeShares")
    return draft.source(VERSION)
