"""The Sierpinski sponge: a tetrahedron of which each level keeps four half-sized ones at the corners."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from domeshim.GLUT.shapes import platonic
from domeshim.GLUT.shapes.mesh import Solid, Wire
from domeshim.GLUT.shapes.platonic import Faces


@lru_cache(maxsize=8)
def sponge(levels: int, offset: tuple[float, float, float], scale: float) -> Solid | None:
    """The filled sponge about offset, its corners at distance scale; None under no levels."""
    return None if levels < 0 else platonic.solid(_faces(levels, offset, scale))


@lru_cache(maxsize=8)
def wire_sponge(levels: int, offset: tuple[float, float, float], scale: float) -> Wire | None:
    """The outlines of the sponge's faces."""
    return None if levels < 0 else platonic.wire(_faces(levels, offset, scale))


def _faces(levels: int, offset: tuple[float, float, float], scale: float) -> Faces:
    corners, normals = platonic.tetrahedron_faces()
    # Rounded where freeglut rounds, so that of edges which coincide the same ones are seen.
    tips, size = -normals.astype(np.float32).astype(float), np.float32(scale)
    places = np.array([offset], float)
    for level in range(1, levels + 1):
        places = (places[:, None] + float(size) / 2**level * tips).reshape(-1, 3)
    small = size / np.float32(2**levels) * corners.astype(np.float32)
    moved = places.astype(np.float32)[:, None, None] + small
    return moved.reshape(-1, 3, 3).astype(float), np.tile(normals, (len(places), 1))
