"""Where what is drawn next belongs: on the dome at its true angles, or on the flat panel (DESIGN 2.2).

Matrices are (4, 4) float64, rows by columns.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from domeshim.options import Options
from domeshim.state.perspective import (
    CAMERA,
    DepthTerms,
    Matrix,
    depth_range,
    is_perspective,
    perspective,
    perspective_part,
)
from domeshim.window.frame import Frame, Rectangle

if TYPE_CHECKING:
    from domeshim.state.comfort import SteadyView

_REMEMBERED = 8


@dataclass(frozen=True)
class Placement:
    """How vertices reach the dome's eye space, and how their distance becomes depth."""

    place: Literal["modelview", "view", "panel"]
    view: tuple[float, ...]
    """The uniform domeView, column-major; the identity for "modelview"."""
    depth: DepthTerms
    hud: bool = False
    """Drawn flat by a program that has a perspective of its own."""


_IDENTITY = tuple(np.eye(4).ravel())


@dataclass(frozen=True)
class View:
    """A perspective and its place in the window."""

    camera: Matrix
    """The main view's perspective, filled."""
    viewport: Rectangle
    turn: NDArray[np.float64] = field(default_factory=lambda: np.eye(3))
    """(3, 3): from the program's eye space to the dome's, which follows it more slowly (DOME_MAX_TURN)."""

    def moved(self, x: int, y: int) -> View:
        """The same view from a window whose own place is (-x, -y)."""
        left, bottom, width, height = self.viewport
        return View(self.camera, (left + x, bottom + y, width, height), self.turn)

    def direction(self, x: float, y: float) -> NDArray[np.float64]:
        """(3,): where a point of the window is seen, in the program's eye space; its z is -1."""
        vx, vy, w, h = self.viewport
        window = [2 * (x - vx) / w - 1, 2 * (y - vy) / h - 1, 1.0]
        found = np.asarray(np.linalg.solve(self.camera[CAMERA, :3], window), np.float64)
        return np.asarray(found / -found[2], np.float64)

    def distance(self, depth: float, direction: NDArray[np.float64]) -> float:
        """How far away a point of this depth, 0 to 1, is in a direction whose z is -1."""
        p, z = self.camera, 2 * depth - 1
        return float(p[2, 3] / (p[2, 2] - z * p[3, 2]) * np.linalg.norm(direction))


@dataclass
class MainView:
    """The main view of a window and of those inside it; its viewport lies in the outermost one's pixels."""

    view: View | None = None


class Placer:
    """Remembers the perspectives that a program sets, and places its draws by them.

    Nothing of GL's own state is kept: PROJECTION and the viewport are given at each question.
    """

    def __init__(self, options: Options, main: MainView | None = None) -> None:
        """main: that of the window around this one, if there is one."""
        self._options = options
        self._known: list[Matrix] = []
        self.main = main or MainView()
        self.fills_dome = False
        """A main view has been drawn in this window."""
        self.steady = _steady_view(options)
        """What limits how fast the view turns, if anything."""
        self._fills_asked = False
        """The program draws into the window that it asked for, and was not given."""
        self.on_modelview = False
        """A perspective went to the MODELVIEW stack: that matrix must be looked at as well."""

    def perspective_set(self, p: Matrix, *, on_modelview: bool) -> None:
        """The program multiplied this perspective onto its PROJECTION or MODELVIEW stack."""
        self._known = [p, *(k for k in self._known if not np.array_equal(k, p))][:_REMEMBERED]
        self.on_modelview = self.on_modelview or on_modelview

    def place(
        self, projection: Matrix, modelview: Matrix | None, viewport: Rectangle, frame: Frame
    ) -> Placement:
        """Where a draw belongs.

        modelview: given where on_modelview asks for it; its perspective counts if projection has none.
        """
        self._fills_asked = self._fills_asked or frame.fills_asked(viewport)
        if is_perspective(projection):
            return self._in_perspective(projection, projection, viewport, frame)
        if modelview is not None and is_perspective(modelview):
            return self._in_perspective(projection, projection @ modelview, viewport, frame)
        return self._flat(viewport, frame)

    def through_window(self, frame: Frame) -> View:
        """The main view, which what is drawn flat is seen through."""
        x, y, width, height = frame.outer
        if self._fills_asked and frame.asked is not None:
            x, y, width, height = 0, 0, *frame.asked
        if self.main.view is None:
            p = perspective(self._options.panel, width / height, 1.0, 10.0)
            assert p is not None
            return View(p, (x, y, width, height))
        return self.main.view.moved(x, y)

    def panel(self, viewport: Rectangle, frame: Frame) -> Placement:
        """Where what is drawn flat in a viewport belongs."""
        return self._flat(viewport, frame)

    @property
    def has_perspective(self) -> bool:
        """The program has drawn in perspective: what it draws flat is a HUD."""
        return self.main.view is not None

    def _in_perspective(
        self, projection: Matrix, whole: Matrix, viewport: Rectangle, frame: Frame
    ) -> Placement:
        if not frame.covers_most(viewport):
            return self._flat(viewport, frame)
        p = self._perspective_in(whole)
        camera = self._filled(p)
        outer_x, outer_y, _, _ = frame.outer
        turn = self.steady.turn if self.steady is not None else None
        self.main.view = View(camera, viewport, *(() if turn is None else (turn,))).moved(-outer_x, -outer_y)
        self.fills_dome = True
        depth = depth_range(p).uniform
        if (
            turn is None
            and whole is projection
            and camera is p
            and np.allclose(projection, p, rtol=1e-6, atol=1e-9)
        ):
            return Placement("modelview", _IDENTITY, depth)
        view = np.zeros((4, 4))
        view[:3] = np.linalg.solve(camera[CAMERA, :3], projection[CAMERA])
        view[3] = [0, 0, 0, 1] if whole is projection else np.linalg.solve(p.T, [0, 0, 0, 1]) @ projection
        if turn is not None:
            view[:3] = turn @ view[:3]
        return Placement("view", tuple(view.T.ravel()), depth)

    def _perspective_in(self, whole: Matrix) -> Matrix:
        """The program's own P inside a matrix: one that leaves a rigid motion, else the one set last."""
        for p in self._known:
            if _is_rigid(np.linalg.solve(p[CAMERA, :3], whole[CAMERA, :3])):
                return p
        return self._known[0] if self._known else perspective_part(whole)

    def _filled(self, p: Matrix) -> Matrix:
        """P with its vertical view widened or narrowed to DOME_FILL degrees."""
        if self._options.fill is None:
            return p
        scale = 1 / (abs(p[1, 1] / p[3, 2]) * np.tan(np.radians(self._options.fill) / 2))
        return np.diag([scale, scale, 1.0, 1.0]) @ p

    def _flat(self, viewport: Rectangle, frame: Frame) -> Placement:
        main = self.through_window(frame)
        x, y, w, h = viewport
        mx, my, mw, mh = main.viewport
        window = np.array(
            [
                [w / mw, 0, 0, (2 * (x - mx) + w) / mw - 1],
                [0, h / mh, 0, (2 * (y - my) + h) / mh - 1],
                [0, 0, 0, 1],
            ]
        )
        view = np.zeros((4, 4))
        view[:3] = main.turn @ np.linalg.solve(main.camera[CAMERA, :3], window)
        view[3, 3] = 1
        return Placement("panel", tuple(view.T.ravel()), (0.0, 0.0), hud=self.has_perspective)


def _steady_view(options: Options) -> SteadyView | None:
    if options.max_turn is None:
        return None
    from domeshim.state.comfort import SteadyView  # noqa: PLC0415 - with DOME_MAX_TURN

    return SteadyView(options.max_turn)


def _is_rigid(turn: NDArray[np.floating]) -> bool:
    return bool(np.abs(turn @ turn.T - np.eye(3)).max() < 1e-4)
