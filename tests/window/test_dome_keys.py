"""Ctrl+Shift+P shows the test card in a running window, and the program does not hear of it."""

from __future__ import annotations

import json
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
from domeshim.measure.pixels import read_pixels

heard, pictures = [], []
class Watcher:
    def frame_finished(self, window, number):
        pixels = read_pixels(*window.size)
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


@needs_xvfb
@pytest.mark.parametrize(
    ("source", "heard"),
    [
        (GLUT, ["a", "up", "b", "up", "\x10", "up"]),
        (GLFW, ["a", "up", "b", "up", "ctrl", "up"]),
    ],
    ids=["GLUT", "glfw"],
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
