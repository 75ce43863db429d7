"""The same lit cube in every toolkit, and how such programs are run and photographed."""

from __future__ import annotations

import subprocess
import sys
import textwrap
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import numpy as np
from PIL import Image, ImageGrab

from domeshim.measure.reference import virtual_display
from tests.displays import only_on
from tests.waiting import LONGEST, wait_for

ROOT = Path(__file__).resolve().parents[3]
Seen = Callable[[np.ndarray], bool]

SCENE = """
from OpenGL.GL import *
from OpenGL.GLU import *
n = 0
SIDES = [(axis, sign) for axis in range(3) for sign in (-1, 1)]
def start():
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0, GL_COLOR_MATERIAL):
        glEnable(capability)
    glLightfv(GL_LIGHT0, GL_POSITION, (2, 3, 4, 0))
    glClearColor(.1, .1, .3, 1)
def shape(width, height):
    glViewport(0, 0, width, height)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(70, width / height, .1, 50)
    glMatrixMode(GL_MODELVIEW)
def draw():
    global n
    n += 1
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glLoadIdentity()
    glTranslatef(0, 0, -2.5)
    glRotatef(25 + STEP * n, 1, 2, .5)
    glBegin(GL_QUADS)
    for axis, sign in SIDES:
        glColor3f(*(.9 if i == axis else .3 + .3 * sign for i in range(3)))
        glNormal3f(*(sign if i == axis else 0 for i in range(3)))
        for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            corner = [u, v]
            corner.insert(axis, sign)
            glVertex3f(*corner)
    glEnd()
"""

GLUT = """
from OpenGL.GLUT import *
import scene
def display():
    scene.draw()
    glutSwapBuffers()
    glutPostRedisplay()
glutInit()
glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH)
glutInitWindowSize(300, 300)
glutCreateWindow("cube")
scene.start()
glutReshapeFunc(scene.shape)
glutDisplayFunc(display)
glutMainLoop()
"""

PYGAME = """
import pygame
from pygame.locals import *
import scene
pygame.init()
display = (300, 300)
screen = pygame.display.set_mode(display, DOUBLEBUF | OPENGL)
scene.start()
scene.shape(*screen.get_size())
while True:
    for event in pygame.event.get():
        if event.type == pygame.QUIT:
            pygame.quit()
            quit()
    scene.draw()
    pygame.display.flip()
    pygame.time.wait(10)
"""

GLFW = """
import glfw
import scene
glfw.init()
window = glfw.create_window(300, 300, "cube", None, None)
glfw.make_context_current(window)
scene.start()
scene.shape(*glfw.get_framebuffer_size(window))
while not glfw.window_should_close(window):
    scene.draw()
    glfw.swap_buffers(window)
    glfw.poll_events()
glfw.terminate()
"""

QT_WIDGET = """
import sys
from BINDING.QtCore import QTimer
from BINDING.QtWidgets import QApplication, QMainWindow
from BINDING.QtOpenGLWidgets import QOpenGLWidget
import scene
class Cube(QOpenGLWidget):
    def __init__(self, parent=None):
        super().__init__(parent)
        self.timer = QTimer(self)
        self.timer.timeout.connect(self.update)
        self.timer.start(16)
    def initializeGL(self): scene.start()
    def resizeGL(self, width, height): scene.shape(width, height)
    def paintGL(self): scene.draw()
app = QApplication(sys.argv)
window = QMainWindow()
window.setCentralWidget(Cube())
window.resize(300, 300)
window.show()
sys.exit(app.exec())
"""

QT_WINDOW = """
import sys
from BINDING.QtGui import QGuiApplication, QSurfaceFormat
from BINDING.QtOpenGL import QOpenGLWindow
import scene
class Cube(QOpenGLWindow):
    def initializeGL(self): scene.start()
    def resizeGL(self, width, height): scene.shape(width, height)
    def paintGL(self):
        scene.draw()
        self.update()
asked = QSurfaceFormat()
asked.setDepthBufferSize(24)
QSurfaceFormat.setDefaultFormat(asked)
app = QGuiApplication(sys.argv)
window = Cube()
window.resize(300, 300)
window.show()
sys.exit(app.exec())
"""


def write(folder: Path, source: str, step: float = 5.0) -> None:
    """Write prog.py and the scene that it draws, turned by step degrees at each picture."""
    (folder / "scene.py").write_text(f"STEP = {step}\n{SCENE}")
    (folder / "prog.py").write_text(textwrap.dedent(source))


def environment(**variables: str) -> dict[str, str]:
    """Where there is no display, or on the one that is given."""
    clean = only_on("")
    del clean["DISPLAY"]
    return clean | {"PYTHONPATH": str(ROOT), "PYGAME_HIDE_SUPPORT_PROMPT": "1"} | variables


def capture(folder: Path, source: str, *options: str, **variables: str) -> subprocess.CompletedProcess[str]:
    """Photograph the program's third picture, 200 pixels square unless the options say otherwise."""
    write(folder, source)
    defaults = ["--size", "200", "--frame", "3", "--output", "picture.png"]
    return subprocess.run(
        [sys.executable, "-m", "domeshim", "capture", *defaults, *options, "prog.py"],
        cwd=folder,
        env=environment(**variables),
        capture_output=True,
        text=True,
        timeout=LONGEST,
    )


def picture(folder: Path) -> np.ndarray:
    """The picture taken, rows of RGB, as integers that can be subtracted."""
    return np.asarray(Image.open(folder / "picture.png")).astype(int)


def photograph(folder: Path, source: str, wanted: Seen, **variables: str) -> tuple[np.ndarray, str]:
    """Run the program, standing still, with DOME=1 on a display of its own; what it shows, and stderr.

    wanted: whether it shows by now what it is run for; if it never does, it is what it shows in the end.
    """
    write(folder, source, step=0.0)
    start = (
        "import _domeshim_gate as g; g.arm(); import runpy; runpy.run_path('prog.py', run_name='__main__')"
    )
    with virtual_display((300, 300)) as display:
        program = subprocess.Popen(
            [sys.executable, "-c", start],
            cwd=folder,
            env=environment(DISPLAY=display, DOME="1", **variables),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )

        def shown() -> np.ndarray:
            return np.asarray(ImageGrab.grab(xdisplay=display).convert("RGB")).astype(int)

        with suppress(TimeoutError):
            wait_for(lambda: program.poll() is not None or wanted(shown()), 0.05)
        seen = shown()
        program.kill()
        return seen, program.communicate()[1]


def begun(seen: np.ndarray) -> bool:
    """The rim, the background and the scene are there."""
    return not seen[2, 2].any() and len(np.unique(seen.reshape(-1, 3), axis=0)) >= 3


def alike(seen: np.ndarray, other: np.ndarray) -> bool:
    """Qt's windows are not smoothed, GLUT's are: edges may differ, and nothing else."""
    return bool((np.abs(seen - other) > 8).any(axis=2).mean() < 0.01)
