"""What programs of the other toolkits notice, and what they are told."""

from __future__ import annotations

import subprocess
import sys
from importlib.util import find_spec

import numpy as np
import pytest

from tests.displays import needs_xvfb, run_on_display
from tests.intercept.toolkits import program_runs as runs
from tests.waiting import LONGEST

needs_pygame = pytest.mark.skipif(find_spec("pygame") is None, reason="pygame is not installed")
needs_qt = pytest.mark.skipif(find_spec("PySide6") is None, reason="PySide6 is not installed (group qt)")

PYGAME_EVENTS = """
import pygame
from pygame.locals import *
pygame.init()
screen = pygame.display.set_mode((300, 100), DOUBLEBUF | OPENGL | RESIZABLE)
import scene  # GL is imported after the window was opened
scene.start()
scene.shape(*screen.get_size())
pygame.time.set_timer(USEREVENT, 20)
while True:
    event = pygame.event.wait()
    if event.type == VIDEORESIZE:
        print("resized", *event.size)
    if event.type == USEREVENT:
        print("tick", pygame.time.get_ticks(), pygame.mouse.get_pos())
        scene.draw()
        pygame.display.flip()
"""

QT_TIME = """
import sys
from PySide6.QtCore import QElapsedTimer, QTimer
from PySide6.QtWidgets import QApplication
from PySide6.QtOpenGLWidgets import QOpenGLWidget
import scene
class Draws:
    def paintGL(self):
        scene.draw()
        print(watch.elapsed(), self.width(), self.height(), self.defaultFramebufferObject())
class Cube(Draws, QOpenGLWidget):
    def initializeGL(self):
        self.context().aboutToBeDestroyed.connect(print)
        scene.start()
    def resizeGL(self, width, height): scene.shape(width, height)
app = QApplication(sys.argv)
watch = QElapsedTimer()
watch.start()
cube = Cube()
cube.resize(30, 20)
cube.show()
def later():
    cube.update()
    QTimer.singleShot(50, later)
later()
app.exec()
"""

QT_BUFFERS = """
import sys
import numpy as np
from PySide6.QtGui import QOpenGLContext
from PySide6.QtOpenGL import QOpenGLBuffer, QOpenGLVertexArrayObject
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QApplication
from OpenGL.GL import *
class Half(QOpenGLWidget):
    def initializeGL(self):
        print("initialise", self.isValid(), QOpenGLContext.currentContext() is self.context())
        print(self.context().format().version() >= (2, 1), self.context().hasExtension(b"GL_ARB_multisample"))
        self.array = QOpenGLVertexArrayObject(self)
        self.corners = QOpenGLBuffer(QOpenGLBuffer.Type.VertexBuffer)
        self.numbers = QOpenGLBuffer(QOpenGLBuffer.IndexBuffer)
        self.corners.setUsagePattern(QOpenGLBuffer.UsagePattern.DynamicDraw)
        print(self.corners.isCreated(), self.corners.create(), self.numbers.create(), self.array.create())
        self.array.bind()
        self.corners.bind()
        self.corners.allocate(4 * 8)
        self.corners.write(0, np.array([(-1, -1), (0, -1), (0, 1), (-1, 1)], "f").tobytes(), 32)
        self.numbers.bind()
        self.numbers.allocate(np.arange(4, dtype=np.uint32).tobytes(), 16)
        print(self.corners.size(), self.numbers.size(), bytes(self.numbers.read(4, 4)))
        glVertexPointer(2, GL_FLOAT, 0, None)
        glEnableClientState(GL_VERTEX_ARRAY)
        self.array.release()
        self.corners.release()
    def paintGL(self):
        glClearColor(0, 0, 1, 1)
        glClear(GL_COLOR_BUFFER_BIT)
        glColor3f(1, 1, 0)
        self.array.bind()
        glDrawElements(GL_QUADS, 4, GL_UNSIGNED_INT, None)
        self.array.release()
app = QApplication(sys.argv)
half = Half()
print("made", half.isValid(), QOpenGLContext.currentContext())
half.show()
app.exec()
"""

QT_OWN_PAINT_EVENT = """
import sys
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QApplication
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from OpenGL.GL import *
class Flat(QOpenGLWidget):
    number = 0
    def paintEvent(self, event):
        self.number += 1
        self.makeCurrent()
        glClearColor(self.number / 255, 0, 1, 1)
        glClear(GL_COLOR_BUFFER_BIT)
        painter = QPainter(self)
        painter.drawText(10, 10, "over it")
        painter.end()
app = QApplication(sys.argv)
flat = Flat()
flat.show()
app.exec()
"""

GLFW_CLEARS = """
import glfw
glfw.init()
{}
window = glfw.create_window(300, 300, "flat", None, None)
glfw.make_context_current(window)
from OpenGL.GL import *
n = 0
while not glfw.window_should_close(window):
    n += 1
    glClearColor(n / 255, 0, 1, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glfw.swap_buffers(window)
    glfw.poll_events()
"""

CORE = """
glfw.window_hint(glfw.CONTEXT_VERSION_MAJOR, 3)
glfw.window_hint(glfw.CONTEXT_VERSION_MINOR, 3)
glfw.window_hint(glfw.OPENGL_PROFILE, glfw.OPENGL_CORE_PROFILE)
"""

WITHOUT_PYOPENGL = """
import moderngl, pygame
pygame.init()
pygame.display.set_mode((300, 300), pygame.OPENGL | pygame.DOUBLEBUF)
context = moderngl.create_context()
while True:
    pygame.event.get()
    context.clear(0, 0, 1)
    pygame.display.flip()
"""

FLAT_PYGAME = """
import sys
import pygame
pygame.init()
screen = pygame.display.set_mode((30, 20))
screen.fill((255, 0, 0))
pygame.display.flip()
pygame.display.update()
assert screen.get_at((3, 3))[:3] == (255, 0, 0)
assert "domeshim.intercept.dome" not in sys.modules
pygame.quit()
print("fine")
"""

UNINSTALL = """
import glfw, pygame
from pygame.display import flip
names = [(glfw, "create_window"), (glfw, "swap_buffers"), (pygame.display, "set_mode"), (pygame.event, "get")]
if {qt}:
    from PySide6 import QtOpenGL, QtOpenGLWidgets
    names += [(QtOpenGL, "QOpenGLWindow"), (QtOpenGLWidgets, "QOpenGLWidget")]
before = [getattr(module, name) for module, name in names]
original = [flip]  # a name of its own would be led to ours as well
import domeshim
domeshim.install()
assert all(getattr(module, name) is not was for (module, name), was in zip(names, before))
assert flip is not original[0]
domeshim.uninstall()
assert [getattr(module, name) for module, name in names] == before
assert flip is original[0]
print("restored")
"""

UNBENT = "domeshim: the program's GL has no fixed function; what it draws with it is not bent\n"


@needs_pygame
def test_pygame_timers_go_by_pictures_and_the_size_is_told(tmp_path, captured_by_glut):
    result = runs.capture(tmp_path, PYGAME_EVENTS)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout == "resized 200 200\ntick 20 (0, 0)\ntick 40 (0, 0)\ntick 60 (0, 0)\n"
    assert (runs.picture(tmp_path) == captured_by_glut["dome"]).all()


@needs_pygame
@needs_xvfb
def test_pygame_opens_its_window_also_before_pygame_init(tmp_path):
    ends = "    print(pygame.display.get_init())\n    break\n"
    runs.write(
        tmp_path, runs.PYGAME.replace("pygame.init()\n", "").replace("    pygame.time.wait(10)\n", ends)
    )
    command = [sys.executable, "-m", "domeshim", "run", "prog.py"]
    variables = {"PYTHONPATH": str(runs.ROOT), "DOME": "1", "SDL_AUDIODRIVER": "dummy"}
    done = run_on_display(command, variables, folder=tmp_path)
    assert (done.returncode, done.stdout.splitlines()[-1:]) == (0, ["True"]), done.stderr


GLFW_SAMPLES = """
import glfw
from OpenGL.GL import *
glfw.init()
{}
first = glfw.create_window(60, 60, "first", None, None)
glfw.make_context_current(first)
glfw.create_window(60, 60, "second", None, first)
glClear(GL_COLOR_BUFFER_BIT)  # in the first, as before
samples, renderer = glGetInteger(GL_SAMPLES), glGetString(GL_RENDERER)
print(samples > 1, b"llvmpipe" in renderer)
"""


PYGAME_SAMPLES = """
import pygame
from OpenGL.GL import *
pygame.display.init()
{}
pygame.display.set_mode((60, 60), pygame.OPENGL | pygame.DOUBLEBUF)
glClear(GL_COLOR_BUFFER_BIT)
samples, renderer = glGetInteger(GL_SAMPLES), glGetString(GL_RENDERER)
print(samples > 1, b"llvmpipe" in renderer)
"""
PYGAME_ASKS = "pygame.display.gl_set_attribute(pygame.GL_MULTISAMPLEBUFFERS, 1)\n" + (
    "pygame.display.gl_set_attribute(pygame.GL_MULTISAMPLESAMPLES, 4)"
)


@needs_xvfb
@pytest.mark.parametrize(
    ("source", "asking"),
    [
        (GLFW_SAMPLES, "glfw.window_hint(glfw.SAMPLES, 4)"),
        pytest.param(PYGAME_SAMPLES, PYGAME_ASKS, marks=needs_pygame),
    ],
    ids=["glfw", "pygame"],
)
@pytest.mark.parametrize("asked", [False, True])
def test_edges_are_smoothed_in_windows_where_a_gpu_draws_or_the_program_asks(tmp_path, source, asking, asked):
    """The processor would take ten times as long for a simple picture."""
    runs.write(tmp_path, source.format(asking if asked else ""))
    done = run_on_display(
        [sys.executable, "-m", "domeshim", "run", "prog.py"], runs.environment(), folder=tmp_path
    )
    assert (done.returncode, done.stderr) == (0, "")
    smoothed, by_processor = (word == "True" for word in done.stdout.split())
    assert smoothed == (asked or not by_processor)


QT_SAMPLES = """
import sys
from PySide6.QtCore import QTimer
from PySide6.QtGui import QSurfaceFormat
from PySide6.QtWidgets import QApplication
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from OpenGL.GL import *
class Empty(QOpenGLWidget):
    def paintGL(self):
        glClear(GL_COLOR_BUFFER_BIT)
        print(glGetInteger(GL_SAMPLES) > 1)
        QTimer.singleShot(0, lambda: app.exit(0))
asked = QSurfaceFormat()
asked.setSamples({})
QSurfaceFormat.setDefaultFormat(asked)
app = QApplication(sys.argv)
empty = Empty()
empty.show()
sys.exit(app.exec())
"""


@needs_qt
@needs_xvfb
@pytest.mark.parametrize("asked", [-1, 4])
def test_edges_are_smoothed_in_qts_windows_as_the_program_asks(tmp_path, asked):
    runs.write(tmp_path, QT_SAMPLES.format(asked))
    done = run_on_display(
        [sys.executable, "-m", "domeshim", "run", "prog.py"], runs.environment(), folder=tmp_path
    )
    assert (done.returncode, done.stdout.split()[0]) == (0, str(asked > 1)), done.stderr


def test_a_window_of_an_unknown_toolkit_is_told_of_once(tmp_path):
    stranger = """
from domeshim.window.contract import SurfaceFormat, WindowEvents
from domeshim.window.offscreen import OffscreenBackend
window = OffscreenBackend().open_window("stranger", (8, 6), None, SurfaceFormat(), WindowEvents())
from OpenGL.GL import *
for picture in range(3):
    glClear(GL_COLOR_BUFFER_BIT)
    glRectf(-1, -1, 1, 1)
print(glReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE))
"""
    runs.write(tmp_path, stranger)
    command = [sys.executable, "-m", "domeshim", "run", "prog.py"]
    variables = runs.environment(DOME="1", PYOPENGL_PLATFORM="egl")
    done = subprocess.run(
        command, cwd=tmp_path, env=variables, capture_output=True, text=True, timeout=LONGEST
    )
    assert done.stdout == "b'\\xff\\xff\\xff'\n"
    assert done.stderr.count("another toolkit than GLUT, pygame, glfw or Qt") == 1
    assert len(done.stderr.splitlines()) == 1


def test_clearing_before_the_window_opens_names_no_unknown_toolkit(tmp_path):
    early = """
import glfw
from OpenGL.GL import *
glClear(GL_COLOR_BUFFER_BIT)
glfw.init()
window = glfw.create_window(64, 64, "late", None, None)
glfw.make_context_current(window)
glClear(GL_COLOR_BUFFER_BIT)
glRectf(-1, -1, 1, 1)
glfw.swap_buffers(window)
"""
    runs.write(tmp_path, early)
    command = [sys.executable, "-m", "domeshim", "capture", "--size", "64", "--output", "out.png", "prog.py"]
    done = subprocess.run(
        command, cwd=tmp_path, env=runs.environment(), capture_output=True, text=True, timeout=LONGEST
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert (tmp_path / "out.png").exists()


@needs_pygame
def test_pygame_without_gl_is_left_alone(tmp_path):
    runs.write(tmp_path, FLAT_PYGAME)
    variables = runs.environment(DOME="1", SDL_VIDEODRIVER="dummy", SDL_AUDIODRIVER="dummy")
    command = [sys.executable, "-m", "domeshim", "run", "prog.py"]
    done = subprocess.run(
        command, cwd=tmp_path, env=variables, capture_output=True, text=True, timeout=LONGEST
    )
    assert (done.returncode, done.stdout) == (0, "fine\n"), done.stderr


@needs_pygame
def test_a_program_without_pyopengl_is_told_once_and_left_as_it_is(tmp_path):
    result = runs.capture(tmp_path, WITHOUT_PYOPENGL, "--mode", "dome")
    told = "domeshim: this program draws without PyOpenGL; only PyOpenGL's calls are bent onto the dome\n"
    assert (result.returncode, result.stderr) == (0, told)
    assert (runs.picture(tmp_path) == (0, 0, 255)).all()


@pytest.mark.parametrize(("hints", "told"), [("", ""), (CORE, UNBENT)])
def test_a_core_profile_is_told_once_and_left_as_it_is(tmp_path, hints, told):
    result = runs.capture(tmp_path, GLFW_CLEARS.format(hints), "--mode", "dome")
    assert (result.returncode, result.stderr) == (0, told)
    picture = runs.picture(tmp_path)
    assert picture[100, 100].tolist() == [3, 0, 255]
    assert picture[2, 2].tolist() == ([3, 0, 255] if hints else [0, 0, 0])  # the rim


@pytest.mark.parametrize("mode", ["monitor", "dome"])
def test_a_single_buffered_glfw_window_ends_its_pictures_by_flushing(tmp_path, mode):
    source = GLFW_CLEARS.format("glfw.window_hint(glfw.DOUBLEBUFFER, False)")
    result = runs.capture(tmp_path, source.replace("glfw.swap_buffers(window)", "glFlush()"), "--mode", mode)
    assert (result.returncode, result.stderr) == (0, "")
    assert runs.picture(tmp_path)[100, 100].tolist() == [3, 0, 255]


@needs_qt
def test_qt_timers_go_by_pictures_and_a_mixin_may_paint(tmp_path, captured_by_glut):
    result = runs.capture(tmp_path, QT_TIME)
    assert result.returncode == 0, result.stderr
    assert result.stdout == "0 200 200 0\n50 200 200 0\n100 200 200 0\n"
    assert (runs.picture(tmp_path) == captured_by_glut["dome"]).all()


@needs_qt
def test_a_qt_program_may_fill_qts_own_buffers(tmp_path):
    result = runs.capture(tmp_path, QT_BUFFERS, "--mode", "monitor")
    assert result.returncode == 0, result.stderr
    assert result.stdout.splitlines() == [
        "made False None",
        "initialise True True",
        "True True",
        "False True True True",
        r"32 16 b'\x01\x00\x00\x00'",
    ]
    picture = runs.picture(tmp_path)
    half = picture.shape[1] // 2
    assert (picture[:, :half] == (255, 255, 0)).all()
    assert (picture[:, half:] == (0, 0, 255)).all()


@needs_qt
def test_a_qt_program_may_paint_in_paint_event_and_hears_of_what_is_missing(tmp_path):
    result = runs.capture(tmp_path, QT_OWN_PAINT_EVENT, "--mode", "monitor")
    assert result.returncode == 0
    assert result.stderr.count("domeshim: what QPainter draws over GL is not in this picture") == 1
    assert (runs.picture(tmp_path) == (3, 0, 255)).all()


@needs_pygame
def test_uninstall_puts_every_name_back(tmp_path):
    runs.write(tmp_path, UNINSTALL.format(qt=find_spec("PySide6") is not None))
    command = [sys.executable, "prog.py"]
    done = subprocess.run(
        command, cwd=tmp_path, env=runs.environment(), capture_output=True, text=True, timeout=LONGEST
    )
    assert (done.returncode, done.stdout) == (0, "restored\n"), done.stderr


RESIZED = [
    pytest.param(
        runs.PYGAME.replace(
            "while True:",
            "pygame.display.set_mode((200, 150), DOUBLEBUF | OPENGL)\nscene.draw()\npygame.display.flip()\n"
            "pygame.display.set_mode((300, 300), DOUBLEBUF | OPENGL)\nwhile True:",
        ),
        marks=needs_pygame,
        id="pygame",
    ),
    pytest.param(
        runs.GLFW.replace("300, 300", "200, 150").replace(
            "while",
            "glfw.set_framebuffer_size_callback(window, lambda _, *size: scene.shape(*size))\n"
            "scene.draw()\nglfw.swap_buffers(window)\nglfw.set_window_size(window, 300, 300)\nwhile",
        ),
        id="glfw",
    ),
    pytest.param(
        runs.QT_WIDGET.replace("BINDING", "PySide6")
        .replace("300, 300", "200, 150")
        .replace("sys.exit", "QTimer.singleShot(100, lambda: window.resize(300, 300))\nsys.exit"),
        marks=needs_qt,
        id="PySide6",
    ),
]


@needs_xvfb
@pytest.mark.parametrize("source", RESIZED)
def test_the_dome_follows_the_windows_size(source, tmp_path, seen_by_glut):
    seen, stderr = runs.photograph(tmp_path, source, lambda seen: _same_dome(seen, seen_by_glut))
    assert "domeshim:" not in stderr
    # Without a window manager SDL leaves a window that has grown where it was: the dome is looked for.
    assert _same_dome(seen, seen_by_glut), stderr


def _same_dome(seen: np.ndarray, wanted: np.ndarray) -> bool:
    """Where the two overlap when the upper left corners of what is not black lie upon each other."""
    if not seen.any():
        return False
    corner = [np.nonzero(seen.any(axis=2).any(axis=axis))[0][0] for axis in (1, 0)]
    base = [np.nonzero(wanted.any(axis=2).any(axis=axis))[0][0] for axis in (1, 0)]
    shift = (base[0] - corner[0], base[1] - corner[1])
    moved = np.roll(seen, shift, axis=(0, 1))
    height, width = 300 + min(shift[0], 0), 300 + min(shift[1], 0)
    difference = np.abs(moved[:height, :width] - wanted[:height, :width]) > 8
    return bool(difference.any(axis=2).mean() < 0.01)
