"""What the program draws by vertex arrays, read from its memory or its buffers."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterator
from ctypes import c_char, c_void_p
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from domeshim.driver import Driver
from domeshim.record.attributes import DEFAULTS
from domeshim.record.runs import Block, Run

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
_SAMPLES = 64


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


@dataclass(frozen=True)
class Elements:
    """glDrawElements' indices: in the element buffer at an offset, or given as bytes."""

    count: int
    type: str
    buffer: int
    offset: int
    data: bytes


@dataclass(frozen=True)
class ArrayDraw:
    """One draw from arrays, not read yet."""

    key: object
    """Equal for draws of the same vertices."""
    buffered: bool
    """All of it lies in buffers, so that the key tells all; else it samples the program's memory."""
    read: Callable[[], Run]
    numbers: Callable[[], NDArray[np.int64]]
    """The number in the program's arrays of each vertex of the run."""


class ArrayReader:
    """Reads the vertex arrays of one context."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver

    def draw(self, mode: int, indices: range | Elements, texture_units: int) -> ArrayDraw | None:
        """A draw of these vertices; None where there are none or an array says which edges show."""
        gl = self._driver
        count = len(indices) if isinstance(indices, range) else indices.count
        if count <= 0 or not gl.glIsEnabled(_VERTEX.enabled) or gl.glIsEnabled(_EDGE_FLAG_ARRAY):
            return None
        arrays = tuple(self._arrays(texture_units))
        buffered = all(array.buffer for array in arrays)
        samples = b"" if buffered else self._samples(arrays[0], indices)
        return ArrayDraw(
            (mode, arrays, indices, samples),
            buffered,
            lambda: self._read(mode, arrays, self.numbers(indices)),
            lambda: self.numbers(indices),
        )

    def elements(self, count: int, kind: int, indices: object) -> Elements:
        """glDrawElements' indices: an array, bytes, an address, or an offset into the element buffer."""
        dtype = np.dtype(_TYPES[kind])
        buffer = self._driver.integer(_ELEMENT_BUFFER_BINDING)
        place = indices.value if isinstance(indices, c_void_p) else indices
        if buffer:
            return Elements(count, dtype.str, buffer, int(place or 0), b"")  # type: ignore[call-overload]
        if isinstance(place, bytes):
            data = place
        elif isinstance(place, int) or place is None:
            data = self._memory(0, place or 0, count * dtype.itemsize)
        else:
            data = np.asarray(place).ravel()[:count].astype(dtype).tobytes()
        return Elements(count, dtype.str, 0, 0, data)

    def numbers(self, indices: range | Elements) -> NDArray[np.int64]:
        """The number in the program's arrays of each vertex of a draw."""
        if isinstance(indices, range):
            return np.arange(indices.start, indices.stop)
        dtype = np.dtype(indices.type)
        data = indices.data or self._memory(indices.buffer, indices.offset, indices.count * dtype.itemsize)
        return np.frombuffer(data, dtype, indices.count).astype(np.int64)

    def _samples(self, positions: Array, indices: range | Elements) -> bytes:
        """Some of the positions' bytes, to tell whether the program has moved them."""
        numbers = self.numbers(indices)
        chosen = numbers[:: max(1, len(numbers) // _SAMPLES)].tolist()
        if positions.buffer:
            return b""
        size = positions.size * np.dtype(positions.type).itemsize
        return b"".join(ctypes.string_at(positions.pointer + n * positions.stride, size) for n in chosen)

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

    def _read(self, mode: int, arrays: tuple[Array, ...], indices: NDArray[np.integer]) -> Run:
        first, last = int(indices.min()), int(indices.max())
        chosen = indices - first
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
