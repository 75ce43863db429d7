"""Which pixel of the frame shows each pixel of the program's window, and what is seen there."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from domeshim.state.pointer import Sight
from domeshim.window.frame import Rectangle


def middles(area: Rectangle) -> NDArray[np.float64]:
    """(height, width, 2): the middles of an area's pixels."""
    x, y, width, height = area
    return np.stack(np.meshgrid(x + 0.5 + np.arange(width), y + 0.5 + np.arange(height)), -1)


class Shown:
    """The pixels of the frame that show an area of the program's window."""

    def __init__(self, sight: Sight, places: NDArray[np.floating], *, bent: bool = True) -> None:
        """places: (height, width, 2) in the frame, one for each of the area's pixels; bent: on the dome."""
        self._sight = sight
        self._bent = bent
        self.pixels: NDArray[np.int64] = np.floor(places).astype(np.int64)
        """(height, width, 2)."""

    @cached_property
    def inside(self) -> NDArray[np.bool_]:
        """(height, width): which show anything; the n of them are meant below."""
        framed = ((self.pixels >= 0) & (self.pixels < self._sight.frame.size)).all(-1)
        if not self._bent:
            return np.asarray(framed)
        return framed & self._sight.within(self.pixels + 0.5)

    @cached_property
    def box(self) -> Rectangle:
        """Around them; there is at least one."""
        left, bottom = self.pixels[self.inside].min(0).tolist()
        right, top = self.pixels[self.inside].max(0).tolist()
        return left, bottom, right - left + 1, top - bottom + 1

    @cached_property
    def in_box(self) -> NDArray[np.int64]:
        """(n,): where they are in the box, counted row by row."""
        left, bottom, width, _ = self.box
        columns, rows = self.pixels[self.inside].T
        return np.asarray((rows - bottom) * width + columns - left)

    @cached_property
    def directions(self) -> NDArray[np.float64]:
        """(n, 3): what is seen there, unit vectors in the program's eye space."""
        return self._sight.directions_on_dome(self.pixels[self.inside] + 0.5)

    def monitor_depth(self, depths: NDArray[np.float64], which: NDArray[np.bool_]) -> NDArray[np.float64]:
        """What the monitor's depth buffer would hold, 0 to 1, where the dome's holds depths; (n,) which."""
        return self._sight.monitor_depth(depths, self.directions[which])
