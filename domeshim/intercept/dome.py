"""The dome as the session sees it: one WindowDome a window, and the one that calls go to now."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from domeshim.driver import OLDEST_GL
from domeshim.errors import DriverError, OptionError
from domeshim.intercept.draws import Draws
from domeshim.intercept.window_dome import WindowDome
from domeshim.state.context import DomeContext
from domeshim.window.frame import Frame, Rectangle
from domeshim.window.subwindow import SubWindow

if TYPE_CHECKING:
    from domeshim.driver import Driver
    from domeshim.lens.mesh import Floats
    from domeshim.session import Session
    from domeshim.state.region import Region
    from domeshim.window.contract import Window


_MAX_VIEWPORT_DIMS = 0x0D3A


class Dome(Draws):
    """All windows of a session while the dome is on."""

    def __init__(self, session: Session) -> None:
        super().__init__(session)
        self._windows: dict[Window, WindowDome] = {}

    def window_opened(self, window: Window, program_size: tuple[int, int]) -> None:
        """A window's context was made and is current."""
        self._driver.require(OLDEST_GL)
        if self._session.options.finishes:
            self._driver.require((3, 3), "a warp mesh, mirror, fade, brightness or gamma")
        around = self._windows.get(window.outermost) if isinstance(window, SubWindow) else None
        frame = _frame(self._session, self._driver, window, program_size)
        if frame.aside and around is None and 0 in frame.strip()[2:]:
            size = "{}x{}".format(*frame.size)
            raise OptionError(f"DOME_HUD=side: {size} has no room beside the disc; set DOME_FRAME=WxH")
        self._windows[window] = WindowDome(
            self._session.options, self._driver, frame, lambda: window.framebuffer, around
        )
        self.window_current(window)

    def window_current(self, window: Window | None) -> None:
        """The program's GL calls go to this window from now on."""
        self._current = self._windows.get(window) if window is not None else None
        self.context = self._current.context if self._current else None
        self.lists = self._current.lists if self._current else None
        self.building = self.lists.building if self.lists else None
        if self.context is not None:
            self.context.viewport_changed()  # another window may have changed the main view that they share
            if self.context.aside.in_own_framebuffer:
                self.context.framebuffer_bound()  # the toolkit may have bound the window's again, unseen
            self.context.aside.pass_by(self._session.passing)

    def window_resized(self, window: Window, program_size: tuple[int, int]) -> None:
        """The program's window has this size now."""
        context = self._windows[window].context
        self.flush()
        context.undress()
        context.frame = _frame(self._session, self._driver, window, program_size)
        context.viewport_changed()

    def window_closed(self, window: Window) -> None:
        """The window's context is about to go."""
        closed = self._windows.pop(window, None)
        if closed is not None and closed.holds_passes:
            self._free(closed, window)
        if self._current is closed:
            self.window_current(None)

    def _free(self, closed: WindowDome, window: Window) -> None:
        """Free what a closing window's passes hold; it need not be the current one."""
        current = self._session.window
        window.make_current()
        closed.close()
        if current is not None and current is not window:
            current.make_current()

    def context_of(self, window: Window) -> DomeContext | None:
        """The dome's side of a window's context; None where its pictures are left as they are."""
        return self._windows[window].context if window in self._windows else None

    def program_place(self, window: Window, x: float, y: float) -> tuple[float, float]:
        """Where the program would see a place of the frame in its window; pixels, origin at the top left."""
        if window not in self._windows:
            return x, y  # its pictures are left as they are
        sight = self._windows[window].context.pixels.sight
        seen = self._windows[window].before_finish(np.array([x, sight.frame.size[1] - y]))
        place = sight.to_program(seen)
        return float(place[0]), float(sight.frame.program_size[1] - place[1])

    def frame_place(self, window: Window, x: float, y: float) -> tuple[float, float]:
        """Where a place of the program's window is in the frame; pixels, origin at the top left."""
        if window not in self._windows:
            return x, y
        sight = self._windows[window].context.pixels.sight
        place = sight.to_frame(np.array([x, sight.frame.program_size[1] - y]))
        return float(place[0]), float(sight.frame.size[1] - place[1])

    def fills(self, window: Window) -> bool:
        """A window that lies inside another is a main view, which fills the dome."""
        return self._windows[window].context.pixels.fills_dome

    def region(self, window: Window, part: Rectangle) -> Region | None:
        """Which pixels of the frame show this part of a window that lies inside another; None: none do."""
        return self._windows[window].context.pixels.region(part)

    def clearing(self, *, colour: bool) -> None:
        """The program clears a buffer, and the dome does it."""
        self._session.clearing(colour=colour)

    def reading(self) -> None:
        """The program reads pixels of its picture."""
        self._session.reading()

    def look(self, places: Floats) -> None:
        """The program looks on from here; places: (3, 3), gluLookAt's eye, centre and up."""
        context = self.context
        if context is None or context.placer.steady is None:
            return
        from domeshim.state.comfort import looking_at  # noqa: PLC0415 - with DOME_MAX_TURN

        view = looking_at(*places)
        if view is not None:
            context.placer.steady.look(view, self._session.clock.now())
            context.viewport_changed()

    def pass_by(self, on: bool) -> None:
        """Nobody looks at what comes now: leave all draws out, or make them again."""
        self.flush()
        if self.context is not None:
            self.context.aside.pass_by(on)

    @contextmanager
    def straight(self, window: Window) -> Iterator[None]:
        """Within it, draws into the window are left as on the monitor; it must be current."""
        if window not in self._windows:
            yield
            return
        context = self._windows[window].context
        self.flush()
        context.aside.bypass("straight", on=True)
        try:
            yield
        finally:
            self.flush()
            context.aside.bypass("straight", on=False)

    def selects(self, window: Window) -> bool:
        """The window's draws select or give feedback: they make no picture."""
        return window in self._windows and self._windows[window].context.aside.selects

    def frame_ending(self, window: Window) -> None:
        """The picture is complete: cut it at the rim."""
        self.flush()
        self._windows[window].end_frame()

    def showing(self, window: Window) -> None:
        """The window's back buffer is about to be seen: make of it what the projector needs."""
        if window in self._windows:
            self._windows[window].finish()

    def toggle_card(self, window: Window) -> bool:
        """Show the test card over the window's pictures, or no longer; False for a window left as it is."""
        if window not in self._windows:
            return False
        self._windows[window].card.toggle()
        return True


def _frame(session: Session, driver: Driver, window: Window, program_size: tuple[int, int]) -> Frame:
    """A window's frame; of a window without pixels for all of it, the frame of its part.

    Raises DriverError where it is larger than what this GL draws to.
    """
    inside = window.inside if isinstance(window, SubWindow) else None
    most = min(driver.integers(_MAX_VIEWPORT_DIMS, 2))
    frame = Frame.of(session.options, window.size, program_size, inside)
    frame = replace(frame, on_grid=session.on_grid, asked=window.asked)
    if window.part is not None:
        return frame.cut(window.part, most)
    if frame.square[2] > most:
        raise DriverError(f"{frame.square[2]} pixels across: this OpenGL draws to {most} at once, at most")
    return frame
