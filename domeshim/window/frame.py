"""The frame: the real picture in pixels, and the square in its middle that the disc fills."""

from __future__ import annotations

from dataclasses import dataclass

Rectangle = tuple[int, int, int, int]
"""x, y, width, height in pixels, the origin at the bottom left as in glViewport."""


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

    @property
    def outer(self) -> Rectangle:
        """The outermost window, in the pixels of the program's window."""
        x, y, width, height = self.inside or (0, 0, *self.program_size)
        return -x, -y, width, height

    @property
    def square(self) -> Rectangle:
        """The centre square; the disc touches its sides."""
        width, height = self.size
        side = min(width, height)
        return (width - side) // 2, (height - side) // 2, side, side

    def covers_most(self, viewport: Rectangle) -> bool:
        """It holds more than half of the outermost window: it is a main view, not an inset."""
        width, height = self.program_size
        x, y, w, h = viewport
        seen = max(0, min(x + w, width) - max(x, 0)) * max(0, min(y + h, height) - max(y, 0))
        return 2 * seen > self.outer[2] * self.outer[3]

    def flat(self, viewport: Rectangle) -> Rectangle:
        """The viewport's place where the program's window lies undistorted in the centre square."""
        left, bottom, scale = self._flat
        x, y, w, h = viewport
        return round(left + scale * x), round(bottom + scale * y), round(scale * w), round(scale * h)

    def from_flat(self, x: float, y: float) -> tuple[float, float]:
        """The place in the program's window that lies there: flat's way back."""
        left, bottom, scale = self._flat
        return (x - left) / scale, (y - bottom) / scale

    @property
    def _flat(self) -> tuple[float, float, float]:
        """Where the program's window lies undistorted, x and y, and how large one of its pixels is there."""
        x0, y0, side, _ = self.square
        x, y, width, height = self.outer
        scale = side / max(width, height)
        left, bottom = x0 + (side - scale * width) / 2, y0 + (side - scale * height) / 2
        return left - scale * x, bottom - scale * y, scale
