"""Sphere, cone, cylinder and torus: rings of points joined band by band.

The sizes, the first point of each ring, the sense of rotation and the order of drawing are freeglut 3.4's
(fg_geometry.c), so that flat shading, blending and the lines look alike.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from domeshim.GLUT.shapes.mesh import Solid, Vertices, Wire

Rows = NDArray[np.int64]
RingIndices = Sequence[NDArray[np.int64]]


@lru_cache(maxsize=64)
def sphere(radius: float, slices: int, stacks: int) -> Solid | None:
    """A ball about the origin, its poles on z; None (drawn as nothing) without slices or 2 stacks."""
    if slices < 1 or stacks < 2:
        return None
    vertices, rings = _ball(radius, slices, stacks)
    return Solid.of(vertices, _bands([(lower, upper) for upper, lower in pairwise(rings)]))


@lru_cache(maxsize=64)
def wire_sphere(radius: float, slices: int, stacks: int) -> Wire | None:
    """The ball's meridians from pole to pole, then its parallels."""
    if slices < 1 or stacks < 2:
        return None
    vertices, rings = _ball(radius, slices, stacks)
    return Wire.of(vertices, [(np.array(rings).T, False), (np.array(rings[1:-1]), True)])


@lru_cache(maxsize=64)
def cone(base: float, height: float, slices: int, stacks: int) -> Solid | None:
    """A cone with its base on z = 0 and its tip at z = height, closed below."""
    if slices < 1 or stacks < 1:
        return None
    vertices, centre, rings = _cone(base, height, slices, stacks)
    return Solid.of(vertices, _bands([(centre, rings[0]), *pairwise(rings[1:])]))


@lru_cache(maxsize=64)
def wire_cone(base: float, height: float, slices: int, stacks: int) -> Wire | None:
    """The cone's lines from base to tip, then its rings without the tip."""
    if slices < 1 or stacks < 1:
        return None
    vertices, _, rings = _cone(base, height, slices, stacks)
    return Wire.of(vertices, [(np.stack([rings[1], rings[-1]], 1), False), (np.array(rings[1:-1]), True)])


@lru_cache(maxsize=64)
def cylinder(radius: float, height: float, slices: int, stacks: int) -> Solid | None:
    """A tube about z from z = 0 to z = height, closed at both ends."""
    if slices < 1 or stacks < 1:
        return None
    vertices, bottom, rings, top = _cylinder(radius, height, slices, stacks)
    bands = [(bottom, rings[0]), *pairwise(rings[1:-1]), (rings[-1], top)]
    return Solid.of(vertices, _bands(bands))


@lru_cache(maxsize=64)
def wire_cylinder(radius: float, height: float, slices: int, stacks: int) -> Wire | None:
    """The tube's lines along z, then its rings."""
    if slices < 1 or stacks < 1:
        return None
    vertices, _, rings, _ = _cylinder(radius, height, slices, stacks)
    return Wire.of(vertices, [(np.stack([rings[1], rings[-2]], 1), False), (np.array(rings[1:-1]), True)])


@lru_cache(maxsize=64)
def torus(inner: float, outer: float, sides: int, rings: int) -> Solid | None:
    """A ring about z: inner is the tube's radius, outer its middle's; None under 2 sides or rings."""
    if sides < 2 or rings < 2:
        return None
    vertices, grid = _torus(inner, outer, sides, rings)
    return Solid.of(vertices, _bands([(grid[:, i], grid[:, (i + 1) % sides]) for i in range(sides)]))


@lru_cache(maxsize=64)
def wire_torus(inner: float, outer: float, sides: int, rings: int) -> Wire | None:
    """The tube's cross-sections, then the circles along it."""
    if sides < 2 or rings < 2:
        return None
    vertices, grid = _torus(inner, outer, sides, rings)
    return Wire.of(vertices, [(grid, True), (grid.T, True)])


def _ball(radius: float, slices: int, stacks: int) -> tuple[Vertices, RingIndices]:
    """Vertices and the rings' indices from the upper pole to the lower; a pole's ring repeats one vertex."""
    angles = np.pi * np.arange(1, stacks) / stacks
    middle = _lathe(np.sin(angles), np.cos(angles), slices)
    normals = np.concatenate([[(0, 0, 1)], middle.reshape(-1, 3), [(0, 0, -1)]])
    parallels = 1 + np.arange((stacks - 1) * slices).reshape(stacks - 1, slices)
    poles = np.zeros(slices, np.int64), np.full(slices, len(normals) - 1)
    return Vertices.of(normals * radius, normals), [poles[0], *parallels, poles[1]]


def _cone(
    base: float, height: float, slices: int, stacks: int
) -> tuple[Vertices, NDArray[np.int64], RingIndices]:
    """Vertices, the base's centre, the rings: the base's rim facing down, then the side up to the tip."""
    up = np.arange(stacks + 1) / stacks
    slant = np.hypot(base, height) or 1.0
    return _turned(
        radii=[0, base, *(base * (1 - up))],
        heights=[0, 0, *(height * up)],
        outward=[0, 0, *np.full(stacks + 1, height / slant)],
        upward=[-1, -1, *np.full(stacks + 1, base / slant)],
        slices=slices,
    )


def _cylinder(
    radius: float, height: float, slices: int, stacks: int
) -> tuple[Vertices, NDArray[np.int64], RingIndices, NDArray[np.int64]]:
    """Vertices, the lower centre, the rings (lower rim, side upwards, upper rim), and the upper centre."""
    up = height * np.arange(stacks + 1) / stacks
    vertices, bottom, rings = _turned(
        radii=[0, radius, *np.full(stacks + 1, radius), radius, 0],
        heights=[0, 0, *up, height, height],
        outward=[0, 0, *np.ones(stacks + 1), 0, 0],
        upward=[-1, -1, *np.zeros(stacks + 1), 1, 1],
        slices=slices,
    )
    return vertices, bottom, rings[:-1], np.full(slices, rings[-1][0])


def _turned(
    radii: Sequence[float],
    heights: Sequence[float],
    outward: Sequence[float],
    upward: Sequence[float],
    slices: int,
) -> tuple[Vertices, NDArray[np.int64], RingIndices]:
    """Turn a profile about z: vertices, the first ring (a centre, one vertex repeated), the other rings."""
    positions = _lathe(np.asarray(radii, float), np.asarray(heights, float), slices)
    normals = _lathe(np.asarray(outward, float), np.asarray(upward, float), slices)
    grid = np.arange(len(radii) * slices).reshape(-1, slices)
    vertices = Vertices.of(positions.reshape(-1, 3), normals.reshape(-1, 3))
    return vertices, np.zeros(slices, np.int64), list(grid[1:])


def _torus(inner: float, outer: float, sides: int, rings: int) -> tuple[Vertices, NDArray[np.int64]]:
    """Vertices and their indices (rings, sides)."""
    along, across = 2 * np.pi * np.arange(rings) / rings, 2 * np.pi * np.arange(sides) / sides
    axis = np.stack([np.cos(along), np.sin(along), np.zeros(rings)], -1)[:, None]
    normals = np.cos(across)[:, None] * axis - np.sin(across)[:, None] * (0.0, 0.0, 1.0)
    positions = outer * axis + inner * normals
    vertices = Vertices.of(positions.reshape(-1, 3), normals.reshape(-1, 3))
    return vertices, np.arange(rings * sides).reshape(rings, sides)


def _lathe(radii: NDArray[np.float64], heights: NDArray[np.float64], slices: int) -> NDArray[np.float64]:
    """Points (rows, slices, 3): each row of the profile turned about z, clockwise seen from above."""
    turn = 2 * np.pi * np.arange(slices) / slices
    x, y = np.multiply.outer(radii, np.cos(turn)), np.multiply.outer(radii, -np.sin(turn))
    return np.stack([x, y, np.broadcast_to(heights[:, None], x.shape)], -1)


def _bands(pairs: Sequence[tuple[NDArray[np.int64], NDArray[np.int64]]]) -> NDArray[np.int64]:
    """Triangles between pairs of closed rings; each has the last corner that a triangle strip gives it."""
    first, second = (np.array(ring) for ring in zip(*pairs, strict=True))
    next_first, next_second = np.roll(first, -1, axis=1), np.roll(second, -1, axis=1)
    quads = [first, second, next_first, next_first, second, next_second]
    return np.stack(quads, axis=-1).reshape(-1, 3)
