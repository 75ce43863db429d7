"""What GL or GLU evaluates is drawn like any other run: curves, surfaces, blocks with points of them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from typing import TYPE_CHECKING

from domeshim.draw.catcher import OLDEST_GL
from domeshim.draw.evaluated import Evaluated, Evaluator
from domeshim.draw.hull import mesh_extent
from domeshim.draw.listed import ListedDraw
from domeshim.draw.replay import inside_block, replay
from domeshim.draw.subdivide import subdivision_of
from domeshim.record.immediate import Immediate
from domeshim.record.runs import Run
from domeshim.state.context import CURRENT_AND_LIGHTING_BITS, DomeContext

if TYPE_CHECKING:
    from domeshim.draw.submit import Submitter
    from domeshim.record.lists import DisplayLists

_POLYGON_BIT, _FRONT_AND_BACK, _LINE = 0x0008, 0x0408, 0x1B01


class EvaluatedDraws:
    """Draws what GL evaluates, in one context; in a display list GL is asked at each call."""

    def __init__(self, context: DomeContext, submitter: Submitter, lists: DisplayLists) -> None:
        self._context = context
        self._submitter = submitter
        self._lists = lists
        self._evaluator = Evaluator(context.driver)
        self.nurbs_begun = False
        """GLU is between the beginning and the end of a curve or surface."""

    def draw_mesh(self, draw: Callable[[], object], kind: Evaluated | None, limits: Sequence[int]) -> None:
        """Make a draw of glEvalMesh; limits: the steps of the grid from which and to which it goes."""
        extent = mesh_extent(self._context.driver, limits) if kind is not None and self._asks else None
        if extent is not None and kind == "triangles":
            extent = extent._replace(shortest_line=math.inf)
        whole = extent is not None and self._context.subdividing.subdivision(extent) is None
        self.draw(draw, None if whole else kind)

    def draw(self, draw: Callable[[], object], kind: Evaluated | None) -> None:
        """Make a draw that may be made more than once; kind: what it makes, None: nothing to subdivide."""
        if kind is None or not self._asks:
            self._context.draw(draw)
        elif kind == "outlines":
            self._draw_run(self._evaluator.run(draw, "lines"))
            triangles = self._evaluator.run(draw, "triangles")
            with self._outlined():  # which the call itself says as well, and takes back
                self._draw_run(triangles)
        else:
            self._draw_run(self._evaluator.run(draw, kind))

    @contextmanager
    def _outlined(self) -> Iterator[None]:
        gl = self._context.driver
        gl.glPushAttrib(_POLYGON_BIT)
        gl.glPolygonMode(_FRONT_AND_BACK, _LINE)
        yield
        gl.glPopAttrib()

    def draw_once(self, draw: Callable[[], object], kind: Evaluated) -> None:
        """The same where the call may be made but once: GL keeps what it makes in a list."""
        lists, gl = self._lists, self._context.driver

        def made(name: int) -> None:
            self.draw(partial(gl.glCallList, name), kind)

        if lists.building is not None:
            lists.keep_mesh(lambda: ListedDraw(lists.compile(draw), made))
            return
        self._context.undress()  # the sampling goes by the program's own window
        name = lists.compile(draw)
        made(name)
        gl.glDeleteLists(name, 1)

    def draw_block(self, recorder: Immediate) -> None:
        """Draw recorded blocks in which GL is to evaluate vertices."""
        if self._lists.building is not None:
            self._lists.keep(lambda: self._draw_block(recorder))
        else:
            self._draw_block(recorder)

    def _draw_block(self, recorder: Immediate) -> None:
        context, setters = self._context, self._submitter.setters
        run = None
        if self._asks:
            with inside_block(context):
                run = self._evaluator.block_run(recorder, setters)
        if run is None:
            context.draw(inside_block(context)(lambda: replay(context.driver, recorder, setters)))
        else:
            self._draw_run(run)

    @property
    def _asks(self) -> bool:
        """How long the edges are that GL makes now is of interest, and GL can tell."""
        context = self._context
        if not context.subdividing.minds_edges or context.own.current is not None:
            return False
        if context.driver.version >= OLDEST_GL:
            return True
        context.say_once("this OpenGL cannot say what it evaluates: long edges of its surfaces stay straight")
        return False

    def _draw_run(self, run: Run) -> None:
        """Draw it; what is current stays so."""
        if len(run.positions):
            gl, context = self._context.driver, self._context
            gl.glPushAttrib(CURRENT_AND_LIGHTING_BITS)
            self._submitter.draw_as_needed(run, context, subdivision_of(run, context))
            gl.glPopAttrib()
