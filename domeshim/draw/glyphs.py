"""Bitmaps go to GL: as rectangles on a surface that bends them, or as they are at GL's raster position."""

from __future__ import annotations

from collections.abc import Sequence

from domeshim.draw.transfer import tightly_packed
from domeshim.driver import Driver
from domeshim.record.bitmaps import Bitmap

_QUADS, _COMPILE = 0x0007, 0x1300
_MOST = 4096
"""So many bitmaps are remembered."""
_OWN_NAMES = 0x5000_0000
"""Names of lists begin here, far above what programs choose for themselves."""


def draw_bitmaps(driver: Driver, bitmaps: Sequence[Bitmap]) -> None:
    """Draw bitmaps one after the other by glBitmap."""
    with tightly_packed(driver):
        for bitmap in bitmaps:
            driver.glBitmap(bitmap.width, bitmap.height, *bitmap.origin, *bitmap.move, bitmap.rows)


class Glyphs:
    """Bitmaps compiled into display lists, a unit a pixel, the lower left corner at the origin."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._names: dict[Bitmap, int] = {}
        self._next = _OWN_NAMES

    def draw(self, placed: Sequence[tuple[int, int, Bitmap]]) -> None:
        """Draw the rectangles of bitmaps, their lower left corners at these places; MODELVIEW moves along."""
        gl, x, y = self._driver, 0, 0
        for left, bottom, bitmap in placed:
            gl.glTranslatef(left - x, bottom - y, 0.0)
            x, y = left, bottom
            gl.glCallList(self._names.get(bitmap) or self._compiled(bitmap))

    def _compiled(self, bitmap: Bitmap) -> int:
        gl = self._driver
        if len(self._names) >= _MOST:
            for name in self._names.values():
                gl.glDeleteLists(name, 1)
            self._names.clear()
            self._next = _OWN_NAMES
        while gl.glIsList(self._next):  # glGenLists gives the program names above the highest in use
            self._next += 1
        name = self._names[bitmap] = self._next
        gl.glNewList(name, _COMPILE)
        gl.glBegin(_QUADS)
        for left, bottom, right, top in bitmap.rectangles().tolist():
            for x, y in ((left, bottom), (right, bottom), (right, top), (left, top)):
                gl.glVertex3f(x, y, 0.0)
        gl.glEnd()
        gl.glEndList()
        return name
