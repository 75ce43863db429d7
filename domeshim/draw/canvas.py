"""What the dome's draws go onto: discs in the window itself, or what becomes the window's picture later."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Literal, Protocol

import numpy as np

from domeshim.driver import Driver
from domeshim.errors import ScreenError
from domeshim.lens.landing import Floats, Lens
from domeshim.lens.orientation import Orientation
from domeshim.lens.projection import direction_of, disc_of
from domeshim.lens.radial import RadialLens
from domeshim.options import Options
from domeshim.state.perspective import DepthTerms
from domeshim.state.views import View
from domeshim.window.frame import NO_QUAD, Frame

_STEREO, _BACK_LEFT, _BACK_RIGHT = 0x0C33, 0x0402, 0x0403


class Canvas(Protocol):
    """Where a window's pictures come into being; the window must be current in all calls."""

    kind: Literal["disc", "face"]
    """How the dome's programs bend onto it."""
    framebuffer: int | None
    """Draws go to this one of its own; None: to the window's."""
    views: tuple[View, ...]
    """Each draw is made once in every one of them."""

    def drawn(self, depth: DepthTerms) -> None:
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
    framebuffer: int | None = None

    def __init__(self, options: Options, frame: Frame, lens: Lens, orientation: Orientation) -> None:
        self._frame = frame
        self._lens = lens
        self._orientation = orientation
        self.views = tuple(_views(options, frame))

    def drawn(self, depth: DepthTerms) -> None:
        """Nothing: the window has it."""

    def settle(self, *, deep: bool = False, straight: bool = False) -> None:
        """Nothing: the window has it."""

    def clear(self, mask: int) -> None:
        """Nothing: the program's own clears the window."""

    def places(self, direction: Floats) -> list[tuple[float, float, float] | None]:
        """As for Canvas."""
        disc = disc_of(direction, self._lens, self._orientation)
        found = (self._frame.place_of(disc, view.viewport) for view in self.views)
        return [(float(x), float(y), 1.0) for x, y in found]

    def direction(self, x: float, y: float) -> tuple[Floats, float] | None:
        """As for Canvas."""
        for view in self.views:
            disc = self._frame.disc_of(np.array([x, y]), view.viewport)
            if self._lens.within(disc):
                return direction_of(disc, self._lens, self._orientation), 1.0
        return None

    def close(self) -> None:
        """Nothing."""


def _views(options: Options, frame: Frame) -> Iterator[View]:
    """The disc, or each eye's; an eye is told how far it stands to the right of the middle."""
    if options.stereo == "off":
        yield View(frame.square)
        return
    left, right = ((("domeEye", (side * options.eyes / 2,)),) for side in (-1, 1))
    match options.stereo:
        case "left" | "right":
            yield View(frame.square, uniforms=left if options.stereo == "left" else right)
        case "quad":
            yield View(frame.square, uniforms=left, buffer=_BACK_LEFT)
            yield View(frame.square, uniforms=right, buffer=_BACK_RIGHT)
        case _:
            for square, part, eye in zip(frame.squares, frame.parts, (left, right), strict=True):
                yield View(square, part, eye)


def canvas_of(
    driver: Driver,
    options: Options,
    frame: Frame,
    lens: Lens,
    orientation: Orientation,
    say: Callable[[str], None],
    window: Callable[[], int],
) -> Canvas:
    """The canvas that the method draws onto.

    say: tells the user; window: asks for the number of the window's framebuffer.

    Raises DriverError where this GL cannot have it, ScreenError where the window has not what it takes.
    """
    if not options.cubemap:
        if options.stereo == "quad" and not driver.integer(_STEREO):
            raise ScreenError(NO_QUAD)
        return DiscCanvas(options, frame, lens, orientation)
    assert isinstance(lens, RadialLens), "options.py takes no other screen with it"
    from domeshim.draw.cubemap import CubeCanvas  # noqa: PLC0415 - moderngl for this method alone

    return CubeCanvas(driver, options, frame, lens, orientation, say, window)
