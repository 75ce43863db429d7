"""What a recipe asks for and what it leaves out, in words."""

from __future__ import annotations

from domeshim.options import Options
from domeshim.shading.recipe import Lighting, Mapping, Recipe, Scene
from domeshim.wording import counted

_PLACES = {
    "modelview": "on the dome",
    "view": "on the dome, part of the view being outside of MODELVIEW",
    "panel": "on the panel",
}


def needs(recipe: Recipe) -> list[str]:
    """What a draw by this recipe needs, the place first."""
    mapping, scene = recipe.mapping, recipe.scene
    found = [_PLACES[mapping.place], f"method {mapping.method}", f"lens {_lens(mapping)}"]
    if recipe.patch is not None:
        found.append(f"{recipe.patch.kind} subdivided by {recipe.patch.method}")
    found += [mapping.aim] if mapping.aim != "straight" else []
    found += ["cube's face"] if mapping.face else []
    found += ["an eye beside the middle"] if mapping.beside else []
    found += [f"{mapping.clip} behind cut off"] if mapping.clip != "behind" else []
    found += [f"{counted(len(mapping.sides), 'side')} of the scissor"] if mapping.sides else []
    found += ["raster position"] if mapping.raster else []
    found += _lighting(scene.lighting) if scene.lighting is not None else []
    found += [f"{scene.normals} normals"] if scene.normals != "plain" else []
    found += [_texture(unit) for unit in range(8) if any(t.unit == unit for t in scene.textures)]
    found += [f"fog by {scene.fog}"] if scene.fog else []
    found += [f"clip plane {number}" for number in scene.clip_planes]
    found += ["secondary colour"] if scene.secondary_color else []
    found += ["point attenuation"] if scene.point_attenuation else []
    found += ["flat shading of pieces"] if recipe.flat else []
    return found


def left_out(recipe: Recipe) -> list[str]:
    """What this recipe's program has no text for, since nothing asks for it."""
    scene: Scene = recipe.scene
    lighting = scene.lighting
    absent = {
        "lighting": lighting is None,
        "two-sided lighting": lighting is not None and not lighting.two_sided,
        "textures": not scene.textures,
        "fog": scene.fog is None,
        "clip planes": not scene.clip_planes,
        "secondary colour": not scene.secondary_color,
        "point attenuation": not scene.point_attenuation,
        "subdivision": recipe.patch is None,
        "scissor": not recipe.mapping.sides,
        "turning of the dome": recipe.mapping.aim == "straight",
    }
    return [name for name, missing in absent.items() if missing]


def approximated(recipe: Recipe, options: Options, *, cut: bool) -> list[str]:
    """What of a draw by this recipe is near the truth and not on it; cut: on the CPU."""
    mapping, fog = recipe.mapping, recipe.scene.fog
    found = [_edges(recipe, options, cut=cut)]
    if mapping.method == "paper":
        found.append("colours and textures run evenly in the picture, not on the surface")
        found.append("depth is planar")
    if mapping.face:
        found.append("the faces are resampled, which softens")
    if recipe.patch is not None and recipe.patch.method == "geometry":
        found.append("neighbours under unlike lights or textures may meet in vertices of their own")
    if cut and recipe.scene.lighting is not None:
        found.append("new vertices are lit for themselves")
    if fog == "distance" and mapping.place != "modelview":
        found.append("fog goes by planar depth")
    return found


def _edges(recipe: Recipe, options: Options, *, cut: bool) -> str:
    """How near an edge comes to its curve."""
    off = f"within {options.tolerance:g} pixels of its curve"
    if recipe.mapping.face:
        return "edges are straight on each face, as they are in space"
    if recipe.patch is not None or cut:
        return f"each edge is made of straight pieces, {off}"
    if options.method in ("paper", "vertex"):
        return "each edge is one straight piece, however long"
    return f"each edge is one straight piece, {off}"


def _lens(mapping: Mapping) -> str:
    return mapping.lens[0].rpartition("/")[2]


def _lighting(lighting: Lighting) -> list[str]:
    kinds = [light.kind for light in lighting.lights]
    lights = ", ".join(f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds)) or "no light"
    found = [f"lighting ({lights})"]
    found += ["two-sided"] if lighting.two_sided else []
    found += ["local viewer"] if lighting.local_viewer else []
    found += ["separate specular"] if lighting.separate_specular else []
    found += ["material by colour"] if lighting.color_material else []
    found += ["material by vertex"] if lighting.vertex_material else []
    return found


def _texture(unit: int) -> str:
    return f"texture {unit}"
