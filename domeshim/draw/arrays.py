"""Draws from vertex arrays that need more than GL's own draw."""

from __future__ import annotations

from typing import TYPE_CHECKING

from domeshim.draw.extent import Extent
from domeshim.draw.primitives import Parts, extent_of, parts_of
from domeshim.draw.subdivide import subdivide

if TYPE_CHECKING:
    from domeshim.draw.submit import Submitter
    from domeshim.record.arrays import ArrayDraw
    from domeshim.record.runs import Run
    from domeshim.state.context import DomeContext

_MOST_KEPT = 1024


class ArrayDraws:
    """The array draws of one context: how large each is, and what of them was read from buffers."""

    def __init__(self, context: DomeContext, submitter: Submitter) -> None:
        self._context = context
        self._submitter = submitter
        self._extents: dict[object, Extent | None] = {}
        self._runs: dict[object, tuple[Run, Parts | None]] = {}

    def buffers_changed(self) -> None:
        """The program has written to a buffer or deleted one."""
        self._extents.clear()
        self._runs.clear()

    def subdivide(self, draw: ArrayDraw) -> bool:
        """Draw in patches where an edge is too long for one piece; False where GL's own draw will do."""
        run = None
        if draw.key not in self._extents:
            if len(self._extents) >= _MOST_KEPT:
                self.buffers_changed()
            run = draw.read()
            self._extents[draw.key] = extent_of(run)
        extent = self._extents[draw.key]
        subdivision = self._context.subdividing.subdivision(extent) if extent is not None else None
        if subdivision is None:
            return False
        if draw.key in self._runs:
            run, parts = self._runs[draw.key]
        else:
            run = run or draw.read()
            parts = parts_of(run)
            if draw.buffered:
                self._runs[draw.key] = run, parts
        return subdivide(run, self._context, self._submitter, subdivision, parts)
