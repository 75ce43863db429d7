"""The rhombic dodecahedron: twelve rhombs about a cube whose edges are their short diagonals."""

from __future__ import annotations

from functools import lru_cache
from math import sqrt

import numpy as np

from domeshim.GLUT.shapes.platonic import Faces, faces_of


@lru_cache(maxsize=1)
def rhombic_dodecahedron_faces() -> Faces:
    """Tips at z = 1 and -1; table and normals of freeglut 3.4, the eight slanted ones 0.707 long."""
    h = sqrt(0.5)
    points = (
        *((0, 0, 1), (h, 0, 0.5), (0, h, 0.5), (-h, 0, 0.5), (0, -h, 0.5)),
        *((h, h, 0), (-h, h, 0), (-h, -h, 0), (h, -h, 0)),
        *((h, 0, -0.5), (0, h, -0.5), (-h, 0, -0.5), (0, -h, -0.5), (0, 0, -1)),
    )
    sides = (
        *((0, 1, 5, 2), (0, 2, 6, 3), (0, 3, 7, 4), (0, 4, 8, 1)),
        *((5, 10, 6, 2), (6, 11, 7, 3), (7, 12, 8, 4), (8, 9, 5, 1)),
        *((5, 9, 13, 10), (6, 10, 13, 11), (7, 11, 13, 12), (8, 12, 13, 9)),
    )
    corners, normals = faces_of(points, sides)
    lengths = np.repeat([h, 1.0, h], 4)
    return corners, normals * lengths[:, None]
