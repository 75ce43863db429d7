"""Where a program runs for its pictures: off screen, on a clock that counts frames, watched."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, NoReturn

from domeshim import startup
from domeshim.partners import FrameListener
from domeshim.session import Session
from domeshim.window.clock import VirtualClock

if TYPE_CHECKING:
    from domeshim.options import Options
    from domeshim.window.contract import Backend

WITHOUT_A_DISPLAY = {
    "PYOPENGL_PLATFORM": "egl",
    "SDL_VIDEODRIVER": "dummy",
    "SDL_AUDIODRIVER": "dummy",
    "QT_QPA_PLATFORM": "offscreen",
}


@dataclass(frozen=True)
class Studio:
    """The window's size in pixels, pictures a second, and the real seconds that a picture may take."""

    size: tuple[int, int]
    fps: float = 60.0
    timeout: float = 60.0
    part: tuple[int, int, int, int] | None = None
    """Of the window, for which alone there are pixels: x and y from its bottom left, width, height."""


class Watch:
    """Calls silent() in a thread of its own when nothing was heard for so many real seconds."""

    def __init__(self, timeout: float, silent: Callable[[], None]) -> None:
        self.timeout = timeout
        self.waiting = False
        """The program is being kept waiting: its silence means nothing."""
        self._silent = silent
        self._news = threading.Event()

    def start(self) -> None:
        """Begin to watch, until the process ends."""
        threading.Thread(target=self._watch, name="domeshim watchdog", daemon=True).start()

    def heard(self) -> None:
        """A picture came."""
        self._news.set()

    def _watch(self) -> None:
        # The operating system times the waiting for a lock: pinning the time module does not reach it.
        while self._news.wait(self.timeout) or self.waiting:
            self._news.clear()
        self._silent()


def run_off_screen(
    run: Callable[[], None], options: Options, studio: Studio, listener: Callable[[Session], FrameListener]
) -> tuple[Session, object]:
    """Run a program by run() to its end; the session, and what the program told Python to exit with.

    listener: makes what hears of each finished picture. What the program prints and raises passes through.
    """
    os.environ.update(WITHOUT_A_DISPLAY)  # before anything imports OpenGL or a toolkit
    from domeshim.window.virtual_time import pin_time  # noqa: PLC0415 - only pictures have a time of their own

    clock = VirtualClock(studio.fps)
    session = Session(
        options, clock=clock, backend=partial(_off_screen, studio.part), window_size=studio.size
    )
    session.listeners.append(listener(session))
    startup.run_under(session)
    pin_time(clock)
    try:
        run()
    except SystemExit as ended:
        return session, ended.code
    return session, None


def end_at_once(status: int) -> NoReturn:
    """End the process without asking the program; what it has printed is kept."""
    for stream in (sys.stdout, sys.stderr):
        with suppress(Exception):
            stream.flush()
    os._exit(status)


def _off_screen(part: tuple[int, int, int, int] | None) -> Backend:
    # Imported with the first window: until then the program may set PyOpenGL's flags.
    from domeshim.window.offscreen import OffscreenBackend  # noqa: PLC0415

    return OffscreenBackend(part)
