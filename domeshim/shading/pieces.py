"""What the subdividing methods share: the unbent vertex, and where and how each vertex of a piece comes out.

The vertex shader does what it does without subdivision, but leaves the position unbent. A later stage finds
the weights of each new vertex, places and bends it, and blends the attributes as on the true surface. A piece
of a split primitive blends those of the whole primitive's corners, so the program's vertex lighting stays.
"""

from __future__ import annotations

from dataclasses import dataclass

from domeshim.shading.compose import add_attributes, add_lens, add_level, add_surface
from domeshim.shading.draft import Draft, Source
from domeshim.shading.recipe import Patch, Recipe


@dataclass(frozen=True)
class Stages:
    """The sources of one program, in the order of the pipeline."""

    vertex: Source
    control: Source | None = None
    evaluation: Source | None = None
    geometry: Source | None = None


def unbent_vertex(recipe: Recipe) -> Draft:
    """The vertex shader: attributes as ever, the position as it travels down the pipeline."""
    draft = Draft()
    draft.add("vec4 eye = gl_ModelViewMatrix * gl_Vertex;")
    corner = "eye"
    if patch_of(recipe).split:
        draft.need("tessellate/piece.vert")
        draft.add("vec4 corner = gl_ModelViewMatrix * domePlace;", "domeShare = domeWeights;")
        corner = "corner"
    if recipe.mapping.place == "panel":
        draft.add(f"gl_Position = gl_ProjectionMatrix * {corner};")
    else:
        draft.need(f"place/{recipe.mapping.place}")
        draft.add(f"gl_Position = placed({corner});")
    add_attributes(draft, recipe)
    return draft


def add_place(draft: Draft, recipe: Recipe) -> None:
    """What tells where a travelling position lies in eye space, and whether the dome reaches it."""
    if recipe.mapping.place == "panel":
        draft.need("tessellate/place_panel")
        draft.need("tessellate/reach_all")
        return
    draft.need("tessellate/place_dome")
    aim = recipe.mapping.aim
    if aim != "straight":
        draft.need(f"aim/{aim}")
    draft.need(f"clip/{recipe.mapping.clip}")
    # From a seat, what the lens leaves out need not be convex: no corner tells of a whole patch there.
    draft.need(f"tessellate/reach_{'all' if aim == 'seated' else 'turned' if aim == 'turned' else 'dome'}")


def add_edges(draft: Draft, recipe: Recipe) -> None:
    """What finds the pieces of a patch's edges."""
    draft.need("tessellate/direction")
    draft.need("tessellate/angle")
    draft.need("tessellate/need_behind" if recipe.mapping.near_behind else "tessellate/need")
    draft.need("tessellate/pieces")
    draft.need(f"tessellate/{shape(recipe)}_edges")


def add_weights(draft: Draft, recipe: Recipe) -> None:
    """What finds where a vertex of a patch lies in it."""
    draft.need("tessellate/edge_weights")
    kind = patch_of(recipe).kind
    if kind != "lines":
        draft.need(f"tessellate/{shape(recipe)}_weights")
    if kind == "quads":
        draft.need("tessellate/quad_halves")


def add_vertex(draft: Draft, recipe: Recipe, shares: str) -> None:
    """The statements that make a vertex of its weights b in the patch.

    shares: the array that tells where each corner lies in the whole primitive, if the patch is a piece of it.
    """
    patch = patch_of(recipe)
    draft.add(
        f"precise vec4 position = {_blend('b', 'gl_in[{}].gl_Position', patch)};",
        "vec4 place = placeOf(position);",
    )
    _add_position(draft, recipe)
    add_surface(draft, recipe.mapping)
    weights = "b"
    if patch.split:
        draft.add(f"vec3 share = {_blend('b', shares + '[{}]', patch)};")
        weights = "share"
    if patch.kind == "quads":
        within = "share.xy" if patch.split else "vec2(b.y + b.z, b.z + b.w)"
        draft.add(f"vec4 halves = onHalves({within});")
        weights = "halves"
    for varying in varyings(recipe):
        if recipe.flat and "Color" in varying:
            draft.add(f"{varying} = gl_in[{patch.corners - 1}].{varying};")
        else:
            draft.add(f"{varying} = {_blend(weights, 'gl_in[{}].' + varying, patch)};")
    if recipe.levels is not None:
        draft.need(f"levels/{shape(recipe)}.{'geom' if patch.method == 'geometry' else 'tese'}")
        add_level(draft, recipe, "pieces()")
    if recipe.scene.fog == "distance" and recipe.mapping.place == "modelview":
        draft.add("gl_FogFragCoord = length(place.xyz / place.w);")


def _add_position(draft: Draft, recipe: Recipe) -> None:
    mapping, distances = recipe.mapping, recipe.clip_distances
    add_lens(draft, mapping)
    ray = "place"
    if mapping.beside:
        draft.need("eye/beside")
        draft.add("vec4 seen = beside(place);")
        ray = "seen"
    if mapping.aim != "straight":
        draft.need(f"aim/{mapping.aim}")
        draft.add(f"vec4 ray = aimed({ray});")
        ray = "ray"
    if mapping.place == "panel":
        draft.need("bend/panel")
        draft.need("clip/panel")
        draft.add(
            f"gl_Position = bent({ray}, position.z / position.w);", "vec4 inside = insideViewport(position);"
        )
        for distance, axis in zip(distances, "xyzw", strict=False):
            draft.add(f"gl_ClipDistance[{distance}] = inside.{axis};")
    else:
        draft.need("bend/vertex")
        draft.add(f"gl_Position = bent({ray});", f"gl_ClipDistance[{distances[0]}] = inFront({ray});")


def patch_of(recipe: Recipe) -> Patch:
    """The recipe's patch, which it must have."""
    assert recipe.patch is not None
    return recipe.patch


def shape(recipe: Recipe) -> str:
    """What the snippets call the patch."""
    return patch_of(recipe).kind.removesuffix("s")


def varyings(recipe: Recipe) -> list[str]:
    """The built-in outputs that the vertex shader writes, beside the position."""
    scene = recipe.scene
    faces = ["Front", "Back"] if scene.lighting and scene.lighting.two_sided else ["Front"]
    separate = scene.secondary_color or (scene.lighting is not None and scene.lighting.separate_specular)
    found = [
        f"gl_{face}{kind}"
        for face in faces
        for kind in (["Color", "SecondaryColor"] if separate else ["Color"])
        if recipe.levels is None
    ]
    found += [f"gl_TexCoord[{texture.unit}]" for texture in scene.textures]
    found += ["gl_FogFragCoord"] if scene.fog else []
    return found + [f"gl_ClipDistance[{i}]" for i in (*scene.clip_planes, *recipe.side_distances)]


def _blend(weights: str, of_corner: str, patch: Patch) -> str:
    return " + ".join(f"{weights}.{'xyzw'[i]} * {of_corner.format(i)}" for i in range(patch.corners))
