"""The names by which a program gives a vertex and its attributes, decoded."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

_NAME = re.compile(
    r"gl(?P<what>Vertex|Color|Normal|TexCoord|MultiTexCoord|SecondaryColor|FogCoord|EdgeFlag)"
    r"(?P<count>[1234]?)(?P<type>ub|us|ui|[bsifd]?)(?P<vector>v?)(ARB|EXT)?"
)

_NORMALISED = {"Color", "SecondaryColor", "Normal"}
_FIXED_COUNT = {"Normal": 3, "TexCoord": 2, "FogCoord": 1, "EdgeFlag": 1}
"""Where the name says no number; PyOpenGL's glTexCoord is glTexCoord2d."""

MATERIAL_PARTS: dict[str, int] = {
    "emission": 0x1600,
    "ambient": 0x1200,
    "diffuse": 0x1201,
    "specular": 0x1202,
    "shininess": 0x1601,
}
"""The parts of a material that glMaterial sets between glBegin and glEnd, by GL's name for each."""

DEFAULTS: dict[str, tuple[float, ...]] = {
    "color": (0.0, 0.0, 0.0, 1.0),
    "normal": (0.0, 0.0, 0.0),
    "secondary": (0.0, 0.0, 0.0),
    "fog": (0.0,),
    "edge": (1.0,),
    **{f"texture{unit}": (0.0, 0.0, 0.0, 1.0) for unit in range(8)},
    **{f"{face} {part}": (0.0, 0.0, 0.0, 1.0) for face in ("front", "back") for part in MATERIAL_PARTS},
}
"""Each attribute, with the values that a shorter call leaves out; their number is the attribute's size.

A material's shininess is the first of four values, so that all its parts are alike.
"""


@dataclass(frozen=True)
class Setter:
    """One GL name: glColor3ubv sets "color" by a vector of 3 values, each times 1/255."""

    attribute: str
    """A key of DEFAULTS; "vertex"; or "texture" where the first argument names the unit."""
    count: int | None
    """How many values; None: as many as are given (glVertex, glColor)."""
    vector: bool
    kind: str
    """GL's type, by the name's ending: f, ub; empty where the name has none."""
    scale: float
    offset: float
    bytes_as: tuple[float, ...] = ()
    """Where values are bytes: what each of the 256 means; an integer beyond them wraps, as in C."""


def setter(name: str) -> Setter | None:
    """What a GL name sets, or None where it sets no vertex attribute."""
    match = _NAME.fullmatch(name)
    if match is None:
        return None
    what, kind = match["what"], match["type"]
    count = int(match["count"]) if match["count"] else _FIXED_COUNT.get(what)
    scale, offset = _conversion(kind) if what in _NORMALISED else (1.0, 0.0)
    attribute = {
        "TexCoord": "texture0",
        "MultiTexCoord": "texture",
        "SecondaryColor": "secondary",
        "FogCoord": "fog",
    }
    return Setter(
        attribute.get(what, "edge" if what == "EdgeFlag" else what.lower()),
        count,
        match["vector"] == "v",
        kind,
        scale,
        offset,
        _bytes(kind, scale, offset) if what in _NORMALISED and kind in ("b", "ub") else (),
    )


def _bytes(kind: str, scale: float, offset: float) -> tuple[float, ...]:
    signed = 256 if kind == "b" else 0
    return tuple(scale * (v - signed if v > 127 else v) + offset for v in range(256))


_MATERIAL = re.compile(r"glMaterial(?P<type>[if]?)v?")
_MATERIAL_FACES = {0x0404: ("front",), 0x0405: ("back",), 0x0408: ("front", "back")}
_AMBIENT_AND_DIFFUSE = 0x1602


def material(name: str, face: int, parameter: int, values: Sequence[float]) -> dict[str, tuple[float, ...]]:
    """What a call of the glMaterial family sets, by attribute; empty where GL itself reports an error."""
    match = _MATERIAL.fullmatch(name)
    assert match is not None
    parts = [
        part
        for part, own in MATERIAL_PARTS.items()
        if parameter == own or (parameter == _AMBIENT_AND_DIFFUSE and part in ("ambient", "diffuse"))
    ]
    if parts == ["shininess"]:
        four = (float(values[0]), 0.0, 0.0, 1.0)
    else:
        scale, offset = _conversion(match["type"])
        given = [scale * v + offset for v in values[:4]]
        r, g, b, a = (
            given + [0.0, 0.0, 0.0, 1.0][len(given) :]
        )  # beyond a short array GL reads what lies there
        four = (r, g, b, a)
    return {f"{side} {part}": four for side in _MATERIAL_FACES.get(face, ()) for part in parts}


def _conversion(kind: str) -> tuple[float, float]:
    """OpenGL 2.1, table 2.9: integers become [0, 1] or [-1, 1]; value = scale * integer + offset."""
    bits = {"b": 8, "s": 16, "i": 32}.get(kind.removeprefix("u"))
    if bits is None:
        return 1.0, 0.0
    most = float(2**bits - 1)
    return (1 / most, 0.0) if kind.startswith("u") else (2 / most, 1 / most)
