"""What the bench draws: vertices in eye space, and lines, triangles or quads that join them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from domeshim.GLUT.shapes.teapot import teapot

Floats = NDArray[np.float64]
Bytes = NDArray[np.uint8]


@dataclass(frozen=True, eq=False)
class Mesh:
    """Primitives of one kind, all corners in eye space."""

    positions: NDArray[np.float32]
    """(n, 3)."""
    corners: NDArray[np.uint32]
    """(m, 2), (m, 3) or (m, 4) rows of positions: lines, triangles, quads."""
    normals: NDArray[np.float32] | None = None
    texcoords: NDArray[np.float32] | None = None
    """(n, 2), where the mesh has a texture."""
    texture: Bytes | None = None
    """(rows, columns, 3), the lowest row first."""
    colour: tuple[float, float, float] = (1.0, 1.0, 1.0)

    @property
    def edges(self) -> Floats:
        """(e, 2, 3): the ends of every edge, once."""
        k = self.corners.shape[1]
        columns = [(0, 1)] if k == 2 else [(i, (i + 1) % k) for i in range(k)]
        pairs = np.concatenate([self.corners[:, pair] for pair in columns])
        pairs = np.unique(np.sort(pairs, 1), axis=0)
        return np.asarray(self.positions[pairs], float)


def of_lines(ends: Floats, colour: tuple[float, float, float] = (1.0, 1.0, 1.0)) -> Mesh:
    """Lines by their ends, (m, 2, 3)."""
    corners = np.arange(2 * len(ends), dtype=np.uint32).reshape(-1, 2)
    return Mesh(ends.reshape(-1, 3).astype(np.float32), corners, colour=colour)


def grid(columns: int, rows: int) -> NDArray[np.uint32]:
    """(columns * rows, 4): the quads of a grid whose points run along its columns + 1 first."""
    i, j = np.meshgrid(np.arange(columns), np.arange(rows))
    first = (j * (columns + 1) + i).reshape(-1, 1)
    around = np.array([0, 1, columns + 2, columns + 1])
    return np.asarray(first + around, np.uint32)


def ball(quads: int, *, halved: bool = True) -> Mesh:
    """A ball of radius 2, five ahead of the eye, of quads x quads pieces; halved: each in two triangles."""
    around, down = np.meshgrid(np.linspace(0, 2 * np.pi, quads + 1), np.linspace(0, np.pi, quads + 1))
    outwards = np.stack([np.cos(around) * np.sin(down), np.cos(down), np.sin(around) * np.sin(down)], -1)
    outwards = outwards.reshape(-1, 3)
    corners = grid(quads, quads)
    if halved:
        corners = np.concatenate([corners[:, :3], corners[:, [0, 2, 3]]])
    return Mesh((2 * outwards - [0, 0, 5]).astype(np.float32), corners, normals=outwards.astype(np.float32))


def long_lines(count: int) -> Mesh:
    """Lines through a cube around the eye, 10 each way: many span over 90 degrees, and some pass close by."""
    chance = np.random.default_rng(7)
    return of_lines(chance.uniform(-10, 10, (count, 2, 3)))


def arrows(count: int) -> Mesh:
    """A swirl around the eye: so many arrows, each a shaft and two barbs."""
    chance = np.random.default_rng(11)
    tails = chance.uniform(-5, 5, (count, 3))
    tails = tails[np.linalg.norm(tails, axis=1) > 1]
    ways = np.stack([tails[:, 1] - tails[:, 2], tails[:, 2] - tails[:, 0], tails[:, 0] - tails[:, 1]], -1)
    ways *= 0.25 / np.linalg.norm(ways, axis=1, keepdims=True)
    tips, sides = tails + ways, 0.3 * np.cross(ways, [0.3, 0.9, 0.3])
    barbs = [np.stack([tips, tips - 0.3 * ways + sign * sides], 1) for sign in (1, -1)]
    return of_lines(np.concatenate([np.stack([tails, tips], 1), *barbs]), (0.4, 0.8, 1.0))


def box_edges(low: Floats, high: Floats) -> Mesh:
    """The twelve edges of a box."""
    ends = []
    for axis in range(3):
        for others in np.ndindex(2, 2):
            edge = np.empty((2, 3))
            edge[:, axis] = low[axis], high[axis]
            for other, end in zip([(axis + 1) % 3, (axis + 2) % 3], others, strict=True):
                edge[:, other] = (low, high)[end][other]
            ends.append(edge)
    return of_lines(np.array(ends), (1.0, 0.8, 0.3))


def teapots() -> list[Mesh]:
    """Thirteen teapots on a ball around the eye, as in the paper's "closest"."""
    towards = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, -1)]
    corners = 2 * np.array(list(np.ndindex(2, 2, 2))) - 1
    places = 3.5 * np.concatenate([towards, corners / np.sqrt(3)])
    solid = teapot(1.1)
    found = []
    for number, place in enumerate(places):
        angle = 0.7 * number
        turn = np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])
        positions = (solid.vertices.positions @ turn.T + place).astype(np.float32)
        normals = (solid.vertices.normals @ turn.T).astype(np.float32)
        colour = 0.55 + 0.4 * np.cos(number + np.arange(3) * 2.1)
        found.append(
            Mesh(positions, solid.triangles.astype(np.uint32), normals, colour=tuple(colour.tolist()))
        )
    return found
