"""The frame: the real picture in pixels, and the square in its middle that the disc fills."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from domeshim.options import Stereo

Rectangle = tuple[int, int, int, int]
"""x, y, width, height in pixels, the origin at the bottom left as in glViewport."""

NO_QUAD = (
    "DOME_STEREO=quad: no window with a buffer for each eye could be had; "
    "accepted here: left, right, top-bottom, left-right"
)
"""What to say where eyes shall have buffers of their own, and have not."""


@dataclass(frozen=True)
class Frame:
    """Where the disc lies in the real picture, and the window that the program believes in."""

    size: tuple[int, int]
    """Width and height of the real picture, pixels."""
    program_size: tuple[int, int]
    """Width and height of the program's window, in the program's own pixels."""
    inside: Rectangle | None = None
    """Where that window lies in the one around it, if there is one: its own place from the bottom left, and
    the outer window's width and height."""

    stereo: Stereo = "off"
    """How the eyes share the picture."""

    @property
    def outer(self) -> Rectangle:
        """The outermost window, in the pixels of the program's window."""
        x, y, width, height = self.inside or (0, 0, *self.program_size)
        return -x, -y, width, height

    @property
    def parts(self) -> tuple[Rectangle, ...]:
        """What each eye has of the picture, the left eye's first; one part where one eye has all of it."""
        width, height = self.size
        if self.stereo == "top-bottom":
            return (0, height - height // 2, width, height // 2), (0, 0, width, height // 2)
        if self.stereo == "left-right":
            return (0, 0, width // 2, height), (width - width // 2, 0, width // 2, height)
        return ((0, 0, width, height),)

    @property
    def squares(self) -> tuple[Rectangle, ...]:
        """The centre square of each part; a disc touches its sides."""
        return tuple(_centre_square(part) for part in self.parts)

    @property
    def square(self) -> Rectangle:
        """The centre square of the picture, or of the left eye's part."""
        return self.squares[0]

    def covers_most(self, viewport: Rectangle) -> bool:
        """It holds more than half of the outermost window: it is a main view, not an inset."""
        width, height = self.program_size
        x, y, w, h = viewport
        seen = max(0, min(x + w, width) - max(x, 0)) * max(0, min(y + h, height) - max(y, 0))
        return 2 * seen > self.outer[2] * self.outer[3]

    def flat(self, viewport: Rectangle, eye: int = 0) -> Rectangle:
        """The viewport's place where the program's window lies undistorted in an eye's centre square."""
        left, bottom, scale = self._flat(eye)
        x, y, w, h = viewport
        return round(left + scale * x), round(bottom + scale * y), round(scale * w), round(scale * h)

    def from_flat(self, x: float, y: float) -> tuple[float, float]:
        """The place in the program's window that lies there: flat's way back."""
        left, bottom, scale = self._flat(0)
        return (x - left) / scale, (y - bottom) / scale

    def _flat(self, eye: int) -> tuple[float, float, float]:
        """Where the program's window lies undistorted, x and y, and how large one of its pixels is there."""
        x0, y0, side, _ = self.squares[eye]
        x, y, width, height = self.outer
        scale = side / max(width, height)
        left, bottom = x0 + (side - scale * width) / 2, y0 + (side - scale * height) / 2
        return left - scale * x, bottom - scale * y, scale


def _centre_square(part: Rectangle) -> Rectangle:
    x, y, width, height = part
    side = min(width, height)
    return x + (width - side) // 2, y + (height - side) // 2, side, side
