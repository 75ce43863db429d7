"""The dome as the session sees it: one DomeContext a window, and the one that calls go to now."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cached_property, partial
from typing import TYPE_CHECKING

import numpy as np

from domeshim.draw.arrays import ArrayDraws
from domeshim.draw.card import TestCard
from domeshim.draw.extent import Extent
from domeshim.draw.finishing import Finishing, finishes
from domeshim.draw.listed import ListedDraw, ListedMesh
from domeshim.draw.materials import material_run
from domeshim.draw.rim import Rim
from domeshim.draw.subdivide import at_once
from domeshim.draw.submit import Submitter
from domeshim.driver import Driver
from domeshim.errors import OptionError
from domeshim.lens.keystone import keystone_of
from domeshim.options import Options
from domeshim.record.arrays import ArrayReader, Elements
from domeshim.record.immediate import Immediate, Run
from domeshim.record.lists import Building, DisplayLists
from domeshim.state.comfort import looking_at
from domeshim.state.context import DomeContext
from domeshim.state.region import Region
from domeshim.window.frame import Frame, Rectangle
from domeshim.window.subwindow import SubWindow

if TYPE_CHECKING:
    from domeshim.draw.finish import Finish
    from domeshim.draw.shape import Shape
    from domeshim.lens.mesh import Floats
    from domeshim.session import Session
    from domeshim.window.contract import Window


@contextmanager
def inside_block(context: DomeContext) -> Iterator[None]:
    """GL stands between glBegin and glEnd: nothing of ours comes in, nor PyOpenGL's question for errors."""
    from OpenGL.raw.GL import _errors  # noqa: PLC0415 - not before the program has imported OpenGL

    checker, compiling = _errors._error_checker, context.compiling
    context.compiling = True
    if checker:
        checker.onBegin()
    try:
        yield
    finally:
        context.compiling = compiling
        if checker:
            checker.onEnd()


def _frame(session: Session, window: Window, program_size: tuple[int, int]) -> Frame:
    inside = window.inside if isinstance(window, SubWindow) else None
    options = session.options
    return Frame(
        window.size,
        program_size,
        inside,
        options.stereo,
        options.disc,
        keystone_of(options),
        aside=options.hud == "side",
    )


OLDEST_GL = (3, 0)
"""From here on GLSL has clip distances."""
_MESHES_OF_A_LIST = 64
"""A list of more pieces keeps the rest as GL's own, for each piece costs its own decision."""


class WindowDome:
    """All that the dome keeps for one window."""

    def __init__(
        self, session: Session, driver: Driver, frame: Frame, around: WindowDome | None = None
    ) -> None:
        """around: the outermost window's, where this one lies inside another."""
        main = around.context.placer.main if around else None
        self.context: DomeContext = DomeContext(session.options, frame, driver, main)
        self.lists = DisplayLists(driver, apart=self.context.several)
        self.submitter = Submitter(driver)
        self.arrays = ArrayReader(driver)
        self.array_draws = ArrayDraws(self.context, self.submitter)
        self.rim = Rim(driver)
        self.card = TestCard(driver, session.options)
        self._finish: tuple[Finishing, Finish] | None = None

    def finishing(self, options: Options) -> Finishing:
        """What the projector wants of this window's pictures."""
        if self._finish is None or self._finish[0].frame != self.context.frame:
            return Finishing(options, self.context.frame)
        return self._finish[0]

    def finish(self, options: Options) -> None:
        """Make of the picture in the back buffer what the projector needs; the window must be current."""
        wanted = self.finishing(options)
        if self._finish is None or self._finish[0] is not wanted:
            from domeshim.draw.finish import Finish  # noqa: PLC0415 - moderngl for those alone who need it

            if self._finish is not None:
                self._finish[1].close()
            self._finish = wanted, Finish(self.context.driver, wanted)
        self._finish[1].draw()

    def before_finish(self, place: Floats, options: Options) -> Floats:
        """Where a place (2,) of what is seen was before it was finished."""
        return self.finishing(options).before(place) if finishes(options) else place


class Dome:
    """All windows of a session while the dome is on, and the recorder that they share."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._driver = Driver()
        self._windows: dict[Window, WindowDome] = {}
        self._current: WindowDome | None = None
        self.recorder = Immediate()
        self.context: DomeContext | None = None
        """The context that the program's GL calls go to; None before its first window."""
        self.lists: DisplayLists | None = None
        """That context's display lists."""
        self.building: Building | None = None
        """The one of them that is being built."""

    def window_opened(self, window: Window, program_size: tuple[int, int]) -> None:
        """A window's context was made and is current."""
        self._driver.require(OLDEST_GL)
        around = self._windows.get(window.outermost) if isinstance(window, SubWindow) else None
        frame = _frame(self._session, window, program_size)
        if frame.aside and around is None and 0 in frame.strip()[2:]:
            size = "{}x{}".format(*frame.size)
            raise OptionError(f"DOME_HUD=side: {size} has no room beside the disc; set DOME_FRAME=WxH")
        self._windows[window] = WindowDome(self._session, self._driver, frame, around)
        self.window_current(window)

    def window_current(self, window: Window | None) -> None:
        """The program's GL calls go to this window from now on."""
        self._current = self._windows.get(window) if window is not None else None
        self.context = self._current.context if self._current else None
        self.lists = self._current.lists if self._current else None
        self.building = self.lists.building if self.lists else None
        if self.context is not None:
            self.context.viewport_changed()  # another window may have changed the main view that they share
            self.context.pass_by(self._session.passing)

    def window_resized(self, window: Window, program_size: tuple[int, int]) -> None:
        """The program's window has this size now."""
        context = self._windows[window].context
        self.flush()
        context.undress()
        context.frame = _frame(self._session, window, program_size)
        context.viewport_changed()

    def window_closed(self, window: Window) -> None:
        """The window's context is about to go."""
        closed = self._windows.pop(window, None)
        if closed is not None and closed.context.canvas.framebuffer:
            self._free(closed, window)
        if self._current is closed:
            self.window_current(None)

    def _free(self, closed: WindowDome, window: Window) -> None:
        """Free what a closing window's canvas holds; it need not be the current one."""
        current = self._session.window
        window.make_current()
        closed.context.canvas.close()
        if current is not None and current is not window:
            current.make_current()

    def context_of(self, window: Window) -> DomeContext | None:
        """The dome's side of a window's context; None where its pictures are left as they are."""
        return self._windows[window].context if window in self._windows else None

    def program_place(self, window: Window, x: float, y: float) -> tuple[float, float]:
        """Where the program would see a place of the frame in its window; pixels, origin at the top left."""
        if window not in self._windows:
            return x, y  # its pictures are left as they are
        sight = self._windows[window].context.pixels.sight
        seen = self._windows[window].before_finish(
            np.array([x, sight.frame.size[1] - y]), self._session.options
        )
        place = sight.to_program(seen)
        return float(place[0]), float(sight.frame.program_size[1] - place[1])

    def frame_place(self, window: Window, x: float, y: float) -> tuple[float, float]:
        """Where a place of the program's window is in the frame; pixels, origin at the top left."""
        if window not in self._windows:
            return x, y
        sight = self._windows[window].context.pixels.sight
        place = sight.to_frame(np.array([x, sight.frame.program_size[1] - y]))
        return float(place[0]), float(sight.frame.size[1] - place[1])

    def fills(self, window: Window) -> bool:
        """A window that lies inside another is a main view, which fills the dome."""
        return self._windows[window].context.pixels.fills_dome

    def region(self, window: Window, part: Rectangle) -> Region | None:
        """Which pixels of the frame show this part of a window that lies inside another; None: none do."""
        return self._windows[window].context.pixels.region(part)

    def clearing(self, *, colour: bool) -> None:
        """The program clears a buffer, and the dome does it."""
        self._session.clearing(colour=colour)

    def reading(self) -> None:
        """The program reads pixels of its picture."""
        self._session.reading()

    def look(self, places: Floats) -> None:
        """The program looks on from here; places: (3, 3), gluLookAt's eye, centre and up."""
        context = self.context
        steady = context.placer.steady if context is not None else None
        view = looking_at(*places) if steady is not None else None
        if context is not None and steady is not None and view is not None:
            steady.look(view, self._session.clock.now())
            context.viewport_changed()

    def pass_by(self, on: bool) -> None:
        """Nobody looks at what comes now: leave all draws out, or make them again."""
        self.flush()
        if self.context is not None:
            self.context.pass_by(on)

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
        if recorder.blocks:
            self._session.drawing()
            if recorder.materials:
                self._flush_materials(current)
                return
        if recorder.blocks and current.context.passing and not recorder.extras and self.building is None:
            current.context.draw(lambda: current.submitter.skip(recorder))
        elif recorder.extras:
            current.submitter.replay(recorder, self._draw_inside_block)
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

        It is where a draw is made more than once: what else is in the list must not be.
        """
        current = self._current
        if self.building is None or current is None or not current.context.several:
            return False
        context, lists = current.context, current.lists
        lists.keep_mesh(lambda: ListedDraw(context, lists.compile(draw), at_raster=at_raster))
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

    def draw_run(self, run: Run, extent: Extent | None) -> None:
        """Draw what the program asks for whole, and leave its last attributes current.

        extent: the run's own, or None where it has no edges.
        """
        if self.recorder.pending()():
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
        if self.recorder.pending()():
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
        extent = shape.extent
        subdivision = context.subdividing.subdivision(extent) if extent is not None else None
        if subdivision is None:
            context.draw(draw)
        else:
            current.submitter.draw_as_needed(shape.run, context, subdivision)
        return True

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

    def frame_ending(self, window: Window) -> None:
        """The picture is complete: cut it at the rim."""
        self.flush()
        ended = self._windows[window]
        if ended.context.passing:
            ended.context.undress()
            return
        steady = ended.context.placer.steady
        if steady is not None and steady.blind:
            ended.context.say_once(
                "DOME_MAX_TURN: no gluLookAt tells where the program looks; its view turns freely"
            )
        ended.context.settle()
        ended.rim.draw(ended.context.frame, ended.context.rim)
        ended.card.draw(ended.context.frame)

    def showing(self, window: Window) -> None:
        """The window's back buffer is about to be seen: make of it what the projector needs."""
        shown = self._windows.get(window)
        if shown is None or shown.context.passing or not finishes(self._session.options):
            return
        shown.context.undress()
        shown.finish(self._session.options)

    def toggle_card(self, window: Window) -> bool:
        """Show the test card over the window's pictures, or no longer; False for a window left as it is."""
        if window not in self._windows:
            return False
        self._windows[window].card.toggle()
        return True
