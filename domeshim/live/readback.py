"""Reads pictures back while later ones are drawn: the copy waits in a pixel buffer until the GPU is done."""

from __future__ import annotations

from collections import deque
from ctypes import byref, c_uint, create_string_buffer
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from domeshim.driver import Driver
from domeshim.measure.pixels import (
    GL_BACK,
    GL_RGB,
    GL_UNSIGNED_BYTE,
    PIXEL_PACK_BUFFER,
    plain_reading,
    resolved,
)
from domeshim.window.contract import Window

_BEHIND = 2
"""So many pictures later one is taken out of its buffer."""
_STREAM_READ, _DRAW_BUFFER, _FRONT = 0x88E1, 0x0C01, 0x0404


@dataclass(frozen=True)
class Picture:
    """A finished picture, and when it was."""

    time: float
    """Seconds on the clock that the reader was told the time of."""
    size: tuple[int, int]
    content: bytes
    """RGB pixels, a byte each, the bottom row first."""

    @property
    def rows(self) -> NDArray[np.uint8]:
        """(height, width, 3), the top row first."""
        width, height = self.size
        return np.frombuffer(self.content, np.uint8).reshape(height, width, 3)[::-1]


class Readback:
    """The pictures of one window, which must be current in all calls."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._waiting: deque[tuple[c_uint, float, tuple[int, int]]] = deque()

    def read(self, window: Window, time: float) -> Picture | None:
        """Begin to read the finished picture; the one before the last, which has been read by now."""
        gl, buffer = self._driver, c_uint()
        width, height = window.pixels
        front = not window.format.double_buffer and gl.integer(_DRAW_BUFFER) == _FRONT
        library = _library()
        with (
            plain_reading(library, _FRONT if front else GL_BACK),
            resolved(library, (0, 0), width, height) as (left, bottom),
        ):
            gl.glGenBuffers(1, byref(buffer))
            gl.glBindBuffer(PIXEL_PACK_BUFFER, buffer)
            gl.glBufferData(PIXEL_PACK_BUFFER, 3 * width * height, None, _STREAM_READ)
            gl.glReadPixels(left, bottom, width, height, GL_RGB, GL_UNSIGNED_BYTE, None)
            gl.glBindBuffer(PIXEL_PACK_BUFFER, 0)
            self._waiting.append((buffer, time, (width, height)))
            return self._next() if len(self._waiting) > _BEHIND else None

    def rest(self) -> list[Picture]:
        """What is still being read, waited for."""
        with plain_reading(_library(), GL_BACK):
            return [self._next() for _ in range(len(self._waiting))]

    def _next(self) -> Picture:
        gl = self._driver
        buffer, time, (width, height) = self._waiting.popleft()
        content = create_string_buffer(3 * width * height)
        gl.glBindBuffer(PIXEL_PACK_BUFFER, buffer)
        gl.glGetBufferSubData(PIXEL_PACK_BUFFER, 0, len(content), content)
        gl.glBindBuffer(PIXEL_PACK_BUFFER, 0)
        gl.glDeleteBuffers(1, byref(buffer))
        return Picture(time, (width, height), content.raw)


def _library() -> object:
    from OpenGL.platform import PLATFORM  # noqa: PLC0415 - the program may still set PyOpenGL's flags

    return PLATFORM.GL
