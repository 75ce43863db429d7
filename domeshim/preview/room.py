"""Draws the room: the dome with a picture on it, and the floor."""

from __future__ import annotations

from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from domeshim.preview.dome import VirtualDome
from domeshim.preview.viewer import Viewer
from domeshim.shading.snippets import snippet

_VERSION = "#version 330\n"
_BACKGROUND = (0.015, 0.016, 0.02)
_FLOOR_SIDES = 96


class Room:
    """One virtual dome in a moderngl context, which must be current in all calls."""

    def __init__(self, context: Any, dome: VirtualDome) -> None:
        self._context = context
        corners, triangles = dome.mesh()
        self._dome = self._surface("dome", corners, triangles)
        self._floor = self._surface("floor", *_floor(1.4 * dome.radius))
        self._picture: Any = None
        self.show(np.zeros((2, 2, 3), np.uint8))

    def show(self, picture: NDArray[np.uint8]) -> None:
        """Hang another picture: (height, width, 3), the top row first; its centre square is the disc's."""
        height, width = picture.shape[:2]
        side = min(height, width)
        top, left = (height - side) // 2, (width - side) // 2
        square = np.ascontiguousarray(picture[top : top + side, left : left + side][::-1])
        if self._picture is None or self._picture.size != (side, side):
            if self._picture is not None:
                self._picture.release()
            self._picture = self._context.texture((side, side), 3, alignment=1)
            self._picture.anisotropy = 8.0
        self._picture.write(square.tobytes(), alignment=1)
        self._picture.build_mipmaps()

    def draw(self, viewer: Viewer, size: tuple[int, int]) -> None:
        """Draw what the viewer sees onto the framebuffer in use, of so many pixels."""
        context = self._context
        context.viewport = (0, 0, *size)
        context.clear(*_BACKGROUND)
        context.enable(moderngl.DEPTH_TEST)
        matrix = viewer.matrix(size[0] / size[1]).T.astype(np.float32).tobytes()
        for surface in (self._floor, self._dome):
            surface.program["toClip"].write(matrix)
        self._floor.render(moderngl.TRIANGLES)
        self._picture.use(0)
        self._dome.render(moderngl.TRIANGLES)

    def _surface(self, name: str, corners: NDArray[np.float32], triangles: NDArray[np.uint32]) -> Any:
        program = self._context.program(
            vertex_shader=_VERSION + snippet("preview/room.vert"),
            fragment_shader=_VERSION + snippet(f"preview/{name}.frag"),
        )
        content = self._context.buffer(corners.tobytes())
        layout = "3f 2f" if "at" in program else "3f 2x4"
        names = ("place", "at") if "at" in program else ("place",)
        return self._context.vertex_array(
            program, [(content, layout, *names)], self._context.buffer(triangles.tobytes())
        )


def _floor(radius: float) -> tuple[NDArray[np.float32], NDArray[np.uint32]]:
    around = np.linspace(0, 2 * np.pi, _FLOOR_SIDES, endpoint=False)
    edge = np.stack([radius * np.cos(around), np.zeros_like(around), radius * np.sin(around)], -1)
    corners = np.vstack([np.zeros(3), edge])
    k = np.arange(_FLOOR_SIDES)
    triangles = np.stack([np.zeros_like(k), 1 + k, 1 + (k + 1) % _FLOOR_SIDES], -1)
    return np.hstack([corners, np.zeros((len(corners), 2))]).astype(np.float32), triangles.astype(np.uint32)
