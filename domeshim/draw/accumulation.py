"""glAccum where the surface has no accumulation buffer, as none has off screen: it is kept in memory."""

from __future__ import annotations

from ctypes import c_float
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.over import way_cleared
from domeshim.draw.transfer import plain_transfer
from domeshim.driver import Driver
from domeshim.window.contract import Window

BUFFER_BIT = 0x0200
"""GL_ACCUM_BUFFER_BIT of glClear."""
_RED_BITS, _CLEAR_VALUE = 0x0D58, 0x0B80
_RGBA, _FLOAT = 0x1908, 0x1406


class Accumulation:
    """The accumulation buffers of all windows, (height, width, 4) float32 each."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._buffers: WeakKeyDictionary[Window, NDArray[np.float32]] = WeakKeyDictionary()

    @property
    def needed(self) -> bool:
        """The current surface has no accumulation buffer of its own."""
        return self._driver.integer(_RED_BITS) == 0

    def clear(self, window: Window, size: tuple[int, int]) -> None:
        """Fill a window's buffer with the program's glClearAccum; size: of its frame, pixels."""
        value = (c_float * 4)()
        self._driver.glGetFloatv(_CLEAR_VALUE, value)
        self._buffers[window] = np.tile(np.array(value, np.float32), (size[1], size[0], 1))

    def operate(self, window: Window, size: tuple[int, int], operation: int, value: float) -> None:
        """One glAccum: on the colours of the current read buffer, or back into the draw buffer."""
        buffer = self._buffers.get(window)
        if buffer is None or buffer.shape[:2] != size[::-1]:
            buffer = self._buffers[window] = np.zeros((size[1], size[0], 4), np.float32)
        match operation:
            case 0x0100:  # GL_ACCUM
                buffer += value * self._read(size)
            case 0x0101:  # GL_LOAD
                buffer[:] = value * self._read(size)
            case 0x0102:  # GL_RETURN
                self._write(np.clip(value * buffer, 0, 1).astype(np.float32))
            case 0x0103:  # GL_MULT
                buffer *= value
            case 0x0104:  # GL_ADD
                buffer += value

    def _read(self, size: tuple[int, int]) -> NDArray[np.float32]:
        pixels = np.empty((size[1], size[0], 4), np.float32)
        with plain_transfer(self._driver):
            self._driver.glReadPixels(0, 0, *size, _RGBA, _FLOAT, pixels.ctypes.data)
        return pixels

    def _write(self, pixels: NDArray[np.float32]) -> None:
        gl = self._driver
        with way_cleared(gl), plain_transfer(gl):
            gl.glPixelZoom(1.0, 1.0)
            gl.glWindowPos3f(0.0, 0.0, 0.0)
            gl.glDrawPixels(pixels.shape[1], pixels.shape[0], _RGBA, _FLOAT, pixels.ctypes.data)
