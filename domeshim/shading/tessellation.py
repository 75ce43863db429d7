"""A recipe becomes the three shaders that subdivide: vertex, control and evaluation.

The vertex shader does what it does without subdivision, but leaves the position unbent; the control shader
finds each edge's pieces by its angle; the evaluation shader places and bends, and blends the attributes with
the weights of the true surface.
"""

from __future__ import annotations

from dataclasses import dataclass

from domeshim.shading.compose import Draft, Source, add_attributes
from domeshim.shading.recipe import Recipe

VERSION = "#version 400 compatibility"


@dataclass(frozen=True)
class Stages:
    """The sources of one program, in the order of the pipeline."""

    vertex: Source
    control: Source
    evaluation: Source


def compose_tessellated(recipe: Recipe) -> Stages:
    """The shaders for a recipe whose patch is triangles or lines."""
    return Stages(_vertex(recipe), _control(recipe), _evaluation(recipe))


def _vertex(recipe: Recipe) -> Source:
    draft = Draft()
    draft.add("vec4 eye = gl_ModelViewMatrix * gl_Vertex;")
    if recipe.mapping.place == "panel":
        draft.add("gl_Position = gl_ProjectionMatrix * eye;")
    else:
        draft.need(f"place/{recipe.mapping.place}")
        draft.add("gl_Position = placed(eye);")
    add_attributes(draft, recipe)
    return draft.source(VERSION)


def _control(recipe: Recipe) -> Source:
    draft = Draft()
    _add_place(draft, recipe)
    draft.need("tessellate/direction")
    draft.need("tessellate/level")
    draft.need(f"tessellate/{_patch(recipe)}.tesc")
    for varying in ("gl_Position", *_varyings(recipe)):
        draft.add(f"gl_out[gl_InvocationID].{varying} = gl_in[gl_InvocationID].{varying};")
    draft.add("if (gl_InvocationID == 0)", "    subdivide();")
    return draft.source(VERSION)


def _evaluation(recipe: Recipe) -> Source:
    draft = Draft()
    _add_place(draft, recipe)
    draft.need(f"tessellate/{_patch(recipe)}.tese")
    corners = 2 if recipe.patch == "lines" else 3
    draft.add(f"vec{corners} b = weights();", f"vec4 position = {_blend('gl_Position', corners)};")
    draft.add("vec4 place = placeOf(position);")
    _add_position(draft, recipe)
    for varying in _varyings(recipe):
        last = f"gl_in[{corners - 1}].{varying}"
        draft.add(f"{varying} = {last if recipe.flat and 'Color' in varying else _blend(varying, corners)};")
    if recipe.scene.fog == "distance" and recipe.mapping.place == "modelview":
        draft.add("gl_FogFragCoord = length(place.xyz / place.w);")
    return draft.source(VERSION)


def _patch(recipe: Recipe) -> str:
    return "line" if recipe.patch == "lines" else "triangle"


def _add_place(draft: Draft, recipe: Recipe) -> None:
    """What tells where a travelling position lies, before the tilt, and whether the dome reaches it."""
    if recipe.mapping.place == "panel":
        draft.need("tessellate/place_panel")
        draft.need("tessellate/reach_panel")
        return
    draft.need("tessellate/place_dome")
    if recipe.mapping.tilted:
        draft.need("place/tilt")
    draft.need("clip/cone" if recipe.mapping.wide else "clip/behind")
    draft.need("tessellate/reach_tilted" if recipe.mapping.tilted else "tessellate/reach_dome")


def _add_position(draft: Draft, recipe: Recipe) -> None:
    mapping, distances = recipe.mapping, recipe.clip_distances
    draft.need(f"lens/{mapping.lens}")
    if mapping.tilted:
        draft.need("place/tilt")
    bent = "tilted(place)" if mapping.tilted else "place"
    if mapping.place == "panel":
        draft.need("bend/panel")
        draft.need("clip/panel")
        draft.add(
            f"gl_Position = bent({bent}, position.z / position.w);", "vec4 inside = insideViewport(position);"
        )
        for distance, axis in zip(distances, "xyzw", strict=False):
            draft.add(f"gl_ClipDistance[{distance}] = inside.{axis};")
    else:
        draft.need("bend/vertex")
        draft.add(f"gl_Position = bent({bent});", f"gl_ClipDistance[{distances[0]}] = reach(place);")


def _varyings(recipe: Recipe) -> list[str]:
    """The built-in outputs that the vertex shader writes, beside the position."""
    scene = recipe.scene
    faces = ["Front", "Back"] if scene.lighting and scene.lighting.two_sided else ["Front"]
    separate = scene.secondary_color or (scene.lighting is not None and scene.lighting.separate_specular)
    found = [
        f"gl_{face}{kind}"
        for face in faces
        for kind in (["Color", "SecondaryColor"] if separate else ["Color"])
    ]
    found += [f"gl_TexCoord[{texture.unit}]" for texture in scene.textures]
    found += ["gl_FogFragCoord"] if scene.fog else []
    return found + [f"gl_ClipDistance[{i}]" for i in (*scene.clip_planes, *recipe.side_distances)]


def _blend(varying: str, corners: int) -> str:
    return " + ".join(f"b.{'xyz'[i]} * gl_in[{i}].{varying}" for i in range(corners))
