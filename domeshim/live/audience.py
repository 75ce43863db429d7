"""What the audience sees goes on to a film and to a virtual dome, while the program runs."""

from __future__ import annotations

import atexit
import os
import subprocess
import sys
import time
from datetime import datetime
from itertools import chain, count
from pathlib import Path
from typing import TYPE_CHECKING

from domeshim.driver import Driver
from domeshim.errors import DomeError
from domeshim.wording import counted

if TYPE_CHECKING:
    from domeshim.live.readback import Picture, Readback
    from domeshim.live.recording import Recording
    from domeshim.live.shared import Board
    from domeshim.session import Session
    from domeshim.window.contract import Window

_SHOWN_EVERY = 1 / 30
"""Seconds between two pictures for the virtual dome."""


class Audience:
    """Looks at the pictures of the first window that the program shows."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._options = session.options
        self._driver = Driver()
        self._window: Window | None = None
        self._readback: Readback | None = None
        self._recording: Recording | None = None
        self._board: Board | None = None
        self._viewer: subprocess.Popen[bytes] | None = None
        self._shown = 0.0
        self._files = 0
        if self._options.record is not None:
            self.toggle_recording()
        if self._options.preview:
            self._open_preview()
        atexit.register(self.close)

    def frame_finished(self, window: Window, number: int) -> None:  # noqa: ARG002 - the contract's own
        """Read the picture, if anybody wants it, and hand on an earlier one."""
        if self._recording is None and self._board is None:
            return
        self._window = self._window or window
        if window is not self._window:
            return
        now = time.perf_counter()
        if self._recording is None and now - self._shown < _SHOWN_EVERY:
            return
        if self._readback is None:
            from domeshim.live.readback import Readback  # noqa: PLC0415 - numpy, for those who look alone

            self._readback = Readback(self._driver)
        picture = self._readback.read(window, now)
        if picture is not None:
            self._hand_on(picture)

    def window_closing(self, window: Window) -> None:
        """The window's context is about to go; it need not be current."""
        if window is not self._window:
            return
        current = self._session.window
        window.make_current()
        self._finish_reading()
        self._window = None
        if current is not None and current is not window:
            current.make_current()

    def toggle_recording(self) -> None:
        """Begin a film, or end it; says so, and where it is."""
        from domeshim.startup import say  # noqa: PLC0415 - which imports the session

        if self._recording is not None:
            self._finish_reading()
            self._end_recording()
            return
        try:
            from domeshim.live.recording import Recording  # noqa: PLC0415 - for those who record alone

            self._recording = Recording(self._next_file())
        except DomeError as error:
            say(str(error))
        else:
            say(f"recording to {self._recording.path}; Ctrl+Shift+R ends it")

    def close(self) -> None:
        """End the film and the virtual dome."""
        atexit.unregister(self.close)
        if self._window is not None and self._session.window is self._window and _has_context():
            self._finish_reading()
        self._end_recording()
        if self._board is not None:
            self._board.close()
            self._board = None

    def _next_file(self) -> Path:
        self._files += 1
        path = Path(self._options.record or f"domeshim-{datetime.now():%Y%m%d-%H%M%S}.mp4").absolute()
        asked_for = self._options.record is not None and self._files == 1
        return path if asked_for else unused(path)

    def _end_recording(self) -> None:
        from domeshim.startup import say  # noqa: PLC0415 - which imports the session

        recording, self._recording = self._recording, None
        if recording is None:
            return
        recording.close()
        if recording.error:
            say(f"{recording.path}: {recording.error}")
        elif recording.taken:
            lost = f"; {recording.dropped} dropped, for encoding was slower" if recording.dropped else ""
            say(f"{counted(recording.taken, 'picture')} recorded to {recording.path}{lost}")

    def _finish_reading(self) -> None:
        """Hand on what is still being read; the window must be current."""
        if self._readback is not None:
            for picture in self._readback.rest():
                self._hand_on(picture)

    def _hand_on(self, picture: Picture) -> None:
        if self._recording is not None:
            self._recording.add(picture)
        if self._board is None or picture.time - self._shown < _SHOWN_EVERY:
            return
        self._shown = picture.time
        if self._viewer is not None and self._viewer.poll() is not None:
            self._board.close()  # the user has closed it
            self._board = None
        else:
            self._board.put(picture.rgb)

    def _open_preview(self) -> None:
        from domeshim.live.shared import Board  # noqa: PLC0415 - numpy, for those who look alone
        from domeshim.preview.dome import dome_of  # noqa: PLC0415
        from domeshim.preview.viewer import Viewer  # noqa: PLC0415

        self._board = Board()
        dome = self._session.virtual_dome or dome_of(self._options)
        told = dome.to_json(), (self._session.viewer or Viewer()).to_json()
        here = self._board.name, str(os.getpid())
        command = [sys.executable, "-m", "domeshim.preview.beside", *here, *told]
        self._viewer = subprocess.Popen(command, env={**os.environ, "DOME": "0"})


def unused(path: Path) -> Path:
    """The path, or where a file is there already, the first of path-2, path-3 and so on where none is."""
    numbered = (path.with_stem(f"{path.stem}-{number}") for number in count(2))
    return next(free for free in chain([path], numbered) if not free.exists())


def _has_context() -> bool:
    """The window that the program's calls went to last is still there."""
    from OpenGL.platform import PLATFORM  # noqa: PLC0415 - the program may have set PyOpenGL's flags

    return bool(PLATFORM.GetCurrentContext())
