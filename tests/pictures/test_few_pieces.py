"""A few vertices that must bend are handed over one by one: the picture is that of arrays."""

import numpy as np
import pytest

from domeshim.draw import submit
from tests.pictures.test_recorder import MODES, ring
from tests.pictures.test_subdivision import perspective

SIZE = 256


def placed(mode, count):
    """(count, 3) vertices that span tens of degrees, (count, 4) colours."""
    points = np.array([(x, y, -3) for x, y in ring(count, "STRIP" in mode)], np.float32)
    colours = np.ones((count, 4), np.float32)
    colours[:, :3] = np.random.default_rng(count).uniform(0.2, 1, (count, 3))
    return points, colours


@pytest.fixture
def replayed(monkeypatch):
    found = []
    drawing_of = submit.drawing_of

    def spy(*args):
        found.append(args)
        return drawing_of(*args)

    monkeypatch.setattr(submit, "drawing_of", spy)
    return found


@pytest.mark.parametrize(("method", "tolerance"), [("auto", 0.5), ("geometry", 3.0)])
@pytest.mark.parametrize("shade", ["GL_SMOOTH", "GL_FLAT"])
@pytest.mark.parametrize("mode", MODES)
def test_one_by_one_as_from_arrays(beside, replayed, mode, shade, method, tolerance):
    for count in (4, 12):
        points, colours = placed(mode, count)
        current = []

        def one_by_one(gl, points=points, colours=colours, current=current):
            perspective(gl)
            gl.glShadeModel(getattr(gl, shade))
            gl.glBegin(getattr(gl, f"GL_{mode}"))
            for point, colour in zip(points.tolist(), colours.tolist(), strict=True):
                gl.glColor4f(*colour)
                gl.glVertex3f(*point)
            gl.glEnd()
            current.append(gl.glGetFloatv(gl.GL_CURRENT_COLOR))

        def from_arrays(gl, points=points, colours=colours):
            perspective(gl)
            gl.glShadeModel(getattr(gl, shade))
            gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
            gl.glEnableClientState(gl.GL_COLOR_ARRAY)
            gl.glVertexPointer(3, gl.GL_FLOAT, 0, points)
            gl.glColorPointer(4, gl.GL_FLOAT, 0, colours)
            gl.glDrawArrays(getattr(gl, f"GL_{mode}"), 0, len(points))
            gl.glDisableClientState(gl.GL_COLOR_ARRAY)
            gl.glDisableClientState(gl.GL_VERTEX_ARRAY)

        one, other = (
            beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method=method, tolerance=tolerance).picture
            for scene in (one_by_one, from_arrays)
        )
        assert one.any()
        assert (one == other).all()
        np.testing.assert_allclose(current[0], colours[-1], atol=1e-6)
    assert len(replayed) == 2


def quad(gl, colours):
    """One colour before each corner, or none."""
    gl.glBegin(gl.GL_QUADS)
    for colour, (x, y) in zip(colours, ((-1, -1), (1, -1), (1, 1), (-1, 1)), strict=True):
        if colour:
            gl.glColor3f(*colour)
        gl.glVertex3f(0.6 * x, 0.6 * y, -3)
    gl.glEnd()


def test_a_colour_from_before_goes_on(beside, replayed):
    def scene(gl):
        perspective(gl)
        gl.glColor3f(0, 1, 0)
        gl.glGetError()  # so that the colour is GL's, and not recorded with the quad
        gl.glLoadIdentity()
        quad(gl, (None, None, (1, 0, 0), None))
        gl.glTranslatef(0, 2, 0)
        quad(gl, (None,) * 4)

    picture = beside.through_dome(scene, (SIZE, SIZE), fov=180.0).picture
    lower, upper = picture[SIZE // 2 + 6, SIZE // 2], picture[SIZE // 2 - 48, SIZE // 2]
    assert lower[1] > 0
    assert lower[0] > 0
    assert upper.tolist() == [255, 0, 0]
    assert len(replayed) == 1


@pytest.mark.parametrize("last", [(-1, 1), (-1, 0.6)], ids=["parallelogram", "no parallelogram"])
def test_a_quad_as_from_arrays(beside, replayed, last):
    corners = [(x, y, -5) for x, y in ((-1, -1), (1, -0.8), (1, 1.2), last)]

    def one_by_one(gl):
        perspective(gl)
        gl.glBegin(gl.GL_QUADS)
        for corner in corners:
            gl.glVertex3f(*corner)
        gl.glEnd()

    def from_arrays(gl):
        perspective(gl)
        gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
        gl.glVertexPointer(3, gl.GL_FLOAT, 0, np.array(corners, np.float32))
        gl.glDrawArrays(gl.GL_QUADS, 0, 4)
        gl.glDisableClientState(gl.GL_VERTEX_ARRAY)

    one, other = (
        beside.through_dome(scene, (SIZE, SIZE), fov=180.0).picture for scene in (one_by_one, from_arrays)
    )
    assert one.any()
    assert (one == other).all()
    assert [args[5] is not None for args in replayed] == [last == (-1, 1)]  # in an order of its own
