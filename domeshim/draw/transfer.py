"""Pixels between memory and GL as they are, whatever the program has set for its own."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from domeshim.driver import Driver

_PIXEL_STORE_BIT, _PIXEL_MODE_AND_TEXTURE_BITS = 0x1, 0x40020
_PACK_BUFFER, _UNPACK_BUFFER = 0x88EB, 0x88EC
_PACK_ALIGNMENT, _UNPACK_ALIGNMENT = 0x0D05, 0x0CF5
_LAYOUT = (*range(0x0CF0, 0x0CF5), *range(0x0D00, 0x0D05))
"""Byte order, row length and what is skipped, of unpacking and packing."""
_SCALES, _OFFSETS = (0x0D14, 0x0D18, 0x0D1A, 0x0D1C, 0x0D1E), (0x0D15, 0x0D19, 0x0D1B, 0x0D1D, 0x0D1F)
_MAP_COLOR = 0x0D10


@contextmanager
def tightly_packed(gl: Driver) -> Iterator[None]:
    """Pixels in memory lie row after row, nothing between them, while this lasts."""
    gl.glPushClientAttrib(_PIXEL_STORE_BIT)
    for target in (_PACK_BUFFER, _UNPACK_BUFFER):
        gl.glBindBuffer(target, 0)
    for name in _LAYOUT:
        gl.glPixelStorei(name, 0)
    for name in (_PACK_ALIGNMENT, _UNPACK_ALIGNMENT):
        gl.glPixelStorei(name, 1)
    try:
        yield
    finally:
        gl.glPopClientAttrib()


@contextmanager
def plain_transfer(gl: Driver) -> Iterator[None]:
    """Pixels go between memory and GL tightly packed and unchanged while this lasts."""
    gl.glPushAttrib(_PIXEL_MODE_AND_TEXTURE_BITS)
    for name in (_MAP_COLOR, *_OFFSETS):
        gl.glPixelTransferf(name, 0.0)
    for name in _SCALES:
        gl.glPixelTransferf(name, 1.0)
    try:
        with tightly_packed(gl):
            yield
    finally:
        gl.glPopAttrib()
