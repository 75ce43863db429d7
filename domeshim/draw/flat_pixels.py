"""Bitmaps as rectangles, images as textures: pixels of the monitor's window for other pixels to show."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from ctypes import c_uint
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.client_arrays import client_arrays
from domeshim.driver import Driver

Floats = NDArray[np.floating]

_QUADS, _COMPILE = 0x0007, 0x1300
_MOST = 4096
"""So many bitmaps are remembered."""
_CELL, _MOST_CELLS = 24, 64
"""An image is cut into cells about so many pixels wide, and so many at most each way: the panel bends it."""
_LSB_FIRST, _ROW_LENGTH, _SKIP_ROWS, _SKIP_PIXELS, _ALIGNMENT = 0x0CF1, 0x0CF2, 0x0CF3, 0x0CF4, 0x0CF5
_UNPACK_BUFFER_BINDING = 0x88EF
_TEXTURE_2D, _TEXTURE0 = 0x0DE1, 0x84C0
_MAG_FILTER, _MIN_FILTER, _WRAP_S, _WRAP_T = 0x2800, 0x2801, 0x2802, 0x2803
_NEAREST, _MIPMAPS, _TO_EDGE, _GENERATE_MIPMAP = 0x2600, 0x2703, 0x812F, 0x8191
_TEXTURE_ENV, _ENV_MODE, _REPLACE = 0x2300, 0x2200, 0x1E01
_TEXTURE_AND_ENABLE_BITS, _T2F_V3F = 0x42000, 0x2A27


@dataclass(frozen=True)
class Bitmap:
    """What one glBitmap draws."""

    width: int
    height: int
    origin: tuple[float, float]
    move: tuple[float, float]
    pixels: bytes
    """One byte a pixel, row after row, the lowest first; not 0 where it is drawn."""

    @classmethod
    def read(
        cls, driver: Driver, width: int, height: int, numbers: tuple[float, ...], bits: object
    ) -> Bitmap:
        """From glBitmap's own arguments, unpacked as GL is told to. numbers: xorig, yorig, xmove, ymove.

        Raises ValueError where the bits are not to be had here, say in a buffer object's memory.
        """
        x, y, dx, dy = numbers
        pixels = b"" if bits is None else _unpacked(driver, int(width), int(height), bits)
        return cls(int(width), int(height), (x, y), (dx, dy), pixels)

    @cached_property
    def shows(self) -> bool:
        """Some pixel is drawn."""
        return any(self.pixels)

    def rectangles(self) -> Floats:
        """(n, 4): left, bottom, right, top of each row of neighbours that are drawn."""
        grid = np.frombuffer(self.pixels, np.uint8).reshape(-1, self.width or 1) != 0
        steps = np.diff(np.pad(grid, ((0, 0), (1, 1))).astype(np.int8), axis=1)
        rows, left = np.nonzero(steps == 1)
        _, right = np.nonzero(steps == -1)
        return np.stack([left, rows, right, rows + 1], -1).astype(float)


def _unpacked(driver: Driver, width: int, height: int, bits: object) -> bytes:
    if driver.has("glBindBuffer") and driver.integer(_UNPACK_BUFFER_BINDING):
        raise ValueError("a buffer object has the bits")
    data = np.frombuffer(bits, np.uint8) if isinstance(bits, bytes | bytearray) else np.asarray(bits)
    if data.dtype.kind not in "iu":
        raise ValueError("no bits that can be read")
    alignment, row_length = driver.integer(_ALIGNMENT), driver.integer(_ROW_LENGTH) or width
    stride = -(-((row_length + 7) // 8) // alignment) * alignment
    skip = driver.integer(_SKIP_ROWS)
    rows = np.zeros((height + skip) * stride, np.uint8)
    given = data.astype(np.uint8).ravel()[: rows.size]
    rows[: given.size] = given
    order: Literal["little", "big"] = "little" if driver.integer(_LSB_FIRST) else "big"
    grid = np.unpackbits(rows.reshape(-1, stride)[skip:], axis=1, bitorder=order)
    first = driver.integer(_SKIP_PIXELS)
    return bytes(grid[:, first : first + width].tobytes())


class Glyphs:
    """Bitmaps compiled into display lists, a unit a pixel, the lower left corner at the origin."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._names: dict[tuple[int, bytes], int] = {}

    def draw(self, placed: Sequence[tuple[int, int, Bitmap]]) -> None:
        """Draw the rectangles of bitmaps, their lower left corners at these places; MODELVIEW moves along."""
        gl, x, y = self._driver, 0, 0
        for left, bottom, bitmap in placed:
            gl.glTranslatef(left - x, bottom - y, 0.0)
            x, y = left, bottom
            gl.glCallList(self._name(bitmap))

    def _name(self, bitmap: Bitmap) -> int:
        key = bitmap.width, bitmap.pixels
        if key not in self._names:
            if len(self._names) >= _MOST:
                for name in self._names.values():
                    self._driver.glDeleteLists(name, 1)
                self._names.clear()
            self._names[key] = self._compiled(bitmap)
        return self._names[key]

    def _compiled(self, bitmap: Bitmap) -> int:
        gl = self._driver
        name = int(gl.glGenLists(1))
        gl.glNewList(name, _COMPILE)
        gl.glBegin(_QUADS)
        for left, bottom, right, top in bitmap.rectangles().tolist():
            for x, y in ((left, bottom), (right, bottom), (right, top), (left, top)):
                gl.glVertex3f(x, y, 0.0)
        gl.glEnd()
        gl.glEndList()
        return name


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
