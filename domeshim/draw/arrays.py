"""Draws from vertex arrays that need more than GL's own draw."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.extent import Extent
from domeshim.draw.own_patches import draw_parts, own_parts
from domeshim.draw.primitives import extent_of, many_primitives
from domeshim.draw.standing import AtOnce, Standing
from domeshim.draw.subdivide import subdivide
from domeshim.record.runs import Block

if TYPE_CHECKING:
    from domeshim.draw.submit import Submitter
    from domeshim.record.arrays import ArrayDraw, ArrayReader, Elements
    from domeshim.record.lists import DisplayLists
    from domeshim.state.context import DomeContext

_MOST_KEPT = 1024
_RESTARTS = (0x8F9D, 0x8D69)
_ELEMENT_BUFFER, _ELEMENT_BUFFER_BINDING, _UNSIGNED_INT = 0x8893, 0x8895, 0x1405


class ArrayDraws:
    """The array draws of one context: how large each is, and what of them was read from buffers."""

    def __init__(self, context: DomeContext, submitter: Submitter, lists: DisplayLists) -> None:
        self._context = context
        self._submitter = submitter
        self._lists = lists
        self._extents: dict[object, Extent | None] = {}
        """Of draws from the program's memory, which may be written at any time."""
        self._standing: dict[object, Standing] = {}
        """Draws from buffers, of which all writing is heard of."""
        self._numbers: dict[Elements, NDArray[np.int64]] = {}
        """Of those, by the program's own shader: the vertices' numbers."""

    def buffers_changed(self) -> None:
        """The program has written to a buffer or deleted one."""
        self._extents.clear()
        self._numbers.clear()
        for standing in self._standing.values():
            standing.delete()
        self._standing.clear()

    def subdivide(self, draw: ArrayDraw) -> bool:
        """Draw in pieces where an edge is too long for one; False where GL's own draw will do."""
        if len(self._extents) + len(self._standing) >= _MOST_KEPT:
            self.buffers_changed()
        return self._standing_of(draw).draw() if draw.buffered else self._subdivide_moving(draw)

    def subdivide_own(
        self, mode: int, indices: range | Elements, placed: ArrayDraw | None, reader: ArrayReader
    ) -> bool:
        """Draw by the program's own shader, in pieces; False where GL's own draw will do.

        placed: the draw as far as it is from GL's own arrays, if it is.
        """
        numbers = partial(reader.numbers, indices)
        if isinstance(indices, range):
            count = len(indices)
        else:
            if any(self._context.driver.glIsEnabled(restart) for restart in _RESTARTS):
                return False  # one of the numbers ends a strip
            count = indices.count
            if indices.buffer:
                numbers = partial(self._numbers_in_buffer, indices, reader)
        extent = partial(self._extent_of, placed)
        parts = own_parts(self._context, (Block(mode, 0, count),), extent)
        if parts is not None:
            draw_parts(self._context, parts, partial(self._by_number, cache(numbers)))
        return parts is not None

    def _extent_of(self, placed: ArrayDraw | None) -> Extent | None:
        if placed is None:
            return None
        if placed.key not in self._extents:
            self._extents[placed.key] = extent_of(placed.read())
        return self._extents[placed.key]

    def _numbers_in_buffer(self, elements: Elements, reader: ArrayReader) -> NDArray[np.int64]:
        if elements not in self._numbers:
            self._numbers[elements] = reader.numbers(elements)
        return self._numbers[elements]

    def _standing_of(self, draw: ArrayDraw) -> Standing:
        known = self._standing.get(draw.key)
        if known is None:
            by_number = partial(self._by_number, cache(draw.numbers))
            known = Standing(draw.read, self._context, self._submitter, self._lists, by_number)
            self._standing[draw.key] = known
        return known

    def _subdivide_moving(self, draw: ArrayDraw) -> bool:
        run = None
        if draw.key not in self._extents:
            run = draw.read()
            self._extents[draw.key] = extent_of(run)
        extent = self._extents[draw.key]
        subdivision = self._context.subdividing.subdivision(extent) if extent is not None else None
        if subdivision is None:
            return False
        run = run or draw.read()
        drawer = AtOnce(self._submitter, partial(self._by_number, draw.numbers))
        return subdivide(run, self._context, drawer, subdivision, many_primitives(run))

    def _by_number(
        self, program: Callable[[], NDArray[np.int64]], mode: int, numbers: NDArray[np.uint32]
    ) -> None:
        """Draw from the program's own arrays; program: gives the number there of each vertex of the run."""
        gl = self._context.driver
        chosen = program()[numbers].astype(np.uint32)
        bound = gl.integer(_ELEMENT_BUFFER_BINDING)
        gl.glBindBuffer(_ELEMENT_BUFFER, 0)
        gl.glDrawElements(mode, chosen.size, _UNSIGNED_INT, chosen.ctypes.data)
        gl.glBindBuffer(_ELEMENT_BUFFER, bound)
