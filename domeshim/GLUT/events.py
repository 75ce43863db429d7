"""What happens to a window, on its way to the program's callbacks.

The screen's events are queued as they come and dispatched by the main loop, so that no program code runs
inside the screen library's own calls.
"""

from __future__ import annotations

from typing import Any

from domeshim.GLUT.state import GlutState, GlutWindow
from domeshim.window.contract import WindowEvents


class QueuedEvents(WindowEvents):
    """Puts a window's events into GLUT's queue."""

    def __init__(self, state: GlutState) -> None:
        self.state = state
        self.window: GlutWindow | None = None

    def _queue(self, name: str, *args: Any) -> None:
        if self.window is not None:
            self.state.events.append((self.window, name, args))

    def resized(self, width: int, height: int) -> None:
        """Queue a new frame size."""
        self._queue("resized", width, height)

    def exposed(self) -> None:
        """Queue that the content is gone."""
        self._queue("exposed")

    def close_asked(self) -> None:
        """Queue that the user wants the window closed."""
        self._queue("close_asked")

    def key(self, key: int, pressed: bool, modifiers: int) -> None:
        """Queue a key."""
        self._queue("key", key, pressed, modifiers)

    def character(self, codepoint: int) -> None:
        """Queue a character."""
        self._queue("character", codepoint)

    def pointer_moved(self, x: float, y: float) -> None:
        """Queue a move of the pointer."""
        self._queue("pointer_moved", x, y)

    def pointer_entered(self, inside: bool) -> None:
        """Queue that the pointer came in or left."""
        self._queue("pointer_entered", inside)

    def button(self, button: int, pressed: bool, modifiers: int) -> None:
        """Queue a mouse button."""
        self._queue("button", button, pressed, modifiers)

    def wheel(self, dx: float, dy: float) -> None:
        """Queue a turn of the wheel."""
        self._queue("wheel", dx, dy)

    def visibility_changed(self, visible: bool) -> None:
        """Queue that the window went or came back."""
        self._queue("visibility_changed", visible)

    def moved(self, x: int, y: int) -> None:
        """Queue a new place on the screen."""
        self._queue("moved", x, y)
