"""Whom the session speaks to: the dome, what joins windows' pictures, and who hears of each picture."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Sequence
    from contextlib import AbstractContextManager

    from domeshim.draw.shape import Shape
    from domeshim.record.bitmaps import Bitmap
    from domeshim.state.region import Region
    from domeshim.window.contract import Window
    from domeshim.window.frame import Rectangle


class Dome(Protocol):
    """What the intercepted GL offers to the session while the dome is on."""

    def window_opened(self, window: Window, program_size: tuple[int, int]) -> None:
        """A window's context was made and is current."""

    def window_current(self, window: Window | None) -> None:
        """The program's GL calls go to this window from now on."""

    def window_resized(self, window: Window, program_size: tuple[int, int]) -> None:
        """The program's window has this size now, in the program's own pixels."""

    def window_closed(self, window: Window) -> None:
        """The window's context is about to go."""

    def program_place(self, window: Window, x: float, y: float) -> tuple[float, float]:
        """Where the program would see a place of the frame in its window; pixels, origin at the top left."""

    def frame_place(self, window: Window, x: float, y: float) -> tuple[float, float]:
        """Where a place of the program's window is in the frame; pixels, origin at the top left."""

    def fills(self, window: Window) -> bool:
        """A window that lies inside another is a main view, which fills the dome."""

    def region(self, window: Window, part: Rectangle) -> Region | None:
        """Which pixels of the frame show this part of a window that lies inside another; None: none do."""

    def straight(self, window: Window) -> AbstractContextManager[None]:
        """Within it, draws into the window are left as on the monitor; it must be current."""

    def flush(self) -> None:
        """Let GL see what has been recorded."""

    def pass_by(self, on: bool) -> None:
        """Nobody looks at what comes now: leave all draws out, or make them again."""

    def draw_shape(self, shape: Shape) -> bool:
        """Draw a shape that is in memory; False where it cannot be drawn now."""

    def write(self, bitmaps: Sequence[Bitmap]) -> bool:
        """Draw bitmaps one after the other; False where the caller must do it by glBitmap."""

    def selects(self, window: Window) -> bool:
        """The window's draws select or give feedback: they make no picture."""

    def frame_ending(self, window: Window) -> None:
        """The picture is complete: what must still be drawn over it is drawn now."""

    def showing(self, window: Window) -> None:
        """The window's back buffer is about to be seen: make of it what the projector needs."""

    def toggle_card(self, window: Window) -> bool:
        """Show the test card over the window's pictures, or no longer; False for a window left as it is."""


class Parts(Protocol):
    """Makes one picture of several windows'."""

    def keep(self, window: Window) -> bool:
        """Keep a finished picture, whose window is current; False where it is a whole one."""

    def round_ended(self) -> None:
        """Show what has come together."""


class FrameListener(Protocol):
    """Hears of each finished picture, before it is shown."""

    def frame_finished(self, window: Window, number: int) -> None:
        """Picture number (1 the first) stands complete in the window's back buffer."""
