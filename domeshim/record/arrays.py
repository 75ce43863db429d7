"""What the program draws by vertex arrays, read from its memory or its buffers."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from ctypes import c_char, c_void_p
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from domeshim.driver import Driver
from domeshim.record.attributes import DEFAULTS
from domeshim.record.immediate import Block, Run

_TYPES: dict[int, str] = {
    0x1400: "i1",
    0x1401: "u1",
    0x1402: "i2",
    0x1403: "u2",
    0x1404: "i4",
    0x1405: "u4",
    0x1406: "f4",
    0x140A: "f8",
}
_NORMALISED = ("color", "secondary", "normal")
_ARRAY_BUFFER, _ARRAY_BUFFER_BINDING, _ELEMENT_BUFFER_BINDING = 0x8892, 0x8894, 0x8895
_CLIENT_ACTIVE_TEXTURE, _TEXTURE0 = 0x84E1, 0x84C0
_EDGE_FLAG_ARRAY = 0x8079


@dataclass(frozen=True)
class _Names:
    """What to ask GL about one array; size is a fixed number where GL has no name for it."""

    enabled: int
    size: int
    type: int
    stride: int
    pointer: int
    buffer: int


_VERTEX = _Names(0x8074, 0x807A, 0x807B, 0x807C, 0x808E, 0x8896)
_TEXTURE = _Names(0x8078, 0x8088, 0x8089, 0x808A, 0x8092, 0x889A)
_OTHERS = {
    "normal": _Names(0x8075, 3, 0x807E, 0x807F, 0x808F, 0x8897),
    "color": _Names(0x8076, 0x8081, 0x8082, 0x8083, 0x8090, 0x8898),
    "secondary": _Names(0x845E, 0x845A, 0x845B, 0x845C, 0x845D, 0x889C),
    "fog": _Names(0x8457, 1, 0x8454, 0x8455, 0x8456, 0x889D),
}


@dataclass(frozen=True)
class Array:
    """Where one attribute's values lie, as GL knows it."""

    name: str
    size: int
    type: str
    stride: int
    pointer: int
    """An address, or an offset into the buffer."""
    buffer: int


class ArrayReader:
    """Reads the arrays of one context; what lies in buffers is kept until a buffer changes."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._kept: dict[object, Run] = {}

    def buffers_changed(self) -> None:
        """The program has written to a buffer or deleted one."""
        self._kept.clear()

    def run(self, mode: int, indices: NDArray[np.integer] | range, texture_units: int) -> Run | None:
        """One draw as a run; None where there are no vertices or an array says which edges show.

        indices: of the vertices in the order of drawing.
        """
        gl = self._driver
        if not len(indices) or not gl.glIsEnabled(_VERTEX.enabled) or gl.glIsEnabled(_EDGE_FLAG_ARRAY):
            return None
        arrays = tuple(self._arrays(texture_units))
        key = (mode, arrays, indices if isinstance(indices, range) else indices.tobytes())
        run = self._kept.get(key)
        if run is None:
            run = self._read(mode, arrays, indices)
            if all(array.buffer for array in arrays):
                self._kept[key] = run
        return run

    def elements(self, count: int, kind: int, indices: object) -> NDArray[np.integer]:
        """glDrawElements' indices: an array, bytes, an address, or an offset into the element buffer."""
        dtype = np.dtype(_TYPES[kind])
        buffer = self._driver.integer(_ELEMENT_BUFFER_BINDING)
        if buffer:
            offset = indices.value if isinstance(indices, c_void_p) else indices
            data = self._memory(buffer, int(offset or 0), count * dtype.itemsize)  # type: ignore[call-overload]
        elif isinstance(indices, bytes):
            data = indices
        elif isinstance(indices, (c_void_p, int)):
            address = indices.value if isinstance(indices, c_void_p) else indices
            data = self._memory(0, address or 0, count * dtype.itemsize)
        else:
            return np.asarray(indices).ravel()[:count].astype(np.int64)
        return np.frombuffer(data, dtype, count).astype(np.int64)

    def _arrays(self, texture_units: int) -> Iterator[Array]:
        gl = self._driver
        yield self._array("vertex", _VERTEX)
        for name, names in _OTHERS.items():
            if gl.glIsEnabled(names.enabled):
                yield self._array(name, names)
        active = gl.integer(_CLIENT_ACTIVE_TEXTURE)
        for unit in range(max(texture_units, active - _TEXTURE0 + 1)):
            gl.glClientActiveTexture(_TEXTURE0 + unit)
            if gl.glIsEnabled(_TEXTURE.enabled):
                yield self._array(f"texture{unit}", _TEXTURE)
        gl.glClientActiveTexture(active)

    def _array(self, name: str, names: _Names) -> Array:
        gl = self._driver
        size = names.size if names.size < 5 else gl.integer(names.size)
        kind = _TYPES[gl.integer(names.type)]
        pointer = c_void_p()
        gl.glGetPointerv(names.pointer, pointer)
        stride = gl.integer(names.stride) or size * np.dtype(kind).itemsize
        return Array(name, size, kind, stride, pointer.value or 0, gl.integer(names.buffer))

    def _read(self, mode: int, arrays: tuple[Array, ...], indices: NDArray[np.integer] | range) -> Run:
        first, last = int(min(indices)), int(max(indices))
        chosen = np.asarray(indices) - first
        values = {array.name: self._values(array, first, last + 1)[chosen] for array in arrays}
        positions = values.pop("vertex")
        if positions.shape[1] == 2:
            positions = np.hstack([positions, np.zeros((len(positions), 1), np.float32)])
        return Run(positions, values, (Block(mode, 0, len(positions)),), ())

    def _values(self, array: Array, first: int, end: int) -> NDArray[np.float32]:
        """One array's values from the first vertex up to, without, the end: (end - first, size) float32."""
        dtype = np.dtype(array.type)
        row = array.size * dtype.itemsize
        data = self._memory(
            array.buffer, array.pointer + first * array.stride, (end - first - 1) * array.stride + row
        )
        raw = np.ndarray((end - first, array.size), dtype, data, strides=(array.stride, dtype.itemsize))
        values = raw.astype(np.float32)
        if array.name in _NORMALISED and dtype.kind in "iu":
            most = float(2 ** (8 * dtype.itemsize) - 1)
            values = values / np.float32(most) if dtype.kind == "u" else (2 * values + 1) / np.float32(most)
        if array.name != "vertex" and array.size < len(DEFAULTS[array.name]):
            missing = DEFAULTS[array.name][array.size :]
            values = np.hstack([values, np.tile(np.array(missing, np.float32), (len(values), 1))])
        return values

    def _memory(self, buffer: int, pointer: int, size: int) -> bytes:
        """Bytes at an address, or at an offset into a buffer."""
        if not buffer:
            return ctypes.string_at(pointer, size)
        gl = self._driver
        bound = gl.integer(_ARRAY_BUFFER_BINDING)
        data = (c_char * size)()
        gl.glBindBuffer(_ARRAY_BUFFER, buffer)
        gl.glGetBufferSubData(_ARRAY_BUFFER, pointer, size, data)
        gl.glBindBuffer(_ARRAY_BUFFER, bound)
        return data.raw
