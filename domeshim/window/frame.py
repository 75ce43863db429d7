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

    @property
    def square(self) -> Rectangle:
        """The centre square; the disc touches its sides."""
        width, height = self.size
        side = min(width, height)
        return (width - side) // 2, (height - side) // 2, side, side

    def covers_most(self, viewport: Rectangle) -> bool:
        """More than half of the program's window lies in this viewport: it is a main view, not an inset."""
        width, height = self.program_size
        x, y, w, h = viewport
        seen = max(0, min(x + w, width) - max(x, 0)) * max(0, min(y + h, height) - max(y, 0))
        return 2 * seen > width * height

    def flat(self, viewport: Rectangle) -> Rectangle:
        """The viewport's place where the program's window lies undistorted in the centre square."""
        x0, y0, side, _ = self.square
        scale = side / max(self.program_size)
        width, height = self.program_size
        left, bottom = x0 + (side - scale * width) / 2, y0 + (side - scale * height) / 2
        x, y, w, h = viewport
        return round(left + scale * x), round(bottom + scale * y), round(scale * w), round(scale * h)
