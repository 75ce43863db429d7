"""A picture from memory into the window."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.over import way_cleared
from domeshim.draw.transfer import plain_transfer
from domeshim.driver import Driver

_RGB, _UNSIGNED_BYTE = 0x1907, 0x1401


def paste(gl: Driver, picture: NDArray[np.uint8], corner: tuple[int, int] = (0, 0)) -> None:
    """Draw a picture over what is bound for drawing; (height, width, 3), the top row first.

    corner: where its lower left one goes, pixels from the lower left.
    """
    upright = np.ascontiguousarray(picture[::-1])
    with way_cleared(gl), plain_transfer(gl):
        gl.glColorMask(1, 1, 1, 1)
        gl.glPixelZoom(1.0, 1.0)
        gl.glWindowPos3f(*corner, 0.0)
        gl.glDrawPixels(upright.shape[1], upright.shape[0], _RGB, _UNSIGNED_BYTE, upright.ctypes.data)
