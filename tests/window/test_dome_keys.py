"""Ctrl+Shift+P shows the test card in a running window, and the program does not hear of it."""

from __future__ import annotations

import json
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.GLUT.program_runs import needs_xvfb, run_on_screen
from tests.intercept.toolkits.program_runs import capture

COMMON = """
import os, subprocess, sys
os.environ["DOME"] = "1"
import domeshim
domeshim.install()
from OpenGL.GL import *
from OpenGL.GLU import *
from domeshim import session

heard, pictures = [], []
class Watcher:
    def frame_finished(self, window, number):
        pixels = glReadPixels(0, 0, *window.size, GL_RGB, GL_UNSIGNED_BYTE)
        pictures.append(sum(pixels[i] > 200 and pixels[i + 2] > 200 for i in range(0, len(pixels), 3)))
session.current().listeners.append(Watcher())
STEPS = iter(["key a", "key ctrl+shift+p", "key b", "key ctrl+shift+p", "key ctrl+p"])
def step():
    words = next(STEPS, None)
    if words is None:
        print(heard, [n > 1000 for n in pictures[:1] + shown], flush=True)
        os._exit(0)
    subprocess.run(["xdotool", *words.split()], check=True)
shown = []
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
    if heard_steps:
        shown.append(pictures[-1])
    heard_steps.append(1)
    step()
    glutTimerFunc(300, timer, 0)
heard_steps = []
glutInit(sys.argv)
glutInitDisplayMode(GLUT_DOUBLE)
glutInitWindowSize(400, 400)
glutInitWindowPosition(0, 0)
glutCreateWindow("card")
glutDisplayFunc(display)
glutKeyboardFunc(lambda key, x, y: heard.append(key.decode("latin-1")))
glutKeyboardUpFunc(lambda key, x, y: heard.append("up"))
glutTimerFunc(300, timer, 0)
glutMainLoop()
"""
GLFW = """
import time
import glfw
glfw.init()
window = glfw.create_window(400, 400, "card", None, None)
glfw.make_context_current(window)
def key(window, key, scancode, action, mods):
    if action != glfw.REPEAT and key < 256:
        heard.append(chr(key).lower() if action == glfw.PRESS and not mods else "ctrl" if action else "up")
assert glfw.set_key_callback(window, key) is None
first = True
while True:
    until = time.time() + 0.3
    while time.time() < until:
        draw()
        glfw.swap_buffers(window)
        glfw.poll_events()
    if not first:
        shown.append(pictures[-1])
    first = False
    step()
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
def tick():
    if began:
        shown.append(pictures[-1])
    began.append(1)
    step()
    if len(began) != 3:  # the card comes and goes by itself
        widget.update()
def begin():
    subprocess.run("xdotool search --onlyvisible --name ^card windowfocus".split(), check=True)
    timer.start(300)
began, timer = [], QTimer()
timer.timeout.connect(tick)
QTimer.singleShot(1000, begin)
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
