"""Stiff and extreme geometry: what a dome's mathematics has to bear, case by case."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.patches import corners, kind_of, outlines

LINES, TRIANGLES, QUADS = 1, 4, 7

_SIDES = {TRIANGLES: 3, QUADS: 4}

Vertices = Sequence[Sequence[float]]


@dataclass(frozen=True)
class Extreme:
    """One case: what a program draws, seen how."""

    name: str
    mode: int
    """GL's."""
    vertices: Vertices
    """x, y, z, or x, y, z, w."""
    fov: float = 180.0
    lens: tuple[str, tuple[float, ...]] = ("equidistant", ())
    tilt: float = 0.0
    near: float = 1e-3
    far: float = 1e5
    unseen: tuple[int, ...] = ()
    """Which primitives, counted from 0, have no place, no extent or only one direction: not to be missed."""
    outline: bool = True
    """A surface ends at its outline; False where it is closed."""

    @property
    def edges(self) -> NDArray[np.float64]:
        """(m, 2, 4): the ends of the lines, or of the surfaces' outlines, that are to be seen."""
        seen = np.delete(self._primitives, self.unseen, 0).reshape(-1, 2)
        return self.positions.astype(float)[seen if self.outline else seen[:0]]

    @property
    def allowed(self) -> NDArray[np.float64]:
        """(n, 2, 4): what may be seen, and need not, of the unseen: their corners and edges."""
        ends = self.positions.astype(float)[self._primitives[list(self.unseen)].reshape(-1, 2)]
        ends = np.concatenate([ends, ends[:, [0, 0]], ends[:, [1, 1]]])
        placed = np.isfinite(ends).all(-1) & (np.abs(ends[..., :3]).max(-1, initial=0) > 0)
        return np.asarray(ends[placed.all(1)])

    @property
    def _primitives(self) -> NDArray[np.int64]:
        """(m, k, 2): the vertices at both ends of each primitive's k edges."""
        count = len(self.vertices)
        if kind_of(self.mode) == "lines":
            return corners(self.mode, count)[:, None]
        return outlines(self.mode, count).reshape(count // _SIDES[self.mode], -1, 2)

    @property
    def positions(self) -> NDArray[np.float32]:
        """(n, 4): the vertices as the program's single precision has them."""
        rows = [(*vertex, 1.0) if len(vertex) == 3 else tuple(vertex) for vertex in self.vertices]
        return np.array(rows, np.float32)


def _box(low: float, high: float) -> Vertices:
    """The six quads of a room."""
    c = [(x, y, z) for x in (low, high) for y in (low, high) for z in (low, high)]
    faces = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    return [c[k] for face in faces for k in face]


def _floor(height: float, size: float) -> Vertices:
    return [(-size, height, -size), (size, height, -size), (size, height, size), (-size, height, size)]


_NAN, _INF = float("nan"), float("inf")
_STEEP = ("polynomial", (0.3, 0.0, 0.0, 0.0, 0.055))
"""Six times as steep at the rim of 180 degrees as in the middle."""
_FLAT = ("polynomial", (0.95, 0.0, -0.127, 0.0, 0.0))
"""A hundredth as steep at the rim of 180 degrees as in the middle."""

EXTREMES = (
    Extreme("edge of 172 degrees", LINES, [(-50, 3, -2), (50, 3, -2)]),
    Extreme("edge of 179.98 degrees, a hair from the eye", LINES, [(-100, 0.01, -0.01), (100, 0.01, -0.01)]),
    Extreme(
        "edge a billionth from the eye", LINES, [(-100, 1e-7, -1e-7), (100, 1e-7, -1e-7)], near=1e-9, far=1e3
    ),
    Extreme("edge through the eye", LINES, [(-3, -4, 5), (3, 4, -5)], unseen=(0,)),
    Extreme("edge that begins in the eye", LINES, [(0, 0, 0), (3, 4, -5)], unseen=(0,)),
    Extreme("edge from 0.02 to 1100 away", LINES, [(0.01, 0.02, -0.01), (500, 30, -1000)]),
    Extreme(
        "ends 1e-30 and 1e30 away", LINES, [(1e-30, 0, -1e-30), (-3e29, 8e29, -1e29)], near=1e-32, far=1e32
    ),
    Extreme("all at 1e-30", LINES, [(-3e-30, 1e-30, -1e-30), (2e-30, 2e-30, -1e-30)], near=1e-32, far=1e-28),
    Extreme("all at 1e30", LINES, [(-3e30, 1e30, -1e30), (2e30, 2e30, -1e30)], near=1e27, far=1e32),
    Extreme("near and far 1e7 apart", LINES, [(0.002, 0.001, -0.001), (-7e3, 2e3, -1e3)], near=1e-3, far=1e4),
    Extreme("cut by near and far", LINES, [(0.02, 0.01, -0.01), (-7e3, 2e3, -1e3)], near=0.1, far=1e3),
    Extreme("w = 0 at one end", LINES, [(1, 2, -3, 1), (-4, 1, -1, 0)], near=0.1, far=1e30),
    Extreme("w = 0 at both ends", LINES, [(1, 2, -3, 0), (-4, 1, -1, 0)], near=0.1, far=1e30),
    Extreme("w < 0", LINES, [(5, -3, 2, -1), (-5, -3, 2, -2)]),
    Extreme("w of 1e-6 and 1e6", LINES, [(5e-6, 3e-6, -2e-6, 1e-6), (-5e6, 3e6, -2e6, 1e6)]),
    Extreme("through the axis", LINES, [(-4, -3, -2), (4, 3, -2)]),
    Extreme("along the axis", LINES, [(0, 0, -1), (0, 0, -500)]),
    Extreme("a ten-millionth off the axis", LINES, [(1e-7, -3, -2), (1e-7, 3, -2)]),
    Extreme("exactly on the rim", LINES, [(-1, 0.2, 0), (0.3, 1, 0)]),
    Extreme("across the rim", LINES, [(-2, 1.5, 0.5), (0.5, 1.5, -0.1)]),
    Extreme("wholly behind", LINES, [(-2, 1.5, 0.5), (2, 1.5, 0.5)]),
    Extreme("zero length", LINES, [(1, 2, -3), (1, 2, -3), (-4, 3, -2), (4, 3, -2)]),
    Extreme(
        "NaN beside a good edge", LINES, [(_NAN, 0, -1), (1, 0, -1), (-4, 3, -2), (4, 3, -2)], unseen=(0,)
    ),
    Extreme(
        "infinity beside a good edge",
        LINES,
        [(1, 2, -3), (_INF, 0, -1), (-4, 3, -2), (4, 3, -2)],
        unseen=(0,),
    ),
    Extreme("fov 360, past straight behind", LINES, [(-9, 0.3, 4), (8, -0.2, 4)], fov=360),
    Extreme("fov 360, a hundredth from straight behind", LINES, [(-9, 0.04, 4), (8, 0.04, 4)], fov=360),
    Extreme("fov 360, through straight behind", LINES, [(-9, 0, 4), (8, 0, 4)], fov=360),
    Extreme("fov 220, tilted", LINES, [(-9, 0.3, 4), (8, -2, 1)], fov=220, tilt=35),
    Extreme("lens steep at the rim", LINES, [(-50, 3, -2), (50, 3, -2)], lens=_STEEP),
    Extreme("lens flat at the rim", LINES, [(-50, 3, -2), (50, 3, -2)], lens=_FLAT),
    Extreme("floor to the horizon", QUADS, _floor(-1, 1e4)),
    Extreme("floor a thousandth below the eye", QUADS, _floor(-1e-3, 100), near=1e-4),
    Extreme("triangle around the axis", TRIANGLES, [(-9, -7, -1), (8, -6, -1), (0, 9, -1)]),
    Extreme("triangle around the eye's level", TRIANGLES, [(-9, -1, -8), (9, -1, -7), (0, -1, 9)]),
    Extreme("long thin triangle", TRIANGLES, [(-90, 2, -3), (90, 2, -3), (90, 2.01, -3)]),
    Extreme(
        "degenerate triangles",
        TRIANGLES,
        [
            (1, 2, -3),
            (1, 2, -3),
            (4, 3, -2),
            (-9, 1, -4),
            (0, 1, -4),
            (9, 1, -4),
            (-4, 3, -2),
            (4, 3, -2),
            (0, 1, -3),
        ],
        unseen=(0, 1),
    ),
    Extreme(
        "corner in the eye",
        TRIANGLES,
        [(0, 0, 0), (4, 3, -2), (-4, 3, -2), (-2, -2, -3), (2, -2, -3), (0, -1, -3)],
        unseen=(0,),
    ),
    Extreme(
        "triangle from 0.01 to 1e4 away",
        TRIANGLES,
        [(0.01, 0.004, -0.006), (-900, 2000, -10), (1e4, -20, -3000)],
    ),
    Extreme(
        "NaN beside a good triangle",
        TRIANGLES,
        [(_NAN, 0, -1), (1, 0, -1), (0, 1, -1), (-4, 3, -2), (4, 3, -2), (0, 1, -3)],
        unseen=(0,),
    ),
    Extreme("fov 220, wall behind", QUADS, [(-4, -3, 1), (5, -3, 1), (5, 4, 1), (-4, 4, 1)], fov=220),
    Extreme(
        "fov 360, triangle around straight behind", TRIANGLES, [(-4, -3, 1), (5, -3, 1), (0, 6, 1)], fov=360
    ),
    Extreme("room around the eye", QUADS, _box(-2, 3), outline=False),
    Extreme("fov 360, room around the eye", QUADS, _box(-2, 3), fov=360, outline=False),
)
