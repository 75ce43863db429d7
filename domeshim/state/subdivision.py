"""Whether a mesh has to be subdivided to keep the tolerance, by which method, and how finely."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Literal, NamedTuple

from domeshim.driver import Driver
from domeshim.lens.detail import pieces_per_radian
from domeshim.lens.models import Lens
from domeshim.lens.orientation import Orientation
from domeshim.options import Options
from domeshim.shading.geometry import most_pieces
from domeshim.shading.recipe import Scene
from domeshim.window.frame import Frame

Method = Literal["tessellate", "geometry", "cpu"]
"""What subdivides."""

_ORDER: dict[Method, str] = {
    "tessellate": "tessellation shaders",
    "geometry": "geometry shaders",
    "cpu": "",
}
"""From the cheapest on, with what each needs of GL."""
_OLDEST = {"tessellate": (4, 0), "geometry": (3, 2), "cpu": (0, 0)}
"""The version of GL from which on each is there."""

_MOST_PIECES = 60
"""A little under the 64 pieces that every tessellator has."""
_WIDEST = 1.75
"""Within this angle a triangle's inside follows its edges, radians."""


class Subdivision(NamedTuple):
    """What a mesh needs to keep the tolerance."""

    method: Method
    widest: float
    """The angle up to which the method draws an edge well, radians."""
    split: bool
    """Some edge may be wider, and is to be halved first."""


def method_of(wanted: str, driver: Driver, say: Callable[[str], None]) -> Method | None:
    """The method that subdivides, given the user's; None for those that do not. What is missing is said."""
    if wanted in ("paper", "vertex"):
        return None
    methods = list(_ORDER)
    first: Method = "tessellate" if wanted == "auto" else wanted  # type: ignore[assignment] # options.py
    for method in methods[methods.index(first) :]:
        if driver.version >= _OLDEST[method]:
            if method != first:
                say(f"this OpenGL has no {_ORDER[first]}: long edges are subdivided by method {method}")
            return method
    raise AssertionError("method cpu asks nothing of GL")


class Tolerance:
    """What DOME_TOLERANCE asks of a lens in a frame."""

    def __init__(
        self, options: Options, lens: Lens, orientation: Orientation, frame: Frame, method: Method | None
    ) -> None:
        self._method = method
        self._always = options.method in ("tessellate", "geometry")
        radius = frame.square[2] / 2
        self.detail = pieces_per_radian(lens, options.fov, radius, options.tolerance, orientation)
        """How many pieces an arc of one radian needs."""
        whole = 0.0 if self._always else min(1 / self.detail, math.pi / 2)
        self.far = 0.5 / math.tan(whole / 2) if whole else math.inf
        """From how far an edge of length 1 surely needs nothing, if anything does not."""

    def broken_by(self, angle: float) -> bool:
        """An edge of this angle, radians, is off by too much as one straight piece."""
        return angle * self.detail > 1

    def subdivision(self, angle: float, scene: Callable[[], Scene]) -> Subdivision | None:
        """What a mesh needs whose edges subtend at most this angle, radians; scene: tells what is drawn."""
        method = self._method
        if method is None or not (self._always or self.broken_by(angle)):
            return None
        most = 1
        if method != "cpu":
            most = _MOST_PIECES if method == "tessellate" else most_pieces(scene(), "triangles")
        widest = min(_WIDEST, most / self.detail)
        return Subdivision(method, widest, angle > widest)
