"""A GLUT off screen, on a virtual clock, one for each test."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from domeshim import GLUT
from domeshim import session as sessions
from domeshim.GLUT.state import GlutWindow
from domeshim.options import Options
from domeshim.session import Session
from domeshim.window.clock import VirtualClock
from domeshim.window.contract import WindowEvents


@pytest.fixture
def glut_session() -> Iterator[Session]:
    from domeshim.window.offscreen import OffscreenBackend

    former = sessions._current
    session = Session(Options(), clock=VirtualClock(), backend=OffscreenBackend, window_size=(256, 192))
    sessions.begin(session)
    yield session
    session.backend.close()
    if former is not None:
        sessions.begin(former)
    else:
        sessions._current = None


@pytest.fixture
def window(glut_session: Session) -> GlutWindow:
    GLUT.glutInit()
    GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE | GLUT.GLUT_DEPTH)
    GLUT.glutCreateWindow("test")
    GLUT.glutDisplayFunc(GLUT.glutSwapBuffers)
    GLUT.glutMainLoopEvent()
    assert glut_session.glut is not None
    assert glut_session.glut.current is not None
    return glut_session.glut.current


@pytest.fixture
def screen(window: GlutWindow) -> WindowEvents:
    return window.surface.events


@pytest.fixture
def log(window: GlutWindow) -> list[tuple[Any, ...]]:
    """Note everything that the keyboard and the mouse tell, with the modifiers."""
    heard: list[tuple[Any, ...]] = []

    def note(name: str) -> Any:
        return lambda *args: heard.append((name, *args))

    def note_input(name: str) -> Any:
        return lambda *args: heard.append((name, *args, GLUT.glutGetModifiers()))

    GLUT.glutKeyboardFunc(note_input("key"))
    GLUT.glutKeyboardUpFunc(note_input("key up"))
    GLUT.glutSpecialFunc(note_input("special"))
    GLUT.glutSpecialUpFunc(note_input("special up"))
    GLUT.glutMouseFunc(note_input("mouse"))
    GLUT.glutMotionFunc(note("motion"))
    GLUT.glutPassiveMotionFunc(note("passive"))
    GLUT.glutEntryFunc(note("entry"))
    return heard
