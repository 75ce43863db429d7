"""A recorded run goes to GL: a few vertices as they were given, more of them as arrays in a few draws."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from ctypes import ArgumentError
from functools import partial
from typing import TYPE_CHECKING

from domeshim.draw.current import current_setters
from domeshim.draw.extent import Extent
from domeshim.draw.own_patches import Parts, draw_parts, own_parts
from domeshim.draw.patches import POINTS, Indices, kind_of
from domeshim.draw.primitives import extent_of, many_primitives, taken
from domeshim.draw.quads import few_as_quads
from domeshim.draw.replay import replay
from domeshim.draw.replay_pieces import drawing_of, knows_all
from domeshim.draw.subdivide import (
    Making,
    at_once,
    is_flat,
    patch_for,
    shader_subdivides,
    subdivide,
    subdivision_of,
)
from domeshim.draw.upload import Upload, completed
from domeshim.driver import Driver
from domeshim.record.immediate import Immediate
from domeshim.record.runs import Run

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext
    from domeshim.state.subdivision import Subdivision

_FEW = 24
"""Up to so many vertices GL's own glVertex costs less than arrays."""


class Submitter:
    """Draws recorded runs in one context, through a vertex array object of its own."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._stream = Upload(driver)
        self.setters = current_setters(driver)
        """What makes each attribute's value current, by its name."""

    def submit(self, recorder: Immediate, context: DomeContext, *, compiling: bool = False) -> None:
        """Draw what was recorded and leave the last attributes current, as GL itself would have.

        compiling: into a display list, where an attribute's current value is not known yet.
        """
        try:
            self._submit(recorder, context, compiling=compiling)
        except (TypeError, ArgumentError):
            try:
                recorder.settle()  # which says what is no number
            finally:
                recorder.clear()
            raise

    def _submit(self, recorder: Immediate, context: DomeContext, *, compiling: bool) -> None:
        few = self._as_given(recorder, compiling=compiling)
        if few and not recorder.plain:
            recorder.settle()
        if few and not compiling and not recorder.extras and self._submit_few_own(recorder, context):
            return
        subdivision = _subdivision_of_few(recorder, context) if few else None
        if few and subdivision is None:
            self.replay(recorder, context.draw if recorder.blocks else at_once)
            return
        if subdivision is not None and self._replay_pieces(recorder, context, subdivision):
            return
        run = recorder.take()
        if not few and not compiling:
            subdivision = subdivision_of(run, context)
        self.draw_as_needed(run, context, subdivision)

    def _submit_few_own(self, recorder: Immediate, context: DomeContext) -> bool:
        parts = own_parts(context, recorder.blocks, partial(_extent_of_few, recorder))
        if parts is None:
            return False
        run = recorder.take()
        self._draw_parts(run, context, parts)
        self.make_current(run)
        return True

    def draw_own(self, run: Run, context: DomeContext) -> bool:
        """Draw a run by the program's own shader, subdivided; False where it is to be drawn whole."""
        parts = own_parts(context, run.blocks, partial(extent_of, run))
        if parts is not None:
            self._draw_parts(run, context, parts)
        return parts is not None

    def _draw_parts(self, run: Run, context: DomeContext, parts: Parts) -> None:
        with self._uploaded(run) as upload:
            draw_parts(context, parts, upload.draw_some)

    def replay(self, recorder: Immediate, made: Making = at_once) -> None:
        """Make the recorded calls one by one; made: makes the draw, once for each view."""
        try:
            made(lambda: replay(self._driver, recorder, self.setters))
        finally:
            recorder.clear()

    def _replay_pieces(self, recorder: Immediate, context: DomeContext, subdivision: Subdivision) -> bool:
        """Draw a few vertices to be subdivided by a shader; False where that is not all they need."""
        blocks, alike = recorder.blocks, recorder.alike
        kinds = [kind_of(block.mode) for block in blocks]
        if recorder.rare or not shader_subdivides(kinds, context, subdivision):
            return False
        if not alike and not knows_all(recorder):
            return False
        # Nothing is split here: no w changes, so parallelograms may be quads.
        by_quads = "triangles" in kinds and not recorder.has_w and subdivision.method == "tessellate"
        flat = by_quads and is_flat(context)
        for block, kind in zip(blocks, kinds, strict=True):
            order = None
            if kind == "triangles" and by_quads:
                count = block.end - block.first
                order = few_as_quads(block.mode, recorder.positions, block.first, count, flat=flat)
            patch = None if kind == "points" else patch_for("quads" if order else kind, subdivision)
            mode = POINTS if patch is None else patch.mode
            context.draw(drawing_of(self._driver, recorder, self.setters, block, mode, order), patch)
        if alike:
            recorder.clear()  # all is current already
        else:
            self.skip(recorder)
        return True

    def skip(self, recorder: Immediate) -> None:
        """Leave out the draws, and leave the last attributes current."""
        for name, events in recorder.used:
            self.setters[name](*events.last)
        recorder.clear()

    def draw_as_needed(self, run: Run, context: DomeContext, subdivision: Subdivision | None) -> None:
        """Draw a run onto the dome, in patches if it needs them, and leave its last attributes current."""
        if self.draw_own(run, context):
            self.make_current(run)
            return
        if subdivision is None or not subdivide(run, context, self, subdivision, many_primitives(run)):
            self.draw_whole(run, context.draw)
        self.make_current(run)

    def draw(self, run: Run, made: Making) -> None:
        """Draw a run from arrays, and leave its last attributes current."""
        self.draw_whole(run, made)
        self.make_current(run)

    def make_current(self, run: Run) -> None:
        """Set each attribute to what the run set it to last."""
        for name, value in run.last:
            self.setters[name](*value)

    @staticmethod
    def _as_given(recorder: Immediate, *, compiling: bool) -> bool:
        if len(recorder.positions) <= 3 * _FEW or recorder.extras:
            return True
        return compiling and recorder.sets_late

    def set_constant(self, run: Run) -> None:
        """Set what is the same for every vertex of the run, before it is drawn."""
        for name, value in run.constant:
            self.setters[name](*value)

    # As arrays.

    @contextmanager
    def _uploaded(self, run: Run) -> Iterator[Upload]:
        """Within it, GL's arrays are the run's; after it, the program's own again."""
        self.set_constant(run)
        with self._stream.bound(run):
            yield self._stream

    def draw_all(self, mode: int, run: Run, made: Making = at_once) -> None:
        """Draw all of a run's vertices by one mode."""
        with self._uploaded(run) as upload:
            made(partial(upload.draw_all, mode, len(run.positions)))

    def draw_whole(self, run: Run, made: Making = at_once) -> None:
        """Draw the run's blocks as they are."""
        with self._uploaded(run) as upload:
            made(partial(upload.draw_blocks, run.blocks))

    def draw_some(self, mode: int, run: Run, indices: Indices, made: Making = at_once) -> None:
        """Draw those of a run's vertices by one mode."""
        self.draw_all(mode, taken(run, indices), made)

    def completed(self, run: Run) -> Run:
        """The run with every attribute of every vertex known."""
        return completed(self._driver, run)


def _subdivision_of_few(recorder: Immediate, context: DomeContext) -> Subdivision | None:
    """What a few vertices need to keep the tolerance."""
    if not recorder.blocks or recorder.extras or not context.subdividing.minds_edges:
        return None
    return context.subdividing.needed(_extent_of_few(recorder))


def _extent_of_few(recorder: Immediate) -> Extent:
    return Extent.unknown() if recorder.w else Extent.of_few(recorder.positions)
