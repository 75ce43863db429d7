"""Meshes of mixed primitives have no pinhole where they share edges; MESHES=1000 looks at so many."""

import os

import numpy as np
import pytest

from domeshim.measure.watertight import holes, random_mesh, surrounds
from tests.pictures.test_subdivision import perspective

SIZE = 320
MESHES = int(os.environ.get("MESHES", "12"))


def drawn(beside, seed, **options):
    def scene(gl):
        perspective(gl)
        for part in random_mesh(seed):
            gl.glBegin(part.mode)
            for vertex in part.vertices:
                gl.glVertex3f(*vertex)
            gl.glEnd()

    return beside.through_dome(scene, (SIZE, SIZE), **options).picture


@pytest.mark.parametrize(
    ("method", "fov"),
    [("auto", 180.0), ("auto", 360.0), ("tessellate", 220.0), ("geometry", 200.0), ("cpu", 180.0)],
)
def test_random_meshes_have_no_pinhole(beside, method, fov):
    across = (2 * np.arange(SIZE) + 1 - SIZE) / SIZE
    disc = np.hypot(*np.meshgrid(across, across)) < 1 - 1 / SIZE
    sheets = 0
    for seed in range(MESHES):
        picture = drawn(beside, seed, method=method, fov=fov)
        assert holes(picture) == 0, f"mesh {seed}"
        if surrounds(seed):
            assert picture.max(-1)[disc].all(), f"mesh {seed} does not cover the disc"
        else:
            sheets += 1
            assert picture.any()
    assert 0 < sheets < MESHES


def test_a_hole_is_found(beside):
    picture = np.zeros((SIZE, SIZE, 3), np.uint8)
    picture[100:200, 100:200] = 255
    assert holes(picture) == 0
    picture[150, 160] = 0
    assert holes(picture) == 1
