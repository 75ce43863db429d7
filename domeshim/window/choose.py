"""Which screen a program gets when nobody said."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager

from domeshim.window.contract import Backend


def choose_backend() -> Backend:
    """Open the display's windows; off-screen work is asked for by name, never taken silently.

    Raises ScreenError where there is no display.
    """
    with _children_without_dome():
        from domeshim.window.screen import ScreenBackend  # noqa: PLC0415 - glfw only when a window is wanted

    return ScreenBackend()


@contextmanager
def _children_without_dome() -> Iterator[None]:
    """Within it no Python that is started arms a dome: glfw starts one, to ask its library's version."""
    dome = os.environ.pop("DOME", None)
    try:
        yield
    finally:
        if dome is not None:
            os.environ["DOME"] = dome
