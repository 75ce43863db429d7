"""Images as textures: pixels of the monitor's window for other pixels to show."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from ctypes import c_uint

import numpy as np

from domeshim.draw.client_arrays import client_arrays
from domeshim.driver import Driver

_QUADS = 0x0007
_CELL, _MOST_CELLS = 24, 64
"""An image is cut into cells about so many pixels wide, and so many at most each way: the panel bends it."""
_TEXTURE_2D, _TEXTURE0 = 0x0DE1, 0x84C0
_MAG_FILTER, _MIN_FILTER, _WRAP_S, _WRAP_T = 0x2800, 0x2801, 0x2802, 0x2803
_NEAREST, _MIPMAPS, _TO_EDGE, _GENERATE_MIPMAP = 0x2600, 0x2703, 0x812F, 0x8191
_TEXTURE_ENV, _ENV_MODE, _REPLACE = 0x2300, 0x2200, 0x1E01
_TEXTURE_AND_ENABLE_BITS, _ENABLE_AND_COLOR_BUFFER_BITS, _T2F_V3F = 0x42000, 0x6000, 0x2A27
_OF_FRAGMENTS = (0x0B71, 0x0B90, 0x0BC0, 0x0BE2, 0x0BF2, 0x0B60, 0x8458)
"""The depth, stencil and alpha tests, blending, the logic operation, fog and the sum of colours."""


@contextmanager
def as_texture(driver: Driver, units: int, load: Callable[[], object]) -> Iterator[None]:
    """Within it an image is the only texture, of unit 0, and covers what it is drawn on.

    units: how many texture units the program uses; load: makes the image of the texture that is bound.
    """
    gl, name = driver, c_uint()
    gl.glPushAttrib(_TEXTURE_AND_ENABLE_BITS)
    for unit in reversed(range(units)):
        gl.glActiveTexture(_TEXTURE0 + unit)
        for target in gl.texture_targets:
            gl.glDisable(target)
    gl.glGenTextures(1, name)
    gl.glBindTexture(_TEXTURE_2D, name.value)
    settings = (
        (_MAG_FILTER, _NEAREST),
        (_MIN_FILTER, _MIPMAPS),
        (_WRAP_S, _TO_EDGE),
        (_WRAP_T, _TO_EDGE),
        (_GENERATE_MIPMAP, 1),
    )
    for setting, value in settings:
        gl.glTexParameteri(_TEXTURE_2D, setting, value)
    gl.glTexEnvi(_TEXTURE_ENV, _ENV_MODE, _REPLACE)
    try:
        load()
        gl.glEnable(_TEXTURE_2D)
        yield
    finally:
        gl.glDeleteTextures(1, name)
        gl.glPopAttrib()


def draw_over(driver: Driver, width: float, height: float) -> None:
    """Draw the same cells over whatever is there, as a copy of pixels does: no test and no blending."""
    driver.glPushAttrib(_ENABLE_AND_COLOR_BUFFER_BITS)
    for capability in _OF_FRAGMENTS:
        driver.glDisable(capability)
    driver.glColorMask(1, 1, 1, 1)
    draw_cells(driver, width, height)
    driver.glPopAttrib()


def draw_cells(driver: Driver, width: float, height: float) -> None:
    """Draw a rectangle from the origin to there in cells, with texture coordinates from 0 to 1."""
    across, up = (min(max(1, round(abs(size) / _CELL)), _MOST_CELLS) for size in (width, height))
    s, t = np.meshgrid(np.linspace(0, 1, across + 1), np.linspace(0, 1, up + 1))
    grid = np.stack([s, t, s * width, t * height, 0 * s], -1)
    corners = np.stack([grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]], 2)
    vertices = np.ascontiguousarray(corners.reshape(-1, 5), np.float32)
    gl = driver
    with client_arrays(gl):
        gl.glInterleavedArrays(_T2F_V3F, 0, vertices.ctypes.data)
        gl.glDrawArrays(_QUADS, 0, len(vertices))
