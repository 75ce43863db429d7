"""Ctrl+Shift+P shows the test card in a running window, and the program does not hear of it."""

from __future__ import annotations

import json
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.displays import needs_xvfb
from tests.GLUT.program_runs import run_on_screen
from tests.intercept.toolkits.program_runs import capture

COMMON = """
import os, subprocess, sys
os.environ["DOME"] = "1"
import domeshim
domeshim.install()
import numpy
from OpenGL.GL import *
from OpenGL.GLU import *
from domeshim import session
from tests.waiting import Steps

heard, pictures = [], []
class Watcher:
    def frame_finished(self, window, number):
        pixels = glReadPixels(0, 0, *window.size, GL_RGB, GL_UNSIGNED_BYTE)
        pixels = numpy.frombuffer(pixels, numpy.uint8).reshape(-1, 3)
        pictures.append(int((pixels[:, [0, 2]] > 200).all(axis=1).sum()))
session.current().listeners.append(Watcher())
STEPS = ["key a", "key ctrl+shift+p", "key b", "key ctrl+shift+p", "key ctrl+p"]
def steps():
    shown = []
    def drawn():
        shown.append(pictures[-1] > 1000)
    yield lambda: pictures
    drawn()
    for words in STEPS:
        card, awaited, before = shown[-1], len(heard) + answers, len(pictures)
        subprocess.run(["xdotool", *words.split()], check=True)
        if words != "key ctrl+shift+p":
            yield lambda: len(heard) >= awaited
            redraw()
            yield lambda: len(pictures) > before
        else:
            yield lambda: (pictures[-1] > 1000) != card  # the card comes and goes by itself
        drawn()
    print(heard, shown, flush=True)
    os._exit(0)
taken = Steps(steps())
def draw():
    glClearColor(0, 0.2, 0, 1)
    glClear(GL_COLOR_BUFFER_BIT)
"""
GLUT = """
from OpenGL.GLUT import *
def display():
    draw()
    glutSwapBuffers()
def timer(_):
    taken.ended()
    glutTimerFunc(5, timer, 0)
glutInit(sys.argv)
glutInitDisplayMode(GLUT_DOUBLE)
glutInitWindowSize(400, 400)
glutInitWindowPosition(0, 0)
glutCreateWindow("card")
glutDisplayFunc(display)
redraw, answers = glutPostRedisplay, 2
glutKeyboardFunc(lambda key, x, y: heard.append(key.decode("latin-1")))
glutKeyboardUpFunc(lambda key, x, y: heard.append("up"))
glutTimerFunc(0, timer, 0)
glutMainLoop()
"""
GLFW = """
import glfw
glfw.init()
window = glfw.create_window(400, 400, "card", None, None)
glfw.make_context_current(window)
def key(window, key, scancode, action, mods):
    if action != glfw.REPEAT and key < 256:
        heard.append(chr(key).lower() if action == glfw.PRESS and not mods else "ctrl" if action else "up")
assert glfw.set_key_callback(window, key) is None
redraw, answers = int, 2  # it draws all the time
while not taken.ended():
    draw()
    glfw.swap_buffers(window)
    glfw.poll_events()
"""
QT = """
from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QApplication
from PySide6.QtOpenGLWidgets import QOpenGLWidget
CONTROL = Qt.KeyboardModifier.ControlModifier
class Widget(QOpenGLWidget):
    def paintGL(self):
        draw()
    def keyPressEvent(self, event):
        if event.key() < 256:
            heard.append("ctrl" if event.modifiers() & CONTROL else event.text())
app = QApplication([])
widget = Widget()
widget.setWindowTitle("card")
widget.resize(400, 400)
widget.show()
redraw, answers = widget.update, 1
def focused():
    subprocess.run("xdotool search --onlyvisible --name ^card windowfocus".split(), capture_output=True)
    return widget.isActiveWindow()
def tick():
    if ready or pictures and focused():
        ready.append(1)
        taken.ended()
ready, timer = [], QTimer()
timer.timeout.connect(tick)
timer.start(20)
app.exec()
"""
needs_pyside = pytest.mark.skipif(find_spec("PySide6") is None, reason="PySide6 is not installed")


@needs_xvfb
@pytest.mark.parametrize(
    ("source", "heard"),
    [
        (GLUT, ["a", "up", "b", "up", "\x10", "up"]),
        (GLFW, ["a", "up", "b", "up", "ctrl", "up"]),
        pytest.param(QT, ["a", "b", "ctrl"], marks=needs_pyside),
    ],
    ids=["GLUT", "glfw", "Qt"],
)
def test_on_screen(tmp_path: Path, source: str, heard: list[str]) -> None:
    ended = run_on_screen(tmp_path, COMMON + source)
    assert ended.returncode == 0, ended.stderr
    # Before, after a, the card, after b, no card, after Ctrl+P.
    assert ended.stdout.strip() == f"{heard} [False, False, True, True, False, False]"


PYGAME = """
import json
import pygame
from pygame.locals import *
import scene
pygame.init()
screen = pygame.display.set_mode((300, 300), DOUBLEBUF | OPENGL)
scene.start()
scene.shape(300, 300)
scene.draw()
pygame.display.flip()
pygame.event.clear()
heard = []
CARD, ALT = KMOD_LCTRL | KMOD_RSHIFT, KMOD_LCTRL | KMOD_LSHIFT | KMOD_LALT
for key, mod in ((K_a, 0), (K_p, CARD), (K_p, KMOD_LCTRL), (K_p, ALT)):
    for kind in (KEYDOWN, KEYUP):
        pygame.event.post(pygame.event.Event(kind, key=key, mod=mod, unicode=""))
        heard.append(len(pygame.event.get()) if key != K_p else pygame.event.poll().type == kind)
open("heard.json", "w").write(json.dumps(heard))
while True:
    scene.draw()
    pygame.display.flip()
"""


def test_pygames_events(tmp_path: Path) -> None:
    done = capture(tmp_path, PYGAME, "--mode", "dome", "--frame", "2", "--size", "300")
    assert done.returncode == 0, done.stderr
    assert json.loads((tmp_path / "heard.json").read_text()) == [1, 1, False, False, True, True, True, True]
    white = (np.asarray(Image.open(tmp_path / "picture.png")) > 200).all(-1)
    assert white.sum() > 500  # the card's rim
