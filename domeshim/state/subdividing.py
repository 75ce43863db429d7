"""What the edges of what is drawn now need to keep the tolerance."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from domeshim.draw.extent import Extent
from domeshim.draw.primitives import Primitives
from domeshim.options import Options
from domeshim.state.perspective import Matrix
from domeshim.state.placement import Placement
from domeshim.state.subdivision import Choice, Method, Subdivision, Tolerance, method_of
from domeshim.state.whereabouts import matrix
from domeshim.window.contract import processor_draws
from domeshim.window.frame import Frame

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext

_MODELVIEW_MATRIX, _PROJECTION_MATRIX = 0x0BA6, 0x0BA7
_SAMPLES = 0x80A9
_TRANSFORM_FEEDBACK_ACTIVE = 0x8E24
_ROOM_BEHIND = 0.24
"""Closer to straight behind, radians, edges would have to be halved more often than a shader does."""
_HALVINGS, _HALVINGS_BEHIND = 6, 9
"""So often the widest edge of a floor under the viewer is halved, and of one that goes on behind."""
_SHORT = 2.0
"""So many pixels of an average width a line is long that is surely longer than one of any width."""


class Subdividing:
    """Judges the meshes of one context by where they are drawn."""

    def __init__(self, context: DomeContext, options: Options) -> None:
        self._context = context
        self._options = options
        self._tolerance: tuple[Frame, Tolerance] | None = None

    @property
    def minds_edges(self) -> bool:
        """How long the edges of what is drawn now are makes a difference."""
        context = self._context
        unbent = context.compiling or context.aside.bypassed or context.aside.passing
        return not unbent and self.method is not None

    @property
    def may_subdivide(self) -> bool:
        """What is drawn now could be subdivided."""
        return not self._context.aside.bypassed and self.method is not None

    @property
    def subdivides_own(self) -> bool:
        """What the program draws now by a vertex shader of its own is subdivided, if that shader can be."""
        context = self._context
        if not self.minds_edges or context.own.current is None or self.method != "tessellate":
            return False
        if self.tolerance.least < _ROOM_BEHIND:
            return False
        caught = context.driver.integer(_TRANSFORM_FEEDBACK_ACTIVE)
        return context.seen.placement.place != "panel" and not caught

    def subdivision(self, extent: Extent) -> Subdivision | None:
        """What a mesh needs to keep the tolerance: nothing, pieces of its edges, or to be split first."""
        return self.needed(extent) if self.minds_edges else None

    def needed(self, extent: Extent) -> Subdivision | None:
        """The same where minds_edges was asked already."""
        placement = self._context.seen.placement
        if placement.hud and self._options.hud != "panel":
            return None
        to_eye = self._to_eye(placement)
        needed = self._needed(extent, to_eye)
        if extent.shortest_line == math.inf or not self._may_vanish(extent, to_eye):
            return needed
        if needed is None:
            needed = Subdivision(None, self.tolerance.limit(math.pi), split=False)
        return needed._replace(lengthened=True)

    def _may_vanish(self, extent: Extent, to_eye: Sequence[float]) -> bool:
        """Some line may be shorter than a pixel, and the driver would leave it out."""
        if self._context.own.current is not None:
            return False
        return self._leaves_out_short and extent.smallest_line(to_eye) < _SHORT * self.tolerance.pixel

    @cached_property
    def _leaves_out_short(self) -> bool:
        """Mesa's CPU driver leaves out a multisampled line that no border between two pixels crosses."""
        gl = self._context.driver
        makes_lines = self.method in ("tessellate", "geometry") and gl.version >= (3, 2)
        return makes_lines and b"llvmpipe" in gl.renderer and gl.integer(_SAMPLES) > 1

    def _needed(self, extent: Extent, to_eye: Sequence[float]) -> Subdivision | None:
        tolerance, own = self.tolerance, self._context.own.current
        if extent.surely_seen_from(to_eye, tolerance.far):
            return None
        angle, behind = self._angles(extent, to_eye)
        if own is None:
            return tolerance.subdivision(angle, behind, self._context.scene_now)
        if tolerance.broken_by(angle, behind) and not own.own_matrices:
            why = own.subdivided.complaint or "this draw is not subdivided"
            self._context.say_once(f"long edges drawn by the program's own GLSL stay straight: {why}")
        return None

    def _angles(self, extent: Extent, to_eye: Sequence[float]) -> tuple[float, float]:
        """No edge is wider than this angle, and none comes closer to straight behind than that; radians."""
        behind = math.pi
        if self.tolerance.least < 1:
            behind = extent.least_angle_from(self.tolerance.aft, to_eye)
        return extent.largest_angle(to_eye), behind

    def own_halvings(self, extent: Extent | None) -> int | None:
        """How often the widest edge of what the program's own shader draws may have to be halved.

        None where surely no edge needs pieces. extent: of the vertices, where the fixed pipeline would put
        them; None: not known.
        """
        tolerance, own = self.tolerance, self._context.own.current
        deepest = _HALVINGS if tolerance.least == 1 else _HALVINGS_BEHIND
        if extent is None or own is None or not own.fixed_place:
            return deepest
        angle, behind = self._angles(extent, self._to_eye(self._context.seen.placement))
        if not tolerance.broken_by(angle, behind):
            return None
        return 0 if tolerance.least == 1 and angle <= tolerance.widest else deepest

    def choice(self, primitives: Primitives, *, lengthened: bool) -> Choice | None:
        """What each primitive of a mesh needs, where subdivision says that the mesh needs something.

        None where all are to be treated alike; lengthened: as in subdivision.
        """
        choice = self.tolerance.choice(primitives, self.to_eye, self._context.scene_now)
        if choice is None or not lengthened:
            return choice
        whole = Subdivision(None, self.tolerance.limit(math.pi), split=False)
        needed = (each or whole for each in choice.subdivisions)
        return choice._replace(subdivisions=tuple(each._replace(lengthened=True) for each in needed))

    @property
    def to_eye(self) -> Matrix:
        """(4, 4): the space of the vertices that are drawn now -> the dome's eye space."""
        return np.array(self._to_eye(self._context.seen.placement)).reshape(4, 4).T

    @property
    def even_w(self) -> bool:
        """Places drawn now all have the w that they were given, times one number: none is behind infinity."""
        return not any(self._to_eye(self._context.seen.placement)[3:12:4])

    @cached_property
    def method(self) -> Method | None:
        """What subdivides, if anything does."""
        return method_of(self._options.method, self._context.driver, self._context.say_once)

    @cached_property
    def _method_of_few(self) -> Method | None:
        """What makes few pieces of edges for less: geometry shaders where the processor draws, by a third."""
        by_processor = processor_draws(self._context.driver.renderer)
        return "geometry" if by_processor and self.method == "tessellate" else None

    @property
    def tolerance(self) -> Tolerance:
        """What the tolerance asks of the lens in this frame."""
        context = self._context
        if self._tolerance is None or self._tolerance[0] is not context.frame:
            found = Tolerance(
                self._options,
                context.lens,
                context.orientation,
                context.frame,
                self.method,
                self._method_of_few,
            )
            self._tolerance = context.frame, found
        return self._tolerance[1]

    def _to_eye(self, placement: Placement) -> Sequence[float]:
        modelview = self._context.driver.doubles(_MODELVIEW_MATRIX, 16)
        if placement.place == "modelview":
            return modelview
        whole = np.array(placement.view).reshape(4, 4).T
        if placement.place == "panel":
            whole = whole @ matrix(self._context.driver, _PROJECTION_MATRIX)
        return tuple((whole @ np.array(modelview).reshape(4, 4).T).T.ravel().tolist())
