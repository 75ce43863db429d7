"""The raster position in each of several views: GL keeps one, and where the others are follows from it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from ctypes import c_float
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext

Point = tuple[float, float, float]
"""x, y in the framebuffer's pixels, and depth, 0 to 1."""

_POSITION, _VALID, _RASTER_COLOR, _COLOR, _DEPTH_RANGE = 0x0B07, 0x0B08, 0x0B04, 0x0B00, 0x0B70
_NEVER_SET = (0.0, 0.0, 0.0, 1.0)
"""Where GL's own beginning puts the position."""
_LIGHTING_BIT = 0x40
_MOST = 4096
"""So many positions are remembered: attribute stacks may bring any of them back."""


class RasterPoints:
    """Makes calls at the raster position in each view of one context."""

    def __init__(self, context: DomeContext) -> None:
        self._context = context
        self._driver = context.driver
        self._known: dict[Point, tuple[Point | None, ...]] = {}

    def set(self, call: Callable[[], object]) -> Any:
        """Make a call that sets the position, in each view, and return its answer.

        GL's position is then where the first view that sees it has it.
        """
        self._context.dress(raster=True)
        views = self._context.views_now
        if not views:
            return call()
        points, result = [], None
        for view in views:
            self._context.worn.show(view)
            result = call()
            points.append(self._now())
        self.move(points)
        return result

    def put(self, points: Sequence[Point | None]) -> None:
        """Set the position to places of the views in the framebuffer; None: out of a view's sight."""
        self._context.dress(raster=True)
        first = next((point for point in points if point is not None), None)
        if first is None:
            self._driver.glRasterPos2f(0.0, 0.0)  # goes nowhere
            return
        self._driver.glWindowPos3f(*first)
        now = self._now()
        if now is not None and len(points) > 1:
            self._known[now] = tuple(points)

    def move(self, points: Sequence[Point | None]) -> None:
        """Move the position on, to places of the views in the framebuffer, with the colour that it has."""
        first = next((point for point in points if point is not None), None)
        if first is None:
            return
        self._move_gl(first)
        if len(self._known) >= _MOST:
            self._known.clear()
        self._known[self._now() or first] = tuple(points)

    def begin(self) -> None:
        """Bring a position that was never set, the corner of the program's window, to where that is seen."""
        gl, pixels = self._driver, self._context.pixels
        if not pixels.placed or gl.doubles(_POSITION, 4) != _NEVER_SET or not gl.integer(_VALID):
            return
        corner = pixels.positions(0.0, 0.0, 0.0)
        if any(corner):
            self.move(corner)
        else:
            self.put(corner)

    def draw(self, call: Callable[[], object]) -> Any:
        """Make a call that draws at the position, and may move it on, in each view; return its answer."""
        self._context.dress(raster=True)
        self.begin()
        views = self._context.views_now
        if not views:
            return call()
        now = self._now()
        points = self._known.get(now) if now is not None else None
        if points is None or len(points) != len(views):
            return call()  # nowhere
        moved: list[Point | None] = []
        result = None
        for view, point in zip(views, points, strict=True):
            if point is None:
                moved.append(None)
                continue
            self._context.worn.show(view)
            self._move_gl(point)
            result = call()
            moved.append(self._now())
        self.move(moved)
        return result

    def _now(self) -> Point | None:
        if not self._driver.integer(_VALID):
            return None
        x, y, z, _ = self._driver.doubles(_POSITION, 4)
        return x, y, z

    def _move_gl(self, point: Point) -> None:
        """Put GL's position there; what is drawn at it keeps the colour that it had."""
        gl = self._driver
        if self._now() == point:
            return
        near, far = gl.doubles(_DEPTH_RANGE, 2)
        depth = (point[2] - near) / (far - near) if far != near else 0.0
        at_position, current = (c_float * 4)(), (c_float * 4)()
        gl.glGetFloatv(_RASTER_COLOR, at_position)
        gl.glGetFloatv(_COLOR, current)
        gl.glPushAttrib(_LIGHTING_BIT)  # a material may follow the colour
        gl.glColor4f(*at_position)
        gl.glWindowPos3f(point[0], point[1], depth)
        gl.glColor4f(*current)
        gl.glPopAttrib()
