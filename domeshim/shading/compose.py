"""A recipe becomes the text of a vertex shader: pure, and tested as text.

Each part of the pipeline names the snippets that it needs and the statements that it puts into main(),
in the order in which the values come into being.
"""

from __future__ import annotations

from collections.abc import Iterator

from domeshim.shading.draft import Draft, Source, version_for
from domeshim.shading.recipe import (
    MATERIAL_UNITS,
    ColorMaterial,
    Light,
    Lighting,
    Mapping,
    Recipe,
    Scene,
    Texture,
)
from domeshim.shading.snippets import snippet

_FACETS = "levels/facets.frag"


def compose(recipe: Recipe) -> Source:
    """The vertex shader for a recipe."""
    draft = Draft()
    draft.add("vec4 eye = gl_ModelViewMatrix * gl_Vertex;")
    if recipe.legacy and recipe.distances:
        draft.add("gl_ClipVertex = vec4(1.0);")
    _position(draft, recipe)
    add_surface(draft, recipe.mapping)
    add_attributes(draft, recipe)
    _raster(draft, recipe)
    return draft.source(version_for(legacy=recipe.legacy))


def add_attributes(draft: Draft, recipe: Recipe) -> None:
    """All that a vertex carries beside its position; needs the statement that makes eye before it."""
    _clip_planes(draft, recipe)
    _sides(draft, recipe)
    _normal(draft, recipe.scene)
    if recipe.levels is None:
        _color(draft, recipe.scene)
    elif recipe.levels != "patch":
        add_level(draft, recipe, "domePieces" if recipe.levels == "cut" else "0.0")
    for texture in recipe.scene.textures:
        _texture(draft, texture)
    _fog(draft, recipe)
    if recipe.scene.point_attenuation:
        draft.need("point/attenuated")
        draft.add("gl_PointSize = pointSize(eye);")


def add_level(draft: Draft, recipe: Recipe, pieces: str) -> None:
    """The colour of a number of pieces; needs the statement that makes place before it."""
    draft.need("levels/ramp")
    draft.need("levels/seen_legacy" if recipe.legacy else "levels/seen")
    if recipe.levels == "cut":
        draft.need("levels/cut")
    draft.add(
        f"gl_FrontColor = ofPieces({pieces});", "domeSeen = place.xyz / (place.w != 0.0 ? place.w : 1.0);"
    )


def levels_fragment(*, legacy: bool = False) -> Source:
    """The fragment shader that shows colours by the number of pieces; legacy: as for Recipe."""
    return Source.join([(_FACETS, snippet(_FACETS))], version_for(legacy=legacy))


def add_surface(draft: Draft, mapping: Mapping) -> None:
    """Take gl_Position from the disc to what the picture falls on."""
    if mapping.keystone:
        draft.need("surface/keystone")
        draft.add("gl_Position = onSurface(gl_Position);")
    if mapping.grid:
        draft.need("surface/grid")
        draft.add("gl_Position = onGrid(gl_Position);")


def add_lens(draft: Draft, mapping: Mapping) -> None:
    """Say where a direction lands."""
    for name in ("bend/face",) if mapping.face else mapping.lens:
        draft.need(name)


def _position(draft: Draft, recipe: Recipe) -> None:
    mapping = recipe.mapping
    draft.need(f"place/{mapping.place}")
    draft.add("vec4 place = placed(eye);")
    if mapping.beside:
        draft.need("eye/beside")
        draft.add("place = beside(place);")
    if mapping.aim != "straight":
        draft.need(f"aim/{mapping.aim}")
        draft.add("place = aimed(place);")
    add_lens(draft, mapping)
    if mapping.method == "paper":
        draft.need("bend/paper")
        draft.add("gl_Position = bent(place);")
    elif mapping.place == "panel":
        _panel_position(draft, recipe)
    elif mapping.face:
        draft.need("bend/face_point")
        draft.add("gl_Position = bent(place);")
    else:
        draft.need("bend/vertex")
        draft.need(f"clip/{mapping.clip}")
        draft.add("gl_Position = bent(place);")
        _cut(draft, recipe, recipe.clip_distances[0], "inFront(place)")


def _cut(draft: Draft, recipe: Recipe, distance: int, value: str) -> None:
    """Write a clip distance, where there is room for it."""
    written = recipe.distance(distance)
    if written is not None:
        draft.add(f"{written} = {value};")


def _panel_position(draft: Draft, recipe: Recipe) -> None:
    draft.need("bend/face_panel" if recipe.mapping.face else "bend/panel")
    draft.need("clip/panel")
    draft.add(
        "vec4 clip = gl_ProjectionMatrix * eye;",
        "gl_Position = bent(place, clip.z / clip.w);",
        "vec4 inside = insideViewport(clip);",
    )
    for distance, axis in zip(recipe.clip_distances, "xyzw", strict=False):
        _cut(draft, recipe, distance, f"inside.{axis}")


def _clip_planes(draft: Draft, recipe: Recipe) -> None:
    if recipe.scene.clip_planes:
        draft.need("clip/plane_legacy" if recipe.legacy else "clip/plane")
    for plane in recipe.scene.clip_planes:
        _cut(draft, recipe, plane, f"abovePlane({plane}, eye)")


def _sides(draft: Draft, recipe: Recipe) -> None:
    if not recipe.mapping.sides:
        return
    draft.need("clip/panel")
    draft.add("vec4 within = insideViewport(gl_ProjectionMatrix * eye);")
    for distance, side in zip(recipe.side_distances, recipe.mapping.sides, strict=False):
        _cut(draft, recipe, distance, f"within[{side}]")


def _raster(draft: Draft, recipe: Recipe) -> None:
    if recipe.mapping.raster is None:
        return
    numbers = (*recipe.clip_distances, *recipe.scene.clip_planes)
    distances = (recipe.distance(number) for number in numbers)
    cut = " || ".join(f"{distance} < 0.0" for distance in distances if distance is not None)
    condition = "true" if recipe.mapping.raster == "nowhere" else cut or "false"
    draft.add(f"if ({condition})", "    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);")


def _normal(draft: Draft, scene: Scene) -> None:
    mapped = any(g in ("sphere", "reflection", "normal") for t in scene.textures for g in t.generated)
    if scene.lighting or mapped:
        draft.need(f"light/normal_{scene.normals}")
        draft.add("vec3 normal = eyeNormal();")


def _color(draft: Draft, scene: Scene) -> None:
    if scene.lighting is None:
        draft.add("gl_FrontColor = gl_Color;")
        if scene.secondary_color:
            draft.add("gl_FrontSecondaryColor = gl_SecondaryColor;")
        return
    draft.need(f"light/viewer_{'local' if scene.lighting.local_viewer else 'infinite'}")
    draft.add("vec3 viewer = toViewer(eye);")
    _lit_face(draft, scene.lighting, "Front", "normal")
    if scene.lighting.two_sided:
        _lit_face(draft, scene.lighting, "Back", "-normal")


def _lit_face(draft: Draft, lighting: Lighting, face: str, normal: str) -> None:
    surface = face.lower()
    draft.need("light/surface")
    draft.add(f"Surface {surface} = surfaceOf(gl_{face}Material, {normal});")
    if lighting.vertex_material in (surface, "both"):
        draft.add(*_carried(surface))
    draft.add(*_followed(lighting.color_material, surface))
    for light in lighting.lights:
        _light(draft, light, surface)
    draft.need("light/sum_separate" if lighting.separate_specular else "light/sum")
    draft.add(f"gl_{face}Color = litColor({surface});")
    if lighting.separate_specular:
        draft.add(f"gl_{face}SecondaryColor = litSecondaryColor({surface});")


def _carried(surface: str) -> Iterator[str]:
    for part, unit in MATERIAL_UNITS.items():
        value = f"gl_MultiTexCoord{unit}" + (".x" if part == "shininess" else "")
        yield f"{surface}.{part} = {value};"


def _followed(material: ColorMaterial | None, surface: str) -> Iterator[str]:
    if material is not None and material.face in (surface, "both"):
        for part in material.follows:
            yield f"{surface}.{part} = gl_Color;"


def _light(draft: Draft, light: Light, surface: str) -> None:
    if light.kind != "directional":
        draft.need("light/positional")
    draft.need(f"light/{light.kind}")
    draft.add(f"light{light.kind.capitalize()}({light.number}, eye, viewer, {surface});")


_TEXGEN = {
    "object": "dot(gl_ObjectPlane{C}[{u}], gl_Vertex)",
    "eye": "dot(gl_EyePlane{C}[{u}], eye)",
    "sphere": "sphereMap(eye, normal).{c}",
    "reflection": "reflectionMap(eye, normal).{c}",
    "normal": "vec4(normal, 1.0).{c}",
}


def _texture(draft: Draft, texture: Texture) -> None:
    u = texture.unit
    draft.add(f"vec4 texture{u} = gl_MultiTexCoord{u};")
    for axis, generated in zip("stpq", texture.generated, strict=True):
        if generated is None:
            continue
        if generated in ("sphere", "reflection"):
            draft.need(f"texture/{generated}")
        plane = "R" if axis == "p" else axis.upper()
        draft.add(f"texture{u}.{axis} = {_TEXGEN[generated].format(C=plane, c=axis, u=u)};")
    draft.add(
        f"gl_TexCoord[{u}] = " + (f"gl_TextureMatrix[{u}] * " if texture.matrix else "") + f"texture{u};"
    )


def _fog(draft: Draft, recipe: Recipe) -> None:
    fog = recipe.scene.fog
    if fog is None:
        return
    draft.need(f"fog/{fog if fog == 'attribute' or _true_eye(recipe.mapping) else 'depth'}")
    draft.add("gl_FogFragCoord = fogCoordinate(eye);")


def _true_eye(mapping: Mapping) -> bool:
    """A length in the program's MODELVIEW space is a distance from the viewer."""
    return mapping.place == "modelview"
