"""The names by which a program gives a vertex and its attributes, decoded."""

from __future__ import annotations

import re
from dataclasses import dataclass

_NAME = re.compile(
    r"gl(?P<what>Vertex|Color|Normal|TexCoord|MultiTexCoord|SecondaryColor|FogCoord|EdgeFlag)"
    r"(?P<count>[1234]?)(?P<type>ub|us|ui|[bsifd]?)(?P<vector>v?)(ARB|EXT)?"
)

_NORMALISED = {"Color", "SecondaryColor", "Normal"}
_FIXED_COUNT = {"Normal": 3, "FogCoord": 1, "EdgeFlag": 1}

DEFAULTS: dict[str, tuple[float, ...]] = {
    "color": (0.0, 0.0, 0.0, 1.0),
    "normal": (0.0, 0.0, 0.0),
    "secondary": (0.0, 0.0, 0.0),
    "fog": (0.0,),
    "edge": (1.0,),
    **{f"texture{unit}": (0.0, 0.0, 0.0, 1.0) for unit in range(8)},
}
"""Each attribute, with the values that a shorter call leaves out; their number is the attribute's size."""


@dataclass(frozen=True)
class Setter:
    """One GL name: glColor3ubv sets "color" by a vector of 3 values, each times 1/255."""

    attribute: str
    """A key of DEFAULTS; "vertex"; or "texture" where the first argument names the unit."""
    count: int | None
    """How many values; None: as many as are given (glVertex, glColor, glTexCoord)."""
    vector: bool
    scale: float
    offset: float


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
        scale,
        offset,
    )


def _conversion(kind: str) -> tuple[float, float]:
    """OpenGL 2.1, table 2.9: integers become [0, 1] or [-1, 1]; value = scale * integer + offset."""
    bits = {"b": 8, "s": 16, "i": 32}.get(kind.removeprefix("u"))
    if bits is None:
        return 1.0, 0.0
    most = float(2**bits - 1)
    return (1 / most, 0.0) if kind.startswith("u") else (2 / most, 1 / most)
