"""A window inside another: a surface that nobody sees, laid into the outermost window's picture."""

from __future__ import annotations

from dataclasses import replace

from domeshim.window.contract import SurfaceFormat, Window, WindowEvents
from domeshim.window.frame import Rectangle


class SubWindow(Window):
    """Draws on a hidden window; sizes and places are the program's own pixels.

    On the monitor the hidden window is as large as this one; on the dome it is as large as the outermost
    window's frame, and this one's drawings lie where they are seen there.
    """

    def __init__(
        self,
        surface: Window,
        outermost: Window,
        events: WindowEvents,
        asked: SurfaceFormat,
        *,
        on_dome: bool,
    ) -> None:
        """surface: the hidden window, which nothing else uses; asked: what the program wants of it."""
        self.surface = surface
        self.part = surface.part
        self.outermost = outermost
        self.format = replace(surface.format, double_buffer=asked.double_buffer)
        self.events = events
        self.place = (0, 0)
        """The top left corner in the window around it."""
        self.inside: Rectangle = (0, 0, *outermost.size)
        """The place in the outermost window, from its bottom left, and that window's size."""
        self._on_dome = on_dome

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the hidden window in pixels."""
        return self.surface.size

    @property
    def position(self) -> tuple[int, int]:
        """The top left corner in the window around it."""
        return self.place

    def make_current(self) -> None:
        """Direct the GL calls of this thread to the hidden window."""
        self.surface.make_current()

    def swap_buffers(self) -> None:
        """Do nothing: the outermost window shows the picture."""

    def resize(self, width: int, height: int) -> None:
        """Draw into a hidden window of that size, unless it is the dome's; the program is told either way.

        It must be current.
        """
        if not self._on_dome:
            self._fit((width, height))
        self.events.resized(width, height)

    def frame_resized(self) -> None:
        """Follow the outermost window's size, on the dome; the hidden one must be current."""
        if self._on_dome:
            self._fit(self.outermost.size)

    def _fit(self, size: tuple[int, int]) -> None:
        if size != self.surface.size:
            self.surface.resize(*size)
            self.surface.swap_buffers()  # some drivers make the buffers of the new size then

    def move(self, x: int, y: int) -> None:
        """Put the top left corner at (x, y) of the window around it."""
        self.place = (x, y)
        self.events.moved(x, y)

    def set_title(self, title: str) -> None:
        """Do nothing: there is no title bar."""

    def set_visible(self, visible: bool) -> None:
        """Tell of it; the outermost window's next picture is made accordingly."""
        self.events.visibility_changed(visible)

    def iconify(self) -> None:
        """Do nothing: it has no icon of its own."""

    def set_full_screen(self, full: bool, display: int = 0) -> None:
        """Do nothing: it stays inside its window."""

    def set_cursor(self, shape: str) -> None:
        """Show it while the pointer is inside."""
        self.outermost.set_cursor(shape)

    def warp_pointer(self, x: float, y: float) -> None:
        """Put the pointer at (x, y): of the frame on the dome, else of this window."""
        if not self._on_dome:
            left, bottom, _, height = self.inside
            x, y = left + x, height - bottom - self.size[1] + y
        self.outermost.warp_pointer(x, y)

    def close(self) -> None:
        """Destroy the hidden window and its context; safe to call twice."""
        self.surface.close()
