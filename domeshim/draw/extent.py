"""How large a mesh is, and how large an angle one of its edges can subtend at most."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

_AT_ONCE = 2048
"""So many primitives are judged at a time: what is found on the way stays in the processor's cache."""


class Extent(NamedTuple):
    """A sphere around a mesh, its longest edge and its shortest line, in the mesh's own units."""

    centre: tuple[float, float, float]
    radius: float
    longest: float
    shortest_line: float = math.inf
    """Of the lines that have a length; infinite where there are none, or that makes no difference."""

    @classmethod
    def of(cls, positions: NDArray[np.floating], longest: float, shortest_line: float = math.inf) -> Extent:
        """The extent of some vertices whose edges are known. positions: (n, 3 or 4)."""
        (ax, ay, az), (bx, by, bz) = positions[:, :3].min(0).tolist(), positions[:, :3].max(0).tolist()
        diagonal = math.hypot(bx - ax, by - ay, bz - az)
        centre = (ax + bx) / 2, (ay + by) / 2, (az + bz) / 2
        return cls(centre, diagonal / 2, min(longest, diagonal), shortest_line)

    @classmethod
    def unknown(cls) -> Extent:
        """Of vertices whose fourth coordinate puts them anywhere."""
        return cls((0.0, 0.0, 0.0), math.inf, math.inf)

    @classmethod
    def of_few(cls, positions: Sequence[float]) -> Extent:
        """The extent of a few vertices, x, y, z in a row; no edge is longer than their box's diagonal."""
        x, y, z = positions[::3], positions[1::3], positions[2::3]
        ax, ay, az, bx, by, bz = min(x), min(y), min(z), max(x), max(y), max(z)
        diagonal = math.hypot(bx - ax, by - ay, bz - az)
        return cls(((ax + bx) / 2, (ay + by) / 2, (az + bz) / 2), diagonal / 2, diagonal)

    def _side(self, to_eye: Sequence[float]) -> int:
        """The sign of the whole mesh's fourth coordinate: x, y and z alone tell directions; 0 if it changes.

        It is not quite 1 where a perspective was multiplied onto MODELVIEW, and is taken out of it again.
        """
        (x, y, z), (aw, bw, cw, tw) = self.centre, to_eye[3::4]
        w, spread = tw, 0.0
        if aw or bw or cw:
            w, spread = aw * x + bw * y + cw * z + tw, self.radius * math.hypot(aw, bw, cw)
        return (w > spread) - (w < -spread)

    def surely_seen_from(self, to_eye: Sequence[float], distance: float) -> bool:
        """The mesh is so far away that no edge needs a closer look: quickly said, and False where in doubt.

        to_eye: as for largest_angle; distance: from where an edge of length 1 still keeps the tolerance. How
        much the matrix lengthens a vector is bounded by the root of the sum of its squares.
        """
        if self._side(to_eye) <= 0:
            return False
        ax, ay, az, _, bx, by, bz, _, cx, cy, cz, _, tx, ty, tz, _ = to_eye
        x, y, z = self.centre
        px, py, pz = (
            ax * x + bx * y + cx * z + tx,
            ay * x + by * y + cy * z + ty,
            az * x + bz * y + cz * z + tz,
        )
        needed = self.radius + distance * self.longest
        squares = ax * ax + ay * ay + az * az + bx * bx + by * by + bz * bz + cx * cx + cy * cy + cz * cz
        return px * px + py * py + pz * pz > squares * needed * needed

    def largest_angle(self, to_eye: Sequence[float]) -> float:
        """No edge subtends more than this angle, radians; pi where nothing better can be said.

        to_eye: 16 numbers, column-major: the mesh's own space to eye space. All points are at least
        d = distance - radius away, so an edge of length l subtends at most 2 atan(l / 2 d). How much the
        matrix lengthens a vector M is bounded by sqrt of the largest row sum of |M^T M|.
        """
        if not self._side(to_eye):
            return math.pi
        ax, ay, az, _, bx, by, bz, _, cx, cy, cz, _, tx, ty, tz, _ = to_eye
        ab, bc, ca = (
            abs(ax * bx + ay * by + az * bz),
            abs(bx * cx + by * cy + bz * cz),
            abs(cx * ax + cy * ay + cz * az),
        )
        aa, bb, cc = ax * ax + ay * ay + az * az, bx * bx + by * by + bz * bz, cx * cx + cy * cy + cz * cz
        scale = math.sqrt(max(aa + ab + ca, bb + ab + bc, cc + bc + ca))
        x, y, z = self.centre
        distance = math.hypot(
            ax * x + bx * y + cx * z + tx, ay * x + by * y + cy * z + ty, az * x + bz * y + cz * z + tz
        )
        nearest = distance - scale * self.radius
        if not nearest > 0:
            return math.pi
        return 2 * math.atan(scale * self.longest / (2 * nearest))

    def smallest_line(self, to_eye: Sequence[float]) -> float:
        """About the angle, radians, of the shortest line where the mesh is farthest; 0 where in doubt.

        to_eye: as for largest_angle.
        """
        if not self._side(to_eye) or not math.isfinite(self.radius):
            return 0.0
        matrix = np.reshape(to_eye, (4, 4)).T
        scale = float(np.linalg.norm(matrix[:3, :3])) / math.sqrt(3)
        farthest = float(np.linalg.norm(matrix[:3] @ (*self.centre, 1.0))) + scale * self.radius
        return scale * self.shortest_line / farthest if farthest else 0.0

    def least_angle_from(self, direction: Sequence[float], to_eye: Sequence[float]) -> float:
        """No point is seen closer to a direction than this angle, radians; 0 where in doubt.

        direction: unit vector in eye space; to_eye: as for largest_angle.
        """
        if self._side(to_eye) <= 0 or not math.isfinite(self.radius):
            return 0.0
        matrix = np.reshape(to_eye, (4, 4)).T
        centre = matrix[:3] @ (*self.centre, 1.0)
        distance = float(np.linalg.norm(centre))
        radius = self.radius * float(np.linalg.norm(matrix[:3, :3]))
        if not radius < distance:
            return 0.0
        between = math.acos(max(-1.0, min(1.0, float(centre @ np.asarray(direction)) / distance)))
        return max(0.0, between - math.asin(radius / distance))


@dataclass(frozen=True)
class Spheres:
    """A sphere around each primitive of a mesh, and its longest edge, in the mesh's own units."""

    centres: NDArray[np.floating]
    """(3, n): axis by axis, which is summed several times as fast."""
    radii: NDArray[np.floating]
    """(n,)"""
    longest: NDArray[np.floating]
    """(n,); inf where a corner has no finite place."""

    @classmethod
    def of(cls, corners: NDArray[np.floating]) -> Spheres:
        """Of primitives by their corners, (n, 2 or 3, 3)."""
        sound = np.isfinite(corners).all((1, 2))
        places = np.where(sound[:, None, None], corners, 0).astype(float)
        centres = places.mean(1)
        beside = places - centres[:, None]
        edges = places - np.roll(places, 1, 1)
        radii, longest = (np.sqrt((v * v).sum(-1).max(1)) for v in (beside, edges))
        return cls(np.ascontiguousarray(centres.T), radii, np.where(sound, longest, np.inf))

    def largest_angles(self, to_eye: NDArray[np.floating], enough: float = 0.0) -> NDArray[np.floating]:
        """No edge of a primitive subtends more than its angle, (n,), radians; inf where it may be any.

        to_eye: (4, 4), the mesh's own space to eye space; enough: an angle so small that how much smaller one
        is need not be told. The viewer is taken into the mesh's space. A matrix of singular values s0 .. s2
        leaves at least s2 of a distance and at most s0 of an edge; and an edge of length l, all of it farther
        away than d, subtends less than l / d.
        """
        found: NDArray[np.floating] = np.full(len(self.longest), np.inf)
        viewer, stretch = _viewer_in_mesh(to_eye.tobytes())
        if viewer is None:
            return found
        for block in self._blocks:
            some, nearest_of_block = block.numbers, block.distance(*viewer.tolist())
            if nearest_of_block > 0 and stretch * block.longest <= enough * nearest_of_block:
                found[some] = enough
                continue
            x, y, z = self.centres[:, some] - viewer[:, None]
            nearest = np.sqrt(x * x + y * y + z * z) - self.radii[some]
            np.divide(stretch * self.longest[some], nearest, out=found[some], where=nearest > 0)
        if not (before := self._before_infinity(to_eye)).all():
            found[np.broadcast_to(~before, found.shape)] = np.inf
        return found

    def _before_infinity(self, to_eye: NDArray[np.floating]) -> NDArray[np.bool_]:
        """(n,) or (1,): the primitives whose fourth coordinate is above 0 everywhere."""
        along, w = to_eye[3, :3], to_eye[3, 3]
        if not along.any():
            return np.array([w > 0])
        before: NDArray[np.bool_] = along @ self.centres + w > self.radii * np.linalg.norm(along)
        return before

    @cached_property
    def _blocks(self) -> list[_Block]:
        firsts = range(0, len(self.radii), _AT_ONCE)
        return [self._block(slice(first, first + _AT_ONCE)) for first in firsts]

    def _block(self, numbers: slice) -> _Block:
        centres, radius = self.centres[:, numbers], float(self.radii[numbers].max())
        low, high = centres.min(1) - radius, centres.max(1) + radius
        return _Block(numbers, tuple(low.tolist()), tuple(high.tolist()), float(self.longest[numbers].max()))

    def least_angles_from(
        self, direction: Sequence[float], to_eye: NDArray[np.floating]
    ) -> NDArray[np.floating]:
        """No point of a primitive is seen closer to a direction than its angle, (n,), radians; 0 in doubt.

        direction: unit vector in eye space; to_eye: (4, 4), as for largest_angles.
        """
        centres = self.centres.T @ to_eye[:3, :3].T + to_eye[:3, 3]
        distances = np.maximum(np.linalg.norm(centres, axis=1), 1e-300)
        between = np.arccos(np.clip(centres @ np.asarray(direction) / distances, -1, 1))
        radii = self.radii * float(np.linalg.norm(to_eye[:3, :3]))
        least = between - np.arcsin(np.minimum(radii / distances, 1))
        sure = (radii < distances) & np.isfinite(self.longest) & self._before_infinity(to_eye)
        found: NDArray[np.floating] = np.where(sure, np.maximum(least, 0), 0.0)
        return found


class _Block(NamedTuple):
    """Primitives that follow each other: a box around them, and their longest edge."""

    numbers: slice
    low: tuple[float, ...]
    high: tuple[float, ...]
    longest: float

    def distance(self, x: float, y: float, z: float) -> float:
        """From a place to the box."""
        (ax, ay, az), (bx, by, bz) = self.low, self.high
        return math.hypot(max(ax - x, x - bx, 0.0), max(ay - y, y - by, 0.0), max(az - z, z - bz, 0.0))


@lru_cache(maxsize=8)
def _viewer_in_mesh(to_eye: bytes) -> tuple[NDArray[np.floating] | None, float]:
    """Where the viewer stands in a mesh's own space, (3,), and s0 / s2 of Spheres.largest_angles.

    None where that cannot be told. to_eye: (4, 4) float64. A scene's meshes often share it.
    """
    matrix = np.frombuffer(to_eye).reshape(4, 4)
    turn = matrix[:3, :3]
    if not np.isfinite(matrix).all():
        return None, 0.0
    scales = np.linalg.svd(turn, compute_uv=False)
    if not scales[2] > 1e-12 * scales[0]:
        return None, 0.0
    return np.linalg.solve(turn, -matrix[:3, 3]), float(scales[0] / scales[2])
