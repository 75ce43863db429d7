"""What the program has enabled, asked of GL: the Scene of the recipe.

Asking is in groups, each asked again only after a call that could have changed it.
"""

from __future__ import annotations

from ctypes import c_float, c_int
from typing import TYPE_CHECKING, Literal

from domeshim.shading.recipe import ColorMaterial, Face, Light, Lighting, Scene, Texgen, Texture

if TYPE_CHECKING:
    from domeshim.driver import Driver

GL_LIGHTING, GL_LIGHT0, GL_COLOR_MATERIAL = 0x0B50, 0x4000, 0x0B57
GL_NORMALIZE, GL_RESCALE_NORMAL = 0x0BA1, 0x803A
GL_TEXTURES = (0x0DE1, 0x0DE0, 0x806F, 0x8513, 0x84F5)  # 2D, 1D, 3D, cube map, rectangle
GL_TEXTURE_GEN_S = 0x0C60
GL_FOG, GL_COLOR_SUM, GL_CLIP_PLANE0 = 0x0B60, 0x8458, 0x3000

GROUP_OF: dict[int, str] = {
    GL_LIGHTING: "lit",
    **dict.fromkeys((GL_COLOR_MATERIAL, GL_NORMALIZE, GL_RESCALE_NORMAL), "lighting"),
    **{GL_LIGHT0 + i: "lighting" for i in range(8)},
    **dict.fromkeys(GL_TEXTURES, "textured"),
    **{GL_TEXTURE_GEN_S + i: "textures" for i in range(4)},
    **dict.fromkeys((GL_FOG, GL_COLOR_SUM), "rest"),
    **{GL_CLIP_PLANE0 + i: "rest" for i in range(8)},
}
"""The group that glEnable or glDisable of a capability touches; other capabilities touch none."""

GROUPS = frozenset(("lit", "lighting", "textured", "textures", "rest"))
"""lit and textured: only whether lighting and textures are enabled; lighting and textures: all about them."""

_LIGHT_MODEL_TWO_SIDE, _LIGHT_MODEL_LOCAL_VIEWER, _LIGHT_MODEL_COLOR_CONTROL = 0x0B52, 0x0B51, 0x81F8
_SEPARATE_SPECULAR = 0x81FA
_COLOR_MATERIAL_FACE, _COLOR_MATERIAL_PARAMETER = 0x0B55, 0x0B56
_POSITION, _SPOT_CUTOFF = 0x1203, 0x1206
_TEXTURE_GEN_MODE, _TEXTURE_MATRIX, _ACTIVE_TEXTURE, _TEXTURE0 = 0x2500, 0x0BA8, 0x84E0, 0x84C0
_FOG_COORD_SRC, _FOG_COORD = 0x8450, 0x8451
_POINT_DISTANCE_ATTENUATION = 0x8129

_FACES: dict[int, Face] = {0x0404: "front", 0x0405: "back", 0x0408: "both"}
_FOLLOWS: dict[int, tuple[Literal["ambient", "diffuse", "specular", "emission"], ...]] = {
    0x1200: ("ambient",),
    0x1201: ("diffuse",),
    0x1202: ("specular",),
    0x1600: ("emission",),
    0x1602: ("ambient", "diffuse"),
}
_TEXGENS: dict[int, Texgen] = {
    0x2401: "object",
    0x2400: "eye",
    0x2402: "sphere",
    0x8512: "reflection",
    0x8511: "normal",
}
_MOST = 1000
"""So many scenes are remembered."""
_IDENTITY = (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0)


class SceneState:
    """The scene of one context; stale groups are asked for again at the next question."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._lit = False
        self._lighting: Lighting | None = None
        """As it is, or would be, while lighting is enabled; None: not asked for yet."""
        self._normals: Literal["plain", "rescaled", "unit"] = "plain"
        self._textures: tuple[Texture, ...] = ()
        self._units: dict[int, Texture] = {}
        """Each unit that had a texture since textures were stale, as it is or would be."""
        self._rest = Scene()
        self._scene: Scene | None = None
        self._scenes: dict[tuple[object, ...], Scene] = {}
        self.stale = set(GROUPS)
        self.vertex_material: Face | None = None
        """The face whose material comes with each vertex of the next draw."""
        self.texture_units = 1
        """How many texture units the program has ever made active."""
        self.read_units: frozenset[int] = frozenset()
        """Units whose coordinates a fragment shader reads, though none of their textures need be enabled."""

    def scene(self) -> Scene:
        """What the program has enabled now; the same object for the same answer."""
        if self._scene is None or self.stale:
            self._ask()
            self._scene = self._known()
        return self._scene

    def _ask(self) -> None:
        stale = self.stale
        if "lighting" in stale:
            self._lighting = None
            self._normals = self._ask_normals()
        if "lighting" in stale or "lit" in stale:
            self._lit = bool(self._driver.glIsEnabled(GL_LIGHTING))
        if self._lit and self._lighting is None:
            self._lighting = self._ask_lighting()
        if "textures" in stale:
            self._units.clear()
        if "textures" in stale or "textured" in stale:
            self._textures = self._ask_textures()
        if "rest" in stale:
            self._rest = self._ask_rest()
        stale.clear()

    def _known(self) -> Scene:
        lighting = self._lighting if self._lit else None
        key = (lighting, self._normals, self._textures, self._rest)
        known = self._scenes.get(key)
        if known is not None:
            return known
        if len(self._scenes) >= _MOST:
            self._scenes.clear()
        found = Scene(
            lighting=lighting,
            normals=self._normals,
            textures=self._textures,
            fog=self._rest.fog,
            clip_planes=self._rest.clip_planes,
            secondary_color=self._rest.secondary_color,
            point_attenuation=self._rest.point_attenuation,
        )
        self._scenes[key] = found
        return found

    def _ask_normals(self) -> Literal["plain", "rescaled", "unit"]:
        gl = self._driver
        if gl.glIsEnabled(GL_NORMALIZE):
            return "unit"
        return "rescaled" if gl.glIsEnabled(GL_RESCALE_NORMAL) else "plain"

    def _ask_lighting(self) -> Lighting:
        gl = self._driver
        return Lighting(
            lights=tuple(self._light(i) for i in range(8) if gl.glIsEnabled(GL_LIGHT0 + i)),
            two_sided=bool(gl.integer(_LIGHT_MODEL_TWO_SIDE)),
            local_viewer=bool(gl.integer(_LIGHT_MODEL_LOCAL_VIEWER)),
            separate_specular=gl.integer(_LIGHT_MODEL_COLOR_CONTROL) == _SEPARATE_SPECULAR,
            color_material=self._color_material() if gl.glIsEnabled(GL_COLOR_MATERIAL) else None,
            vertex_material=self.vertex_material,
        )

    def _light(self, index: int) -> Light:
        position, cutoff = (c_float * 4)(), c_float()
        self._driver.glGetLightfv(GL_LIGHT0 + index, _POSITION, position)
        if position[3] == 0:
            return Light(index, "directional")
        self._driver.glGetLightfv(GL_LIGHT0 + index, _SPOT_CUTOFF, cutoff)
        return Light(index, "positional" if cutoff.value == 180 else "spot")

    def _color_material(self) -> ColorMaterial:
        return ColorMaterial(
            _FACES[self._driver.integer(_COLOR_MATERIAL_FACE)],
            _FOLLOWS[self._driver.integer(_COLOR_MATERIAL_PARAMETER)],
        )

    def _ask_textures(self) -> tuple[Texture, ...]:
        gl = self._driver
        units = max(self.texture_units, *(unit + 1 for unit in self.read_units), 1)
        if units == 1:
            return tuple(self._unit_texture(0))
        active = gl.integer(_ACTIVE_TEXTURE)
        found: list[Texture] = []
        for unit in range(units):
            gl.glActiveTexture(_TEXTURE0 + unit)
            found += self._unit_texture(unit)
        gl.glActiveTexture(active)
        return tuple(found)

    def _unit_texture(self, unit: int) -> list[Texture]:
        gl = self._driver
        known = self._units.get(unit)
        if known is not None and known == Texture(unit):
            return [known]  # its coordinates cost less than another program, enabled or not
        if unit not in self.read_units and not any(map(gl.glIsEnabled, gl.texture_targets)):
            return []
        if known is not None:
            return [known]
        s, t, r, q = (self._texgen(GL_TEXTURE_GEN_S + axis, 0x2000 + axis) for axis in range(4))
        matrix = (c_float * 16)()
        gl.glGetFloatv(_TEXTURE_MATRIX, matrix)
        self._units[unit] = Texture(unit, (s, t, r, q), tuple(matrix) != _IDENTITY)
        return [self._units[unit]]

    def _texgen(self, capability: int, coordinate: int) -> Texgen | None:
        if not self._driver.glIsEnabled(capability):
            return None
        mode = c_int()
        self._driver.glGetTexGeniv(coordinate, _TEXTURE_GEN_MODE, mode)
        return _TEXGENS[mode.value]

    def _ask_rest(self) -> Scene:
        gl = self._driver
        attenuation = (c_float * 3)()
        gl.glGetFloatv(_POINT_DISTANCE_ATTENUATION, attenuation)
        fog: Literal["distance", "attribute"] | None = None
        if gl.glIsEnabled(GL_FOG):
            fog = "attribute" if gl.integer(_FOG_COORD_SRC) == _FOG_COORD else "distance"
        return Scene(
            fog=fog,
            clip_planes=tuple(i for i in range(gl.clip_planes) if gl.glIsEnabled(GL_CLIP_PLANE0 + i)),
            secondary_color=bool(gl.glIsEnabled(GL_COLOR_SUM)),
            point_attenuation=tuple(attenuation) != (1.0, 0.0, 0.0),
        )
