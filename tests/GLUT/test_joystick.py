"""Joysticks, which nobody has plugged in here: what glfw would say of them is put in its place."""

from __future__ import annotations

from pathlib import Path

import pytest

from domeshim import GLUT
from domeshim.GLUT.state import GlutWindow
from domeshim.session import Session
from domeshim.window.contract import Joystick
from domeshim.window.offscreen import OffscreenBackend
from tests.displays import needs_xvfb
from tests.GLUT.program_runs import run_on_screen

STICK = Joystick((-1.0, 0.25, 0.5, 0.9), (True, False, True))


@pytest.fixture
def plugged_in(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(OffscreenBackend, "joysticks", (STICK, Joystick((0.1,), ())))


@pytest.mark.usefixtures("plugged_in")
def test_a_window_is_told_of_each_as_often_as_it_asked(glut_session: Session, window: GlutWindow) -> None:
    heard: list[tuple[int, ...]] = []
    GLUT.glutJoystickFunc(lambda *args: heard.append((GLUT.glutGetWindow(), *args)), 50)
    GLUT.glutMainLoopEvent()
    both = [(window.number, 5, -1000, 250, 500), (window.number, 0, 100, 0, 0)]
    assert heard == both
    glut_session.clock.advance_to(glut_session.clock.now() + 0.04)
    GLUT.glutMainLoopEvent()
    assert heard == both
    glut_session.clock.advance_to(glut_session.clock.now() + 0.02)
    GLUT.glutMainLoopEvent()
    assert heard == 2 * both


@pytest.mark.usefixtures("plugged_in", "window")
def test_forced_only(glut_session: Session) -> None:
    heard: list[tuple[int, ...]] = []
    GLUT.glutJoystickFunc(lambda *args: heard.append(args), 0)
    GLUT.glutMainLoopEvent()
    assert heard == []
    GLUT.glutForceJoystickFunc()
    assert heard == [(5, -1000, 250, 500), (0, 100, 0, 0)]
    GLUT.glutJoystickFunc(None, 10)
    GLUT.glutForceJoystickFunc()
    assert len(heard) == 2


@pytest.mark.usefixtures("plugged_in", "window")
def test_the_program_may_ask_what_there_is() -> None:
    assert GLUT.glutDeviceGet(GLUT.GLUT_OWNS_JOYSTICK) == 0
    GLUT.glutJoystickFunc(lambda *_: None, 70)
    asked = "HAS_JOYSTICK", "OWNS_JOYSTICK", "JOYSTICK_BUTTONS", "JOYSTICK_AXES", "JOYSTICK_POLL_RATE"
    assert [GLUT.glutDeviceGet(getattr(GLUT, f"GLUT_{name}")) for name in asked] == [1, 1, 3, 4, 70]


def test_none_is_plugged_in(window: GlutWindow) -> None:
    heard: list[tuple[int, ...]] = []
    GLUT.glutJoystickFunc(lambda *args: heard.append(args), 1)
    GLUT.glutForceJoystickFunc()
    assert GLUT.glutDeviceGet(GLUT.GLUT_HAS_JOYSTICK) == 0
    assert heard == []


@needs_xvfb
def test_a_screen_asks_glfw(tmp_path: Path) -> None:
    source = """
    import ctypes
    import glfw
    from domeshim.GLUT import *
    glfw.joystick_present = lambda number: number == glfw.JOYSTICK_3
    glfw.get_joystick_axes = lambda number: ((ctypes.c_float * 2)(0.5, -1), 2)
    glfw.get_joystick_buttons = lambda number: ((ctypes.c_ubyte * 2)(0, 1), 2)
    glutInit()
    glutCreateWindow("joystick")
    glutDisplayFunc(lambda: None)
    heard = []
    def told(*args):
        heard.append(args)
        if len(heard) == 3:
            print(heard)
            glutLeaveMainLoop()
    glutJoystickFunc(told, 5)
    glutMainLoop()
    """
    done = run_on_screen(tmp_path, source)
    assert done.stdout.strip() == str(3 * [(2, 500, -1000, 0)]), done.stderr
