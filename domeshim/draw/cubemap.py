"""Method cubemap: the scene goes onto the faces of a cube, and these onto the window's disc."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Literal

import numpy as np

from domeshim.draw.atlas import Atlas, restored
from domeshim.draw.resampling import Resampling
from domeshim.driver import Driver
from domeshim.errors import DriverError
from domeshim.lens.faces import BORDER, Face, face_size, faces_of
from domeshim.lens.models import Floats, Lens
from domeshim.lens.orientation import Orientation
from domeshim.options import Options
from domeshim.state.perspective import planar
from domeshim.state.views import View
from domeshim.window.frame import Frame

if TYPE_CHECKING:
    from domeshim.draw.canvas import Depth

_LARGEST_SIZES, _DRAW_FRAMEBUFFER, _DRAWN_BITS = (0x0D33, 0x84E8), 0x8CA9, 0x4500
_COLUMNS = 3
_OLDEST = (3, 3)
"""What moderngl needs."""
_LEAST_AHEAD, _DECIMALS = 1e-3, 6
"""A place on a pixel's edge, as most that programs ask for are, must not fall to either side at random."""


class CubeCanvas:
    """The faces that one window's lens needs: all of them regions of one framebuffer."""

    kind: Literal["disc", "face"] = "face"

    def __init__(
        self,
        driver: Driver,
        options: Options,
        frame: Frame,
        lens: Lens,
        orientation: Orientation,
        rim: float,
        say: Callable[[str], None],
    ) -> None:
        """The window must be current. rim: where the picture ends on the disc; say: tells the user.

        Raises DriverError where this GL has no framebuffer for it.
        """
        if driver.version < _OLDEST:
            have, want = ((".".join(map(str, version))) for version in (driver.version, _OLDEST))
            raise DriverError(f"method cubemap needs OpenGL {want}, and this is {have}; take another method")
        self._driver = driver
        self._square = frame.square
        self._say = say
        self._turn = orientation.turn
        self._faces = faces_of(options.fov, orientation)
        reach = self._faces[0].reach
        columns, rows = min(len(self._faces), _COLUMNS), -(-len(self._faces) // _COLUMNS)
        wanted = options.face_size or face_size(lens, options.fov, frame.square[2], reach)
        size = self._fitting(wanted, columns)
        side = _with_border(size)
        self._edge = reach * side / size
        self.views = tuple(
            _view(face, self._edge, side, *divmod(i, _COLUMNS)) for i, face in enumerate(self._faces)
        )
        with restored(driver):
            self._atlas = Atlas(driver, (columns * side, rows * side))
            self._resampling = Resampling(driver, self._atlas, self.views, lens, orientation, rim)
        self.framebuffer = self._atlas.framebuffer
        self._depth: Depth = (0.0, 0.0)
        self._fresh = self._straight = False

    def _fitting(self, wanted: int, columns: int) -> int:
        """Pixels across a face: at most what this GL can draw to with its border."""
        most = min(self._driver.integer(name) for name in _LARGEST_SIZES) // columns
        largest = int((most - 2) / (1 + 2 * BORDER))
        if wanted > largest:
            self._say(f"cube faces of {wanted} pixels are too large for this OpenGL: {largest} it is")
        return min(wanted, largest)

    def drawn(self, depth: Depth) -> None:
        """As for Canvas."""
        self._fresh = True
        if depth != (0.0, 0.0):
            self._depth = depth
        if self._straight:
            self._say("method cubemap: the scene goes on over what was drawn straight into the window")

    def settle(self, *, deep: bool = False, straight: bool = False) -> None:
        """As for Canvas."""
        self._straight = self._straight or straight
        if not self._fresh:
            return
        self._fresh = False
        gl = self._driver
        with restored(gl):
            self._atlas.resolve(deep=deep)
            gl.glBindFramebuffer(_DRAW_FRAMEBUFFER, 0)
            self._resampling.draw(self._square, (planar(self._depth), self._depth) if deep else None)

    def clear(self, mask: int) -> None:
        """As for Canvas."""
        gl = self._driver
        gl.glBindFramebuffer(_DRAW_FRAMEBUFFER, self.framebuffer)
        gl.glClear(mask & _DRAWN_BITS)
        gl.glBindFramebuffer(_DRAW_FRAMEBUFFER, 0)
        self._fresh, self._straight = True, False

    def places(self, direction: Floats) -> list[tuple[float, float, float] | None]:
        """As for Canvas."""
        found: list[tuple[float, float, float] | None] = []
        for face, view in zip(self._faces, self.views, strict=True):
            x, y, ahead = np.array(face.axes, float) @ self._turn @ direction / np.linalg.norm(direction)
            left, bottom, side, _ = view.viewport
            if ahead < _LEAST_AHEAD:
                found.append(None)
                continue
            x, y = (round(side / 2 * (1 + k / ahead / self._edge), _DECIMALS) for k in (x, y))
            found.append((float(left + x), float(bottom + y), float(ahead)))
        return found

    def direction(self, x: float, y: float) -> tuple[Floats, float] | None:
        """As for Canvas."""
        for face, view in zip(self._faces, self.views, strict=True):
            left, bottom, side, _ = view.viewport
            at = np.array([2 * (x - left) / side - 1, 2 * (y - bottom) / side - 1])
            if np.abs(at).max() < 1:
                there = np.array([*(at * self._edge), 1.0])
                ahead = float(1 / np.linalg.norm(there))
                axes = np.array(face.axes, float) @ self._turn
                return np.asarray(np.linalg.solve(axes, there * ahead), float), ahead
        return None

    def close(self) -> None:
        """As for Canvas."""
        with restored(self._driver):
            self._resampling.delete()
        self._atlas.delete()


def _with_border(size: int) -> int:
    return size + 2 * math.ceil(size * BORDER)


def _view(face: Face, edge: float, side: int, row: int, column: int) -> View:
    """A face in the atlas: side pixels across, its border included, and edge each way in its plane."""
    left, bottom = column * side, row * side
    ends = [min(max(round((end / edge + 1) / 2 * side), 0), side) for end in face.part]
    part = left + ends[0], bottom + ends[2], ends[1] - ends[0], ends[3] - ends[2]
    axes = np.zeros((4, 4))
    axes[:3, :3] = np.array(face.axes, float) / [[edge], [edge], [1.0]]
    return View((left, bottom, side, side), part, (("domeFace", tuple(axes.T.ravel().tolist())),))
