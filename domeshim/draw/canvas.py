"""What the dome's draws go onto: discs in the window itself, or what becomes the window's picture later."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal, Protocol

import numpy as np

from domeshim.driver import Driver
from domeshim.lens.models import Floats, Lens
from domeshim.lens.orientation import Orientation
from domeshim.lens.projection import direction_of, disc_of
from domeshim.options import Options
from domeshim.state.views import View
from domeshim.window.frame import Frame

Depth = tuple[float, float]
"""The uniform domeDepth of a placement."""


class Canvas(Protocol):
    """Where a window's pictures come into being; the window must be current in all calls."""

    kind: Literal["disc", "face"]
    """How the dome's programs bend onto it."""
    framebuffer: int
    """Draws go to this one; 0: the window."""
    views: tuple[View, ...]
    """Each draw is made once in every one of them."""

    def drawn(self, depth: Depth) -> None:
        """Something is about to be drawn onto it by this domeDepth; (0, 0) on the panel."""

    def settle(self, *, deep: bool = False, straight: bool = False) -> None:
        """Let the window show what was drawn so far; the context must be undressed.

        deep: its depths as well; straight: the window itself is about to be drawn to.
        """

    def clear(self, mask: int) -> None:
        """Make a glClear of the program's on what is no part of the window."""

    def places(self, direction: Floats) -> list[tuple[float, float, float] | None]:
        """For each view x and y in pixels where a direction (3,) of eye space is seen, or None.

        The third number is what its distance counts for in depth: its share ahead.
        """

    def direction(self, x: float, y: float) -> tuple[Floats, float] | None:
        """The unit direction (3,) seen at a place of the framebuffer, and its share ahead; or None."""

    def close(self) -> None:
        """Free what it holds of GL."""


class DiscCanvas:
    """The window: a disc for each eye."""

    kind: Literal["disc", "face"] = "disc"
    framebuffer = 0

    def __init__(self, frame: Frame, lens: Lens, orientation: Orientation, rim: float) -> None:
        """rim: where the picture ends on the disc, 1 the inscribed circle."""
        self._lens = lens
        self._rim = rim
        self._orientation = orientation
        self.views: tuple[View, ...] = (View(frame.square),)

    def drawn(self, depth: Depth) -> None:
        """Nothing: the window has it."""

    def settle(self, *, deep: bool = False, straight: bool = False) -> None:
        """Nothing: the window has it."""

    def clear(self, mask: int) -> None:
        """Nothing: the program's own clears the window."""

    def places(self, direction: Floats) -> list[tuple[float, float, float] | None]:
        """As for Canvas."""
        x, y = (disc_of(direction, self._lens, self._orientation) + 1) / 2
        boxes = (view.viewport for view in self.views)
        return [(float(left + x * w), float(bottom + y * h), 1.0) for left, bottom, w, h in boxes]

    def direction(self, x: float, y: float) -> tuple[Floats, float] | None:
        """As for Canvas."""
        for left, bottom, w, h in (view.viewport for view in self.views):
            disc = np.array([2 * (x - left) / w - 1, 2 * (y - bottom) / h - 1])
            if np.hypot(*disc) < self._rim:
                return direction_of(disc, self._lens, self._orientation), 1.0
        return None

    def close(self) -> None:
        """Nothing."""


def canvas_of(
    driver: Driver,
    options: Options,
    frame: Frame,
    lens: Lens,
    orientation: Orientation,
    rim: float,
    say: Callable[[str], None],
) -> Canvas:
    """The canvas that the method draws onto; rim: where the picture ends on the disc; say: tells the user.

    Raises DriverError where this GL cannot have it.
    """
    if not options.cubemap:
        return DiscCanvas(frame, lens, orientation, rim)
    from domeshim.draw.cubemap import CubeCanvas  # noqa: PLC0415 - moderngl for this method alone

    return CubeCanvas(driver, options, frame, lens, orientation, rim, say)
