"""Which pixels of the frame show the window that a program believes in."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from domeshim.state.pointer import Sight
from domeshim.window.frame import Rectangle

_STEPS = np.linspace(0, 1, 65)
_MARGIN = 2


@dataclass(frozen=True)
class Region:
    """A part of the frame."""

    box: Rectangle
    """Around it."""
    within: NDArray[np.bool_] | None = None
    """(height, width) of the box, the bottom row first; None: all of it."""


def region_of(sight: Sight, part: Rectangle) -> Region:
    """The pixels whose middle lies where the monitor shows this part of the program's window."""
    corner, size = np.array(part[:2]), np.array(part[2:])
    x, y, width, height = _around(sight, corner, size)
    middles = np.stack(np.meshgrid(x + 0.5 + np.arange(width), y + 0.5 + np.arange(height)), -1)
    places = sight.to_program(middles) - corner
    within = ((places >= 0) & (places < size)).all(-1) & sight.within(middles)
    return Region((x, y, width, height), within)


def _around(sight: Sight, corner: NDArray[np.int64], size: NDArray[np.int64]) -> Rectangle:
    """A box of the frame around the part's outline, a little larger."""
    sides = [np.stack([_STEPS, np.full_like(_STEPS, end)], -1) for end in (0, 1)]
    outline = corner + np.concatenate([*sides, *(side[:, ::-1] for side in sides)]) * size
    seen = sight.to_frame(outline)
    low = np.clip(np.floor(seen.min(0)) - _MARGIN, 0, sight.frame.size).astype(int)
    high = np.clip(np.ceil(seen.max(0)) + _MARGIN, 0, sight.frame.size).astype(int)
    return int(low[0]), int(low[1]), int(high[0] - low[0]), int(high[1] - low[1])
