"""Method cubemap: the scene goes onto the faces of a cube, and these onto the window's disc."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import numpy as np

from domeshim.draw.atlas import Atlas, restored
from domeshim.draw.attached import OLDEST_GL
from domeshim.draw.resampling import Resampling
from domeshim.draw.target import drawing_to
from domeshim.draw.tiles import Tile, packed
from domeshim.driver import Driver
from domeshim.errors import DriverError
from domeshim.lens.faces import face_size, faces_of
from domeshim.lens.landing import Floats
from domeshim.lens.orientation import Orientation
from domeshim.lens.radial import RadialLens
from domeshim.options import Options
from domeshim.state.perspective import DepthTerms, planar
from domeshim.state.views import View
from domeshim.window.frame import Frame

_LARGEST_SIZES, _DRAW_FRAMEBUFFER, _DRAWN_BITS = (0x0D33, 0x84E8), 0x8CA9, 0x4500
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
        lens: RadialLens,
        orientation: Orientation,
        say: Callable[[str], None],
        window: Callable[[], int],
    ) -> None:
        """The window must be current.

        say: tells the user; window: asks for the number of its framebuffer.

        Raises DriverError where this GL has no framebuffer for it.
        """
        if driver.version < OLDEST_GL:
            have, want = ((".".join(map(str, version))) for version in (driver.version, OLDEST_GL))
            raise DriverError(f"method cubemap needs OpenGL {want}, and this is {have}; take another method")
        self._driver = driver
        self._square = frame.square
        self._say = say
        self._window = window
        self._turn = orientation.turn
        self._tiles = [
            Tile(face, options.face_size or face_size(face, lens, options.fov, frame.square[2]))
            for face in faces_of(options.fov, orientation)
        ]
        self.views, size = self._fitting()
        with restored(driver):
            self._atlas = Atlas(driver, size)
            self._resampling = Resampling(driver, self._atlas, self.views, lens, orientation)
        self.framebuffer: int | None = self._atlas.framebuffer
        self._depth: DepthTerms = (0.0, 0.0)
        self._fresh = self._straight = False

    def _fitting(self) -> tuple[tuple[View, ...], tuple[int, int]]:
        """The views and the size of their picture: at most what this GL can draw to."""
        most = min(self._driver.integer(name) for name in _LARGEST_SIZES)
        wanted = max(tile.size for tile in self._tiles)
        views, size = packed(self._tiles)
        while max(size) > most:
            self._tiles = [Tile(tile.face, tile.size * 15 // 16) for tile in self._tiles]
            views, size = packed(self._tiles)
        largest = max(tile.size for tile in self._tiles)
        if largest < wanted:
            self._say(f"cube faces of {wanted} pixels are too large for this OpenGL: {largest} it is")
        return views, size

    def drawn(self, depth: DepthTerms) -> None:
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
            gl.glBindFramebuffer(_DRAW_FRAMEBUFFER, self._window())
            self._resampling.draw(self._square, (planar(self._depth), self._depth) if deep else None)

    def clear(self, mask: int) -> None:
        """As for Canvas."""
        with drawing_to(self._driver, self.framebuffer):
            self._driver.glClear(mask & _DRAWN_BITS)
        self._fresh, self._straight = True, False

    def places(self, direction: Floats) -> list[tuple[float, float, float] | None]:
        """As for Canvas."""
        found: list[tuple[float, float, float] | None] = []
        for tile, view in zip(self._tiles, self.views, strict=True):
            x, y, ahead = tile.axes @ self._turn @ direction / np.linalg.norm(direction)
            left, bottom, side, _ = view.viewport
            if ahead < _LEAST_AHEAD:
                found.append(None)
                continue
            x, y = (round(side / 2 * (1 + k / ahead / tile.edge), _DECIMALS) for k in (x, y))
            found.append((float(left + x), float(bottom + y), float(ahead)))
        return found

    def direction(self, x: float, y: float) -> tuple[Floats, float] | None:
        """As for Canvas."""
        for tile, view in zip(self._tiles, self.views, strict=True):
            left, bottom, side, _ = view.viewport
            part_x, part_y, width, height = view.scissor or view.viewport
            if 0 <= x - part_x < width and 0 <= y - part_y < height:
                at = np.array([2 * (x - left) / side - 1, 2 * (y - bottom) / side - 1])
                there = np.array([*(at * tile.edge), 1.0])
                ahead = float(1 / np.linalg.norm(there))
                return np.asarray(np.linalg.solve(tile.axes @ self._turn, there * ahead), float), ahead
        return None

    def close(self) -> None:
        """As for Canvas."""
        with restored(self._driver):
            self._resampling.delete()
        self._atlas.delete()
