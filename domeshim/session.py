"""The one Session of a process: its options, its clock, its screen, and who hears when a frame ends.

Nothing else in the package keeps state at module level. A program's GLUT, the intercepted GL and the
commands all meet here.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from domeshim.options import Options
from domeshim.window.clock import Clock, RealClock
from domeshim.window.dome_keys import CARD_KEY

if TYPE_CHECKING:
    from collections.abc import Callable

    from domeshim.driver import Driver
    from domeshim.GLUT.state import GlutState
    from domeshim.live.audience import Audience
    from domeshim.partners import Dome, FrameListener, Parts
    from domeshim.preview.dome import VirtualDome
    from domeshim.preview.viewer import Viewer
    from domeshim.startup import Installation
    from domeshim.window.contract import Backend, BackendFactory, Window


_STRANGER = (
    "the program's window was opened by another toolkit than GLUT, pygame, glfw or Qt; "
    "what it draws there is not bent"
)


class Session:
    """All state of one run of one program.

    The order within a frame's end is: the dome completes the picture, the listeners see it, the window
    shows it, the clock goes on.
    """

    def __init__(
        self,
        options: Options | None = None,
        *,
        clock: Clock | None = None,
        backend: BackendFactory | None = None,
        window_size: tuple[int, int] | None = None,
    ) -> None:
        self.options = options if options is not None else Options()
        self.clock: Clock = clock if clock is not None else RealClock()
        self.window_size = window_size
        """The window's size in pixels whatever the program asks for, or None."""
        self.dome: Dome | None = None
        self.make_driver: Callable[[], Driver] | None = None
        """What the dome calls GL by, where somebody wants to look on; None: GL itself."""
        self.installation: Installation | None = None
        self.listeners: list[FrameListener] = []
        self.audience: Audience | None = None
        """Takes what is seen on to a film and a virtual dome; on a screen only."""
        self.virtual_dome: VirtualDome | None = None
        """The one to be opened beside the program, if another than its options stand for."""
        self.viewer: Viewer | None = None
        self.parts: Parts | None = None
        """Takes the pictures of windows that lie inside others; None where there are none."""
        self.glut: GlutState | None = None
        self.frames = 0
        self._backend_factory = backend
        self._backend: Backend | None = None
        self._window: Window | None = None
        self._unmet: dict[Window, tuple[int, int]] = {}
        """Windows opened before there was a dome, by the size that the program believes in."""
        self._unbent: set[Window] = set()
        self._drawn = False
        self._flushed = False
        self._displaying = False
        self._stranger_told = False
        self._passing = False
        self._cleared = False
        self.looked_back = False
        """The program needed a picture that was passed by."""
        self.on_grid = False
        """Tiles of a picture shall be what it is when drawn whole (see Frame); said before a window opens."""

    @property
    def backend(self) -> Backend:
        """The screen, or the place off it, that windows come from; opened on first use."""
        if self._backend is None:
            if self._backend_factory is not None:
                self._backend = self._backend_factory()
            else:
                from domeshim.window.choose import choose_backend  # noqa: PLC0415 - glfw only when a window is wanted

                self._backend = choose_backend()
        return self._backend

    @property
    def window(self) -> Window | None:
        """The window that the program's GL calls go to."""
        return self._window

    @property
    def backend_given(self) -> bool:
        """A command chose where windows come from; those of any toolkit shall come from there."""
        return self._backend_factory is not None

    def dome_made(self, dome: Dome) -> None:
        """The dome is there from now on; a program may have opened its window before it imported GL."""
        self.dome = dome
        self._introduce(self._window)

    @property
    def passing(self) -> bool:
        """Nobody looks at the picture that is being drawn: the dome leaves out its draws."""
        return self._passing

    @passing.setter
    def passing(self, passing: bool) -> None:
        if passing != self._passing:
            self._passing = passing
            if self.dome is not None:
                self.dome.pass_by(passing)

    # What the toolkit tells us of its windows.

    def window_opened(self, window: Window, program_size: tuple[int, int], *, bent: bool = True) -> None:
        """A window was opened and made current; the program believes in program_size, (width, height).

        bent=False: the window's GL has no fixed function, and its pictures are left as they are.
        """
        if self.options.enabled and self.options.vsync is not None:
            window.set_vsync(self.options.vsync)
        if self.options.enabled and self.audience is None and not self.backend_given:
            from domeshim.live.audience import Audience  # noqa: PLC0415 - with a window on a screen

            self.audience = Audience(self)
            self.listeners.append(self.audience)
        if bent:
            self._unmet[window] = program_size
        else:
            self._unbent.add(window)
        self.window_current(window)

    def bends(self, window: Window) -> bool:
        """The window's GL has the fixed function, whose pictures can be bent."""
        return window not in self._unbent

    def window_current(self, window: Window | None) -> None:
        """The program's GL calls go to this window from now on."""
        self._window = window
        if self.dome is not None and not self._introduce(window):
            self.dome.window_current(None if window in self._unbent else window)

    def window_resized(self, window: Window, program_size: tuple[int, int]) -> None:
        """The program's window has this size now, (width, height) in the program's own pixels."""
        if window in self._unmet:
            self._unmet[window] = program_size
        elif self.dome is not None and window not in self._unbent:
            self.dome.window_resized(window, program_size)

    def window_closed(self, window: Window) -> None:
        """The window is about to close."""
        if self.audience is not None:
            self.audience.window_closing(window)
        if self.dome is not None:
            self.dome.window_closed(window)
        self._unmet.pop(window, None)
        self._unbent.discard(window)
        if self._window is window:
            self._window = None

    def _introduce(self, window: Window | None) -> bool:
        """Open the current window for the dome if the two have not met; whether they just did."""
        if self.dome is None or window is None or window not in self._unmet:
            return False
        self.dome.window_opened(window, self._unmet.pop(window))
        return True

    def takes_key(self, window: Window, key: int) -> bool:
        """The dome does what a key of its own (dome_keys.py) stands for; False where it cannot."""
        if key == CARD_KEY:
            return self.dome is not None and self.dome.toggle_card(window)
        if self.audience is not None:
            self.audience.toggle_recording()
        return self.audience is not None

    # How a frame ends: at the swap, or at the flush of a single-buffered program (DESIGN 7).

    def drawing(self) -> None:
        """Something is being drawn; a new picture begins where the last one was flushed."""
        self._drawn = True

    def clearing(self, *, colour: bool) -> None:
        """A buffer is about to be cleared: what was flushed before was a whole picture."""
        if self._window is None:
            self._tell_of_stranger()
        elif self._flushed:
            self._end_frame(self._window)
        self._drawn = True
        self._cleared = self._cleared or colour

    def _tell_of_stranger(self) -> None:
        """Say, once, that the program draws into a window that we have not heard of."""
        if self.dome is not None and not self._stranger_told:
            self._stranger_told = True
            print(f"domeshim: {_STRANGER}", file=sys.stderr)

    def reading(self) -> None:
        """The program reads pixels of its picture."""
        self.looked_back = self.looked_back or self._passing

    def flushed(self) -> None:
        """The program flushed: a single-buffered picture is finished, at the end of display if inside it."""
        window = self._window
        if window is None or window.format.double_buffer or not self._drawn:
            return
        if self._displaying:
            self._flushed = True
        else:
            self._end_frame(window)

    def swapped(self, window: Window) -> None:
        """The program swapped its buffers: the picture is finished, unless it was drawn to select."""
        if self.dome is None or not self.dome.selects(window):
            self._end_frame(window)

    def display_begins(self, window: Window) -> None:
        """The program's display callback is about to run."""
        self._window = window
        self._displaying = True
        self._flushed = self._drawn = False

    def display_ended(self, window: Window) -> None:
        """The display callback has returned; what it drew and never swapped is finished now."""
        self._displaying = False
        if self.dome is not None:
            self.dome.flush()
        if self._drawn:
            self._end_frame(window)

    def _end_frame(self, window: Window) -> None:
        if self.dome is not None and window not in self._unbent:
            self.dome.frame_ending(window)
        self.looked_back |= self._passing and not self._cleared  # the next picture is drawn over it
        self._drawn = self._flushed = self._cleared = False  # the dome's own draws belong to what ends
        if self.parts is None or not self.parts.keep(window):
            self.show(window)

    def show(self, window: Window) -> None:
        """The picture in the window's back buffer is whole: count it, let it be seen, and show it."""
        if self.dome is not None and window not in self._unbent:
            self.dome.showing(window)
        self.frames += 1
        for listener in tuple(self.listeners):
            listener.frame_finished(window, self.frames)
        window.swap_buffers()
        self.clock.frame_finished()


_current: Session | None = None


def current() -> Session:
    """The session of this process; made from the environment when nobody began one."""
    if _current is None:
        begin(Session(Options.from_environment()))
    assert _current is not None
    return _current


def begin(session: Session) -> Session:
    """Make this the process's session and return it."""
    global _current  # noqa: PLW0603 - the one place where the package remembers anything
    _current = session
    return session
