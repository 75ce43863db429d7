"""The dome as the session sees it: one DomeContext a window, and the one that calls go to now."""

from __future__ import annotations

from typing import TYPE_CHECKING

from domeshim.draw.rim import Rim
from domeshim.driver import Driver
from domeshim.state.context import DomeContext
from domeshim.window.frame import Frame

if TYPE_CHECKING:
    from domeshim.options import Options
    from domeshim.window.contract import Window


class Dome:
    """All windows of a session while the dome is on."""

    def __init__(self, options: Options) -> None:
        self._options = options
        self._driver = Driver()
        self._contexts: dict[Window, DomeContext] = {}
        self._rims: dict[Window, Rim] = {}
        self.context: DomeContext | None = None
        """The context that the program's GL calls go to; None before its first window."""

    def window_opened(self, window: Window, program_size: tuple[int, int]) -> None:
        """A window's context was made and is current."""
        self._contexts[window] = DomeContext(self._options, Frame(window.size, program_size), self._driver)
        self.window_current(window)

    def window_current(self, window: Window | None) -> None:
        """The program's GL calls go to this window from now on."""
        self.context = self._contexts.get(window) if window is not None else None

    def window_resized(self, window: Window, program_size: tuple[int, int]) -> None:
        """The program's window has this size now."""
        context = self._contexts[window]
        context.undress()
        context.frame = Frame(window.size, program_size)
        context.viewport_changed()

    def window_closed(self, window: Window) -> None:
        """The window's context is about to go."""
        context = self._contexts.pop(window, None)
        self._rims.pop(window, None)
        if self.context is context:
            self.context = None

    def frame_ending(self, window: Window) -> None:
        """The picture is complete: cut it at the rim."""
        context = self._contexts[window]
        context.undress()
        if window not in self._rims:
            self._rims[window] = Rim(self._driver)
        self._rims[window].draw(context.frame, context.rim)
