"""A recorded run goes to GL: a few vertices as they were given, more of them as arrays in a few draws."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from ctypes import c_int, c_uint
from dataclasses import replace
from functools import partial
from itertools import groupby
from operator import itemgetter
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.current import current_setters, current_value
from domeshim.draw.extent import Extent
from domeshim.draw.primitives import parts_of
from domeshim.draw.replay import replay
from domeshim.draw.subdivide import Making, at_once, subdivide, subdivision_of
from domeshim.driver import Driver
from domeshim.record.immediate import Immediate
from domeshim.record.runs import Block, Run, stretches
from domeshim.shading.recipe import MATERIAL_UNITS, PIECE_ATTRIBUTES

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext
    from domeshim.state.subdivision import Subdivision

_FEW = 24
"""Up to so many vertices GL's own glVertex costs less than arrays."""

_PATCHES = 0x000E
_BATCH = 6 * 48
"""So many vertices of patches are drawn at a time: Mesa's CPU driver mixes up more than 65,536 of a draw."""

_FLOAT, _TEXTURE0, _STREAM_DRAW = 0x1406, 0x84C0, 0x88E0
_VERTEX_ARRAY_BINDING, _ARRAY_BUFFER, _ARRAY_BUFFER_BINDING, _CLIENT_ACTIVE_TEXTURE = (
    0x85B5,
    0x8892,
    0x8894,
    0x84E1,
)
_VERTEX_ARRAY, _TEXTURE_COORD_ARRAY = 0x8074, 0x8078
_ARRAYS = {"normal": 0x8075, "color": 0x8076, "edge": 0x8079, "fog": 0x8457, "secondary": 0x845E}


class Submitter:
    """Draws recorded runs in one context, through a vertex array object of its own."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._array_object = self._buffer = 0
        self._enabled: set[str] = set()
        self._setters = current_setters(driver)

    def submit(self, recorder: Immediate, context: DomeContext, *, compiling: bool = False) -> None:
        """Draw what was recorded and leave the last attributes current, as GL itself would have.

        compiling: into a display list, where an attribute's current value is not known yet.
        """
        few = self._as_given(recorder, compiling=compiling)
        subdivision = _subdivision_of_few(recorder, context) if few else None
        if few and subdivision is None:
            self.replay(recorder, context.draw if recorder.blocks else at_once)
            return
        run = recorder.take()
        if not few and not compiling:
            subdivision = subdivision_of(run, context)
        self.draw_as_needed(run, context, subdivision)

    def replay(self, recorder: Immediate, made: Making = at_once) -> None:
        """Make the recorded calls one by one; made: makes the draw, once for each view."""
        try:
            made(lambda: replay(self._driver, recorder, self._setters))
        finally:
            recorder.clear()

    def skip(self, recorder: Immediate) -> None:
        """Leave out the draws, and leave the last attributes current."""
        for name, events in recorder.used:
            self._setters[name](*events.last)
        recorder.clear()

    def draw_as_needed(self, run: Run, context: DomeContext, subdivision: Subdivision | None) -> None:
        """Draw a run onto the dome, in patches if it needs them, and leave its last attributes current."""
        if subdivision is None or not subdivide(run, context, self, subdivision, parts_of(run)):
            self.draw_whole(run, context.draw)
        self.make_current(run)

    def draw(self, run: Run, made: Making) -> None:
        """Draw a run from arrays, and leave its last attributes current."""
        self.draw_whole(run, made)
        self.make_current(run)

    def make_current(self, run: Run) -> None:
        """Set each attribute to what the run set it to last."""
        for name, value in run.last:
            self._setters[name](*value)

    @staticmethod
    def _as_given(recorder: Immediate, *, compiling: bool) -> bool:
        if len(recorder.positions) <= 3 * _FEW or recorder.extras:
            return True
        return compiling and recorder.sets_late

    # As arrays.

    @contextmanager
    def _uploaded(self, run: Run) -> Iterator[None]:
        """Within it, GL's arrays are the run's; after it, the program's own again."""
        gl = self._driver
        program_object, program_buffer = gl.integer(_VERTEX_ARRAY_BINDING), gl.integer(_ARRAY_BUFFER_BINDING)
        for name, value in run.constant:
            self._setters[name](*value)
        self._bind_own()
        self._upload(run)
        try:
            yield
        finally:
            gl.glBindVertexArray(program_object)
            gl.glBindBuffer(_ARRAY_BUFFER, program_buffer)

    def draw_all(self, mode: int, run: Run, made: Making = at_once) -> None:
        """Draw all of a run's vertices by one mode."""
        with self._uploaded(run):
            made(partial(self._draw_in_batches, mode, len(run.positions)))

    def draw_whole(self, run: Run, made: Making = at_once) -> None:
        """Draw the run's blocks as they are."""
        with self._uploaded(run):
            made(partial(self._draw_blocks, run.blocks))

    def _draw_in_batches(self, mode: int, count: int) -> None:
        size = _BATCH if mode == _PATCHES else count
        firsts = list(range(0, count, size or 1))
        self._draw_parts(mode, firsts, [min(size, count - first) for first in firsts])

    def _draw_blocks(self, blocks: tuple[Block, ...]) -> None:
        for mode, firsts, counts in _draws(blocks):
            self._draw_parts(mode, firsts, counts)

    def _draw_parts(self, mode: int, firsts: list[int], counts: list[int]) -> None:
        gl, count = self._driver, len(firsts)
        if count == 1:
            gl.glDrawArrays(mode, firsts[0], counts[0])
        elif count:
            gl.glMultiDrawArrays(mode, (c_int * count)(*firsts), (c_int * count)(*counts), count)

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
        if name in PIECE_ATTRIBUTES:
            (gl.glEnableVertexAttribArray if on else gl.glDisableVertexAttribArray)(PIECE_ATTRIBUTES[name])
        elif name != "vertex" and name not in _ARRAYS:
            active = gl.integer(_CLIENT_ACTIVE_TEXTURE)
            gl.glClientActiveTexture(_TEXTURE0 + _unit(name))
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
            case "place" | "weights" | "pieces":
                size = {"place": 4, "weights": 3, "pieces": 1}[name]
                gl.glVertexAttribPointer(PIECE_ATTRIBUTES[name], size, _FLOAT, 0, 0, data)
            case name:
                active = gl.integer(_CLIENT_ACTIVE_TEXTURE)
                gl.glClientActiveTexture(_TEXTURE0 + _unit(name))
                gl.glTexCoordPointer(4, _FLOAT, 0, data)
                gl.glClientActiveTexture(active)

    def completed(self, run: Run) -> Run:
        """The run with every attribute of every vertex known."""
        return replace(run, attributes={n: self._filled(n, values) for n, values in run.attributes.items()})

    def _filled(self, name: str, values: NDArray[np.float32]) -> NDArray[Any]:
        """Rows of nan become the value that is current now."""
        if np.isnan(values[:, 0]).any():
            values = np.where(
                np.isnan(values), current_value(self._driver, name, values.shape[1]), values
            ).astype(np.float32)
        return values.astype(np.uint8) if name == "edge" else values


def _subdivision_of_few(recorder: Immediate, context: DomeContext) -> Subdivision | None:
    """What a few vertices need to keep the tolerance."""
    if not recorder.blocks or recorder.extras or not context.subdividing.minds_edges:
        return None
    extent = Extent.unknown() if recorder.has_w else Extent.of_few(recorder.positions)
    return context.subdividing.subdivision(extent)


def _draws(blocks: tuple[Block, ...]) -> Iterator[tuple[int, list[int], list[int]]]:
    """(mode, firsts, counts) of each draw: stretches of one mode in a row go together."""
    for mode, group in groupby(stretches(blocks), key=itemgetter(0)):
        together = list(group)
        yield mode, [first for _, first, _ in together], [count for _, _, count in together]


def _unit(name: str) -> int:
    """The unit whose texture coordinates carry an attribute that has no array of its own."""
    return int(name[-1]) if name.startswith("texture") else MATERIAL_UNITS[name.split()[1]]
