"""The recipe: all that a scene needs of the dome's vertex program, frozen and hashable.

What is not in the recipe is not in the shader. The values themselves (a light's colour, a plane) are the
driver's built-in uniforms and never part of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, NamedTuple

Texgen = Literal["object", "eye", "sphere", "reflection", "normal"]
Face = Literal["front", "back", "both"]

MATERIAL_UNITS = {"emission": 3, "ambient": 4, "diffuse": 5, "specular": 6, "shininess": 7}
"""Which unit's texture coordinates carry each part of a material that is set inside glBegin..glEnd."""
PIECE_ATTRIBUTES = {"place": 6, "weights": 7, "pieces": 6}
"""The generic vertex attributes of a piece of a primitive, by number; pieces never goes with the others.

Some drivers lay generic attributes over the built-in ones; these two lie over none.
"""


PatchMethod = Literal["tessellate", "geometry", "cpu"]
"""Which shader subdivides, or that the CPU has done so."""


class Patch(NamedTuple):
    """What a draw hands over to be subdivided on the GPU, and how; or that it was on the CPU."""

    kind: Literal["quads", "triangles", "lines"]
    """Quads are parallelograms, and only tessellated."""
    method: PatchMethod = "tessellate"
    split: bool = False
    """Pieces of larger primitives: each vertex has the larger one's corner, and tells where its own lies."""
    lengthened: bool = False
    """Lines by method geometry that are shorter than a pixel are made as long as one."""

    @property
    def corners(self) -> int:
        """How many vertices it has."""
        return {"lines": 2, "triangles": 3, "quads": 4}[self.kind]

    @property
    def mode(self) -> int:
        """The mode to draw all of its vertices by: GL_PATCHES, or GL_LINES, GL_TRIANGLES."""
        if self.method == "tessellate":
            return 0x000E
        return 0x0001 if self.kind == "lines" else 0x0004


class Light(NamedTuple):
    """One enabled light by its number and kind."""

    number: int
    kind: Literal["directional", "positional", "spot"]


class ColorMaterial(NamedTuple):
    """GL_COLOR_MATERIAL: which of the material's colours follow the vertex colour, and on which face."""

    face: Face
    follows: tuple[Literal["ambient", "diffuse", "specular", "emission"], ...]


class Lighting(NamedTuple):
    """What the enabled lighting needs."""

    lights: tuple[Light, ...] = ()
    two_sided: bool = False
    local_viewer: bool = False
    separate_specular: bool = False
    color_material: ColorMaterial | None = None
    vertex_material: Face | None = None
    """The face whose material comes with each vertex, as texture coordinates of MATERIAL_UNITS."""


class Texture(NamedTuple):
    """One enabled texture unit: what makes each of s, t, r, q (None: the vertex's own), and a matrix."""

    unit: int
    generated: tuple[Texgen | None, Texgen | None, Texgen | None, Texgen | None] = (None, None, None, None)
    matrix: bool = False


@dataclass(frozen=True)
class Scene:
    """What the program has enabled, as far as a vertex program has to do it."""

    lighting: Lighting | None = None
    normals: Literal["plain", "rescaled", "unit"] = "plain"
    textures: tuple[Texture, ...] = ()
    fog: Literal["distance", "attribute"] | None = None
    clip_planes: tuple[int, ...] = ()
    secondary_color: bool = False
    point_attenuation: bool = False

    @property
    def uncoloured(self) -> Scene:
        """The same without all that makes its colours."""
        return Scene(clip_planes=self.clip_planes, point_attenuation=self.point_attenuation)


Clip = Literal["behind", "cone", "wedge"]
RADIAL = ("lens/equidistant", "bend/radial")


@dataclass(frozen=True)
class Mapping:
    """How the scene gets onto the disc."""

    method: Literal["vertex", "paper"] = "vertex"
    lens: tuple[str, ...] = RADIAL
    """The snippets that say where a direction lands."""
    place: Literal["modelview", "view", "panel"] = "modelview"
    aim: Literal["straight", "turned", "seated"] = "straight"
    """The snippet in glsl/aim, if any: how the dome stands to the program's view."""
    clip: Clip = "behind"
    """The snippet in glsl/clip that leaves out what is behind: a half space, a cone, a wedge."""
    near_behind: bool = False
    """Places close to straight behind are seen: edges there are cut finer."""
    beside: bool = False
    """As an eye sees it that stands beside the viewer's middle."""
    face: bool = False
    """Onto the faces of a cube by plain perspectives, not through the lens."""
    keystone: bool = False
    """The disc's square goes to four corners."""
    grid: bool = False
    """Vertices are brought onto the driver's own steps within a pixel."""
    sides: tuple[int, ...] = ()
    """The scissor's edges that cut a view on the dome: 0 left, 1 right, 2 bottom, 3 top."""
    raster: Literal["point", "nowhere"] | None = None
    """For glRasterPos, which no clip distance stops: points that are cut off, or all, go out of sight."""


Levels = Literal["whole", "cut", "patch"]
"""What shows its level of subdivision: what has none, what the CPU has cut, a patch."""


@dataclass(frozen=True)
class Recipe:
    """A vertex program in full: the mapping and the scene."""

    mapping: Mapping = Mapping()
    scene: Scene = Scene()
    patch: Patch | None = None
    """What is subdivided on the GPU, if anything."""
    levels: Levels | None = None
    """Colours are those of the number of pieces, not the scene's."""
    flat: bool = False
    """GL_FLAT: the pieces of a subdivided primitive all have the colour of its last vertex."""
    legacy: bool = False
    """OpenGL 2: there are no clip distances, and clip planes that pick parts of gl_ClipVertex stand in."""

    @property
    def clip_distances(self) -> tuple[int, ...]:
        """The clip distances of the mapping itself: the lowest numbers that the program leaves free."""
        return self._free[: self._wanted]

    @property
    def side_distances(self) -> tuple[int, ...]:
        """The clip distances of the scissor's sides."""
        return self._free[self._wanted : self._wanted + len(self.mapping.sides)]

    @property
    def distances(self) -> tuple[int, ...]:
        """All clip distances that this OpenGL has room for; what cuts most comes first.

        On OpenGL 2 the n-th of them is the n-th component of gl_ClipVertex. What is between two opposite
        sides is in front, so the mapping's own comes last there.
        """
        own, planes, sides = self.clip_distances, self.scene.clip_planes, self.side_distances
        if self.mapping.place == "panel":
            wanted = (*planes, *own)
        elif any({side, side + 1} <= set(self.mapping.sides) for side in (0, 2)):
            wanted = (*sides, *planes, *own)
        else:
            wanted = (*own, *planes, *sides)
        return wanted[: 4 if self.legacy else 8]

    @property
    def left_out(self) -> bool:
        """Some clip distance finds no room, and what it would cut off is seen."""
        cuts = {*self.scene.clip_planes, *self.side_distances}
        if self.mapping.place == "panel":
            cuts |= set(self.clip_distances)
        room = self._wanted + len(self.mapping.sides) <= len(self._free)
        return not (room and cuts <= set(self.distances))

    def distance(self, number: int) -> str | None:
        """Where the vertex shader writes a clip distance; None where there is no room for it."""
        if number not in self.distances:
            return None
        if self.legacy:
            return f"gl_ClipVertex.{'xyzw'[self.distances.index(number)]}"
        return f"gl_ClipDistance[{number}]"

    @property
    def _wanted(self) -> int:
        if self.mapping.place == "panel":
            return 4 if self.mapping.method != "paper" else 0
        return 0 if self.mapping.method == "paper" or self.mapping.face else 1

    @property
    def _free(self) -> tuple[int, ...]:
        return tuple(i for i in range(6 if self.legacy else 8) if i not in self.scene.clip_planes)
