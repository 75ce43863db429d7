"""How large a mesh is, and how large an angle one of its edges can subtend at most."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Extent:
    """A sphere around a mesh and its longest edge, in the mesh's own units."""

    centre: tuple[float, float, float]
    radius: float
    longest: float

    @classmethod
    def of(cls, positions: NDArray[np.floating], longest: float) -> Extent:
        """The extent of some vertices whose longest edge is known. positions: (n, 3 or 4)."""
        low, high = positions[:, :3].min(0), positions[:, :3].max(0)
        return cls._of_box(low.tolist(), high.tolist(), longest)

    @classmethod
    def of_few(cls, positions: Sequence[float]) -> Extent:
        """The extent of a few vertices, x, y, z in a row; no edge is longer than their box's diagonal."""
        axes = [positions[axis::3] for axis in range(3)]
        return cls._of_box([min(axis) for axis in axes], [max(axis) for axis in axes], math.inf)

    @classmethod
    def _of_box(cls, low: Sequence[float], high: Sequence[float], longest: float) -> Extent:
        x, y, z = ((a + b) / 2 for a, b in zip(low, high, strict=True))
        diagonal = math.dist(low, high)
        return cls((x, y, z), diagonal / 2, min(longest, diagonal))

    def largest_angle(self, to_eye: Sequence[float]) -> float:
        """No edge subtends more than this angle, radians; pi where nothing better can be said.

        to_eye: 16 numbers, column-major: the mesh's own space to eye space. All points are at least
        d = distance - radius away, so an edge of length l subtends at most 2 atan(l / 2 d).
        """
        m = to_eye
        if m[3] or m[7] or m[11] or not m[15]:
            return math.pi
        x, y, z = self.centre
        distance = math.dist(
            (0, 0, 0), [m[i] * x + m[4 + i] * y + m[8 + i] * z + m[12 + i] for i in range(3)]
        )
        scale = _largest_scale(m)
        nearest = distance - scale * self.radius
        if not nearest > 0:
            return math.pi
        return 2 * math.atan(scale * self.longest / (2 * nearest))


def _largest_scale(m: Sequence[float]) -> float:
    """An upper bound of how much the matrix lengthens a vector: sqrt of the largest row sum of |M^T M|."""
    a, b, c = m[0:3], m[4:7], m[8:11]
    ab, bc, ca = (abs(p[0] * q[0] + p[1] * q[1] + p[2] * q[2]) for p, q in ((a, b), (b, c), (c, a)))
    aa, bb, cc = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] for p in (a, b, c))
    return math.sqrt(max(aa + ab + ca, bb + ab + bc, cc + bc + ca))
