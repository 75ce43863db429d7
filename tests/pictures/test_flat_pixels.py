"""Bitmaps and images that are drawn flat are as large on the panel as they were in the monitor's window."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from tests.pictures.beside import GL, SIZE, Beside, Scene, flat

PLACES = [(20, 180, 50, 40), (150, 30, 70, 20), (100, 100, 24, 60), (200, 196, 80, 60)]
"""x, y, width, height; the last reaches beyond the window."""
WIDE: dict[str, Any] = {"fov": 180.0, "panel": 60.0}


def rectangle(gl: GL, x: int, y: int, width: int, height: int) -> None:
    gl.glRectf(x, y, x + width, y + height)


def bitmap(gl: GL, x: int, y: int, width: int, height: int) -> None:
    """In two halves, the second from where the first moves on to; unpacked in as many ways as there are."""
    gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 2)
    gl.glPixelStorei(gl.GL_UNPACK_ROW_LENGTH, width + 13)
    gl.glPixelStorei(gl.GL_UNPACK_SKIP_PIXELS, 5)
    gl.glPixelStorei(gl.GL_UNPACK_SKIP_ROWS, 1)
    gl.glPixelStorei(gl.GL_UNPACK_LSB_FIRST, width % 4)
    left = width // 2
    gl.glRasterPos2f(x + 3, y + 4)
    for part in (left, width - left):
        bits = np.zeros((height + 1, width + 13), np.uint8)
        bits[1:, 5 : 5 + part] = 1
        order = "little" if width % 4 else "big"
        rows = np.packbits(bits, axis=1, bitorder=order)
        rows = np.pad(rows, ((0, 0), (0, rows.shape[1] % 2)))
        gl.glBitmap(part, height, 3, 4, part, 0, rows.tobytes())


def image(gl: GL, x: int, y: int, width: int, height: int) -> None:
    """Upside down, one of its pixels for two each way."""
    colour = (np.array(gl.glGetFloatv(gl.GL_CURRENT_COLOR)) * 255).round().astype(np.uint8)
    gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
    gl.glPixelZoom(2, -2)
    gl.glRasterPos2f(x, min(y + height, SIZE - 0.001))
    pixels = np.tile(colour, (height // 2, width // 2, 1))
    gl.glDrawPixels(width // 2, height // 2, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE, pixels)


def drawn(draw: Callable[..., None], *, hud: bool, in_list: bool = False, busy: bool = False) -> Scene:
    """A scene of things in several colours; busy: under state that rectangles shall not have."""

    def scene(gl: GL) -> None:
        gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
        if hud:
            gl.glMatrixMode(gl.GL_PROJECTION)
            gl.gluPerspective(70, 1, 1, 50)
            gl.glMatrixMode(gl.GL_MODELVIEW)
            gl.glTranslatef(0, 0, -5)
            gl.glRectf(-1, -1, 0.5, 0.5)
        flat(gl)
        if busy:
            gl.glEnable(gl.GL_CULL_FACE)
            gl.glFrontFace(gl.GL_CW)
            gl.glPolygonMode(gl.GL_FRONT_AND_BACK, gl.GL_LINE)
            gl.glFogfv(gl.GL_FOG_COLOR, (1, 0, 0, 1))
            gl.glEnable(gl.GL_FOG)
            gl.glFogi(gl.GL_FOG_MODE, gl.GL_LINEAR)
            gl.glFogf(gl.GL_FOG_START, 5)
            gl.glFogf(gl.GL_FOG_END, 9)
        for number, place in enumerate(PLACES):
            gl.glColor3f(1, number / 3, 0.4)
            if in_list:
                gl.glNewList(7, gl.GL_COMPILE)
            draw(gl, *place)
            if in_list:
                gl.glEndList()
                gl.glCallLists(bytes([7]))

    return scene


@pytest.mark.parametrize("hud", [False, True])
@pytest.mark.parametrize(
    "options", [{}, {"method": "cubemap"}, {"tilt": 25.0}, {"stereo": "top-bottom"}], ids=str
)
@pytest.mark.parametrize("draw", [bitmap, image])
def test_it_is_where_a_rectangle_is(
    beside: Beside, draw: Callable[..., None], options: dict[str, Any], hud: bool
) -> None:
    if draw is image and options.get("method") == "cubemap" and not hud:
        options = {**options, "panel": 61.0}  # a face's border in the middle of the image
    as_rectangles = beside.through_dome(drawn(rectangle, hud=hud), **(WIDE | options)).picture
    picture = beside.through_dome(drawn(draw, hud=hud), **(WIDE | options)).picture
    assert (as_rectangles > 0).any(-1).mean() > 0.004
    beside.assert_equal(as_rectangles, picture, name=f"{draw.__name__} {options} {hud}", wrong=0.003)


@pytest.mark.parametrize("hud", [False, True])
def test_a_bitmap_in_a_display_list_is_as_large(beside: Beside, hud: bool) -> None:
    as_rectangles = beside.through_dome(drawn(rectangle, hud=hud), **WIDE).picture
    picture = beside.through_dome(drawn(bitmap, hud=hud, in_list=True), **WIDE).picture
    beside.assert_equal(as_rectangles, picture, name=f"listed {hud}", wrong=0.003)


@pytest.mark.parametrize("draw", [bitmap, image])
def test_what_polygons_are_drawn_by_is_not_its_own(beside: Beside, draw: Callable[..., None]) -> None:
    as_rectangles = beside.through_dome(drawn(rectangle, hud=True), **WIDE).picture
    picture = beside.through_dome(drawn(draw, hud=True, busy=True), **WIDE).picture
    beside.assert_equal(as_rectangles, picture, name=f"busy {draw.__name__}", wrong=0.003)


def test_the_raster_position_moves_on_as_in_the_window(beside: Beside) -> None:
    def scene(gl: GL) -> Any:
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        flat(gl)
        gl.glColor3f(0.2, 0.4, 0.6)
        gl.glRasterPos2f(30, 200)
        gl.glColor3f(1, 1, 1)
        answers = []
        for _ in range(3):
            gl.glBitmap(8, 8, 0, 0, 40, -30, bytes(32))
            answers += list(gl.glGetFloatv(gl.GL_CURRENT_RASTER_POSITION)[:2])
            answers += list(gl.glGetFloatv(gl.GL_CURRENT_RASTER_COLOR))
        return [
            *answers,
            *gl.glGetFloatv(gl.GL_CURRENT_COLOR),
            *gl.glGetDoublev(gl.GL_MODELVIEW_MATRIX).ravel(),
        ]

    theirs = beside.monitor(scene).answer
    np.testing.assert_allclose(beside.through_dome(scene, **WIDE).answer, theirs, atol=2e-3)


@pytest.mark.parametrize("hud", [False, True])
@pytest.mark.parametrize("options", [{}, {"method": "cubemap"}, {"stereo": "top-bottom"}], ids=str)
@pytest.mark.parametrize("write", [False, True])
def test_without_a_raster_position_it_starts_in_the_windows_corner(
    beside: Beside, write: bool, options: dict[str, Any], hud: bool
) -> None:
    """As the pictures of a ray tracer, say. The bitmaps are white, as GL's own beginning is."""

    def scene(gl: GL, placed: bool) -> None:
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glMatrixMode(gl.GL_PROJECTION)
        if hud:
            gl.gluPerspective(70, 1, 1, 50)
            gl.glBegin(gl.GL_POINTS)
            gl.glVertex3f(0, 0, -2)
            gl.glEnd()
            gl.glLoadIdentity()
        gl.glMatrixMode(gl.GL_MODELVIEW)
        if placed:
            gl.glWindowPos3f(0, 0, 0)
        gl.glColor3f(1, 0, 0.4)
        for _ in range(2):
            if write:
                gl.glBitmap(96, 64, 0, 0, 64, 30, b"\xff" * 768)
            else:
                gl.glDrawPixels(96, 80, gl.GL_RGB, gl.GL_UNSIGNED_BYTE, b"\x60\xc0\xf0" * 7680)

    theirs = beside.through_dome(lambda gl: scene(gl, True), **(WIDE | options)).picture
    ours = beside.through_dome(lambda gl: scene(gl, False), **(WIDE | options)).picture
    assert (theirs > 0).any(-1).mean() > 0.004
    beside.assert_equal(theirs, ours, name=f"no position {write} {options} {hud}", wrong=0.003)
