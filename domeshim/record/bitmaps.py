"""Bitmaps, as glBitmap and GLUT's fonts draw them: read when they are given, drawn a run at a time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from domeshim.driver import Driver

_LSB_FIRST, _ROW_LENGTH, _SKIP_ROWS, _SKIP_PIXELS, _ALIGNMENT = 0x0CF1, 0x0CF2, 0x0CF3, 0x0CF4, 0x0CF5
_UNPACK_BUFFER_BINDING = 0x88EF
_MOST = 4096
"""So many bitmaps are remembered by their bits."""

Numbers = tuple[float, ...]


@dataclass(frozen=True, eq=False)
class Bitmap:
    """What one glBitmap draws."""

    width: int
    height: int
    origin: tuple[float, float]
    move: tuple[float, float]
    pixels: bytes
    """One byte a pixel, row after row, the lowest first; 1 where it is drawn, else 0."""

    @cached_property
    def shows(self) -> bool:
        """Some pixel is drawn."""
        return any(self.pixels)

    def rectangles(self) -> NDArray[np.floating]:
        """(n, 4): left, bottom, right, top of each row of neighbours that are drawn."""
        steps = np.diff(np.pad(self._grid, ((0, 0), (1, 1))).astype(np.int8), axis=1)
        rows, left = np.nonzero(steps == 1)
        _, right = np.nonzero(steps == -1)
        return np.stack([left, rows, right, rows + 1], -1).astype(float)

    @cached_property
    def rows(self) -> bytes | None:
        """The pixels as glBitmap takes them, tightly packed; None where there are none."""
        return None if not self.pixels else np.packbits(self._grid, axis=1).tobytes()

    @property
    def _grid(self) -> NDArray[np.bool_]:
        drawn: NDArray[np.bool_] = np.frombuffer(self.pixels, np.bool_).reshape(-1, self.width or 1)
        return drawn


class Unpacking(NamedTuple):
    """How GL is told to read bits in memory."""

    lsb_first: int
    row_length: int
    skip_rows: int
    skip_pixels: int
    alignment: int

    @classmethod
    def asked(cls, driver: Driver) -> Unpacking | None:
        """As it is now; None where GL reads from a buffer object instead."""
        if driver.has("glBindBuffer") and driver.integer(_UNPACK_BUFFER_BINDING):
            return None
        names = (_LSB_FIRST, _ROW_LENGTH, _SKIP_ROWS, _SKIP_PIXELS, _ALIGNMENT)
        return cls(*map(driver.integer, names))


def read_bitmap(
    width: int, height: int, numbers: Numbers, bits: object, unpacking: Unpacking
) -> Bitmap | None:
    """A bitmap from glBitmap's own arguments; None where they are not to be understood here.

    numbers: xorig, yorig, xmove, ymove.
    """
    if bits is None or isinstance(bits, bytes):
        content = bits
    else:
        data = np.asarray(bits)
        if data.dtype.kind not in "iu":
            return None
        content = data.astype(np.uint8).tobytes()
    if int(width) < 0 or int(height) < 0:
        return None
    return _unpacked(int(width), int(height), numbers, content, unpacking)


@lru_cache(maxsize=_MOST)
def _unpacked(width: int, height: int, numbers: Numbers, bits: bytes | None, unpacking: Unpacking) -> Bitmap:
    x, y, dx, dy = map(float, numbers)
    pixels = b"" if bits is None else _pixels(width, height, bits, unpacking)
    return Bitmap(width, height, (x, y), (dx, dy), pixels)


def _pixels(width: int, height: int, bits: bytes, unpacking: Unpacking) -> bytes:
    lsb_first, row_length, skip_rows, skip_pixels, alignment = unpacking
    stride = -(-(((row_length or width) + 7) // 8) // alignment) * alignment
    rows = np.zeros((height + skip_rows) * stride, np.uint8)
    given = np.frombuffer(bits, np.uint8)[: rows.size]
    rows[: given.size] = given
    order: Literal["little", "big"] = "little" if lsb_first else "big"
    grid = np.unpackbits(rows.reshape(height + skip_rows, stride)[skip_rows:], axis=1, bitorder=order)
    return bytes(grid[:, skip_pixels : skip_pixels + width].tobytes())


@dataclass(frozen=True)
class Written:
    """Bitmaps that follow each other in a display list."""

    bitmaps: tuple[Bitmap, ...]
    write: Callable[[Sequence[Bitmap]], object]

    def __call__(self) -> None:
        """Draw them."""
        self.write(self.bitmaps)
