"""How far a picture's colours are from what rays say, pixel by pixel."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from domeshim.bench.edge_error import INNER
from domeshim.bench.meshes import Floats
from domeshim.lens.landing import Lens
from domeshim.lens.projection import direction_of


def true_picture(look: Callable[[Floats], Floats], lens: Lens, size: int) -> Floats:
    """(size, size, 3), 0 to 255, the top row first: what rays through the pixels' middles meet.

    look: (..., 3) directions -> (..., 3) colours, 0 to 1. nan where the disc is not looked at.
    """
    across = (2 * np.arange(size) + 1 - size) / size
    places = np.stack(np.meshgrid(across, -across), -1)
    seen = np.hypot(*np.moveaxis(places, -1, 0)) <= INNER
    picture = np.full((size, size, 3), np.nan)
    picture[seen] = 255 * look(direction_of(places[seen], lens))
    return picture


def colour_rms(picture: NDArray[np.uint8], true: Floats) -> float:
    """Root of the mean square of what all channels of the disc's pixels are off, of 255."""
    off = picture.astype(float) - true
    return float(np.sqrt(np.nanmean(off**2)))
