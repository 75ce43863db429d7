"""Pixels and text land where their 3D point lands; windows positions where the panel has them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.pictures.beside import FOV, GL, Beside, flat, looking, sphere

GLYPH = np.packbits(np.random.default_rng(4).integers(0, 2, (16, 16)), axis=1)


def pixels(width: int = 20, height: int = 14) -> np.ndarray:
    rows, columns = np.mgrid[0:height, 0:width]
    return np.stack([columns * 12, rows * 18, 255 - columns * 10], -1).astype(np.uint8)


def write(gl: GL, count: int = 3) -> None:
    """Bitmaps side by side, as a bitmap font's characters are."""
    gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
    for _ in range(count):
        gl.glBitmap(16, 16, 2, 3, 18, 0, GLYPH)


def paint(gl: GL) -> None:
    gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
    gl.glDrawPixels(20, 14, gl.GL_RGB, gl.GL_UNSIGNED_BYTE, pixels())


POSITIONS: dict[str, tuple[float, ...]] = {
    "glRasterPos2f": (0.3, -0.2),
    "glRasterPos2d": (0.3, -0.2),
    "glRasterPos2i": (0, 0),
    "glRasterPos2s": (0, 0),
    "glRasterPos3f": (0.3, -0.2, 0.5),
    "glRasterPos3d": (0.3, -0.2, 0.5),
    "glRasterPos4f": (0.6, -0.2, 0.5, 2),
    "glRasterPos4i": (1, 0, 1, 2),
    "glRasterPos": (0.3, -0.2, 0.5),
    "glRasterPos2fv": (0.3, -0.2),
    "glRasterPos3fv": (0.3, -0.2, 0.5),
    "glRasterPos3dv": (0.3, -0.2, 0.5),
    "glWindowPos2f": (60, 90),
    "glWindowPos2i": (60, 90),
    "glWindowPos2d": (60, 90),
    "glWindowPos3f": (60, 90, 0.2),
    "glWindowPos3i": (60, 90, 0),
    "glWindowPos2fv": (60, 90),
    "glWindowPos2iv": (60, 90),
    "glWindowPos3dv": (60, 90, 0.5),
}


def call(gl: GL, name: str) -> None:
    values = POSITIONS[name]
    getattr(gl, name)(*([values] if name.endswith("v") else values))


@pytest.mark.parametrize("in_list", [False, True])
@pytest.mark.parametrize("name", POSITIONS)
def test_text_stands_where_its_point_is(beside: Beside, name: str, in_list: bool) -> None:
    def scene(gl: GL) -> Any:
        looking(gl)
        sphere(gl, 0.3, 48, 32)
        gl.glColor3f(1, 0.8, 0)
        if in_list:
            gl.glNewList(3, gl.GL_COMPILE)
        call(gl, name)
        write(gl)
        paint(gl)
        if in_list:
            gl.glEndList()
            gl.glCallList(3)
        return gl.glGetBooleanv(gl.GL_CURRENT_RASTER_POSITION_VALID)

    beside.equal(scene, name=f"{name} {in_list}", wrong=0.01)


def test_raster_color_and_texture(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        for k in range(5):
            gl.glColor3f(1, k / 5, 0.5)
            gl.glRasterPos3f(k / 4 - 0.6, k / 4 - 0.5, -k / 5)
            gl.glColor3f(0, 0, 0)
            write(gl, 1)

    beside.equal(scene, wrong=0.005)


def ask_raster(gl: GL) -> list[Any]:
    """The raster position, and what gluProject says of points, where a program asks for both."""
    gl.glClear(gl.GL_COLOR_BUFFER_BIT)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.gluPerspective(60, 1, 1, 100)
    gl.gluLookAt(0, 1, 3, 0, 0, 0, 0, 1, 0)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glDepthRange(0.1, 0.8)
    answers: list[Any] = []
    for point in ((0, 0, 0), (1, 2, -3), (-3, -1, -7)):
        gl.glColor3f(*np.abs(point) / 10)
        gl.glRasterPos3f(*point)
        position = gl.glGetDoublev(gl.GL_CURRENT_RASTER_POSITION)
        np.testing.assert_allclose(position[:2], gl.gluProject(*point)[:2], atol=2e-3)
        distance = gl.glGetFloatv(gl.GL_CURRENT_RASTER_DISTANCE)
        answers += [*position, distance, *gl.glGetFloatv(gl.GL_CURRENT_RASTER_COLOR)]
        answers += gl.glGetIntegerv(gl.GL_CURRENT_RASTER_POSITION).tolist()
        answers += [gl.glGetBooleanv(gl.GL_CURRENT_RASTER_POSITION_VALID)]
        into = np.zeros(4, np.float32)
        gl.glGetFloatv(gl.GL_CURRENT_RASTER_POSITION, into)
        answers += into.tolist()
    gl.glDepthRange(0, 1)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gl.gluOrtho2D(0, 100, 0, 100)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glRasterPos2f(30, 40)
    return [*answers, *gl.glGetFloatv(gl.GL_CURRENT_RASTER_POSITION)]


@pytest.mark.parametrize(
    "options",
    [
        {},
        {"fov": 200.0, "tilt": 30.0},
        {"method": "paper"},
        {"hud": "flat"},
        {"method": "cubemap"},
        {"method": "cubemap", "fov": 220.0, "tilt": 40.0},
    ],
)
def test_the_raster_position_is_told_as_on_the_monitor(beside: Beside, options: dict[str, Any]) -> None:
    theirs = beside.monitor(ask_raster).answer
    ours = beside.through_dome(ask_raster, **({"fov": 180.0} | options)).answer
    np.testing.assert_allclose(np.array(ours, float), np.array(theirs, float), rtol=2e-5, atol=2e-3)


def test_a_window_position_is_told_as_it_was_set(beside: Beside) -> None:
    def scene(gl: GL) -> Any:
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.gluPerspective(60, 1, 1, 100)
        gl.glWindowPos3f(30, 40, 0.75)
        return gl.glGetFloatv(gl.GL_CURRENT_RASTER_POSITION)

    assert beside.through_dome(scene, fov=180.0).answer[:3] == pytest.approx([30, 40, 0.75], abs=1e-4)


def test_a_raster_position_never_set_is_gls_own(beside: Beside) -> None:
    def scene(gl: GL) -> Any:
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        return gl.glGetFloatv(gl.GL_CURRENT_RASTER_POSITION)

    assert beside.through_dome(scene, fov=180.0).answer.tolist() == [0, 0, 0, 1]


def test_lit_raster_position(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        gl.glEnable(gl.GL_LIGHTING)
        gl.glEnable(gl.GL_LIGHT0)
        gl.glMaterialfv(gl.GL_FRONT, gl.GL_DIFFUSE, (0.2, 1, 0.4, 1))
        gl.glNormal3f(0, 0.5, 1)
        gl.glRasterPos2f(-0.2, 0.1)
        write(gl)

    beside.equal(scene, wrong=0.005)


@pytest.mark.parametrize("where", [(3, 0, 0), (0, -3, 0), (0, 0, 200), (0, 0, -150)])
def test_nothing_is_drawn_from_outside_the_view(beside: Beside, where: tuple[float, float, float]) -> None:
    """Above, aside, behind the viewer, beyond the far plane: all outside this narrow dome as well."""

    def scene(gl: GL) -> None:
        looking(gl)
        gl.glTranslatef(*where)
        gl.glRasterPos3f(0, 0, 0)
        write(gl)
        paint(gl)
        gl.glLoadIdentity()
        gl.glTranslatef(0, 0, -114)
        gl.glRectf(-0.2, -0.2, 0.2, 0.2)

    beside.equal(scene, name=f"raster at {where}", wrong=0.004)


@pytest.mark.parametrize(("z", "seen"), [(-5.0, True), (5.0, False)])
def test_a_point_behind_the_viewer_draws_nothing(beside: Beside, z: float, seen: bool) -> None:
    def scene(gl: GL) -> None:
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.gluPerspective(60, 1, 1, 100)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        for x in (-1, 0, 1):
            gl.glRasterPos3f(x, x, z)
            write(gl)
            paint(gl)

    assert beside.through_dome(scene, fov=180).picture.any() == seen


def hud(gl: GL) -> None:
    """Text by glRasterPos, by glWindowPos, and a bar, over a sphere in perspective."""
    looking(gl)
    sphere(gl, 0.4)
    gl.glColor3f(1, 1, 0)
    gl.glDisable(gl.GL_DEPTH_TEST)
    flat(gl)
    gl.glRasterPos2f(60.5, 200.5)
    write(gl)
    gl.glRectf(60, 40, 190, 50)
    gl.glWindowPos2f(100.5, 60.5)
    write(gl)


def test_head_up_text(beside: Beside) -> None:
    beside.equal(hud, wrong=0.008)


def test_hud_off_leaves_its_text_out(beside: Beside) -> None:
    def without(gl: GL) -> None:
        looking(gl)
        sphere(gl, 0.4)

    picture = beside.through_dome(hud, hud="off").picture
    beside.assert_equal(beside.monitor(without).picture, picture, name="hud off")


def test_hud_text_drawn_after_the_perspective_is_back(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        sphere(gl, 0.4)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glPushMatrix()
        flat(gl)
        gl.glRasterPos2f(60.5, 200.5)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glPopMatrix()
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glDisable(gl.GL_DEPTH_TEST)
        write(gl)

    def without(gl: GL) -> None:
        looking(gl)
        sphere(gl, 0.4)

    beside.equal(scene, wrong=0.005)
    picture = beside.through_dome(scene, hud="off").picture
    beside.assert_equal(beside.monitor(without).picture, picture, name="hud text off")


def test_zoomed_masked_and_textured_pixels(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        gl.glRasterPos2f(-0.5, 0)
        gl.glPixelZoom(3, -2)
        gl.glPixelTransferf(gl.GL_RED_SCALE, 0.5)
        paint(gl)
        gl.glPixelZoom(1, 1)
        gl.glEnable(gl.GL_ALPHA_TEST)
        gl.glAlphaFunc(gl.GL_GREATER, 0.5)
        rgba = np.dstack([pixels(), np.where(pixels()[..., 0] > 120, 255, 0)]).astype(np.uint8)
        gl.glRasterPos2f(0.2, 0.2)
        gl.glDrawPixels(20, 14, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE, rgba)

    beside.equal(scene, wrong=0.01)


def test_copied_pixels(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        gl.glDisable(gl.GL_DEPTH_TEST)
        gl.glWindowPos2i(100, 100)
        paint(gl)
        gl.glRasterPos2f(0.3, 0.3)
        gl.glCopyPixels(100, 100, 20, 14, gl.GL_COLOR)
        gl.glWindowPos2i(40, 90)
        gl.glCopyPixels(95, 95, 30, 24, gl.GL_COLOR)

    beside.equal(scene, wrong=0.01)


def test_panel_program_without_a_perspective(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        flat(gl)
        for k in range(10):
            gl.glColor3f(1, k / 10, 0)
            gl.glRectf(60 + 10 * k, 60, 68 + 10 * k, 60 + 10 * k)
        gl.glRasterPos2f(70.5, 170.5)
        write(gl)
        gl.glWindowPos2i(70, 190)
        paint(gl)

    beside.equal(scene, wrong=0.006)


def test_inset_viewport(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        sphere(gl, 0.5)
        gl.glViewport(40, 60, 80, 60)
        gl.glClear(gl.GL_DEPTH_BUFFER_BIT)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glLoadIdentity()
        gl.gluPerspective(FOV, 80 / 60, 100, 130)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glColor3f(1, 0, 0)
        sphere(gl, 0.8)
        gl.glColor3f(1, 1, 1)
        gl.glRasterPos2f(0, 0)
        write(gl, 1)

    beside.equal(scene, wrong=0.006)


@pytest.mark.parametrize("method", ["auto", "tessellate", "geometry", "cpu"])
def test_an_inset_view_from_amid_its_scene(beside: Beside, method: str) -> None:
    """A floor and lines that pass the inset's viewer: what is behind that is nowhere on the panel."""

    def scene(gl: GL) -> None:
        looking(gl)
        sphere(gl, 0.5)
        gl.glViewport(40, 60, 90, 60)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glLoadIdentity()
        gl.gluPerspective(60, 90 / 60, 0.5, 50)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glLoadIdentity()
        gl.glDisable(gl.GL_DEPTH_TEST)
        gl.glLineWidth(3)
        for x in range(-4, 5):
            gl.glColor3f(0.2, 0.9 - 0.1 * abs(x), 0.5)
            gl.glBegin(gl.GL_TRIANGLES)
            for corner in ((x, -1, 9), (x + 0.8, -1, 7), (x + 0.3, -1, -9)):
                gl.glVertex3f(*corner)
            gl.glEnd()
            gl.glBegin(gl.GL_LINES)
            gl.glVertex3f(x, 1, -12)
            gl.glVertex3f(-x, 2, 6)
            gl.glEnd()

    beside.equal(scene, name=f"amid {method}", wrong=0.006, method=method)
