"""Stock GL and domes of any settings side by side in one process, each with a window off screen."""

from __future__ import annotations

import time
from collections.abc import Callable
from types import SimpleNamespace

import OpenGL.GL
import OpenGL.GLU

from domeshim.bench.results import Seconds
from domeshim.intercept.overlay import Overlay
from domeshim.measure.pixels import read_pixels
from domeshim.options import Options
from domeshim.session import Session
from domeshim.window.contract import SurfaceFormat, Window, WindowEvents
from domeshim.window.offscreen import OffscreenBackend

GL = SimpleNamespace


class Player:
    """One GL and its window."""

    def __init__(self, gl: GL, window: Window, session: Session | None) -> None:
        self.gl = gl
        self.window = window
        self._session = session

    def show(self, draw: Callable[[], object]) -> None:
        """Make a picture by draw(), all of it, and wait until it is there."""
        if self._session is None:
            draw()
            self.window.swap_buffers()
        else:
            draw()
            self._session.swapped(self.window)
        OpenGL.GL.glFinish()

    def timed(self, draw: Callable[[], object]) -> Seconds:
        """Make a picture and say what it took."""
        self.window.make_current()
        wall, processor = time.perf_counter(), time.process_time()
        self.show(draw)
        return Seconds(time.perf_counter() - wall, time.process_time() - processor)

    def pixels(self) -> bytes:
        """The picture's RGB, the top row first."""
        return read_pixels(*self.window.size)


class Stage:
    """Where the players are; close it to free all of them."""

    def __init__(self, size: int) -> None:
        """size: of every window, pixels each way. Raises ScreenError where there is no off-screen GL."""
        self._backend = OffscreenBackend()
        self._size = size

    def close(self) -> None:
        """Close all windows."""
        self._backend.close()

    def stock(self) -> Player:
        """PyOpenGL as it is, its window current."""
        return Player(_names(), self._window(), None)

    def dome(self, options: Options) -> Player:
        """A dome of its own with these options, its window current."""
        session = Session(options, backend=lambda: self._backend)
        overlay = Overlay(session)
        overlay.module_imported("OpenGL.GL", OpenGL.GL)
        overlay.module_imported("OpenGL.GLU", OpenGL.GLU)
        gl = _names()
        overlay.remove()
        window = self._window()
        session.window_opened(window, window.size)
        return Player(gl, window, session)

    def _window(self) -> Window:
        size = (self._size, self._size)
        return self._backend.open_window("bench", size, None, SurfaceFormat(), WindowEvents())


def _names() -> GL:
    return GL(**vars(OpenGL.GL), gluPerspective=OpenGL.GLU.gluPerspective)
