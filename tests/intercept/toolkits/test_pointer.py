"""The pointer of other toolkits comes in the monitor's coordinates."""

from __future__ import annotations

import json
import sys
from importlib.util import find_spec
from pathlib import Path
from types import SimpleNamespace

import pytest

from domeshim.intercept.toolkits.pygame import PygameToolkit
from domeshim.intercept.toolkits.windows import ToolkitWindow
from domeshim.options import Options
from domeshim.session import Session
from tests.displays import needs_xvfb, run_on_display
from tests.intercept.toolkits.program_runs import ROOT, capture, write

WIDTH = 200
"""Pixels of the captured window: scene's view of 70 degrees over a dome of 180."""

PYGAME = """
import json
import pygame
from pygame.locals import *
import scene
pygame.init()
screen = pygame.display.set_mode((200, 200), DOUBLEBUF | OPENGL)
scene.start()
scene.shape(200, 200)
scene.draw()
pygame.display.flip()
pygame.event.clear()
for kind, more in ((MOUSEMOTION, {"rel": (1, 2), "buttons": (0, 0, 0)}), (MOUSEBUTTONDOWN, {"button": 1})):
    pygame.event.post(pygame.event.Event(kind, pos=(99, 80), **more))
    pygame.event.post(pygame.event.Event(kind, pos=(3, 99), **more))
told = [list(event.pos) for event in pygame.event.get() if event.type in (MOUSEMOTION, MOUSEBUTTONDOWN)]
open("told.json", "w").write(json.dumps(told))
while True:
    scene.draw()
    pygame.display.flip()
"""

GLFW = """
import ctypes
import json
import glfw
import scene
glfw.init()
window = glfw.create_window(200, 200, "cube", None, None)
glfw.make_context_current(window)
told = []
def hear(window, x, y): told.append([x, y])
assert glfw.set_cursor_pos_callback(window, hear) is None
scene.start()
scene.shape(200, 200)
scene.draw()
glfw.swap_buffers(window)
glfw.set_cursor_pos(window, 100, 20)
glfw.poll_events()
told.append(list(glfw.get_cursor_pos(window)))
assert glfw.set_cursor_pos_callback(window, None) is hear
open("told.json", "w").write(json.dumps(told))
while True:
    scene.draw()
    glfw.swap_buffers(window)
"""

QT = """
import json
import sys
from BINDING.QtCore import QCoreApplication, QEvent, QPoint, QPointF, Qt, QTimer
from BINDING.QtGui import QMouseEvent, QWheelEvent
from BINDING.QtWidgets import QApplication
from MODULE import KIND
import scene
told, painted = [], []
class Cube(KIND):
    def initializeGL(self): scene.start()
    def resizeGL(self, width, height): scene.shape(width, height)
    def paintGL(self): painted.append(scene.draw())
    def mousePressEvent(self, event):
        told.append([event.pos().x(), event.pos().y()])
        event.accept()
    def wheelEvent(self, event):
        place = event.position()
        told.append([place.x(), place.y()])
app = QApplication(sys.argv)
window = Cube()
window.resize(200, 200)
window.show()
def point():
    if not painted:
        QTimer.singleShot(100, point)
        return
    here, there = QPointF(99, 80), QPointF(5, 7)
    press = QEvent.Type.MouseButtonPress
    held = (Qt.MouseButton.LeftButton, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier)
    event = QMouseEvent(press, here, there, *held)
    QCoreApplication.sendEvent(window, event)
    assert event.isAccepted()
    turn = (QPoint(0, 0), QPoint(0, 120), held[1], held[2])
    phase = Qt.ScrollPhase.NoScrollPhase
    QCoreApplication.sendEvent(window, QWheelEvent(here, there, *turn, phase, False))
    open("told.json", "w").write(json.dumps(told))
    print(told, flush=True)
    window.update()
    timer.timeout.connect(window.update)
    timer.start(10)
timer = QTimer()
QTimer.singleShot(100, point)
sys.exit(app.exec())
"""


def told(folder: Path, source: str) -> list[list[float]]:
    done = capture(folder, source, "--mode", "dome")
    assert done.returncode == 0, done.stderr
    found: list[list[float]] = json.loads((folder / "told.json").read_text())
    return found


def test_pygames_events(tmp_path: Path) -> None:
    moved, aside, pressed, aside_again = told(tmp_path, PYGAME)
    # 19.5 pixels up of 100 for 90 degrees: tan(17.55) / tan(35) of the window's upper half
    assert moved == pytest.approx([99, 100 - 45.2], abs=1)
    assert pressed == moved
    assert aside[0] < -1500
    assert aside == aside_again


class Doubling:
    """A dome that shows all at double size."""

    def program_place(self, window: object, x: float, y: float) -> tuple[float, float]:
        return 2 * x, 2 * y

    def frame_place(self, window: object, x: float, y: float) -> tuple[float, float]:
        return x / 2, y / 2


def test_pygames_mouse() -> None:
    """SDL without a display moves no pointer: here one that does."""
    at = [(10, 20)]
    mouse = SimpleNamespace(get_pos=lambda: at[-1], set_pos=lambda x, y: at.append((x, y)))
    session = Session(Options(enabled=True))
    session.dome = Doubling()  # type: ignore[assignment] # all that is asked of it
    toolkit = PygameToolkit(session)
    ours = SimpleNamespace(**toolkit.replacements("pygame.mouse", mouse))  # type: ignore[arg-type]
    assert ours.get_pos() == (10, 20)
    toolkit._window = ToolkitWindow(lambda: (300, 200), lambda: None)
    assert ours.get_pos() == (21, 41)
    at.append((0, 0))
    assert ours.get_pos() == (0, 0)
    ours.set_pos((21, 41))
    ours.set_pos(5000, -7)
    assert at[2:] == [(10, 20), (299, 0)]


def qt(binding: str, module: str, kind: str) -> object:
    missing = pytest.mark.skipif(find_spec(binding) is None, reason=f"{binding} is not installed")
    source = QT.replace("MODULE", f"BINDING.{module}").replace("BINDING", binding).replace("KIND", kind)
    return pytest.param(source, marks=missing, id=f"{binding} {kind}")


QT_PROGRAMS = [
    qt("PySide6", "QtOpenGLWidgets", "QOpenGLWidget"),
    qt("PySide6", "QtOpenGL", "QOpenGLWindow"),
    qt("PyQt6", "QtOpenGLWidgets", "QOpenGLWidget"),
    qt("PyQt5", "QtWidgets", "QOpenGLWidget"),
]


@pytest.mark.parametrize("source", QT_PROGRAMS)
def test_qts_events(tmp_path: Path, source: str) -> None:
    places = told(tmp_path, source)
    assert len(places) == 2
    for place in places:
        assert place == pytest.approx([99, 100 - 45.2], abs=1)


@needs_xvfb
@pytest.mark.parametrize("source", QT_PROGRAMS)
def test_qts_events_on_a_display(tmp_path: Path, source: str) -> None:
    write(tmp_path, source.replace("timer.start(10)", "QTimer.singleShot(100, app.quit)"))
    command = [sys.executable, "-m", "domeshim", "run", "prog.py"]
    done = run_on_display(command, {"PYTHONPATH": str(ROOT)}, (300, 300), tmp_path)
    if "could not connect" in done.stderr or "Could not load the Qt platform plugin" in done.stderr:
        pytest.skip("Qt's plugin for X11 lacks libraries here (Debian: libxcb-cursor0)")
    places = json.loads((tmp_path / "told.json").read_text())
    assert len(places) == 2, done.stderr
    for place in places:
        assert place == pytest.approx([99, 100 - 45.2], abs=1)


def test_glfws_cursor(tmp_path: Path) -> None:
    places = told(tmp_path, GLFW)
    for place in places:
        assert place == pytest.approx([100, 20], abs=3)
