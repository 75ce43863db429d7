"""A GLUT off screen, on a virtual clock, one for each test."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from domeshim import session as sessions
from domeshim.options import Options
from domeshim.session import Session
from domeshim.window.clock import VirtualClock


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
