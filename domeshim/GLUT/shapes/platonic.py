"""The five regular solids, as freeglut 3.4 places them (tables of fg_geometry.c) with one normal a face."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from math import sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray

from domeshim.GLUT.shapes.mesh import Solid, Vertices, Wire

Faces = tuple[NDArray[np.float64], NDArray[np.float64]]
"""The corners of each face (faces, corners, 3), counter-clockwise from outside, and its normal (faces, 3)."""

_CUTS = {3: (0, 1, 2), 4: (0, 1, 2, 0, 2, 3), 5: (0, 1, 2, 0, 2, 4, 4, 2, 3)}
"""How a face of so many corners is cut into triangles."""


def solid(faces: Faces) -> Solid:
    """The filled shape of these faces."""
    corners = faces[0].shape[1]
    firsts = corners * np.arange(len(faces[0]))
    return Solid.of(_vertices(faces), np.add.outer(firsts, _CUTS[corners]))


def wire(faces: Faces) -> Wire:
    """Each face's outline."""
    count, corners = faces[0].shape[:2]
    return Wire.of(_vertices(faces), [(np.arange(count * corners).reshape(count, corners), True)])


def faces_of(points: ArrayLike, indices: Sequence[Sequence[int]]) -> Faces:
    """Gather faces from points (n, 3) and each face's corner indices; the normals are of unit length."""
    corners = np.asarray(points, float)[np.array(indices)]
    across = edge_products(corners)
    return corners, across / np.linalg.norm(across, axis=1, keepdims=True)


def edge_products(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """The cross product of each face's first edge and first diagonal: along its normal, of any length."""
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def _vertices(faces: Faces) -> Vertices:
    corners, normals = faces
    return Vertices.of(corners.reshape(-1, 3), np.repeat(normals, corners.shape[1], axis=0))


@lru_cache(maxsize=1)
def cube_faces() -> Faces:
    """Edge 1, centred."""
    front = ((1, 1, 1), (-1, 1, 1), (-1, -1, 1), (1, -1, 1))
    back = ((1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, -1))
    sides = ((0, 1, 2, 3), (0, 3, 4, 5), (0, 5, 6, 1), (1, 6, 7, 2), (7, 4, 3, 2), (4, 7, 6, 5))
    return faces_of(np.array(front + back) / 2, sides)


@lru_cache(maxsize=1)
def tetrahedron_faces() -> Faces:
    """Corners on the unit sphere."""
    a, b, c = 2 * sqrt(2) / 3, sqrt(2) / 3, sqrt(6) / 3
    points = ((1, 0, 0), (-1 / 3, a, 0), (-1 / 3, -b, c), (-1 / 3, -b, -c))
    return faces_of(points, ((1, 3, 2), (0, 2, 3), (0, 3, 1), (0, 1, 2)))


@lru_cache(maxsize=1)
def octahedron_faces() -> Faces:
    """Corners on the unit sphere's axes."""
    points = np.concatenate([np.eye(3), -np.eye(3)])
    sides = ((0, 1, 2), (0, 5, 1), (0, 2, 4), (0, 4, 5), (3, 2, 1), (3, 1, 5), (3, 4, 2), (3, 5, 4))
    return faces_of(points, sides)


@lru_cache(maxsize=1)
def dodecahedron_faces() -> Faces:
    """Corners at distance sqrt(3): those of a cube of edge 2 are among them."""
    long, short = (sqrt(5) + 1) / 2, (sqrt(5) - 1) / 2
    points = (
        *((0, long, short), (-1, 1, 1), (-short, 0, long), (short, 0, long), (1, 1, 1)),
        *((0, long, -short), (1, 1, -1), (short, 0, -long), (-short, 0, -long), (-1, 1, -1)),
        *((0, -long, short), (1, -1, 1), (-1, -1, 1), (0, -long, -short), (-1, -1, -1)),
        *((1, -1, -1), (long, -short, 0), (long, short, 0), (-long, short, 0), (-long, -short, 0)),
    )
    sides = (
        *((0, 1, 2, 3, 4), (5, 6, 7, 8, 9), (10, 11, 3, 2, 12), (13, 14, 8, 7, 15)),
        *((3, 11, 16, 17, 4), (2, 1, 18, 19, 12), (7, 6, 17, 16, 15), (8, 14, 19, 18, 9)),
        *((17, 6, 5, 0, 4), (16, 11, 10, 13, 15), (18, 1, 0, 5, 9), (19, 14, 13, 10, 12)),
    )
    return faces_of(points, sides)


@lru_cache(maxsize=1)
def icosahedron_faces() -> Faces:
    """Corners on the unit sphere, two of them on x; normals 0.957 long, as freeglut's are."""
    turn = 2 * np.pi * np.arange(5) / 5
    x, r = 1 / sqrt(5), 2 / sqrt(5)
    front = np.stack([np.full(5, x), r * np.cos(turn), r * np.sin(turn)], -1)
    points = np.concatenate([[(1, 0, 0)], front, front * (-1, -1, 1), [(-1, 0, 0)]])
    sides = (
        *((0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), (0, 5, 1), (1, 8, 2), (2, 7, 3), (3, 6, 4), (4, 10, 5)),
        *((5, 9, 1), (1, 9, 8), (2, 8, 7), (3, 7, 6), (4, 6, 10), (5, 10, 9)),
        *((11, 9, 10), (11, 8, 9), (11, 7, 8), (11, 6, 7), (11, 10, 6)),
    )
    corners, _ = faces_of(points, sides)
    return corners, edge_products(corners)
