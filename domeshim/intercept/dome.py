"""The dome as the session sees it: one DomeContext a window, and the one that calls go to now."""

from __future__ import annotations

from typing import TYPE_CHECKING

from domeshim.draw.rim import Rim
from domeshim.draw.submit import Submitter
from domeshim.driver import Driver
from domeshim.record.immediate import Immediate
from domeshim.record.lists import DisplayLists
from domeshim.state.context import DomeContext
from domeshim.window.frame import Frame

if TYPE_CHECKING:
    from domeshim.session import Session
    from domeshim.window.contract import Window


class WindowDome:
    """All that the dome keeps for one window."""

    def __init__(
        self, session: Session, driver: Driver, window: Window, program_size: tuple[int, int]
    ) -> None:
        self.context = DomeContext(session.options, Frame(window.size, program_size), driver)
        self.lists = DisplayLists(driver)
        self.submitter = Submitter(driver)
        self.rim = Rim(driver)


class Dome:
    """All windows of a session while the dome is on, and the recorder that they share."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._driver = Driver()
        self._windows: dict[Window, WindowDome] = {}
        self._current: WindowDome | None = None
        self.recorder = Immediate()
        self.context: DomeContext | None = None
        """The context that the program's GL calls go to; None before its first window."""
        self.lists: DisplayLists | None = None
        """That context's display lists."""

    def window_opened(self, window: Window, program_size: tuple[int, int]) -> None:
        """A window's context was made and is current."""
        self._windows[window] = WindowDome(self._session, self._driver, window, program_size)
        self.window_current(window)

    def window_current(self, window: Window | None) -> None:
        """The program's GL calls go to this window from now on."""
        self._current = self._windows.get(window) if window is not None else None
        self.context = self._current.context if self._current else None
        self.lists = self._current.lists if self._current else None

    def window_resized(self, window: Window, program_size: tuple[int, int]) -> None:
        """The program's window has this size now."""
        context = self._windows[window].context
        self.flush()
        context.undress()
        context.frame = Frame(window.size, program_size)
        context.viewport_changed()

    def window_closed(self, window: Window) -> None:
        """The window's context is about to go."""
        closed = self._windows.pop(window, None)
        if self._current is closed:
            self.window_current(None)

    def drawing(self) -> None:
        """The program draws something that is not recorded."""
        self._session.drawing()

    def flush(self) -> None:
        """Let GL see what has been recorded, before anything else happens to it."""
        recorder, current = self.recorder, self._current
        if recorder.block is not None:
            return  # between glBegin and glEnd nothing may come in between
        if current is None:
            recorder.clear()
            return
        if recorder.blocks:
            self._session.drawing()
            current.context.dress()
        if current.lists.building is not None:
            current.lists.building.used = True
        current.submitter.submit(recorder)

    def frame_ending(self, window: Window) -> None:
        """The picture is complete: cut it at the rim."""
        self.flush()
        ended = self._windows[window]
        ended.context.undress()
        ended.rim.draw(ended.context.frame, ended.context.rim)
