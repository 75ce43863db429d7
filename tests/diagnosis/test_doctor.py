"""domeshim doctor, where there is no display, and on programs that ask for what a dome shows otherwise."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.waiting import LONGEST

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAM = """
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
def display():
    glClear(GL_COLOR_BUFFER_BIT)
    glViewport(0, 0, 250, 240)
    glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(40, 1, 20, 100)
    glMatrixMode(GL_MODELVIEW); glLoadIdentity()
    glGetDoublev(GL_PROJECTION_MATRIX); glGetDoublev(GL_MODELVIEW_MATRIX)
    glRectf(-1, -1, 1, 1)
    glReadPixels(0, 0, 64, 64, GL_RGB, GL_UNSIGNED_BYTE)
    glutSwapBuffers()
glutInit(); glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB); glutCreateWindow("program")
glutDisplayFunc(display); glutMainLoop()
"""


def doctor(folder: Path, *arguments: str, **variables: str) -> subprocess.CompletedProcess[str]:
    environ = {**os.environ, "PYTHONPATH": str(ROOT), **variables}
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "PYOPENGL_PLATFORM"):
        environ.pop(name, None)
    command = [sys.executable, "-m", "domeshim", "doctor", *arguments]
    return subprocess.run(command, cwd=folder, env=environ, capture_output=True, text=True, timeout=LONGEST)


def test_what_works_here_and_why_the_rest_does_not(tmp_path):
    result = doctor(tmp_path, "--json")
    assert (result.returncode, result.stderr) == (0, "")
    told = json.loads(result.stdout)
    screens = {trial["name"]: trial for trial in told["screens"]}
    assert not screens["window"]["works"]
    assert "set DISPLAY" in screens["window"]["words"]
    assert screens["offscreen"]["works"]
    assert screens["offscreen"]["found"]["renderer"]
    assert {trial["name"]: trial["works"] for trial in told["methods"]}["vertex"]


def test_what_a_program_asks_for_and_how_sure_that_is(tmp_path):
    (tmp_path / "prog.py").write_text(PROGRAM)
    result = doctor(tmp_path, "prog.py")
    assert (result.returncode, result.stderr) == (0, "")
    told = " ".join(result.stdout.partition("prog.py:")[2].split())
    assert "surely it sets a viewport of 250x240 at 0,0 whatever the window's size" in told
    assert "perhaps it reads pixels 1 time a picture" in told
    assert "perhaps it asks for both matrices 1 time a picture" in told
    assert "surely its view is 40 degrees high" in told
    assert "perhaps its near plane, 20, is close to its far plane, 100" in told


def test_a_program_without_a_picture_is_status_1(tmp_path):
    result = doctor(tmp_path, "nosuch.py")
    assert (result.returncode, result.stderr) == (1, "")
    assert "cannot run nosuch.py: No such file or directory" in result.stdout


def test_where_nothing_can_be_drawn_it_is_status_1_with_the_reasons(tmp_path):
    result = doctor(tmp_path, EGL_PLATFORM="nonsense", __EGL_VENDOR_LIBRARY_FILENAMES="/dev/null")
    assert result.returncode == 1
    assert "on the screen: no" in result.stdout
    assert "off screen: no" in result.stdout
    assert "libegl1" in result.stdout


def test_a_malformed_variable_is_one_line(tmp_path):
    result = doctor(tmp_path, DOME_FOV="x")
    assert (result.returncode, result.stdout) == (2, "")
    assert result.stderr.startswith("domeshim: DOME_FOV=x: not a number")


@pytest.mark.parametrize("argument", ["--frame=0"])
def test_a_malformed_option_is_status_2(tmp_path, argument):
    assert doctor(tmp_path, argument).returncode == 2
