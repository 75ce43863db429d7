"""DOME_MAX_TURN in the picture: scene, labels and mouse stay together while the view follows."""

import numpy as np
import pytest

from domeshim.window.clock import VirtualClock

SIZE = 256
PIXELS_A_DEGREE = SIZE / 180


def spot(picture, channel):
    rows, columns = np.nonzero(picture[..., channel] > 128)
    return columns.mean() + 0.5, SIZE - rows.mean() - 0.5


@pytest.fixture
def clock(beside):
    former, beside.session.clock = beside.session.clock, VirtualClock(10)
    yield beside.session.clock
    beside.session.clock = former


@pytest.mark.parametrize("method", ["auto", "cubemap"])
def test_view_follows_at_its_own_pace(beside, clock, method):
    """The program looks 40 degrees to the side; a tenth of a second later the dome has turned by 2."""

    def scene(gl):
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.gluPerspective(90, 1, 0.1, 100)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glPointSize(7)
        for heading in (0.0, np.radians(40)):
            gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
            gl.glLoadIdentity()
            gl.gluLookAt(0, 0, 0, np.sin(heading), 0, -np.cos(heading), 0, 1, 0)
            clock.frame_finished()
            gl.glColor3f(1, 0, 0)
            gl.glBegin(gl.GL_POINTS)
            gl.glVertex3f(0, 0, -5)
            gl.glEnd()
            x, y, _ = gl.gluProject(0, 0, -5)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glPushMatrix()
        gl.glLoadIdentity()
        gl.gluOrtho2D(0, SIZE, 0, SIZE)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glLoadIdentity()
        gl.glColor3f(0, 1, 0)
        gl.glPointSize(3)
        gl.glBegin(gl.GL_POINTS)
        gl.glVertex2f(x, y)
        gl.glEnd()
        return x, y

    with beside.window((SIZE, SIZE), fov=180.0, max_turn=20.0, method=method) as finish:
        seen = scene(beside.dome)
        finish()
        picture = beside._read((SIZE, SIZE))
        mouse = beside.session.dome.program_place(beside.session.window, *_top_left(spot(picture, 0)))
    turned = SIZE / 2 - 2 * PIXELS_A_DEGREE
    assert spot(picture, 0)[0] == pytest.approx(turned, abs=0.8)
    assert spot(picture, 1) == pytest.approx(spot(picture, 0), abs=1.01)
    assert _top_left(mouse) == pytest.approx(seen, abs=2.5)


def _top_left(place):
    return place[0], SIZE - place[1]


def test_program_that_looks_by_itself_is_told(beside, capsys):
    with beside.window((SIZE, SIZE), max_turn=20.0) as finish:
        beside.dome.gluPerspective(60, 1, 0.1, 100)
        beside.dome.glRectf(-1, -1, 1, 1)
        finish()
    assert "no gluLookAt" in capsys.readouterr().err
