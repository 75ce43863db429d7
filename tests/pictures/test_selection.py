"""GL_SELECT and GL_FEEDBACK give the program what they give it on the monitor."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.GLUT.program_runs import run_off_screen
from tests.pictures.beside import DISTANCE, FOV, GL, SIZE, Beside, looking, sphere


def objects(gl: GL) -> None:
    """Named objects of every kind of drawing."""
    gl.glNewList(1, gl.GL_COMPILE)
    gl.glPushName(7)
    gl.glRectf(-0.1, -0.1, 0.1, 0.1)
    gl.glPopName()
    gl.glEndList()
    for k in range(16):
        gl.glLoadName(k)
        gl.glPushMatrix()
        gl.glTranslatef(k % 4 / 2.5 - 0.6, k // 4 / 2.5 - 0.6, k / 16)
        if k % 4 == 0:
            gl.glCallList(1)
        elif k % 4 == 1:
            gl.gluSphere(gl.gluNewQuadric(), 0.15, 8, 6)
        elif k % 4 == 2:
            sphere(gl, 0.12, 8, 6)
        else:
            gl.glBegin(gl.GL_LINES)
            gl.glVertex2f(-0.1, -0.1)
            gl.glVertex2f(0.1, 0.1)
            gl.glEnd()
        gl.glPopMatrix()


def pick(gl: GL, x: float, y: float) -> list[tuple[Any, ...]]:
    gl.glSelectBuffer(512)
    gl.glRenderMode(gl.GL_SELECT)
    gl.glInitNames()
    gl.glPushName(0)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glPushMatrix()
    gl.glLoadIdentity()
    gl.gluPickMatrix(x, y, 5, 5, gl.glGetIntegerv(gl.GL_VIEWPORT))
    gl.gluPerspective(FOV, 1, DISTANCE - 4, DISTANCE + 4)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    objects(gl)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glPopMatrix()
    gl.glMatrixMode(gl.GL_MODELVIEW)
    hits = gl.glRenderMode(gl.GL_RENDER)
    return [(float(hit.near), float(hit.far), [int(n) for n in hit.names]) for hit in hits]


def test_a_thousand_picks(beside: Beside) -> None:
    def scene(gl: GL) -> Any:
        looking(gl)
        gl.glInitNames()
        objects(gl)
        places = np.random.default_rng(8).uniform(30, SIZE - 30, (1000, 2)).tolist()
        picked = [pick(gl, x, y) for x, y in places]
        objects(gl)
        return picked

    picked = beside.equal(scene, wrong=0.004)
    assert sum(map(bool, picked)) > 200


@pytest.mark.parametrize("kind", ["GL_2D", "GL_3D", "GL_3D_COLOR", "GL_3D_COLOR_TEXTURE"])
def test_feedback(beside: Beside, kind: str) -> None:
    def scene(gl: GL) -> Any:
        looking(gl)
        gl.glRectf(-0.5, -0.5, 0.5, 0.5)
        gl.glFeedbackBuffer(20000, getattr(gl, kind))
        gl.glRenderMode(gl.GL_FEEDBACK)
        gl.glBegin(gl.GL_TRIANGLES)
        for k in range(36):
            gl.glColor3f(k / 36, 0, 1)
            gl.glVertex3f(0.5 * np.cos(k), 0.5 * np.sin(k), k / 36)
        gl.glEnd()
        gl.glPassThrough(3)
        gl.glBegin(gl.GL_LINE_STRIP)
        for k in range(5):
            gl.glVertex2f(0.2 * k, 0)
        gl.glEnd()
        gl.glRasterPos2f(0, 0)
        gl.glBitmap(8, 8, 0, 0, 8, 0, bytes(8))
        values = gl.glRenderMode(gl.GL_RENDER)
        return [[float(token[0])] + [np.ravel(v.vertex).tolist() for v in token[1:]]
                if hasattr(token[1], "vertex") else [float(token[0])] for token in values]  # fmt: skip

    answer = beside.equal(scene, name=kind)
    assert len(answer) >= 17


PICKS = """
import sys
from OpenGL.GL import *
from domeshim.GLUT import *

def display():
    glClear(GL_COLOR_BUFFER_BIT)
    glRectf(-1, -1, 1, 1)
    glFlush()

def pick(_):
    glSelectBuffer(64)
    glRenderMode(GL_SELECT)
    glInitNames()
    glPushName(3)
    glPushName(5)
    glRectf(-1, -1, 1, 1)
    glPopName()
    glFlush()
    print([[int(n) for n in hit.names] for hit in glRenderMode(GL_RENDER)])
    sys.exit()

glutInit()
glutInitDisplayMode(GLUT_SINGLE)
glutCreateWindow("x")
glutDisplayFunc(display)
glutTimerFunc(10, pick, 0)
glutMainLoop()
"""


@pytest.mark.parametrize("how", ["flush", "swap"])
def test_a_picture_that_ends_while_selecting_is_none(tmp_path: Path, how: str) -> None:
    """A rim would be selected."""
    swaps = PICKS.replace("GLUT_SINGLE", "GLUT_DOUBLE").replace("glFlush", "glutSwapBuffers")
    done = run_off_screen(tmp_path, PICKS if how == "flush" else swaps, "enabled=True")
    assert (done.stderr, done.stdout) == ("", "[[3, 5]]\n")
