"""The pointer of other toolkits comes in the monitor's coordinates."""

from __future__ import annotations

import json
from pathlib import Path
from types import SimpleNamespace

import pytest

from domeshim.intercept.toolkits.pygame import PygameToolkit
from domeshim.intercept.toolkits.windows import ToolkitWindow
from domeshim.options import Options
from domeshim.session import Session
from tests.intercept.toolkits.program_runs import capture

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


def test_glfws_cursor(tmp_path: Path) -> None:
    places = told(tmp_path, GLFW)
    for place in places:
        assert place == pytest.approx([100, 20], abs=3)
