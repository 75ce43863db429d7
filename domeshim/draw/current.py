"""The current value of each vertex attribute in GL: set, and asked for."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import c_float

import numpy as np
from numpy.typing import NDArray

from domeshim.driver import Driver
from domeshim.record.attributes import MATERIAL_PARTS

_TEXTURE0, _ACTIVE_TEXTURE, _CURRENT_TEXTURE_COORDS = 0x84C0, 0x84E0, 0x0B03
_CURRENT = {"color": 0x0B00, "normal": 0x0B02, "secondary": 0x8459, "fog": 0x8453, "edge": 0x0B43}
_FACES = {"front": 0x0404, "back": 0x0405}

Setter = Callable[..., None]


def current_setters(driver: Driver) -> dict[str, Setter]:
    """The function that makes each attribute's value current."""

    def texture(unit: int) -> Setter:
        return lambda *values: driver.glMultiTexCoord4f(_TEXTURE0 + unit, *values)

    def material(face: int, part: int) -> Setter:
        return lambda *values: driver.glMaterialfv(face, part, (c_float * 4)(*values))

    return {
        "color": driver.glColor4f,
        "normal": driver.glNormal3f,
        "secondary": driver.glSecondaryColor3f,
        "fog": driver.glFogCoordf,
        "edge": lambda value: driver.glEdgeFlag(int(value)),
        **{f"texture{unit}": texture(unit) for unit in range(8)},
        **{
            f"{side} {name}": material(face, part)
            for side, face in _FACES.items()
            for name, part in MATERIAL_PARTS.items()
        },
    }


def current_value(driver: Driver, name: str, size: int) -> NDArray[np.float32]:
    """An attribute's current value, as so many numbers."""
    values = (c_float * 4)()
    if name.startswith("texture"):
        active = driver.integer(_ACTIVE_TEXTURE)
        driver.glActiveTexture(_TEXTURE0 + int(name[-1]))
        driver.glGetFloatv(_CURRENT_TEXTURE_COORDS, values)
        driver.glActiveTexture(active)
    elif " " in name:
        face, part = name.split()
        driver.glGetMaterialfv(_FACES[face], MATERIAL_PARTS[part], values)
    else:
        driver.glGetFloatv(_CURRENT[name], values)
    return np.array(values[:size], np.float32)
