"""What has a place in the program's window: where that is in the frame, and what a clear takes of it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

from domeshim.draw.over import way_cleared
from domeshim.options import Options
from domeshim.state.perspective import planar
from domeshim.state.raster import Point
from domeshim.state.scissor import Edges, edges_of, in_view
from domeshim.state.whereabouts import Seen
from domeshim.window.frame import Rectangle

if TYPE_CHECKING:
    from domeshim.draw.clear import PartClear
    from domeshim.state.context import DomeContext
    from domeshim.state.monitor_raster import Raster
    from domeshim.state.pointer import Sight
    from domeshim.state.region import Region
    from domeshim.state.shown import Shown

_KEPT = 4
"""So many areas of the window that a program copies are remembered."""
_SCISSOR_TEST, _COLOR_BUFFER_BIT = 0x0C11, 0x4000


class WindowPixels:
    """The pixels of the window that one context's program believes in."""

    def __init__(self, context: DomeContext, options: Options) -> None:
        self._context = context
        self._options = options
        self._region: tuple[object, Region] | None = None
        """The last answer, and what it depends on."""
        self._shown: dict[object, Shown] = {}
        """The last answers, by what they depend on."""
        self._flat: tuple[Seen, Seen, Rectangle] | None = None
        """What was seen last, and what was made of it."""

    @property
    def placed(self) -> bool:
        """A place in the program's window is another one in the frame."""
        return not self._context.compiling and not self._context.aside.bypassed

    def flat(self, seen: Seen) -> tuple[Seen, Rectangle]:
        """Where things of the window's own pixels belong, and in which viewport: that of all the window."""
        if self._flat is None or self._flat[0] is not seen:
            around, frame = self._around(seen.viewport), self._context.frame
            placement, edges = self._context.placer.panel(around, frame), edges_of(seen.scissor, around)
            self._flat = seen, replace(seen, placement=placement, edges=edges), around
        return self._flat[1:]

    def _around(self, viewport: Rectangle) -> Rectangle:
        """The program's window, and what of a viewport is beyond it."""
        x, y, width, height = viewport
        whole_width, whole_height = self._context.frame.program_size
        left, bottom = min(x, 0), min(y, 0)
        return left, bottom, max(x + width, whole_width) - left, max(y + height, whole_height) - bottom

    def positions(self, x: float, y: float, depth: float) -> list[Point | None]:
        """Where a point of the program's window, and the depth there, are in each view; None: hidden."""
        context = self._context
        placement, frame, canvas = context.seen.placement, context.frame, context.canvas
        if context.placer.has_perspective and self._options.hud == "off":
            return [None]
        if context.placer.has_perspective and self._options.flat_hud:
            corner = (round(x), round(y), 0, 0)
            return [(*frame.flat(corner, eye)[:2], depth) for eye in range(len(frame.parts))]
        main = context.placer.through_window(frame)
        direction = main.direction(x, y)
        a, b = planar(placement.depth) if canvas.kind == "face" else placement.depth
        found: list[Point | None] = []
        for place in canvas.places(main.turn @ direction):
            there = depth
            if place is not None and placement.place != "panel":
                there = (a + b / (main.distance(depth, direction) * place[2]) + 1) / 2
            found.append((place[0], place[1], there) if place is not None else None)
        return found

    @property
    def sight(self) -> Sight:
        """How the program's window lies on the dome, by the last main view that was drawn."""
        from domeshim.state.pointer import Sight  # noqa: PLC0415 - only a program that is pointed at pays

        context = self._context
        view = context.placer.through_window(context.frame)
        paper = self._options.method == "paper"
        return Sight(view, context.frame, context.lens, context.orientation, paper)

    def shown(self, area: Rectangle) -> Shown:
        """Where the frame shows what is drawn now in an area of the program's window."""
        from domeshim.state.shown import Shown, middles  # noqa: PLC0415 - few programs copy

        frame, sight = self._context.frame, self.sight
        flat = self._context.seen.placement.hud and self._options.flat_hud
        key = (*_outlook(sight), flat, area)
        if key not in self._shown:
            places = frame.to_flat(middles(area)) if flat else sight.to_frame(middles(area))
            self._shown = dict([*self._shown.items()][1 - _KEPT :]) | {
                key: Shown(sight, places, bent=not flat)
            }
        return self._shown[key]

    @property
    def raster(self) -> Raster | None:
        """The raster position in the program's window; None where GL's own is the answer."""
        from domeshim.state.monitor_raster import monitor_raster  # noqa: PLC0415 - hardly any program asks

        return monitor_raster(self._context, self._options)

    @property
    def fills_dome(self) -> bool:
        """The program's window is a main view, though it lies inside another."""
        frame = self._context.frame
        return self._context.placer.fills_dome and frame.covers_most((0, 0, *frame.program_size))

    def region(self, part: Rectangle) -> Region | None:
        """Which pixels of the frame show this part of the program's window; None: none do."""
        from domeshim.state.region import Region, region_of  # noqa: PLC0415 - with windows inside others

        frame, placer = self._context.frame, self._context.placer
        if self.fills_dome:
            return Region((0, 0, *frame.size))
        if placer.has_perspective and self._options.hud == "off":
            return None
        if placer.has_perspective and self._options.flat_hud:
            return Region(frame.flat(part))
        sight = self.sight
        key = (*_outlook(sight), part)
        if self._region is None or self._region[0] != key:
            self._region = key, region_of(sight, part)
        return self._region[1]

    # Clearing; the context must be undressed.

    @property
    def scissor_cuts(self) -> bool:
        """The program's scissor leaves out a part of its window."""
        width, height = self._context.frame.program_size
        x, y, w, h = self._context.seen.scissor or (0, 0, width, height)
        return x > 0 or y > 0 or x + w < width or y + h < height

    @contextmanager
    def unscissored(self) -> Iterator[None]:
        """Within it a scissor that leaves out nothing of the program's window does so of the frame."""
        if self._context.seen.scissor is None:
            yield
            return
        self._context.driver.glDisable(_SCISSOR_TEST)
        try:
            yield
        finally:
            self._context.driver.glEnable(_SCISSOR_TEST)

    def blacken_sides(self) -> None:
        """Beside the disc, where a HUD is drawn that the audience does not see, nothing else is."""
        frame, gl = self._context.frame, self._context.driver
        if not frame.aside:
            return
        x, y, side, high = frame.square
        width, height = frame.size
        left, right = (0, 0, x, height), (x + side, 0, width - x - side, height)
        below, above = (0, 0, width, y), (0, y + high, width, height - y - high)
        with way_cleared(gl):
            gl.glEnable(_SCISSOR_TEST)
            gl.glColorMask(1, 1, 1, 1)
            gl.glClearColor(0.0, 0.0, 0.0, 1.0)
            for part in (left, right, below, above):
                if part[2] > 0 and part[3] > 0:
                    gl.glScissor(*part)
                    gl.glClear(_COLOR_BUFFER_BIT)

    def clear_part(self, mask: int) -> None:
        """glClear what the scissor leaves of the program's window."""
        context = self._context
        placement, scissor, edges = context.seen.placement, context.seen.scissor, context.seen.edges
        main = context.placer.through_window(context.frame)
        if edges.empty or scissor is None or context.hides(placement):
            return
        if placement.hud and self._options.flat_hud:
            for eye in range(len(context.frame.parts)):
                context.driver.glScissor(*context.frame.flat(scissor, eye))
                context.driver.glClear(mask)
            context.driver.glScissor(*scissor)
            return
        if placement.place == "panel":
            edges = Edges(in_view(scissor, main.viewport), (0, 1, 2, 3))
        self._part_clear.clear(mask, context.canvas, main.camera[[0, 1, 3], :3] @ main.turn.T, edges)
        context.canvas.drawn((0.0, 0.0))

    @cached_property
    def _part_clear(self) -> PartClear:
        from domeshim.draw.clear import PartClear  # noqa: PLC0415 - only with a scissor

        context = self._context
        keystone = context.frame.keystone
        return PartClear(context.driver, context.lens, context.orientation, keystone)


def _outlook(sight: Sight) -> tuple[object, ...]:
    """What of a sight may change in a context."""
    return sight.view.camera.tobytes(), sight.view.turn.tobytes(), sight.view.viewport, sight.frame
