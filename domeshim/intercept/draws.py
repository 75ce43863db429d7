"""What the program draws into the current window: recorded, and drawn when GL must see it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property, partial
from typing import TYPE_CHECKING

import numpy as np

from domeshim.draw.extent import Extent
from domeshim.draw.listed import ListedDraw, ListedMesh
from domeshim.draw.materials import material_run
from domeshim.draw.replay import inside_block
from domeshim.draw.subdivide import at_once
from domeshim.draw.submit import Submitter
from domeshim.driver import Driver
from domeshim.record.bitmaps import Bitmap, Unpacking, Written, read_bitmap
from domeshim.record.immediate import Immediate
from domeshim.record.lists import Building, DisplayLists
from domeshim.record.runs import Run
from domeshim.state.context import DomeContext

if TYPE_CHECKING:
    from domeshim.draw.evaluated_draws import EvaluatedDraws
    from domeshim.draw.shape import Shape
    from domeshim.intercept.window_dome import WindowDome
    from domeshim.record.arrays import Elements
    from domeshim.session import Session


_MESHES_OF_A_LIST = 64
"""A list of more pieces keeps the rest as GL's own, for each piece costs its own decision."""


class Draws:
    """The draws of a session, and the recorder that its windows share."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._driver = (session.make_driver or Driver)()
        self._current: WindowDome | None = None
        self.recorder = Immediate()
        self.context: DomeContext | None = None
        """The context that the program's GL calls go to; None before its first window."""
        self.lists: DisplayLists | None = None
        """That context's display lists."""
        self.building: Building | None = None
        """The one of them that is being built."""
        self._unpacking: Unpacking | None = None
        """How GL is told to read the bits of the bitmaps that are recorded, once it was asked."""

    def drawing(self) -> None:
        """The program draws something that is not recorded."""
        self._session.drawing()

    def flush(self) -> None:
        """Let GL see what has been recorded, before anything else happens to it."""
        recorder, current = self.recorder, self._current
        if recorder.block is not None:
            return  # between glBegin and glEnd nothing may come in between
        if current is None:
            self._flush_unbent(recorder)
            return
        if recorder.bitmaps:
            self._flush_bitmaps(current)
            if not recorder.pending():
                return
        if recorder.blocks:
            self._session.drawing()
            if recorder.materials:
                self._flush_materials(current)
                return
        left_out = current.context.aside.passing and self.building is None
        if left_out and recorder.blocks and not recorder.extras:
            current.context.draw(lambda: current.submitter.skip(recorder))
        elif recorder.extras:
            self._flush_extras(current)
        elif self.building is not None and self._keeps(self.building):
            self.keep_mesh(recorder.take())
        elif self.building is None:
            current.submitter.submit(recorder, current.context)
        else:
            self.building.used = True
            draw = partial(current.submitter.submit, recorder, current.context, compiling=True)
            if not recorder.blocks or not self.listed(draw):
                draw()

    def _flush_unbent(self, recorder: Immediate) -> None:
        """Draw as on the monitor into a window that we have not heard of, where there is one."""
        from OpenGL.platform import PLATFORM  # noqa: PLC0415 - not before the program has imported OpenGL

        if self._session.window is None and PLATFORM.GetCurrentContext():
            self._unbent.replay(recorder)
        else:
            recorder.clear()

    @cached_property
    def _unbent(self) -> Submitter:
        return Submitter(self._driver)

    def _flush_extras(self, current: WindowDome) -> None:
        """Draw blocks in which calls were made that set no attribute."""
        recorder = self.recorder
        if recorder.evaluates and current.context.subdividing.may_subdivide:
            current.evaluated.draw_block(recorder.moved())
        else:
            current.submitter.replay(recorder, self._draw_inside_block)

    def _draw_inside_block(self, draw: Callable[[], object]) -> None:
        """Make a draw that is between glBegin and glEnd all the while."""
        assert self.context is not None
        inside = inside_block(self.context)(draw)
        if not self.listed(inside):
            self.context.draw(inside)

    def _keeps(self, building: Building) -> bool:
        """What was recorded for a display list becomes a mesh of its own there."""
        recorder, current = self.recorder, self._current
        assert current is not None
        return bool(recorder.blocks) and not recorder.sets_late and self._takes_mesh(building, current)

    @staticmethod
    def _takes_mesh(building: Building, current: WindowDome) -> bool:
        """A display list has room for one more mesh of its own."""
        return building.meshes < _MESHES_OF_A_LIST and current.context.subdividing.may_subdivide

    def keep_mesh(self, run: Run) -> None:
        """Put a run into the display list that is being built, to be drawn as each call's view needs."""
        current, building = self._current, self.building
        assert current is not None
        assert building is not None
        building.meshes += 1
        current.lists.keep_mesh(lambda: ListedMesh(run, current.context, current.submitter, current.lists))

    def listed(self, draw: Callable[[], object], *, at_raster: bool = False) -> bool:
        """Put a draw into the display list that is being built, as a part of its own; whether that is due.

        It is where a draw is made more than once.
        """
        current = self._current
        if self.building is None or current is None or not current.context.several:
            return False
        context, lists = current.context, current.lists

        def raster(name: int) -> object:
            return context.raster.draw(partial(context.driver.glCallList, name))

        made = raster if at_raster else context.draw_list
        lists.keep_mesh(lambda: ListedDraw(lists.compile(draw), made))
        return True

    def draw_arrays(self, mode: int, indices: range | Elements) -> bool:
        """Draw from the program's vertex arrays where that needs more than GL's own draw; False where not."""
        current = self._current
        if current is None:
            return False
        draw = current.arrays.draw(mode, indices, current.context.scene.texture_units)
        if draw is None:
            return False
        if self.building is not None:
            if not self._takes_mesh(self.building, current):
                return False
            self.keep_mesh(draw.read())
            return True
        return current.array_draws.subdivide(draw)

    def draw_own(self, mode: int, vertices: Callable[[], range | Elements]) -> bool:
        """Draw from arrays by the program's own shader, subdivided; False where GL's own draw will do."""
        current = self._current
        if current is None or self.building is not None or not current.context.subdividing.subdivides_own:
            return False
        context, indices = current.context, vertices()
        own, placed = context.own.current, None
        if own is not None and own.fixed_place:
            placed = current.arrays.draw(mode, indices, context.scene.texture_units)
        return current.array_draws.subdivide_own(mode, indices, placed, current.arrays)

    def draw_run(self, run: Run, extent: Extent | None) -> None:
        """Draw what the program asks for whole, and leave its last attributes current.

        extent: the run's own, or None where it has no edges.
        """
        if self.recorder.pending():
            self.flush()
        current = self._current
        assert current is not None
        context, building = current.context, self.building
        self._session.drawing()
        if building is not None:
            if any(np.isnan(values[0]).any() for values in run.attributes.values()):
                current.lists.keep(lambda: self.draw_run(run, extent))
                return
            if self._takes_mesh(building, current):
                self.keep_mesh(run)
                return
            building.used = True
            if self.listed(partial(current.submitter.draw, run, at_once)):
                return
        subdivision = context.subdividing.subdivision(extent) if extent is not None else None
        current.submitter.draw_as_needed(run, context, subdivision)

    def draw_shape(self, shape: Shape) -> bool:
        """Draw a shape that is in memory; False between glBegin and glEnd, and where there is no window."""
        current, building = self._current, self.building
        if current is None or self.recorder.block is not None:
            return False
        if self.recorder.pending():
            self.flush()
        context = current.context
        draw = partial(shape.draw, self._driver)
        self._session.drawing()
        if building is not None:
            if self._takes_mesh(building, current):
                self.keep_mesh(shape.run)
                return True
            building.used = True
            if self.listed(draw):
                return True
        if current.submitter.draw_own(shape.run, context):
            return True
        extent = shape.extent
        subdivision = context.subdividing.subdivision(extent) if extent is not None else None
        if subdivision is None:
            context.draw(draw)
        else:
            current.submitter.draw_as_needed(shape.run, context, subdivision)
        return True

    def write(self, bitmaps: Sequence[Bitmap]) -> bool:
        """Record bitmaps, one after the other; False between glBegin and glEnd, and without a window."""
        recorder = self.recorder
        if self._current is None or recorder.block is not None:
            return False
        if recorder.blocks:
            self.flush()
        recorder.bitmaps += bitmaps
        return True

    def write_bits(self, width: int, height: int, numbers: tuple[float, ...], bits: object) -> bool:
        """Record a glBitmap by its own arguments; False where that is for GL alone.

        numbers: xorig, yorig, xmove, ymove. While bitmaps follow each other nothing else happens to GL, so
        that it is asked but once how bits are to be read.
        """
        if self._unpacking is None:
            self._unpacking = Unpacking.asked(self._driver)
            if self._unpacking is None:
                return False
        bitmap = read_bitmap(width, height, numbers, bits, self._unpacking)
        return bitmap is not None and self.write((bitmap,))

    def _flush_bitmaps(self, current: WindowDome) -> None:
        """Draw the recorded bitmaps, or put them into the display list that is being built."""
        bitmaps = tuple(self.recorder.bitmaps)
        self.recorder.bitmaps.clear()
        self._unpacking = None
        if self.building is not None:
            current.lists.keep(Written(bitmaps, self._write_now))
        else:
            self._write_now(bitmaps)

    def _write_now(self, bitmaps: Sequence[Bitmap]) -> None:
        assert self.context is not None
        self._session.drawing()
        self.context.panel.write(bitmaps)

    @property
    def evaluated(self) -> EvaluatedDraws | None:
        """Draws what GL evaluates, which the program does now; None without a window."""
        current = self._current
        if current is None:
            return None
        self._session.drawing()
        return current.evaluated

    def read_elements(self, count: int, kind: int, indices: object) -> Elements:
        """glDrawElements' indices, wherever they lie."""
        assert self._current is not None
        return self._current.arrays.elements(count, kind, indices)

    def buffers_changed(self) -> None:
        """The program has written to a buffer or deleted one."""
        if self._current is not None:
            self._current.array_draws.buffers_changed()

    def _flush_materials(self, current: WindowDome) -> None:
        """Draw a run in which materials change inside primitives; in a display list, when it is called."""
        recorder, context = self.recorder, current.context
        if self.building is None and not context.bends:
            current.submitter.replay(recorder, context.draw)
            return
        run, face, exact = material_run(recorder.take())
        if not exact:
            context.say_once(
                "glMaterial gave the faces unlike materials between glBegin and glEnd; the front's is used"
            )

        def draw() -> None:
            context.scene.vertex_material = face
            context.scene.stale.add("lighting")
            current.submitter.draw(run, context.draw)
            context.scene.vertex_material = None
            context.scene.stale.add("lighting")

        if self.building is None:
            draw()
        else:
            current.lists.keep(draw)
