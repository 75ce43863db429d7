"""Programs that import from PyOpenGL's inner modules get our functions, and are let go again."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import OpenGL.GL
import OpenGL.GLU
import pytest

from domeshim.intercept.overlay import Overlay
from domeshim.options import Options
from domeshim.session import Session
from tests.waiting import LONGEST

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def overlay() -> Iterator[Overlay]:
    overlay = Overlay(Session(Options(enabled=True)))
    yield overlay
    overlay.remove()


def test_later_imports_find_ours_and_the_modules_themselves_stay(overlay: Overlay) -> None:
    raw = sys.modules["OpenGL.raw.GL.VERSION.GL_1_0"]
    before = dict(vars(raw))
    overlay.module_imported("OpenGL.GL", OpenGL.GL)
    overlay.module_imported("OpenGL.GLU", OpenGL.GLU)
    from OpenGL.GL.exceptional import glBegin
    from OpenGL.raw.GL.VERSION import GL_1_0
    from OpenGL.raw.GL.VERSION.GL_1_0 import glMatrixMode, glVertex3fv
    from OpenGL.raw.GLU import gluPerspective

    assert glBegin is OpenGL.GL.glBegin
    assert glMatrixMode is GL_1_0.glMatrixMode is OpenGL.GL.glMatrixMode
    assert glVertex3fv is OpenGL.GL.glVertex3fv
    assert gluPerspective is OpenGL.GLU.gluPerspective
    assert vars(raw) == before
    overlay.remove()
    assert sys.modules["OpenGL.raw.GL.VERSION.GL_1_0"] is raw
    from OpenGL.raw.GL.VERSION import GL_1_0

    assert GL_1_0 is raw


RAW = """
import OpenGL
OpenGL.ERROR_CHECKING = False  # without this PyOpenGL's own raw glBegin fails
{}
def display():
    glClear(GL_COLOR_BUFFER_BIT)
    glBegin(GL_QUADS)
    for x, y in ((-9, -9), (9, -9), (9, 9), (-9, 9)): glVertex3f(x, y, -1)
    glEnd()
    glutSwapBuffers()
    glutPostRedisplay()
glutInit(["raw"])
glutInitDisplayMode(GLUT_DOUBLE)
glutCreateWindow(b"raw")
gluPerspective(60, 1, .1, 50)
glColor3f(0, 1, 0)
glutDisplayFunc(display)
glutMainLoop()
"""


@pytest.mark.parametrize(
    "imports",
    [
        "from OpenGL.raw.GL.VERSION.GL_1_0 import *\nfrom OpenGL.raw.GLU import *\nfrom OpenGL.GLUT import *",
        "from OpenGL.raw.GLU import gluPerspective\nfrom OpenGL.raw.GL.VERSION.GL_1_0 import glColor3f\n"
        "from OpenGL.GL import *\nfrom OpenGL.GL.exceptional import glBegin, glEnd\n"
        "from OpenGL.GLUT import *\nfrom OpenGL.GLUT.freeglut import *\n"
        "from OpenGL.raw.GLUT import glutPostRedisplay",
        "from OpenGL.raw.GL.VERSION.GL_1_1 import *\nfrom OpenGL.raw.GLU import *\n"
        "from OpenGL.raw.GLUT import *\nfrom OpenGL.GLUT import glutInit, glutCreateWindow, glutDisplayFunc",
    ],
)
def test_a_program_that_imports_inner_modules_is_on_the_dome(tmp_path: Path, imports: str) -> None:
    from PIL import Image

    (tmp_path / "prog.py").write_text(RAW.format(imports))
    environ = {**os.environ, "PYTHONPATH": str(ROOT)}
    del environ["PYOPENGL_PLATFORM"]
    command = ["-m", "domeshim", "capture", "--mode", "dome", "--frame", "2", "--size", "64"]
    result = subprocess.run(
        [sys.executable, *command, "--output", "out.png", "prog.py"],
        cwd=tmp_path,
        env=environ,
        capture_output=True,
        text=True,
        timeout=LONGEST,
    )
    assert (result.returncode, result.stderr) == (0, "")
    picture = Image.open(tmp_path / "out.png")
    # On the monitor the quadrilateral fills the picture; on the dome it ends short of the rim.
    assert picture.getpixel((32, 32)) == (0, 255, 0)
    assert picture.getpixel((32, 3)) == (0, 255, 0)
    assert picture.getpixel((2, 2)) == (0, 0, 0)
