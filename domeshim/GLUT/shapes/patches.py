"""Bicubic Bezier patches: points and normals on them, copies about an axis, nets of triangles or lines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from domeshim.GLUT.shapes.mesh import Vertices

Grid = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Patches:
    """Points and unit normals on patches, (patches, n, n, 3) each; rows run along u, columns along v."""

    points: Grid
    normals: Grid

    def __getitem__(self, chosen: int) -> Patches:
        return Patches(self.points[chosen : chosen + 1], self.normals[chosen : chosen + 1])

    def __len__(self) -> int:
        return len(self.points)

    def vertices(self, textured: bool) -> Vertices:
        """The points in order; textured: with (u, v) of each patch as texture coordinates."""
        count = self.points.shape[1]
        steps = np.linspace(0, 1, count)
        square = np.stack(np.meshgrid(steps, steps, indexing="ij"), -1).reshape(-1, 2)
        texcoords = np.tile(square, (len(self), 1)) if textured else None
        return Vertices.of(self.points.reshape(-1, 3), self.normals.reshape(-1, 3), texcoords)


def patch_points(control: ArrayLike, count: int) -> Patches:
    """Evaluate patches with control points (patches, 4, 4, 3) at count x count even steps of u and v."""
    value, slope = _bernstein(np.linspace(0, 1, count))
    net = np.asarray(control, float)
    points = np.einsum("ui,vj,pijc->puvc", value, value, net)
    along_u = np.einsum("ui,vj,pijc->puvc", slope, value, net)
    along_v = np.einsum("ui,vj,pijc->puvc", value, slope, net)
    return Patches(points, _whole_normals(np.cross(along_v, along_u)))


def turned(patches: Patches) -> Patches:
    """The patches and their copies at 90, 180 and 270 degrees about y."""
    quarter = np.array([[0, 0, 1], [0, 1, 0], [-1, 0, 0]], float)
    turns = [np.linalg.matrix_power(quarter, times).T for times in range(4)]
    return Patches(
        np.concatenate([patches.points @ turn for turn in turns]),
        np.concatenate([patches.normals @ turn for turn in turns]),
    )


def reflected(patches: Patches) -> Patches:
    """The patches and their mirror images in the xy plane, rows reversed: the front stays the front."""
    mirror = np.array([1.0, 1.0, -1.0])
    return Patches(
        np.concatenate([patches.points, patches.points[:, ::-1] * mirror]),
        np.concatenate([patches.normals, patches.normals[:, ::-1] * mirror]),
    )


def join(pieces: Sequence[Patches]) -> Patches:
    """All patches of all pieces, in that order."""
    return Patches(
        np.concatenate([piece.points for piece in pieces]),
        np.concatenate([piece.normals for piece in pieces]),
    )


def grid_triangles(patches: Patches) -> NDArray[np.int64]:
    """Two triangles for each square of the nets, (m, 3)."""
    index = _indices(patches)
    a, b, c, d = index[:, :-1, :-1], index[:, 1:, :-1], index[:, 1:, 1:], index[:, :-1, 1:]
    return np.stack([a, b, c, a, c, d], -1).reshape(-1, 3)


def grid_strips(patches: Patches) -> list[tuple[NDArray[np.int64], bool]]:
    """The nets' lines: first those along u of every patch, then those along v; all open."""
    index = _indices(patches)
    count = index.shape[1]
    return [(index.transpose(0, 2, 1).reshape(-1, count), False), (index.reshape(-1, count), False)]


def _indices(patches: Patches) -> NDArray[np.int64]:
    return np.arange(patches.points[..., 0].size).reshape(patches.points.shape[:3])


def _bernstein(t: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The four cubic Bernstein polynomials and their slopes at t, (n, 4) each."""
    s = 1 - t
    value = np.stack([s**3, 3 * t * s**2, 3 * t**2 * s, t**3], -1)
    slope = np.stack([-3 * s**2, 3 * s**2 - 6 * s * t, 6 * s * t - 3 * t**2, 3 * t**2], -1)
    return value, slope


def _whole_normals(across: Grid) -> Grid:
    """Unit normals; where a patch's edge shrinks to a point and the product is nil, the next row's normal."""
    length = np.linalg.norm(across, axis=-1)
    nil = length < 1e-6 * length.max(axis=(1, 2), keepdims=True)
    normals = across / np.where(nil, 1, length)[..., None]
    for patch, u, v in np.argwhere(nil):
        normals[patch, u, v] = normals[patch, min(max(u, 1), across.shape[1] - 2), v]
    return normals
