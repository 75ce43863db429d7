"""Whether a mesh has to be subdivided to keep the tolerance, by which method, and how finely."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.primitives import Primitives
from domeshim.draw.split import Floats, Limit, edges_of
from domeshim.driver import Driver
from domeshim.lens.detail import pieces_per_radian, room_behind, straight_behind
from domeshim.lens.landing import Lens
from domeshim.lens.orientation import Orientation
from domeshim.options import Options
from domeshim.shading.recipe import Scene
from domeshim.state.perspective import Matrix
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

FEW_PIECES = 4
"""Where no edge has more, looking for quads among triangles costs more than it saves."""
_MOST_PIECES = 16
"""Of the 64 pieces that every tessellator has: with more, the inside follows the edges less evenly."""
_WIDEST = 1.2
"""Within this angle a triangle's inside follows its edges, radians."""
_SEATED = 0.25
"""From a seat off the centre an angle may look this much smaller than it is on the lens."""


class Subdivision(NamedTuple):
    """What a mesh needs to keep the tolerance."""

    method: Method | None
    """None: every edge is near enough as one straight piece."""
    limit: Limit
    """Up to what angle the method draws an edge well."""
    split: bool
    """Some edge may be wider, and is to be halved first."""
    lengthened: bool = False
    """Some line may be shorter than a pixel, and the driver would leave it out."""


class Choice(NamedTuple):
    """What each primitive of a mesh needs to keep the tolerance."""

    levels: NDArray[np.int8]
    """(n,)"""
    subdivisions: tuple[Subdivision | None, ...]
    """By level: what stays whole, what is cut in pieces, what is split first."""
    pieces: float
    """No edge of level 1 needs more than about so many."""


def method_of(wanted: str, driver: Driver, say: Callable[[str], None]) -> Method | None:
    """The method that subdivides, given the user's; None for those that do not. What is missing is said."""
    if wanted.startswith(("paper", "vertex", "cubemap")):
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
        self,
        options: Options,
        lens: Lens,
        orientation: Orientation,
        frame: Frame,
        method: Method | None,
        few: Method | None = None,
    ) -> None:
        """few: the method where a mesh's edges need few pieces, if it is another."""
        self._method = method
        self._few = few or method
        self._always = options.method in ("tessellate", "geometry")
        _, _, width, height = frame.square
        self.half = (width / 2, height / 2)
        """Half of the disc's square, in pixels."""
        self.pixel = math.radians(options.fov) / width
        """The angle of a pixel, on average."""
        radius = width / 2 * (frame.keystone.stretch if frame.keystone else 1.0)
        shape = (1.0, height / width)
        self.detail = pieces_per_radian(lens, radius, options.tolerance, orientation, shape)
        """How many pieces an arc of one radian needs that stays one radian away from straight behind."""
        x, y, z = straight_behind(orientation).tolist()
        self.aft: tuple[float, float, float] = (x, y, z)
        """The direction straight behind, in eye space."""
        self.left_out = lens.left_out(self.detail)
        """The angle from straight behind, radians, within which the lens draws nothing."""
        least = self.left_out * (_SEATED if orientation.off_centre else 1.0)
        self.least = min(least, 1.0) if lens.singular else 1.0
        """The same as the viewer sees it, where it makes edges be cut finer, else 1."""
        self._limits: dict[float, Limit] = {}
        self._widest_tessellated = self.limit(min(_WIDEST, _MOST_PIECES / self.detail))
        quick = not self._always and self.least == 1
        whole = min(1 / self.detail, math.pi / 2) if quick else 0.0
        self.far = 0.5 / math.tan(whole / 2) if whole else math.inf
        """From how far an edge of length 1 surely needs nothing, if anything does not."""

    @property
    def widest(self) -> float:
        """Up to what angle tessellation shaders draw an edge well, radians, away from straight behind."""
        return min(_WIDEST, _MOST_PIECES / self.detail)

    def limit(self, widest: float) -> Limit:
        """The limit to edges of at most this angle, radians, away from straight behind."""
        if widest not in self._limits:
            self._limits[widest] = Limit(widest, self.aft, self.least, 1 / self.detail)
        return self._limits[widest]

    def broken_by(self, angle: float, behind: float = math.pi) -> bool:
        """An edge of this angle is off by too much as one straight piece.

        behind: its least angle from straight behind; both in radians.
        """
        share = 1.0 if self.least == 1 else min(float(room_behind(np.array(behind), self.least)), 1.0)
        return angle * self.detail > share

    def subdivision(self, angle: float, behind: float, scene: Callable[[], Scene]) -> Subdivision | None:
        """What a mesh needs whose edges subtend at most this angle, and come this close to straight behind.

        angle, behind: radians; scene: tells what is drawn.
        """
        if self._method is None or not (self._always or self.broken_by(angle, behind)):
            return None
        limit = self._widest(scene)
        return Subdivision(self._method, limit, angle > limit.at(behind))

    def choice(self, primitives: Primitives, to_eye: Matrix, scene: Callable[[], Scene]) -> Choice | None:
        """What each primitive of a mesh needs; None where all are to be treated alike.

        to_eye: (4, 4), the primitives' space to eye space; scene: tells what is drawn. Most are so far away
        that their spheres tell; the others' edges are looked at as the shader does.
        """
        if self._method is None or self._always:
            return None
        limit, corners = self._widest(scene), primitives.corners
        enough, room = (1 / self.detail if self.least == 1 else 0.0), 1.0
        angles = primitives.spheres.largest_angles(to_eye, enough)
        if self.least < 1:
            behind = primitives.spheres.least_angles_from(self.aft, to_eye)
            room = np.minimum(room_behind(behind, self.least), 1.0)
        levels = np.zeros(len(angles), np.int8)
        near = np.flatnonzero(angles > room / self.detail)
        near = near[_over(corners[near], to_eye, self.limit(1 / self.detail))]
        levels[near] = 1
        if self.least < 1 or (angles[near] > limit.widest).any():
            levels[near[_over(corners[near], to_eye, limit)]] = 2
        pieces = self.detail * float(angles[levels == 1].max(initial=0.0))
        cut = Subdivision(self._method_of(pieces, scene), limit, split=False)
        return Choice(levels, (None, cut, Subdivision(self._method, limit, split=True)), pieces)

    def _method_of(self, pieces: float, scene: Callable[[], Scene]) -> Method | None:
        """What cuts a mesh whose edges need at most so many pieces; near straight behind they need more."""
        if self._few == self._method or pieces > FEW_PIECES or self.least < 1:
            return self._method
        from domeshim.shading.geometry import most_pieces  # noqa: PLC0415 - only this method pays

        enough = most_pieces(scene(), "triangles") >= 2 * pieces  # for they are cut finer than they need
        return self._few if enough else self._method

    def _widest(self, scene: Callable[[], Scene]) -> Limit:
        """The limit to edges that the method draws well."""
        if self._method == "tessellate":
            return self._widest_tessellated
        most = 1
        if self._method == "geometry":
            from domeshim.shading.geometry import most_pieces  # noqa: PLC0415 - only this method pays

            most = most_pieces(scene(), "triangles")
        return self.limit(min(_WIDEST, most / self.detail))


def _over(corners: Floats, to_eye: Matrix, limit: Limit) -> NDArray[np.bool_]:
    """(n,): which primitives have an edge over its limit, or no place; corners: (n, 2 or 3, 3)."""
    if not len(corners):
        return np.zeros(0, np.bool_)
    homogeneous = np.concatenate([corners.astype(float), np.ones_like(corners[..., :1])], -1)
    with np.errstate(invalid="ignore"):
        eye = (homogeneous.reshape(-1, 4) @ to_eye.T).reshape(homogeneous.shape)  # one product, not n
        angles, limits, _ = edges_of(eye, limit)
    over: NDArray[np.bool_] = np.logical_not((angles <= limits).all(1))
    return over
