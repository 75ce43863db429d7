"""glAccum works without an accumulation buffer: sums of pictures are what numpy makes of them."""

from __future__ import annotations

import numpy as np
import pytest

from domeshim.session import Session
from tests.pictures.beside import GL, Beside, Picture, checks, looking, sphere


def first(gl: GL) -> None:
    looking(gl)
    gl.glColor3f(1, 0.5, 0)
    sphere(gl, 0.5)


def second(gl: GL) -> None:
    looking(gl)
    gl.glTranslatef(0.3, 0.2, 0)
    gl.glColor3f(0, 0.5, 1)
    sphere(gl, 0.5)


def picture(beside: Beside, scene: object) -> Picture:
    return beside.through_dome(scene).picture


@pytest.mark.parametrize("in_list", [False, True])
def test_the_mean_of_two_pictures(beside: Beside, in_list: bool) -> None:
    def scene(gl: GL) -> None:
        gl.glClearAccum(0, 0, 0, 0)
        gl.glClear(gl.GL_ACCUM_BUFFER_BIT)
        for draw in (first, second):
            draw(gl)
            if in_list:
                gl.glNewList(1, gl.GL_COMPILE)
            gl.glAccum(gl.GL_ACCUM, 0.5)
            if in_list:
                gl.glEndList()
                gl.glCallList(1)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        checks(gl)  # textures and fog must not touch what comes back
        gl.glEnable(gl.GL_FOG)
        gl.glAccum(gl.GL_RETURN, 1)

    mean = (picture(beside, first).astype(int) + picture(beside, second)) / 2
    assert np.abs(picture(beside, scene) - mean).max() <= 1


def test_every_operation(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        gl.glClearAccum(0.2, 0.1, 0, 0)
        gl.glClear(gl.GL_ACCUM_BUFFER_BIT)
        first(gl)
        gl.glAccum(gl.GL_ACCUM, 0.5)
        gl.glAccum(gl.GL_MULT, 0.5)
        gl.glAccum(gl.GL_ADD, 0.1)
        gl.glAccum(gl.GL_RETURN, 2)
        assert tuple(gl.glGetFloatv(gl.GL_ACCUM_CLEAR_VALUE)[:2]) == pytest.approx((0.2, 0.1))

    drawn = picture(beside, first) / 255
    wanted = np.clip(2 * ((drawn * 0.5 + (0.2, 0.1, 0)) * 0.5 + 0.1), 0, 1)
    found = picture(beside, scene) / 255
    inside = drawn.any(-1)
    assert np.abs(found - wanted)[inside].max() < 1.5 / 255


def test_loading_and_masks(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        first(gl)
        gl.glAccum(gl.GL_LOAD, 1)
        second(gl)
        gl.glColorMask(1, 0, 0, 0)
        gl.glAccum(gl.GL_RETURN, 1)

    one, two = picture(beside, first), picture(beside, second)
    wanted = np.dstack([one[..., :1], two[..., 1:]])
    assert np.abs(picture(beside, scene).astype(int) - wanted).max() <= 1


def test_also_on_the_monitor(beside: Beside) -> None:
    """Off screen the monitor's picture needs it as well, and there is no dome to do it."""
    import OpenGL.GL

    from domeshim.intercept.gl import replacements
    from domeshim.window.contract import SurfaceFormat, WindowEvents

    session = Session(backend=lambda: beside.backend)
    module = type(OpenGL.GL)("stock")
    vars(module).update(vars(beside.stock))
    ours = replacements(session, module)
    gl = beside.stock
    window = beside.backend.open_window("", (32, 32), None, SurfaceFormat(), WindowEvents())
    session.window_opened(window, (32, 32))
    gl.glClearColor(1, 0.5, 0, 1)
    ours["glClear"](gl.GL_COLOR_BUFFER_BIT | gl.GL_ACCUM_BUFFER_BIT)
    ours["glAccum"](gl.GL_LOAD, 0.5)
    ours["glAccum"](gl.GL_RETURN, 1)
    pixel = list(gl.glReadPixels(5, 5, 1, 1, gl.GL_RGB, gl.GL_UNSIGNED_BYTE))
    window.close()
    assert np.abs(np.array(pixel) - (128, 64, 0)).max() <= 1
