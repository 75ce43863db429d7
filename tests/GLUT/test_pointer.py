"""The pointer on the dome: the program's own picking finds what is under it, and warping goes there."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from domeshim import GLUT
from domeshim.GLUT.state import GlutWindow
from domeshim.session import Session
from tests.GLUT.program_runs import run_off_screen

PROGRAM = """
import domeshim
domeshim.install()
import json, sys
import numpy as np
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
from domeshim import session
from domeshim.driver import Driver

SIZE, HALF = (800, 600), 0.3
angles = np.radians(np.arange(-75, 76, 15))
theta, phi = np.meshgrid(angles, angles)
centres = np.stack([np.sin(theta) * np.cos(phi), np.sin(phi), -np.cos(theta) * np.cos(phi)], -1)
centres = centres.reshape(-1, 3)
centres = centres[centres[:, 2] < -0.2]
centres *= (5 + 3 * (np.arange(len(centres)) % 3))[:, None]
cursor = []

def projection():
    gluPerspective(45, SIZE[0] / SIZE[1], 0.5, 50)
    if look_at_on_projection:
        gluLookAt(0, 0, 0, 0, 0, -1, 0, 1, 0)
        glTranslatef(0, 0, -1)

def scene():
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    if look_at_on_projection:
        glTranslatef(0, 0, 1)
    for name, centre in enumerate(centres):
        glLoadName(name)
        glPushMatrix()
        glTranslatef(*centre)
        glColor3ub(name + 1, 0, 77)
        glCallList(1)
        glPopMatrix()

def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    projection()
    scene()
    glutSwapBuffers()

def motion(x, y):
    cursor[:] = [x, y]

def by_depth(x, y):
    depth = float(glReadPixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT)[0][0])
    if depth == 1:
        return -1
    point = np.array(gluUnProject(x, y, depth))
    away = np.abs(np.abs(point - centres).max(1) - HALF)
    return int(away.argmin()) if away.min() < 0.1 else "nowhere"

def by_name(x, y):
    glSelectBuffer(4096)
    glRenderMode(GL_SELECT)
    glInitNames()
    glPushName(0)
    glMatrixMode(GL_PROJECTION)
    glPushMatrix()
    glLoadIdentity()
    gluPickMatrix(x, y, 1, 1, glGetIntegerv(GL_VIEWPORT))
    projection()
    scene()
    glMatrixMode(GL_PROJECTION)
    glPopMatrix()
    hits = glRenderMode(GL_RENDER)
    return int(min(hits, key=lambda hit: hit.near).names[0]) if hits else -1

def by_colour(x, y):
    red, _, blue = glReadPixels(x, y, 1, 1, GL_RGB, GL_UNSIGNED_BYTE)
    return red - 1 if blue == 77 or red == 0 else "blended"

glutInit()
glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH)
glutInitWindowSize(*SIZE)
glutCreateWindow("grid")
glutDisplayFunc(display)
glutPassiveMotionFunc(motion)
look_at_on_projection = "look at" in variant
glNewList(1, GL_COMPILE)
glutSolidCube(2 * HALF)
glEndList()
glEnable(GL_DEPTH_TEST)
glutMainLoopEvent()
surface = session.current().glut.current.surface
width, height = surface.size
on_dome = np.empty((height, width, 4), np.uint8)
Driver().glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, on_dome.ctypes.data)
on_dome = on_dome[..., 0].astype(int) - 1
random = np.random.default_rng(7)
rows, columns = np.nonzero(on_dome >= 0)
wrong, near = [], 0
for k in random.integers(0, len(rows), count):
    row, column = rows[k], columns[k]
    surface.events.pointer_moved(column, height - 1 - row)
    glutMainLoopEvent()
    x, y = cursor[0], glGetIntegerv(GL_VIEWPORT)[3] - 1 - cursor[1]
    around = set(on_dome[row - 1 : row + 2, column - 1 : column + 2].ravel().tolist())
    for way in (by_depth, by_name, by_colour):
        found = way(x, y)
        if found not in around:
            wrong.append([way.__name__, int(column), int(row), found, int(on_dome[row, column])])
        near += found != on_dome[row, column]
print(json.dumps({"wrong": wrong, "near": int(near), "objects": len(set(on_dome[rows, columns].tolist()))}))
"""


@pytest.mark.parametrize(
    ("count", "options", "variant"),
    [
        (1000, "enabled=True", ""),
        (100, "enabled=True, tilt=25.0, fov=230.0, frame=(1024, 768)", ""),
        (100, "enabled=True, fill=100.0, lens=('polynomial', (0.65, 0.01, -0.03))", ""),
        (100, "enabled=True", "look at on the projection"),
    ],
)
def test_what_the_program_picks_is_under_the_cursor(
    tmp_path: Path, count: int, options: str, variant: str
) -> None:
    done = run_off_screen(tmp_path, f"count, variant = {count}, {variant!r}\n" + PROGRAM, options)
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    assert told["objects"] > 80
    assert told["wrong"] == []
    assert told["near"] < 0.04 * 3 * count  # the sample that is shown and the middle differ on an edge


WARPING = """
import domeshim
domeshim.install()
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
from domeshim import session

def display():
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(45, 2, 1, 10)
    glMatrixMode(GL_MODELVIEW)
    glBegin(GL_POINTS)
    glVertex3f(0, 0, -5)
    glEnd()
    glutSwapBuffers()

glutInit()
glutInitWindowSize(600, 300)
glutCreateWindow("warp")
glutDisplayFunc(display)
seen = []
glutMotionFunc(lambda x, y: seen.append(("motion", x, y)))
glutPassiveMotionFunc(lambda x, y: seen.append(("passive", x, y)))
glutMouseFunc(lambda button, state, x, y: seen.append(("mouse", x, y)))
glutKeyboardFunc(lambda key, x, y: seen.append(("key", x, y)))
glutMainLoopEvent()
surface = session.current().glut.current.surface
warped = []
surface.warp_pointer = lambda x, y: warped.append((x, y))
glutWarpPointer(300, 150)
glutWarpPointer(5, 295)
glutWarpPointer(-20000, 150)
for x, y in warped:
    surface.events.pointer_moved(x, y)
surface.events.button(0, True, 0)
surface.events.pointer_moved(*warped[1])
surface.events.key(65, True, 0)
surface.events.character(97)
surface.events.wheel(0, 1)
glutMainLoopEvent()
print((warped, seen))
"""


def test_warping_is_the_way_back_and_every_callback_hears_the_same(tmp_path: Path) -> None:
    done = run_off_screen(tmp_path, WARPING, "enabled=True, frame=(4096, 4096)")
    assert done.returncode == 0, done.stderr
    warped, seen = eval(done.stdout)
    assert warped[0] == pytest.approx((2048, 2048), abs=1)
    assert warped[2][0] == pytest.approx(0, abs=40)
    assert [name for name, _, _ in seen] == [*["passive"] * 3, "mouse", "motion", "key", "mouse", "mouse"]
    places = [place for _, *place in seen]
    assert places[0] == pytest.approx([300, 150], abs=1)
    assert places[1] == pytest.approx([5, 295], abs=1)
    assert -32768 < places[2][0] < -10_000
    assert places[4:] == [places[1]] * 4


def test_without_a_dome_the_pointer_is_scaled_alone(glut_session: Session, window: GlutWindow) -> None:
    from domeshim.GLUT.input import frame_pointer, program_pointer

    assert program_pointer(window, 100, 50) == (100, 50)
    assert frame_pointer(window, 100, 50) == (100, 50)
    assert GLUT.glutGet(GLUT.GLUT_WINDOW_WIDTH) == 256
