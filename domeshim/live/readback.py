"""Reads pictures back while later ones are drawn: the copy waits in a pixel buffer until the GPU is done."""

from __future__ import annotations

from collections import deque
from ctypes import byref, c_uint
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from domeshim.driver import Driver
from domeshim.measure.pixels import (
    GL_BACK,
    GL_UNSIGNED_BYTE,
    PIXEL_PACK_BUFFER,
    PIXEL_PACK_BUFFER_BINDING,
    plain_reading,
    resolved,
)
from domeshim.window.contract import Window

_BEHIND = 2
"""So many pictures later one is taken out of its buffer."""
_STREAM_READ, _DRAW_BUFFER, _FRONT, _COLOR_ATTACHMENT = 0x88E1, 0x0C01, 0x0404, 0x8CE0
_BGRA = 0x80E1
"""As most drivers keep their pixels: they have nothing to convert."""
Pixels = NDArray[np.uint8]


@dataclass(frozen=True)
class Picture:
    """A finished picture, and when it was."""

    time: float
    """Seconds on the clock that the reader was told the time of."""
    content: Pixels
    """(height, width, 4): blue, green, red and what is left to chance, the bottom row first."""

    @property
    def size(self) -> tuple[int, int]:
        """Width and height, pixels."""
        height, width, _ = self.content.shape
        return width, height

    @property
    def bgra(self) -> Pixels:
        """(height, width, 4), the top row first."""
        return self.content[::-1]

    @property
    def rgb(self) -> Pixels:
        """(height, width, 3), the top row first."""
        return self.content[::-1, :, 2::-1]


class _Read(NamedTuple):
    """A picture on its way."""

    buffer: c_uint
    time: float
    size: tuple[int, int]


class Readback:
    """The pictures of one window, which must be current in all calls."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._waiting: deque[_Read] = deque()
        self._spare: list[_Read] = []

    def read(self, window: Window, time: float) -> Picture | None:
        """Begin to read the finished picture; the one before the last, which has been read by now."""
        gl, size = self._driver, window.pixels
        library = _library()
        with (
            plain_reading(library, self._buffer_of(window), window.framebuffer),
            resolved(library, (0, 0), *size) as (left, bottom),
        ):
            read = _Read(self._buffer(size), time, size)
            gl.glBindBuffer(PIXEL_PACK_BUFFER, read.buffer)
            gl.glReadPixels(left, bottom, *size, _BGRA, GL_UNSIGNED_BYTE, None)
            self._waiting.append(read)
            picture = self._next() if len(self._waiting) > _BEHIND else None
            gl.glBindBuffer(PIXEL_PACK_BUFFER, 0)
        return picture

    def rest(self) -> list[Picture]:
        """What is still being read, waited for; nothing of GL is held any more."""
        bound = self._driver.integer(PIXEL_PACK_BUFFER_BINDING)
        pictures = [self._next() for _ in range(len(self._waiting))]
        self._driver.glBindBuffer(PIXEL_PACK_BUFFER, bound)
        self._free()
        return pictures

    def _buffer_of(self, window: Window) -> int:
        """The colour buffer that the window's picture is in."""
        if window.framebuffer:
            return _COLOR_ATTACHMENT
        front = not window.format.double_buffer and self._driver.integer(_DRAW_BUFFER) == _FRONT
        return _FRONT if front else GL_BACK

    def _buffer(self, size: tuple[int, int]) -> c_uint:
        """A buffer for a picture of that size: one that has been read out, or another."""
        if self._spare and self._spare[-1].size == size:
            return self._spare.pop().buffer
        self._free()
        buffer = c_uint()
        self._driver.glGenBuffers(1, byref(buffer))
        self._driver.glBindBuffer(PIXEL_PACK_BUFFER, buffer)
        self._driver.glBufferData(PIXEL_PACK_BUFFER, 4 * size[0] * size[1], None, _STREAM_READ)
        return buffer

    def _next(self) -> Picture:
        read = self._waiting.popleft()
        width, height = read.size
        content = np.empty((height, width, 4), np.uint8)
        self._driver.glBindBuffer(PIXEL_PACK_BUFFER, read.buffer)
        self._driver.glGetBufferSubData(PIXEL_PACK_BUFFER, 0, content.nbytes, content.ctypes.data)
        self._spare.append(read)
        return Picture(read.time, content)

    def _free(self) -> None:
        while self._spare:
            self._driver.glDeleteBuffers(1, byref(self._spare.pop().buffer))


def _library() -> object:
    from OpenGL.platform import PLATFORM  # noqa: PLC0415 - the program may still set PyOpenGL's flags

    return PLATFORM.GL
