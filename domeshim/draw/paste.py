"""A picture from memory into the window."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.over import way_cleared
from domeshim.draw.transfer import plain_transfer
from domeshim.driver import Driver

_RGB, _UNSIGNED_BYTE = 0x1907, 0x1401
_DRAW_FRAMEBUFFER, _DRAW_FRAMEBUFFER_BINDING = 0x8CA9, 0x8CA6


def paste(gl: Driver, picture: NDArray[np.uint8], corner: tuple[int, int] = (0, 0)) -> None:
    """Draw a picture over the current window; (height, width, 3), the top row first.

    corner: where its lower left one goes, pixels from the window's.
    """
    upright = np.ascontiguousarray(picture[::-1])
    framebuffer = gl.integer(_DRAW_FRAMEBUFFER_BINDING) if gl.has("glBindFramebuffer") else 0
    if framebuffer:
        gl.glBindFramebuffer(_DRAW_FRAMEBUFFER, 0)
    with way_cleared(gl), plain_transfer(gl):
        gl.glColorMask(1, 1, 1, 1)
        gl.glPixelZoom(1.0, 1.0)
        gl.glWindowPos3f(*corner, 0.0)
        gl.glDrawPixels(upright.shape[1], upright.shape[0], _RGB, _UNSIGNED_BYTE, upright.ctypes.data)
    if framebuffer:
        gl.glBindFramebuffer(_DRAW_FRAMEBUFFER, framebuffer)
