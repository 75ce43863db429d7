"""Runs in GL's memory: a buffer, and the vertex array object that reads it, where GL has those."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from ctypes import c_int, c_uint
from dataclasses import replace
from itertools import accumulate, groupby
from operator import itemgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.client_arrays import client_arrays, switch_off
from domeshim.draw.current import current_value
from domeshim.driver import Driver
from domeshim.record.runs import Block, Run, stretches
from domeshim.shading.recipe import MATERIAL_UNITS, PIECE_ATTRIBUTES

_PATCHES = 0x000E
_BATCH = 6 * 48
"""So many vertices of patches are drawn at a time: Mesa's CPU driver mixes up more than 65,536 of a draw."""

_FLOAT, _TEXTURE0, _STREAM_DRAW = 0x1406, 0x84C0, 0x88E0
_UNSIGNED_INT = 0x1405
_VERTEX_ARRAY_BINDING, _ARRAY_BUFFER, _ARRAY_BUFFER_BINDING, _CLIENT_ACTIVE_TEXTURE = (
    0x85B5,
    0x8892,
    0x8894,
    0x84E1,
)
_VERTEX_ARRAY, _TEXTURE_COORD_ARRAY = 0x8074, 0x8078
_ARRAYS = {"normal": 0x8075, "color": 0x8076, "edge": 0x8079, "fog": 0x8457, "secondary": 0x845E}


class Upload:
    """One run at a time in GL's memory, through a vertex array object of its own if there are such."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._array_object = self._buffer = 0
        self._enabled: set[str] = set()
        self._layout: list[tuple[str, int, int]] = []
        """Name, size and offset in the buffer of each array."""

    @contextmanager
    def bound(self, run: Run | None = None) -> Iterator[None]:
        """Within it, GL's arrays are these; after it, the program's own again. run: put in before."""
        gl = self._driver
        if gl.legacy:
            with client_arrays(gl):
                switch_off(gl)
                self._enabled = set()
                self._bind_buffer()
                if run is not None:
                    self._upload(run)
                self._point()
                yield
            return
        program_object, program_buffer = gl.integer(_VERTEX_ARRAY_BINDING), gl.integer(_ARRAY_BUFFER_BINDING)
        self._bind_array_object()
        self._bind_buffer()
        if run is not None:
            self._upload(run)
            self._point()
        try:
            yield
        finally:
            gl.glBindVertexArray(program_object)
            gl.glBindBuffer(_ARRAY_BUFFER, program_buffer)

    def draw_all(self, mode: int, count: int) -> None:
        """Draw so many vertices by one mode; the arrays must be bound."""
        size = _BATCH if mode == _PATCHES else count
        firsts = list(range(0, count, size or 1))
        self._draw_parts(mode, firsts, [min(size, count - first) for first in firsts])

    def draw_blocks(self, blocks: tuple[Block, ...]) -> None:
        """Draw blocks of the run; the arrays must be bound."""
        for mode, firsts, counts in _draws(blocks):
            self._draw_parts(mode, firsts, counts)

    def draw_some(self, mode: int, numbers: NDArray[np.uint32]) -> None:
        """Draw the vertices of these numbers, (n,), by one mode; the arrays must be bound."""
        self._driver.glDrawElements(mode, numbers.size, _UNSIGNED_INT, numbers.ctypes.data)

    def _draw_parts(self, mode: int, firsts: list[int], counts: list[int]) -> None:
        gl, count = self._driver, len(firsts)
        if count == 1:
            gl.glDrawArrays(mode, firsts[0], counts[0])
        elif count:
            gl.glMultiDrawArrays(mode, (c_int * count)(*firsts), (c_int * count)(*counts), count)

    def delete(self) -> None:
        """Give back what it has of GL."""
        if self._array_object:
            self._driver.glDeleteVertexArrays(1, c_uint(self._array_object))
        if self._buffer:
            self._driver.glDeleteBuffers(1, c_uint(self._buffer))
        self._array_object = self._buffer = 0
        self._enabled = set()

    def _bind_array_object(self) -> None:
        if not self._array_object:
            array_object = c_uint()
            self._driver.glGenVertexArrays(1, array_object)
            self._array_object = array_object.value
        self._driver.glBindVertexArray(self._array_object)

    def _bind_buffer(self) -> None:
        if not self._buffer:
            buffer = c_uint()
            self._driver.glGenBuffers(1, buffer)
            self._buffer = buffer.value
        self._driver.glBindBuffer(_ARRAY_BUFFER, self._buffer)

    def _upload(self, run: Run) -> None:
        """Positions and attributes into the buffer, one below the other."""
        gl = self._driver
        arrays: dict[str, NDArray[Any]] = {"vertex": run.positions, **completed(gl, run).attributes}
        if "edge" in arrays:
            arrays["edge"] = arrays["edge"].astype(np.uint8)
        data = b"".join(array.tobytes() for array in arrays.values())
        gl.glBufferData(_ARRAY_BUFFER, len(data), data, _STREAM_DRAW)
        ends = accumulate((array.nbytes for array in arrays.values()), initial=0)
        self._layout = [
            (name, array.shape[1], first) for (name, array), first in zip(arrays.items(), ends, strict=False)
        ]

    def _point(self) -> None:
        """Let GL read each array from where it is in the buffer, and no others."""
        wanted = {name for name, _, _ in self._layout}
        for name in wanted - self._enabled:
            self._switch_array(name, on=True)
        for name in self._enabled - wanted:
            self._switch_array(name, on=False)
        self._enabled = wanted
        for name, size, offset in self._layout:
            self._pointer(name, size, offset)

    def _switch_array(self, name: str, *, on: bool) -> None:
        gl = self._driver
        switch = gl.glEnableClientState if on else gl.glDisableClientState
        if name in PIECE_ATTRIBUTES:
            (gl.glEnableVertexAttribArray if on else gl.glDisableVertexAttribArray)(PIECE_ATTRIBUTES[name])
        elif name != "vertex" and name not in _ARRAYS:
            active = gl.integer(_CLIENT_ACTIVE_TEXTURE)
            gl.glClientActiveTexture(_TEXTURE0 + _unit(name))
            switch(_TEXTURE_COORD_ARRAY)
            gl.glClientActiveTexture(active)
        else:
            switch(_VERTEX_ARRAY if name == "vertex" else _ARRAYS[name])

    def _pointer(self, name: str, size: int, data: int) -> None:
        gl = self._driver
        match name:
            case "vertex":
                gl.glVertexPointer(size, _FLOAT, 0, data)
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
            case "place" | "weights" | "pieces":
                gl.glVertexAttribPointer(PIECE_ATTRIBUTES[name], size, _FLOAT, 0, 0, data)
            case name:
                active = gl.integer(_CLIENT_ACTIVE_TEXTURE)
                gl.glClientActiveTexture(_TEXTURE0 + _unit(name))
                gl.glTexCoordPointer(4, _FLOAT, 0, data)
                gl.glClientActiveTexture(active)


def completed(driver: Driver, run: Run) -> Run:
    """The run with every attribute of every vertex known: what was nan becomes the value current now."""
    return replace(run, attributes={n: _filled(driver, n, values) for n, values in run.attributes.items()})


def _filled(driver: Driver, name: str, values: NDArray[np.float32]) -> NDArray[np.float32]:
    if name in PIECE_ATTRIBUTES or not np.isnan(values[:, 0]).any():
        return values
    known = np.where(np.isnan(values), current_value(driver, name, values.shape[1]), values)
    return known.astype(np.float32)


def _draws(blocks: tuple[Block, ...]) -> Iterator[tuple[int, list[int], list[int]]]:
    """(mode, firsts, counts) of each draw: stretches of one mode in a row go together."""
    for mode, group in groupby(stretches(blocks), key=itemgetter(0)):
        together = list(group)
        yield mode, [first for _, first, _ in together], [count for _, _, count in together]


def _unit(name: str) -> int:
    """The unit whose texture coordinates carry an attribute that has no array of its own."""
    return int(name[-1]) if name.startswith("texture") else MATERIAL_UNITS[name.split()[1]]
