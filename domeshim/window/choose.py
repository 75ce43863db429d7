"""Which screen a program gets when nobody said."""

from __future__ import annotations

from domeshim.window.contract import Backend


def choose_backend() -> Backend:
    """Open the display's windows; off-screen work is asked for by name, never taken silently.

    Raises ScreenError where there is no display.
    """
    from domeshim.window.screen import ScreenBackend  # noqa: PLC0415 - glfw only when a window is wanted

    return ScreenBackend()
