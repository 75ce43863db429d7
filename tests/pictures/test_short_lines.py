"""Curves of lines shorter than a pixel are whole, and as wide and bright as long lines.

Mesa's CPU driver leaves out multisampled lines that no border between two pixels crosses.
"""

import numpy as np
import pytest
from scipy import ndimage

from domeshim.measure.pixels import read_pixels
from domeshim.window.contract import SurfaceFormat
from tests.pictures.test_subdivision import from_array, from_buffer, immediately, listed, perspective

SIZE = 256
MIDDLE = slice(SIZE // 4, 3 * SIZE // 4)


@pytest.fixture
def multisampled(beside, monkeypatch):
    monkeypatch.setattr(beside, "surface", SurfaceFormat(samples=4))
    return beside


def brightness(beside, scene, **options):
    """How much light each column of the picture's middle half has, 255 for one white pixel."""
    with beside.window((SIZE, SIZE), fov=180.0, **options) as finish:
        scene(beside.dome)
        finish()
        gl = beside.stock
        assert gl.glGetIntegerv(gl.GL_SAMPLES) == 4
        picture = np.frombuffer(read_pixels(SIZE, SIZE), np.uint8).reshape(SIZE, SIZE, 3)
        return picture[:, MIDDLE, 0].sum(0, int)


def level(pieces):
    """No piece of the one long line ends beside a border of the driver's tiles, where it loses a pixel."""
    return [(x, 0.01, -1) for x in np.linspace(-5, 5, pieces + 1)]


def drawn(way, mode, vertices):
    def scene(gl):
        perspective(gl)
        way(gl, getattr(gl, mode), vertices)

    return scene


@pytest.mark.parametrize("way", [immediately, listed, from_array, from_buffer])
def test_a_strip_of_short_lines_is_one_line(multisampled, way):
    one = brightness(multisampled, drawn(way, "GL_LINE_STRIP", level(1)))
    many = brightness(multisampled, drawn(way, "GL_LINE_STRIP", level(5000)))
    assert one.min() > 200
    np.testing.assert_allclose(many, one, atol=40)


def test_short_lines_beside_triangles(multisampled):
    def scene(gl):
        perspective(gl)
        immediately(gl, gl.GL_TRIANGLES, [(-0.1, -2, -1), (0.1, -2, -1), (0, -1.5, -1)])
        immediately(gl, gl.GL_LINE_STRIP, level(5000))
        immediately(gl, gl.GL_TRIANGLES, [(-0.1, -2, -1), (0.1, -2, -1), (0, -1.5, -1)] * 10)

    found = brightness(multisampled, scene)
    assert found.min() > 200
    assert found[SIZE // 4] > 2 * np.median(found)


def test_flat_programs_curves(multisampled):
    def scene(gl):
        immediately(gl, gl.GL_LINE_STRIP, [(x, 0.01, 0) for x in np.linspace(-1, 1, 3000)])

    found = brightness(multisampled, scene, panel=120.0)
    assert found[8:-8].min() > 200


def straight_nurbs(gl):
    nurbs = gl.gluNewNurbsRenderer()
    gl.gluNurbsProperty(nurbs, gl.GLU_SAMPLING_TOLERANCE, 0.3)
    gl.gluBeginCurve(nurbs)
    points = np.array([(x, 0.01, -1) for x in (-4, -1, 1, 4)], np.float32)
    gl.gluNurbsCurve(nurbs, np.repeat([0, 1], 4).astype(np.float32), points, gl.GL_MAP1_VERTEX_3)
    gl.gluEndCurve(nurbs)


def evaluated(gl, pieces=5000):
    gl.glMap1f(gl.GL_MAP1_VERTEX_3, 0, 1, [(-4, 0.01, -1), (4, 0.01, -1)])
    gl.glEnable(gl.GL_MAP1_VERTEX_3)
    gl.glMapGrid1f(pieces, 0, 1)
    gl.glEvalMesh1(gl.GL_LINE, 0, pieces)


def rational(gl, pieces=5000):
    gl.glMap1f(gl.GL_MAP1_VERTEX_4, 0, 1, [(-8, 0.02, -2, 2), (4, 0.01, -1, 1)])
    gl.glEnable(gl.GL_MAP1_VERTEX_4)
    gl.glMapGrid1f(pieces, 0, 1)
    gl.glEvalMesh1(gl.GL_LINE, 0, pieces)


@pytest.mark.parametrize("in_list", [False, True])
@pytest.mark.parametrize("curve", [straight_nurbs, evaluated, rational])
def test_curves_that_gl_makes_are_whole(multisampled, curve, in_list):
    def scene(gl):
        perspective(gl)
        if in_list:
            gl.glNewList(1, gl.GL_COMPILE)
        curve(gl)
        if in_list:
            gl.glEndList()
            gl.glCallList(1)

    assert brightness(multisampled, scene).min() > 200


def test_long_pieces_of_a_curve_that_gl_makes_bend(beside):
    def scene(gl):
        perspective(gl)
        gl.glTranslatef(0, 1, 0)
        evaluated(gl, pieces=2)

    def lit(scene, method):
        return beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method=method).picture[..., 0] > 0

    truth = lit(drawn(immediately, "GL_LINE_STRIP", [(x, 1.01, -1) for x in (-4, 0, 4)]), "auto")
    near = ndimage.binary_dilation(truth, np.ones((3, 3)))
    assert truth.sum() > 100
    assert not (lit(scene, "auto") & ~near).any()
    assert (lit(scene, "vertex") & ~near).sum() > 50
