"""A user's program is timed in turns, and held against its monitor picture."""

from __future__ import annotations

import pytest

from domeshim.bench.methods import Method
from domeshim.bench.programs import Timed, rows
from domeshim.bench.timekeeper import Errand
from domeshim.errors import DomeError
from domeshim.measure.apart import Program

PROGRAM = """
import sys, time
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *

def display():
    drawn.append(1)
    if len(drawn) > int(sys.argv[1]):
        sys.exit(0)
    end = time.process_time() + 0.02
    while time.process_time() < end:
        pass
    glClear(GL_COLOR_BUFFER_BIT)
    glutWireTeapot(1.0)
    glutSwapBuffers()

drawn = []
glutInit()
glutInitDisplayMode(GLUT_DOUBLE)
glutCreateWindow("timed")
gluPerspective(60, 1, 0.1, 100)
glTranslatef(0, 0, -3)
glutDisplayFunc(display)
glutIdleFunc(glutPostRedisplay)
glutMainLoop()
"""


@pytest.fixture
def program(tmp_path):
    path = tmp_path / "prog.py"
    path.write_text(PROGRAM)
    return str(path)


@pytest.mark.parametrize("settings", [None, {"method": "vertex"}])
def test_a_picture_takes_what_the_program_takes(program, settings):
    timed = Timed(Errand(program, ("9",), size=(64, 64), settings=settings))
    try:
        pictures = [timed.picture() for _ in range(4)]
    finally:
        timed.close()
    assert all(picture.processor >= 0.02 and picture.wall >= 0.02 for picture in pictures)


def test_a_program_that_ends_is_said_to_have_ended(program):
    timed = Timed(Errand(program, ("2",), size=(64, 64)))
    try:
        timed.picture()
        timed.picture()
        with pytest.raises(DomeError, match="ended after 2 pictures"):
            timed.picture()
    finally:
        timed.close()


def test_a_method_is_timed_and_compared(program):
    (row,) = rows(Program(program, ("99",)), 96, [Method("vertex")], 3, {}, lambda _: None)
    assert row.cost.rounds == 3
    assert row.cost.ratio > 0
    assert row.seen is not None
    assert row.seen.wrong < 0.01
