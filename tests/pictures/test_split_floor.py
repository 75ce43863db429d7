"""A floor that reaches behind the viewer is drawn in many pieces, and looks like one surface all the same."""

import numpy as np
import pytest

from tests.pictures.test_subdivision import METHODS, SIZE, immediately, listed, perspective

FLOOR = np.array([(-50, -1, -50), (-50, -1, 50), (50, -1, 50), (50, -1, -50)], float)
LAMP = np.array([-40, 5, -40], float)


def lit_floor(gl):
    """A quad that reaches far behind the viewer, lit at its corners by a lamp above one of them."""
    perspective(gl)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glEnable(gl.GL_LIGHT0)
    gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, [*LAMP, 1])
    gl.glMaterialfv(gl.GL_FRONT, gl.GL_AMBIENT, [0, 0, 0, 1])
    gl.glMaterialfv(gl.GL_FRONT, gl.GL_DIFFUSE, [1, 1, 1, 1])


def floor_seen():
    """(SIZE, SIZE, 2) x and z of the floor in each pixel of a 180 degree dome; nan where there is none."""
    column, row = np.meshgrid((np.arange(SIZE) + 0.5) / SIZE * 2 - 1, 1 - (np.arange(SIZE) + 0.5) / SIZE * 2)
    radius = np.hypot(column, row)
    scale = np.sin(radius * np.pi / 2) / radius
    x, y, z = column * scale, row * scale, -np.cos(radius * np.pi / 2)
    with np.errstate(divide="ignore"):
        place = np.stack([x, z], -1) / -y[..., None]
    seen = (y < -0.03) & (np.abs(place) < 49).all(-1) & (radius < 0.98)
    return np.where(seen[..., None], place, np.nan)


@pytest.mark.parametrize("shade_model", ["GL_SMOOTH", "GL_FLAT"])
@pytest.mark.parametrize("way", [immediately, listed])
@pytest.mark.parametrize("method", ["auto", "geometry"])
def test_a_lit_floor_is_lit_at_its_own_corners(beside, way, method, shade_model):
    def scene(gl):
        lit_floor(gl)
        gl.glNormal3f(0, 1, 0)
        gl.glShadeModel(getattr(gl, shade_model))
        way(gl, gl.GL_QUADS, FLOOR)

    picture = beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method=method).picture[..., 0]
    to_lamp = LAMP - FLOOR
    lit = 255 * to_lamp[:, 1] / np.linalg.norm(to_lamp, axis=1)
    x, z = (floor_seen()[..., axis] / 100 + 0.5 for axis in (0, 1))
    seen = np.isfinite(x)
    # Cut from corner 1 to corner 3, as GL cuts quads here; on each side colour is even in x and z.
    one = lit[0] + (lit[1] - lit[0]) * z + (lit[3] - lit[0]) * x
    other = lit[2] + (lit[1] - lit[2]) * (1 - x) + (lit[3] - lit[2]) * (1 - z)
    want = np.where(x + z < 1, one, other) if shade_model == "GL_SMOOTH" else lit[3]
    assert seen.sum() > 50_000
    assert np.abs(picture - want)[seen].max() < 2.5


@pytest.mark.parametrize("method", METHODS)
def test_a_clip_plane_cuts_a_floor_straight(beside, method):
    """Across all pieces, through the point below the viewer."""

    def scene(gl):
        perspective(gl)
        gl.glClipPlane(gl.GL_CLIP_PLANE1, [2, 0, 1, 0])
        gl.glEnable(gl.GL_CLIP_PLANE1)
        immediately(gl, gl.GL_QUADS, FLOOR)

    picture = beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method=method).picture[..., 0] > 128
    x, z = (floor_seen()[..., axis] for axis in (0, 1))
    seen = np.isfinite(x)
    assert ((picture != (2 * x + z > 0)) & seen).sum() < 0.005 * seen.sum()


@pytest.mark.parametrize("generated", [False, True], ids=["given", "generated"])
@pytest.mark.parametrize("method", METHODS)
def test_texture_coordinates_are_those_of_the_floor(beside, method, generated):
    texels = np.zeros((64, 64, 3), np.uint8)
    texels[..., 0], texels[..., 1] = np.arange(64) * 4, np.arange(64)[:, None] * 4

    def scene(gl):
        perspective(gl)
        gl.glEnable(gl.GL_TEXTURE_2D)
        for parameter in (gl.GL_TEXTURE_MIN_FILTER, gl.GL_TEXTURE_MAG_FILTER):
            gl.glTexParameteri(gl.GL_TEXTURE_2D, parameter, gl.GL_LINEAR)
        gl.glTexImage2D(gl.GL_TEXTURE_2D, 0, gl.GL_RGB, 64, 64, 0, gl.GL_RGB, gl.GL_UNSIGNED_BYTE, texels)
        for axis, plane in (("S", [0.01, 0, 0, 0.5]), ("T", [0, 0, 0.01, 0.5])):
            gl.glTexGeni(getattr(gl, f"GL_{axis}"), gl.GL_TEXTURE_GEN_MODE, gl.GL_OBJECT_LINEAR)
            gl.glTexGenfv(getattr(gl, f"GL_{axis}"), gl.GL_OBJECT_PLANE, plane)
            if generated:
                gl.glEnable(getattr(gl, f"GL_TEXTURE_GEN_{axis}"))
        gl.glBegin(gl.GL_QUADS)
        for x, y, z in FLOOR:
            gl.glTexCoord2f(0.5 + x / 100, 0.5 + z / 100)
            gl.glVertex3f(x, y, z)
        gl.glEnd()

    picture = beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method=method).picture[..., :2]
    want = 4 * ((0.5 + floor_seen() / 100) * 64 - 0.5)
    seen = np.isfinite(want).all(-1) & (np.abs(want - 126) < 120).all(-1)
    assert seen.sum() > 40_000
    assert np.abs(picture - want)[seen].max() < 4
