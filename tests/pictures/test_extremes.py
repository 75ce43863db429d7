"""Vertices without a sensible place are left out, and nothing else is disturbed, by whichever method."""

import math

import numpy as np
import pytest

from tests.pictures.test_subdivision import from_array, listed, perspective

pytestmark = pytest.mark.filterwarnings("error::RuntimeWarning")  # users would see them on stderr

SIZE = 256
METHODS = ["vertex", "auto", "tessellate", "geometry", "cpu"]
GOOD = [(-9, 2, -3), (9, 2, -3), (0, 40, -3)]
"""A large triangle in the upper half of the picture."""
BAD = {
    "nan": [(math.nan, -1, -2), (1, -1, -2), (0, -2, -2)],
    "infinite": [(math.inf, -1, -2), (1, -1, -2), (0, -2, -2)],
    "infinite all over": [(-math.inf, -math.inf, -math.inf)] * 3,
    "in the eye": [(0, 0, 0), (0, 0, 0), (0, 0, 0)],
    "a corner in the eye": [(0, 0, 0), (-1, -1, -2), (1, -1, -2)],
    "no area": [(-1, -1, -2), (-1, -1, -2), (-1, -1, -2)],
    "no width": [(-1, -1, -2), (1, -1, -2), (3, -1, -2)],
    "behind": [(-1, -1, 2), (1, -1, 2), (0, -2, 2)],
    "edge on": [(-3, 0, -3), (3, 0, -3), (0, 0, 4)],
    "through the eye": [(-1, -1, -1), (1, 1, 1), (2, 2, 2)],
    "tiny": [(-1e-30, -1e-30, -1e-30), (1e-30, -1e-30, -1e-30), (0, -2e-30, -1e-30)],
    "huge": [(-1e30, -1e30, -1e30), (1e30, -1e30, -1e30), (0, -2e30, -1e30)],
}


def draw(gl, *triangles, mode="GL_TRIANGLES"):
    perspective(gl)
    gl.glBegin(getattr(gl, mode))
    for triangle in triangles:
        for vertex in triangle:
            gl.glVertex3f(*vertex)
    gl.glEnd()


@pytest.mark.parametrize(("method", "fov"), [*((method, 180.0) for method in METHODS), ("auto", 360.0)])
@pytest.mark.parametrize("bad", BAD.values(), ids=BAD)
def test_the_rest_is_not_disturbed(beside, method, fov, bad):
    options = {"fov": fov, "method": method}
    alone = beside.through_dome(lambda gl: draw(gl, GOOD), (SIZE, SIZE), **options).picture[..., 0] > 128
    both = beside.through_dome(lambda gl: draw(gl, GOOD, bad, GOOD), (SIZE, SIZE), **options).picture
    assert alone.any()
    upper = np.s_[: SIZE // 2 - 2]
    assert ((both[..., 0] > 128)[upper] == alone[upper]).all()


@pytest.mark.parametrize("count", [1, 180], ids=["a few", "many"])
@pytest.mark.parametrize("way", [listed, from_array])
@pytest.mark.parametrize("name", ["nan", "infinite", "infinite all over", "in the eye"])
def test_nor_in_lists_and_arrays(beside, way, name, count):
    bad = BAD[name]

    def scene(gl, *triangles):
        perspective(gl)
        way(gl, gl.GL_TRIANGLES, np.reshape(triangles * count, (-1, 3)))

    alone = beside.through_dome(lambda gl: scene(gl, GOOD), (SIZE, SIZE), fov=180.0).picture[..., 0] > 128
    both = beside.through_dome(lambda gl: scene(gl, GOOD, bad, GOOD), (SIZE, SIZE), fov=180.0).picture
    upper = np.s_[: SIZE // 2 - 2]
    assert ((both[..., 0] > 128)[upper] == alone[upper]).all()


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", ["nan", "infinite", "infinite all over", "in the eye", "no area", "behind"])
def test_what_has_no_place_is_not_seen(beside, method, name):
    picture = beside.through_dome(
        lambda gl: draw(gl, BAD[name]), (SIZE, SIZE), fov=180.0, method=method
    ).picture
    assert not picture.any()


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    "bad", [[(math.nan, 0, -1), (1, -1, -2)], [(0, 0, 0), (0, 0, 0)]], ids=["nan", "eye"]
)
def test_lines_without_a_place_are_not_seen(beside, method, bad):
    def scene(gl):
        draw(gl, bad, mode="GL_LINES")

    assert not beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method=method).picture.any()


@pytest.mark.parametrize("method", METHODS)
def test_points_at_infinity_have_a_direction(beside, method):
    """A triangle of directions, as a sky's may be; no far plane lies behind it."""

    def scene(gl, w):
        perspective(gl)
        gl.glEnable(gl.GL_DEPTH_CLAMP)
        gl.glBegin(gl.GL_TRIANGLES)
        for x, y, z in [(-3, -2, -2), (3, -2, -2), (0, 3, -2)]:
            gl.glVertex4f(x, y, z, w)
        gl.glEnd()

    near, far = (
        beside.through_dome(lambda gl, w=w: scene(gl, w), (SIZE, SIZE), fov=180.0, method=method).picture
        for w in (1, 0)
    )
    assert near.any()
    assert (near != far).any(-1).sum() < 20
