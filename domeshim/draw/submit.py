"""A recorded run goes to GL: a few vertices as they were given, more of them as arrays in a few draws."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from ctypes import c_float, c_int, c_uint
from typing import Any

import numpy as np
from numpy.typing import NDArray

from domeshim.driver import Driver
from domeshim.record.immediate import Block, Immediate, Run

_FEW = 24
"""Up to so many vertices GL's own glVertex costs less than arrays."""

_POINTS, _LINES, _TRIANGLES, _QUADS = 0, 1, 4, 7
_INDEPENDENT = {_POINTS: 1, _LINES: 2, _TRIANGLES: 3, _QUADS: 4}
_FLOAT, _TEXTURE0, _STREAM_DRAW = 0x1406, 0x84C0, 0x88E0
_VERTEX_ARRAY_BINDING, _ARRAY_BUFFER, _ARRAY_BUFFER_BINDING, _CLIENT_ACTIVE_TEXTURE = (
    0x85B5,
    0x8892,
    0x8894,
    0x84E1,
)
_VERTEX_ARRAY, _TEXTURE_COORD_ARRAY = 0x8074, 0x8078
_ARRAYS = {"normal": 0x8075, "color": 0x8076, "edge": 0x8079, "fog": 0x8457, "secondary": 0x845E}
_CURRENT = {"color": 0x0B00, "normal": 0x0B02, "secondary": 0x8459, "fog": 0x8453, "edge": 0x0B43}
_CURRENT_TEXTURE_COORDS, _ACTIVE_TEXTURE = 0x0B03, 0x84E0


class Submitter:
    """Draws recorded runs in one context, through a vertex array object of its own."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._array_object = self._buffer = 0
        self._enabled: set[str] = set()
        self._setters = _current_setters(driver)

    def submit(self, recorder: Immediate) -> None:
        """Draw what was recorded and leave the last attributes current, as GL itself would have."""
        few = len(recorder.positions) <= 3 * _FEW
        if few or any(block.extras for block in recorder.blocks):
            self._replay(recorder)
            recorder.clear()
            return
        last = [(name, events.last) for name, events in recorder.attributes.items() if events.places]
        self._draw_arrays(recorder.take())
        for name, value in last:
            self._setters[name](*value)

    # As it was given.

    def _replay(self, recorder: Immediate) -> None:
        gl = self._driver
        changes = self._changes(recorder)
        place, change = next(changes)
        for block in recorder.blocks:
            while place <= block.first and change is not None:
                change()
                place, change = next(changes)
            extras = iter((*block.extras, (-1, None)))
            extra_at, extra = next(extras)
            gl.glBegin(block.mode)
            for vertex in range(block.first, block.end):
                while place <= vertex and change is not None:
                    change()
                    place, change = next(changes)
                while extra_at == vertex and extra is not None:
                    self._extra(block, vertex, extra)
                    extra_at, extra = next(extras)
                x, y, z = recorder.positions[3 * vertex : 3 * vertex + 3]
                gl.glVertex4f(x, y, z, recorder.w(vertex))
            while extra is not None:
                extra()
                extra_at, extra = next(extras)
            gl.glEnd()
        while change is not None:
            change()
            place, change = next(changes)

    def _extra(self, block: Block, vertex: int, extra: Callable[[], object]) -> None:
        """A glMaterial between two primitives: a vertex program sees it only outside glBegin..glEnd."""
        size = _INDEPENDENT.get(block.mode)
        if size is not None and (vertex - block.first) % size == 0:
            self._driver.glEnd()
            extra()
            self._driver.glBegin(block.mode)
        else:
            extra()

    def _changes(self, recorder: Immediate) -> Iterator[tuple[int, Callable[[], object] | None]]:
        """(vertex, what to call before it), rising."""
        found = []
        for name, events in recorder.attributes.items():
            setter, size = self._setters[name], events.size
            for i, place in enumerate(events.places):
                found.append((place // 3, setter, events.values[size * i : size * i + size]))
        found.sort(key=lambda change: change[0])
        for place, setter, values in found:
            yield place, lambda setter=setter, values=values: setter(*values)  # type: ignore[misc]
        while True:
            yield -1, None

    # As arrays.

    def _draw_arrays(self, run: Run) -> None:
        gl = self._driver
        program_object, program_buffer = gl.integer(_VERTEX_ARRAY_BINDING), gl.integer(_ARRAY_BUFFER_BINDING)
        self._bind_own()
        self._upload(run)
        for mode, firsts, counts in _draws(run.blocks):
            if len(firsts) == 1:
                gl.glDrawArrays(mode, firsts[0], counts[0])
            else:
                count = len(firsts)
                gl.glMultiDrawArrays(mode, (c_int * count)(*firsts), (c_int * count)(*counts), count)
        gl.glBindVertexArray(program_object)
        gl.glBindBuffer(_ARRAY_BUFFER, program_buffer)

    def _bind_own(self) -> None:
        gl = self._driver
        if not self._array_object:
            array_object, buffer = c_uint(), c_uint()
            gl.glGenVertexArrays(1, array_object)
            gl.glGenBuffers(1, buffer)
            self._array_object, self._buffer = array_object.value, buffer.value
        gl.glBindVertexArray(self._array_object)
        gl.glBindBuffer(_ARRAY_BUFFER, self._buffer)

    def _upload(self, run: Run) -> None:
        """Positions and attributes into the buffer, one below the other; the pointers to where each is."""
        gl = self._driver
        wanted = {"vertex", *run.attributes}
        for name in wanted - self._enabled:
            self._switch_array(name, on=True)
        for name in self._enabled - wanted:
            self._switch_array(name, on=False)
        self._enabled = wanted
        arrays = [run.positions, *(self._filled(name, values) for name, values in run.attributes.items())]
        data = b"".join(array.tobytes() for array in arrays)
        gl.glBufferData(_ARRAY_BUFFER, len(data), data, _STREAM_DRAW)
        gl.glVertexPointer(run.positions.shape[1], _FLOAT, 0, 0)
        offset = run.positions.nbytes
        for name, array in zip(run.attributes, arrays[1:], strict=True):
            self._attribute_pointer(name, offset)
            offset += array.nbytes

    def _switch_array(self, name: str, *, on: bool) -> None:
        gl = self._driver
        switch = gl.glEnableClientState if on else gl.glDisableClientState
        if name.startswith("texture"):
            active = gl.integer(_CLIENT_ACTIVE_TEXTURE)
            gl.glClientActiveTexture(_TEXTURE0 + int(name[-1]))
            switch(_TEXTURE_COORD_ARRAY)
            gl.glClientActiveTexture(active)
        else:
            switch(_VERTEX_ARRAY if name == "vertex" else _ARRAYS[name])

    def _attribute_pointer(self, name: str, data: int) -> None:
        gl = self._driver
        match name:
            case "color":
                gl.glColorPointer(4, _FLOAT, 0, data)
            case "normal":
                gl.glNormalPointer(_FLOAT, 0, data)
            case "secondary":
                gl.glSecondaryColorPointer(3, _FLOAT, 0, data)
            case "fog":
                gl.glFogCoordPointer(_FLOAT, 0, data)
            case "edge":
                gl.glEdgeFlagPointer(0, data)
            case texture:
                active = gl.integer(_CLIENT_ACTIVE_TEXTURE)
                gl.glClientActiveTexture(_TEXTURE0 + int(texture[-1]))
                gl.glTexCoordPointer(4, _FLOAT, 0, data)
                gl.glClientActiveTexture(active)

    def _filled(self, name: str, values: NDArray[np.float32]) -> NDArray[Any]:
        """Rows of nan become the value that is current now."""
        unset = np.isnan(values[0, 0])
        if unset:
            values = np.where(np.isnan(values), self._current(name, values.shape[1]), values).astype(
                np.float32
            )
        return values.astype(np.uint8) if name == "edge" else values

    def _current(self, name: str, size: int) -> NDArray[np.float32]:
        gl = self._driver
        values = (c_float * 4)()
        if name.startswith("texture"):
            active = gl.integer(_ACTIVE_TEXTURE)
            gl.glActiveTexture(_TEXTURE0 + int(name[-1]))
            gl.glGetFloatv(_CURRENT_TEXTURE_COORDS, values)
            gl.glActiveTexture(active)
        else:
            gl.glGetFloatv(_CURRENT[name], values)
        return np.array(values[:size], np.float32)


def _draws(blocks: tuple[Block, ...]) -> Iterator[tuple[int, list[int], list[int]]]:
    """(mode, firsts, counts) of each draw: blocks of one mode in a row go together, touching ones as one."""
    mode, firsts, counts = -1, [], []  # type: int, list[int], list[int]
    for block in blocks:
        size = _INDEPENDENT.get(block.mode)
        count = block.end - block.first
        count -= count % size if size else 0
        if block.mode != mode:
            if firsts:
                yield mode, firsts, counts
            mode, firsts, counts = block.mode, [block.first], [count]
        elif size and firsts[-1] + counts[-1] == block.first:
            counts[-1] += count
        else:
            firsts.append(block.first)
            counts.append(count)
    if firsts:
        yield mode, firsts, counts


def _current_setters(driver: Driver) -> dict[str, Callable[..., None]]:
    """The GL function that makes each attribute's value current."""

    def texture(unit: int) -> Callable[..., None]:
        return lambda *values: driver.glMultiTexCoord4f(_TEXTURE0 + unit, *values)

    return {
        "color": driver.glColor4f,
        "normal": driver.glNormal3f,
        "secondary": driver.glSecondaryColor3f,
        "fog": driver.glFogCoordf,
        "edge": lambda value: driver.glEdgeFlag(int(value)),
        **{f"texture{unit}": texture(unit) for unit in range(8)},
    }
