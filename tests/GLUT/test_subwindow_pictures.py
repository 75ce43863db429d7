"""Programs with subwindows: on the monitor beside freeglut, on the dome beside the same in viewports."""

from __future__ import annotations

import ctypes.util
import shutil
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageGrab

from domeshim.measure.reference import virtual_display
from tests.displays import only_on
from tests.GLUT.program_runs import run_off_screen
from tests.waiting import LONGEST, wait_for

REPOSITORY = Path(__file__).parents[2]
SIZE = 256
SCENE = """
import sys
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *

def begin(mode=GLUT_DOUBLE):
    glutInit(sys.argv)
    glutInitDisplayMode(mode | GLUT_DEPTH)
    glutInitWindowSize(256, 256)
    glutInitWindowPosition(0, 0)
    return glutCreateWindow(b"outer")

def projected(w, h, flat):
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glOrtho(-2 * w / h, 2 * w / h, -2, 2, -9, 9) if flat else gluPerspective(70, w / h, 0.1, 50)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()

def view(w, h, shade, eye, flat):
    glClearColor(*shade, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    projected(w, h, flat)
    gluLookAt(*eye, 0, 0, 0, 0, 1, 0)
    for colour, z in (((1, 0.5, 0), 0), ((0, 0.5, 1), -1)):
        glColor3f(*colour)
        glBegin(GL_QUADS)
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            glVertex3f(x + z / 2, y + z / 2, z)
        glEnd()

VIEWS = {views}
"""
SUBWINDOWS = """
outer = begin()

def around():
    glClearColor(0.3, 0.3, 0.3, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glutSwapBuffers()

def moved(w, h):
    glViewport(0, 0, w, h)
    for number, (x, y, w, h, *_) in zip(inner, VIEWS):
        glutSetWindow(number)
        glutPositionWindow(x, 256 - y - h)
        glutReshapeWindow(w, h)

glutDisplayFunc(around)
glutReshapeFunc(moved)
inner = []
for k, (x, y, w, h, *how) in enumerate(VIEWS):
    glutInitDisplayMode(GLUT_DEPTH | (GLUT_SINGLE if k == 1 else GLUT_DOUBLE))
    inner.append(glutCreateSubWindow(outer, 0, 0, 50, 50))
    def display(k=k, w=w, h=h, how=how):
        view(w, h, *how)
        glFlush() if k == 1 else glutSwapBuffers()
    glutDisplayFunc(display)
"""
VIEWPORTS = """
begin()

def display():
    glDisable(GL_SCISSOR_TEST)
    glClearColor(0.3, 0.3, 0.3, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    for x, y, w, h, *how in VIEWS:
        glViewport(x, y, w, h)
        if 2 * w * h < 256 * 256:  # what covers most fills the dome, its background as well
            glEnable(GL_SCISSOR_TEST)
            glScissor(x, y, w, h)
        view(w, h, *how)
    glutSwapBuffers()

glutDisplayFunc(display)
glutReshapeFunc(lambda w, h: None)
"""
LOOP = "glutMainLoop()\n"
PHOTOGRAPHED = """
def again(_):
    for number in (outer, *inner):
        glutPostWindowRedisplay(number)
    glutTimerFunc(100, again, 0)

glutTimerFunc(100, again, 0)
glutMainLoop()
"""
FOUR = [
    (8, 8, 116, 116, (0.2, 0, 0), (0, 0, 3), True),
    (132, 8, 116, 116, (0, 0.2, 0), (0, 0, 3), False),
    (8, 132, 116, 116, (0, 0, 0.2), (2, 1, 3), True),
    (132, 132, 116, 116, (0.2, 0.2, 0), (2, 1, 3), False),
]
MAIN = [
    (0, 40, 256, 216, (0.2, 0, 0), (2, 1, 3), False),
    (30, 4, 196, 32, (0, 0.2, 0), (0, 0, 3), True),
]


def program(folder: Path, views: list[tuple[object, ...]], *parts: str) -> Path:
    path = folder / "prog.py"
    path.write_text("".join([SCENE.replace("{views}", repr(views)), *parts]))
    return path


def picture_of(path: Path) -> np.ndarray:
    return np.asarray(Image.open(path).convert("RGB")).astype(int)


def captured(path: Path, mode: str, *options: str) -> np.ndarray:
    output = path.with_name(f"{mode}.png")
    command = [sys.executable, "-m", "domeshim", "capture", "--mode", mode, "--size", str(SIZE), *options]
    done = subprocess.run(
        [*command, "--output", str(output), str(path)],
        cwd=REPOSITORY,
        capture_output=True,
        text=True,
        check=False,
        timeout=LONGEST,
    )
    assert done.returncode == 0, done.stderr
    return picture_of(output)


def photographed(path: Path, wanted: np.ndarray, **environment: str) -> np.ndarray:
    """What a screen of its own shows: as soon as that is what is wanted, else in the end."""
    with virtual_display((SIZE, SIZE)) as display:

        def shown() -> np.ndarray:
            return np.asarray(ImageGrab.grab(xdisplay=display).convert("RGB")).astype(int)

        program = subprocess.Popen([sys.executable, str(path)], env=only_on(display) | environment)
        with suppress(TimeoutError):
            wait_for(lambda: np.abs(shown() - wanted).max() <= 1, 0.05)
        seen = shown()
        program.kill()
        program.wait()
        return seen


needs_freeglut = pytest.mark.skipif(
    shutil.which("Xvfb") is None or ctypes.util.find_library("glut") is None,
    reason="needs an X server and freeglut's library",
)


@needs_freeglut
def test_a_capture_and_a_screen_show_what_freeglut_shows(tmp_path: Path) -> None:
    shot = captured(program(tmp_path, FOUR, SUBWINDOWS, LOOP), "monitor")
    assert len(np.unique(shot.reshape(-1, 3), axis=0)) > len(FOUR) + 2
    source = program(tmp_path, FOUR, SUBWINDOWS, PHOTOGRAPHED)
    theirs = photographed(source, shot, PYTHONPATH="")
    assert np.abs(theirs - shot).max() <= 1
    source.write_text(source.read_text().replace("from OpenGL.GLUT", "from domeshim.GLUT"))
    assert np.abs(theirs - photographed(source, theirs, PYTHONPATH=str(REPOSITORY))).max() <= 1


@pytest.mark.parametrize(
    ("views", "options"), [(FOUR, ()), (MAIN, ("--tilt", "25", "--fov", "210")), (MAIN, ("--hud", "flat"))]
)
def test_the_dome_shows_what_viewports_show(
    tmp_path: Path, views: list[tuple[object, ...]], options: tuple[str, ...]
) -> None:
    theirs = captured(program(tmp_path, views, VIEWPORTS, LOOP), "dome", *options)
    ours = captured(program(tmp_path, views, SUBWINDOWS, LOOP), "dome", *options)
    drawn = (theirs != theirs[SIZE // 2, 3]).any(-1)
    apart = np.abs(theirs - ours).max(-1) > 40
    assert drawn.sum() > 2000
    assert apart.sum() < 0.03 * drawn.sum(), "but for pixels on the subwindows' borders"


POINTING = """
from OpenGL.GL import *
from OpenGL.GLU import *
from domeshim.GLUT import *
from domeshim.session import current

heard = []
glutInit()
glutInitDisplayMode(GLUT_DOUBLE)
glutInitWindowSize(256, 256)
outer = glutCreateWindow("outer")
glutDisplayFunc(glutSwapBuffers)
for name, place, size in (("main", (0, 0), (256, 216)), ("strip", (30, 220), (196, 32))):
    number = glutCreateSubWindow(outer, *place, *size)
    def display(perspective=name == "main"):
        glLoadIdentity()
        if perspective:
            gluPerspective(70, 256 / 216, 1, 9)
        glClear(GL_COLOR_BUFFER_BIT)
        glRectf(-1, -1, 1, 1)
        glutSwapBuffers()
    glutDisplayFunc(display)
    glutPassiveMotionFunc(lambda x, y, name=name: heard.append((name, x, y)))
glutMainLoopEvent()
windows, dome = current().glut.windows, current().dome
for number, place in ((2, (5.5, 7.5)), (3, (100.5, 20.5)), (2, (120.5, -39.5))):
    windows[outer].surface.events.pointer_moved(*dome.frame_place(windows[number].surface, *place))
glutMainLoopEvent()
print(heard)
"""


def test_the_pointer_on_the_dome_is_in_the_subwindow_seen_there(tmp_path: Path) -> None:
    """The third place lies beyond the window's upper edge, where what fills the dome is seen."""
    done = run_off_screen(tmp_path, POINTING, "enabled=True, frame=(900, 800), fov=110.0")
    assert done.stdout.strip() == "[('main', 5, 7), ('strip', 100, 20), ('main', 120, -40)]", done.stderr


BETWEEN = """
from OpenGL.GL import *
from domeshim.GLUT import *

glutInit()
first, second = glutCreateWindow("first"), glutCreateWindow("second")

def colour(number):
    glutSetWindow(number)
    return list(glReadPixels(150, 150, 1, 1, GL_RGB, GL_UNSIGNED_BYTE))

for number, green in ((first, 1), (second, 0)):
    glutSetWindow(number)
    glColor3f(1, green, 0)
    glBegin(GL_QUADS)
    for corner in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        glVertex2f(*corner)
    glEnd()
print(colour(first), colour(second))
"""


def test_what_is_drawn_goes_to_the_window_that_was_current(tmp_path: Path) -> None:
    done = run_off_screen(tmp_path, BETWEEN, "enabled=True")
    assert done.stdout.strip() == "[255, 255, 0] [255, 0, 0]", done.stderr
