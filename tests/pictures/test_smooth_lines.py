"""Smoothed lines (GL_LINE_SMOOTH) lie where others do, on a driver that misplaces their pieces as well."""

from collections.abc import Callable

import numpy as np
import pytest
from scipy import ndimage

from tests.pictures.beside import GL, Beside, Picture
from tests.pictures.own_glsl import both
from tests.pictures.test_subdivision import perspective

SIZE = 512
REACH = 4
"""A smoothed line is a pixel wider on each side, and more where the rim cuts it aslant."""
LINES = [point for k in range(-10, 11) for point in ((k, -3, -30), (k, -3, 30), (-30, -3, k), (30, -3, k))]
GENERIC = """\
#version 120
varying vec4 c;
void main() { c = vec4(1.0); gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }
"""
GENERIC_COLOUR = "#version 120\nvarying vec4 c; void main() { gl_FragColor = c; }"


def immediately(gl: GL) -> None:
    """The lines, each vertex with all that a vertex may have."""
    gl.glBegin(gl.GL_LINES)
    for x, y, z in LINES:
        gl.glNormal3f(0, 1, 0)
        gl.glTexCoord2f(x, z)
        gl.glColor3f(1, 1, 0.5)
        gl.glVertex3f(x, y, z)
    gl.glEnd()


def listed(gl: GL) -> None:
    """The lines out of a display list."""
    gl.glNewList(1, gl.GL_COMPILE)
    immediately(gl)
    gl.glEndList()
    gl.glCallList(1)


def plain(gl: GL) -> None:
    """Nothing but the lines' colour."""


def cut(gl: GL) -> None:
    """A clip plane that all is in front of."""
    gl.glClipPlane(gl.GL_CLIP_PLANE0, (0, 0, 0, 1))
    gl.glEnable(gl.GL_CLIP_PLANE0)


def own(gl: GL) -> None:
    """A program's own shaders."""
    gl.glUseProgram(both(gl, GENERIC, GENERIC_COLOUR))


def drawn(
    beside: Beside, way: Callable[[GL], None], state: Callable[[GL], None], smooth: bool, method: str
) -> Picture:
    """The lines' picture; if they are smoothed, after one that was not, by the same shaders."""

    def scene(gl: GL) -> None:
        assert not gl.glGetIntegerv(gl.GL_SAMPLES)
        perspective(gl)
        gl.glEnable(gl.GL_BLEND)
        gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
        state(gl)
        way(gl)
        if smooth:
            gl.glFinish()
            gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
            gl.glEnable(gl.GL_LINE_SMOOTH)
            way(gl)
            assert gl.glIsEnabled(gl.GL_LINE_SMOOTH)

    return beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method=method).picture


@pytest.mark.parametrize("method", ["auto", "tessellate", "geometry", "cpu"])
@pytest.mark.parametrize("way", [immediately, listed])
@pytest.mark.parametrize("state", [plain, cut, own])
def test_smoothed_lines_lie_where_others_do(beside, state, way, method):
    if state is own and method in ("geometry", "cpu"):
        pytest.skip("own GLSL is not subdivided by this method")
    sharp, smooth = (drawn(beside, way, state, smooth, method).max(-1) > 20 for smooth in (False, True))
    near = np.ones((3, 3), bool)
    assert sharp.sum() > 3000
    assert not (smooth & ~ndimage.binary_dilation(sharp, near, REACH)).any()
    assert not (sharp & ~ndimage.binary_dilation(smooth, near, REACH)).any()


def test_what_own_glsl_draws_unsmoothed_is_said_once(beside, capsys):
    renderer = beside.monitor(lambda gl: gl.glGetString(gl.GL_RENDERER)).answer
    if b"llvmpipe" not in renderer:
        pytest.skip("this driver smooths what shaders subdivide")
    drawn(beside, immediately, own, True, "auto")
    assert capsys.readouterr().err.count("GL_LINE_SMOOTH") == 1
