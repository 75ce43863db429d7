"""A still picture in a window of its own, until the user closes it."""

from __future__ import annotations

from collections.abc import Callable

import glfw
import numpy as np
from numpy.typing import NDArray

from domeshim.draw.paste import paste
from domeshim.driver import Driver
from domeshim.window.contract import SurfaceFormat, WindowEvents
from domeshim.window.screen import ScreenBackend

_WAIT = 0.5
"""Seconds between two looks at whether anything happened."""


class _Closing(WindowEvents):
    """Escape, q, or the window's own button."""

    closed = False
    stale = True

    def close_asked(self) -> None:
        """End."""
        self.closed = True

    def key(self, key: int, pressed: bool, modifiers: int) -> None:  # noqa: ARG002 - the contract's own
        """End at Escape or q."""
        self.closed = self.closed or (pressed and key in (glfw.KEY_ESCAPE, glfw.KEY_Q))

    def exposed(self) -> None:
        """Draw again."""
        self.stale = True

    def resized(self, width: int, height: int) -> None:  # noqa: ARG002 - the contract's own
        """Draw again."""
        self.stale = True


def show(
    picture: Callable[[tuple[int, int]], NDArray[np.uint8]],
    title: str,
    size: tuple[int, int],
    display: int | None = None,
    finish: Callable[[Driver, tuple[int, int]], None] | None = None,
) -> None:
    """Show what picture(size) gives, (height, width, 3), in a window; full screen where a display is given.

    finish: makes of it what the projector needs.

    Raises ScreenError where there is no display to show it on.
    """
    backend = ScreenBackend()
    try:
        events = _Closing()
        window = backend.open_window(title, size, None, SurfaceFormat(), events)
        if display is not None:
            window.set_full_screen(True, display)
        driver = Driver()
        shown: tuple[tuple[int, int], NDArray[np.uint8]] | None = None
        while not events.closed:
            if events.stale and min(window.size) > 0:
                events.stale = False
                if shown is None or shown[0] != window.size:
                    shown = window.size, picture(window.size)
                paste(driver, shown[1])
                if finish is not None:
                    finish(driver, window.size)
                window.swap_buffers()
            backend.poll(_WAIT)
    finally:
        backend.close()
