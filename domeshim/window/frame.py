"""The frame: the real picture in pixels, and the square in its middle that the disc fills."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from domeshim.lens.keystone import WHOLE, Keystone, keystone_of

if TYPE_CHECKING:
    from domeshim.options import Options
    from domeshim.settings import Stereo

Floats = NDArray[np.float64]
Rectangle = tuple[int, int, int, int]
"""x, y, width, height in pixels, the origin at the bottom left as in glViewport."""

_STEPS = 256
"""Of a pixel: what drivers round a vertex's place to."""
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
    disc: tuple[float, float, float] | None = None
    """The disc's centre from the top left, and its radius, pixels; None: the largest, in the middle. For eyes
    that share the picture, in the part of each."""
    keystone: Keystone | None = None
    """Where the corners of the disc's square go, if not to the square's own."""
    aside: bool = False
    """What is drawn flat lies beside the disc, not over it."""
    whole: bool = False
    """There is no disc: the picture fills each part, as on a cylindrical screen."""
    asked: tuple[int, int] | None = None
    """The window's size that the program asked for, where the user's choice stands instead."""
    on_grid: bool = False
    """Vertices are brought onto the driver's own steps within a pixel: tiles are then what the whole is."""

    @classmethod
    def of(
        cls,
        options: Options,
        size: tuple[int, int],
        program_size: tuple[int, int],
        inside: Rectangle | None = None,
    ) -> Frame:
        """The frame that the options ask for; the others as for the fields."""
        return cls(
            size,
            program_size,
            inside,
            options.stereo,
            options.disc,
            keystone_of(options),
            aside=options.hud == "side",
            whole=options.surface[0] == "cylinder",
        )

    def cut(self, part: Rectangle, viewport: int) -> Frame:
        """The frame of a part of this one, in which all stands where it stands here.

        viewport: the most pixels a side that GL draws to at once. The disc's square may be larger: then only
        what of it is around the part is drawn to, and the keystone takes the square beyond that.
        """
        left, bottom, side, _ = self.square
        x, y, width, height = part
        drawn = min(side, viewport)
        right, up = (
            min(max(middle - drawn // 2, 0), side - drawn)
            for middle in (x - left + width // 2, y - bottom + height // 2)
        )
        keystone = self.keystone
        if drawn < side:
            corners = np.reshape(keystone.corners if keystone else WHOLE, (4, 2))
            keystone = Keystone(tuple(((corners * side - (right, up)) / drawn).ravel().tolist()))
        radius = drawn / 2
        disc = left + right + radius - x, height - (bottom + up + radius - y), radius
        return replace(self, size=(width, height), disc=disc, keystone=keystone)

    @property
    def uniforms(self) -> list[tuple[str, tuple[float, ...]]]:
        """What the dome's programs are told of it."""
        found: list[tuple[str, tuple[float, ...]]] = []
        if self.keystone is not None:
            found.append(("domeKeystone", self.keystone.uniform))
        if self.on_grid:
            _, _, width, height = self.square
            found.append(("domeGrid", (width / 2 * _STEPS, height / 2 * _STEPS)))
        return found

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
        """Of each part the rectangle whose sides a picture touches: the centre square, unless told so."""
        return tuple(self._square_in(part) for part in self.parts)

    @property
    def square(self) -> Rectangle:
        """The square of the picture's disc, or of the left eye's."""
        return self.squares[0]

    def _square_in(self, part: Rectangle) -> Rectangle:
        left, bottom, width, height = part
        if self.whole:
            return part
        if self.disc is None:
            side = min(width, height)
            return left + (width - side) // 2, bottom + (height - side) // 2, side, side
        x, y, radius = self.disc
        side = round(2 * radius)
        return round(left + x - radius), round(bottom + height - y - radius), side, side

    def place_of(self, disc: Floats, square: Rectangle | None = None) -> Floats:
        """(..., 2) on the disc, 1 at the square's sides -> (..., 2) pixels; square: of one eye's disc."""
        x, y, width, height = square or self.square
        placed = disc if self.keystone is None else self.keystone.to_frame(disc)
        found: Floats = (placed + 1) * (width / 2, height / 2) + (x, y)
        return found

    def disc_of(self, places: NDArray[np.floating], square: Rectangle | None = None) -> Floats:
        """(..., 2) pixels -> (..., 2) on the disc; square: of one eye's disc."""
        x, y, width, height = square or self.square
        found: Floats = (np.asarray(places, float) - (x, y)) * (2 / width, 2 / height) - 1
        return found if self.keystone is None else self.keystone.to_disc(found)

    def covers_most(self, viewport: Rectangle) -> bool:
        """It holds more than half of the outermost window: it is a main view, not an inset.

        So is one that would have filled the window that the program asked for.
        """
        if self.fills_asked(viewport):
            return True
        width, height = self.program_size
        x, y, w, h = viewport
        seen = max(0, min(x + w, width) - max(x, 0)) * max(0, min(y + h, height) - max(y, 0))
        return 2 * seen > self.outer[2] * self.outer[3]

    def fills_asked(self, viewport: Rectangle) -> bool:
        """It is just the window that the program asked for, and was not given."""
        return self.asked is not None and viewport == (0, 0, *self.asked)

    def flat(self, viewport: Rectangle, eye: int = 0) -> Rectangle:
        """The viewport's place where the program's window lies undistorted in an eye's centre square."""
        left, bottom, scale = self._flat(eye)
        x, y, w, h = viewport
        return round(left + scale * x), round(bottom + scale * y), round(scale * w), round(scale * h)

    def to_flat(self, places: Floats) -> Floats:
        """(..., 2) pixels of the program's window -> where flat shows them to the first eye."""
        left, bottom, scale = self._flat(0)
        found: Floats = scale * places + (left, bottom)
        return found

    def from_flat(self, x: float, y: float) -> tuple[float, float]:
        """The place in the program's window that lies there: flat's way back."""
        left, bottom, scale = self._flat(0)
        return (x - left) / scale, (y - bottom) / scale

    def _flat(self, eye: int) -> tuple[float, float, float]:
        """Where the program's window lies undistorted, x and y, and how large one of its pixels is there."""
        x0, y0, across, high = self.strip(eye) if self.aside else self.squares[eye]
        x, y, width, height = self.outer
        scale = min(across / width, high / height)
        left, bottom = x0 + (across - scale * width) / 2, y0 + (high - scale * height) / 2
        return left - scale * x, bottom - scale * y, scale

    def strip(self, eye: int = 0) -> Rectangle:
        """The largest strip of an eye's part beside its disc's square, the left one of two alike."""
        (left, bottom, width, height), (x, y, side, high) = self.parts[eye], self.squares[eye]
        right, top = left + width - x - side, bottom + height - y - high
        strips = [
            (left, bottom, max(x - left, 0), height),
            (x + side, bottom, max(right, 0), height),
            (left, bottom, width, max(y - bottom, 0)),
            (left, y + high, width, max(top, 0)),
        ]
        return max(strips, key=lambda strip: strip[2] * strip[3])
