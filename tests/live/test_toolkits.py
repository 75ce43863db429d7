"""Programs of every toolkit are recorded, by the key as well."""

from __future__ import annotations

import json
import re
from importlib.util import find_spec
from pathlib import Path

import pytest

from tests.displays import needs_xvfb
from tests.GLUT.program_runs import run_on_screen

COMMON = """
import json, os, subprocess, sys
import domeshim
domeshim.install()
from pathlib import Path
from OpenGL.GL import *
from tests.waiting import Steps
n, heard = 0, []
def draw():
    global n
    n += 1
    glClearColor(0, 0.2 + 0.6 * (n % 2), 0, 1)
    glClear(GL_COLOR_BUFFER_BIT)
def key(words):
    subprocess.run(["xdotool", "key", *words.split()], check=True)
def steps():
    yield lambda: n >= 10 and ready()
    numbers = [n]
    key("ctrl+shift+r")
    yield lambda: list(Path().glob("domeshim-*.mp4"))
    numbers.append(n)
    key("a")
    yield lambda: heard and n >= numbers[1] + 20
    numbers.append(n)
    key("ctrl+shift+r b")
    yield lambda: len(heard) == 2
    numbers.append(n)
    yield lambda: n >= numbers[3] + 10
    print(json.dumps([numbers, heard, int(glGetError())]), flush=True)
taken = Steps(steps())
def ready(): return True
"""
PYGAME = """
import pygame
from pygame.locals import *
pygame.init()
pygame.display.set_mode((200, 200), DOUBLEBUF | OPENGL)
pygame.display.set_caption("film")
while not taken.ended():
    heard += [e.key for e in pygame.event.get() if e.type == KEYDOWN and e.key < 128]
    draw()
    pygame.display.flip()
    pygame.time.wait(10)
"""
GLFW = """
import glfw, time
glfw.init()
window = glfw.create_window(200, 200, "film", None, None)
glfw.make_context_current(window)
def hear(window, key, scancode, action, mods):
    if action == glfw.PRESS and key < 128:
        heard.append(key + 32)
glfw.set_key_callback(window, hear)
while not taken.ended():
    draw()
    glfw.swap_buffers(window)
    glfw.poll_events()
    time.sleep(0.01)
"""
QT = """
from BINDING.QtCore import QTimer
from BINDING.QtWidgets import QApplication, QMainWindow
from BINDING.MODULE import QOpenGLWidget
class Widget(QOpenGLWidget):
    def paintGL(self):
        draw()
class Main(QMainWindow):
    def keyPressEvent(self, event):
        if event.key() < 128: heard.append(event.key() + 32)
app = QApplication([])
main = Main()
widget = Widget()
main.setCentralWidget(widget)
main.setWindowTitle("film")
main.resize(200, 200)
main.show()
def ready():
    subprocess.run("xdotool search --onlyvisible --name ^film windowfocus".split(), capture_output=True)
    return main.isActiveWindow()
def tick():
    widget.update()
    if taken.ended(): app.quit()
timer = QTimer()
timer.timeout.connect(tick)
timer.start(10)
app.exec() if hasattr(app, "exec") else app.exec_()
"""


def qt(binding: str, module: str) -> object:
    missing = pytest.mark.skipif(find_spec(binding) is None, reason=f"{binding} is not installed")
    return pytest.param(QT.replace("BINDING", binding).replace("MODULE", module), marks=missing, id=binding)


PROGRAMS = [
    pytest.param(PYGAME, id="pygame"),
    pytest.param(GLFW, id="glfw"),
    qt("PySide6", "QtOpenGLWidgets"),
    qt("PyQt6", "QtOpenGLWidgets"),
    qt("PyQt5", "QtWidgets"),
]


@needs_xvfb
@pytest.mark.parametrize("source", PROGRAMS)
def test_recorded_by_the_key(tmp_path: Path, source: str):
    av = pytest.importorskip("av")
    begin = f"import os\nos.environ['DOME'] = '1'\nos.chdir({str(tmp_path)!r})\n"
    ended = run_on_screen(tmp_path, begin + COMMON + source)
    if "Could not load the Qt platform plugin" in ended.stderr:
        pytest.skip("Qt's plugin for X11 lacks libraries here (Debian: libxcb-cursor0)")
    assert ended.returncode == 0, ended.stderr
    (before, begun, ending, after), heard, error = json.loads(ended.stdout.splitlines()[-1])
    assert (heard, error) == ([97, 98], 0)
    (film,) = tmp_path.glob("*.mp4")
    with av.open(str(film)) as read:
        greens = [int(frame.to_ndarray(format="rgb24")[100, 100, 1]) for frame in read.decode(video=0)]
    told = re.search(rf"{len(greens)} pictures recorded to {film}(?:; (\d+) dropped)?", ended.stderr)
    assert told, ended.stderr
    assert ending - begun <= len(greens) + int(told[1] or 0) <= after - before + 1
    assert min(greens) < 80
    assert max(greens) > 180
