"""Walls, boxes and turned bodies of which the demos build, and display lists to keep them in."""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray
from OpenGL.GL import *

Mesh = tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]]
"""Quads, four rows each: places (n, 3), normals (n, 3), texture coordinates (n, 2)."""


def compiled(draw: Callable[[], None]) -> int:
    """A display list of what a function draws."""
    name = glGenLists(1)
    glNewList(name, GL_COMPILE)
    draw()
    glEndList()
    return name


def plane(corner: ArrayLike, across: ArrayLike, up: ArrayLike, pieces: int = 24) -> None:
    """A wall from a corner along two edges, textured by the metre, seen from where they turn left.

    It is in so many pieces each way that a near lamp's light falls softly on it.
    """
    start, along, rise = (np.asarray(side, float) for side in (corner, across, up))
    glNormal3dv(np.cross(along, rise) / np.linalg.norm(np.cross(along, rise)))
    for row in range(pieces):
        glBegin(GL_QUAD_STRIP)
        for column in range(pieces + 1):
            for t in (row + 1, row):
                place = start + along * column / pieces + rise * t / pieces
                glTexCoord2d(np.linalg.norm(along) * column / pieces, np.linalg.norm(rise) * t / pieces)
                glVertex3dv(place)
        glEnd()


def box(foot: ArrayLike, size: ArrayLike) -> None:
    """An upright box: where the middle of its foot is, and its width, height and depth."""
    x, y, z = np.asarray(foot, float)
    w, h, d = np.asarray(size, float)
    low, high = np.array((x - w / 2, y, z - d / 2)), np.array((x + w / 2, y + h, z + d / 2))
    right, up, back = np.diag((w, h, d))
    for corner, across, rise in (
        (low, up, right), (low, right, back), (low, back, up),
        (high, -right, -up), (high, -back, -right), (high, -up, -back),
    ):  # fmt: skip
        plane(corner, across, rise, 1)


def turned(profile: ArrayLike, sides: int, carve: Callable[..., ArrayLike] | None = None) -> Mesh:
    """A body turned on a lathe, from rows of radius and height; carve(radii, heights, angles): new radii."""
    angles = np.arange(sides + 1) * 2 * math.pi / sides
    radii, heights = np.asarray(profile, float).T[..., None]
    radii = radii + 0.0 * angles if carve is None else np.asarray(carve(radii, heights, angles))
    places = np.stack([radii * np.cos(angles), heights + 0.0 * angles, radii * np.sin(angles)], -1)
    wrapped = np.concatenate([places[:, -2:-1], places, places[:, 1:2]], 1)
    normals = np.cross(np.gradient(places, axis=0), wrapped[:, 2:] - wrapped[:, :-2])
    normals /= np.linalg.norm(normals, axis=-1, keepdims=True) + 1e-12
    coordinates = np.stack([angles / math.pi + 0.0 * heights, places[..., 1] / 2.0], -1)

    def quads(grid: NDArray[np.float64]) -> NDArray[np.float32]:
        corners = [grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]]
        return np.ascontiguousarray(np.stack(corners, 2).reshape(-1, grid.shape[-1]), np.float32)

    return quads(places), quads(normals), quads(coordinates)


def draw_mesh(mesh: Mesh) -> None:
    """Draw it from vertex arrays."""
    places, normals, coordinates = mesh
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT)
    for kind in (GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY):
        glEnableClientState(kind)
    glVertexPointer(3, GL_FLOAT, 0, places)
    glNormalPointer(GL_FLOAT, 0, normals)
    glTexCoordPointer(2, GL_FLOAT, 0, coordinates)
    glDrawArrays(GL_QUADS, 0, len(places))
    glPopClientAttrib()
