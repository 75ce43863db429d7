"""GLUT's solids go their own short way onto the dome, and look and leave things as any draw does."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.waiting import LONGEST

ROOT = Path(__file__).resolve().parents[2]

PROGRAM = """
import ctypes, sys
import numpy as np
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
def by_hand(size):
    sides = [(axis, sign) for axis in range(3) for sign in (-1, 1)]
    glBegin(GL_QUADS)
    for axis, sign in sides:
        glNormal3f(*(sign if i == axis else 0 for i in range(3)))
        corners = ((-1, -1), (1, -1), (1, 1), (-1, 1))
        for u, v in corners if sign * (1 if axis != 1 else -1) > 0 else reversed(corners):
            corner = [u, v]
            corner.insert(axis, sign)
            glVertex3f(*(size / 2 * c for c in corner))
    glEnd()
cube = {"solid": glutSolidCube, "hand": by_hand}[sys.argv[1]]
def scene():
    glColor3f(1, .5, .2)
    glPushMatrix(); glTranslatef(0, -3, -6); glScalef(9, 1, 1); cube(1.5); glPopMatrix()
    glPushMatrix(); glTranslatef(0, 1, -4); glRotatef(30, 1, 1, 0); cube(1); glPopMatrix()
def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glLoadIdentity()
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_COLOR_ARRAY)
    glVertexPointer(3, GL_FLOAT, 0, triangle)
    glColorPointer(3, GL_FLOAT, 0, triangle)
    scene()
    glRotatef(90, 0, 1, 0)
    glCallList(1)
    glRotatef(-90, 0, 1, 0)
    glDrawArrays(GL_TRIANGLES, 0, 3)
    print(glIsEnabled(GL_COLOR_ARRAY), glGetPointerv(GL_VERTEX_ARRAY_POINTER) is not None, glGetError())
    glutSwapBuffers()
triangle = np.array([[0, 1, -2], [1, 1, -2], [0, 2, -2]], np.float32)
glutInit(["shape"])
glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH)
glutCreateWindow(b"shape")
glMatrixMode(GL_PROJECTION)
gluPerspective(70, 1, .1, 50)
glMatrixMode(GL_MODELVIEW)
for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0, GL_COLOR_MATERIAL, GL_NORMALIZE):
    glEnable(capability)
glNewList(1, GL_COMPILE)
scene()
glEndList()
glutDisplayFunc(display)
glutMainLoop()
"""


@pytest.fixture(params=["auto", "vertex", "cubemap"])
def pictures(tmp_path: Path, request: pytest.FixtureRequest) -> dict[str, np.ndarray]:
    (tmp_path / "prog.py").write_text(PROGRAM)
    environ = {**os.environ, "PYTHONPATH": str(ROOT), "DOME_METHOD": request.param}
    del environ["PYOPENGL_PLATFORM"]
    found = {}
    for cube in ("solid", "hand"):
        command = [sys.executable, "-m", "domeshim", "capture", "--mode", "dome", "--size", "192"]
        done = subprocess.run(
            [*command, "--output", f"{cube}.png", "prog.py", cube],
            cwd=tmp_path,
            env=environ,
            capture_output=True,
            text=True,
            timeout=LONGEST,
        )
        assert (done.returncode, done.stdout, done.stderr) == (0, "1 True 0\n", "")
        found[cube] = np.asarray(Image.open(tmp_path / f"{cube}.png"), int)
    return found


def test_a_solid_is_drawn_as_if_by_hand(pictures: dict[str, np.ndarray]) -> None:
    solid, hand = pictures["solid"], pictures["hand"]
    assert (solid.max(-1) > 60).mean() > 0.03
    assert (abs(solid - hand).max(-1) > 30).mean() < 0.003
