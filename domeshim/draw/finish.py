"""The finished picture as the projector needs it: warped by a mesh, mirrored, faded at the edge, its light set."""

from __future__ import annotations

from ctypes import byref, c_uint
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from domeshim.draw.atlas import restored
from domeshim.draw.attached import attached
from domeshim.draw.over import way_cleared
from domeshim.driver import Driver
from domeshim.lens.mesh import Floats, WarpMesh
from domeshim.shading.snippets import snippet
from domeshim.window.frame import Frame

_VERSION = "#version 330\n"
_FRAMEBUFFER, _READ, _DRAW, _TEXTURE_2D = 0x8D40, 0x8CA8, 0x8CA9, 0x0DE1
_COLOR_ATTACHMENT, _COLOR_BIT, _NEAREST, _LINEAR, _CLAMP_TO_EDGE = 0x8CE0, 0x4000, 0x2600, 0x2601, 0x812F
_FILTERS, _WRAPS = (0x2801, 0x2800), (0x2802, 0x2803)
_RGBA8, _RGBA, _BYTE, _PIXEL_BUFFER = 0x8058, 0x1908, 0x1401, 0x88EC


class Finish:
    """Draws one window's finished pictures once more; the window must be current in all calls."""

    def __init__(self, driver: Driver, frame: Frame, mesh: WarpMesh, fade: tuple[float, float], tone: tuple[float, float]) -> None:
        """fade: the radii where the picture begins to fade and ends; tone: brightness, and 1 / gamma."""
        self._driver = driver
        self.frame = frame
        self._framebuffer, self._copy = c_uint(), c_uint()
        with restored(driver):
            self._make_copy()
            self._context = attached(driver)
            self._program: Any = self._context.program(
                vertex_shader=_VERSION + snippet("finish/mesh.vert"),
                fragment_shader=_VERSION + snippet("finish/picture.frag"),
            )
            nodes = np.hstack([mesh.places, mesh.picture, mesh.intensity[:, None]]).astype(np.float32)
            content = [(self._context.buffer(nodes.tobytes()), "2f 2f 1f", "place", "shown", "intensity")]
            index = self._context.buffer(mesh.triangles.astype(np.uint32).tobytes())
            self._mesh: Any = self._context.vertex_array(self._program, content, index)
            self._held = (content[0][0], index, self._mesh, self._program)
        x, y, side, _ = frame.square
        width, height = frame.size
        self._program["part"].value = x / width, y / height, side / width, side / height
        self._program["fade"].value = fade
        self._program["tone"].value = tone
        self._program["picture"].value = 0

    def draw(self) -> None:
        """Put the window's back buffer, which holds the dome's picture, through the mesh."""
        gl = self._driver
        box = (0, 0, *self.frame.size)
        with restored(gl):
            with way_cleared(gl):
                gl.glColorMask(1, 1, 1, 1)
                gl.glBindFramebuffer(_READ, 0)
                gl.glBindFramebuffer(_DRAW, self._framebuffer)
                gl.glBlitFramebuffer(*box, *box, _COLOR_BIT, _NEAREST)
                gl.glBindFramebuffer(_DRAW, 0)
                gl.glViewport(*box)
                gl.glClearColor(0.0, 0.0, 0.0, 1.0)
                gl.glClear(_COLOR_BIT)
                self._context.external_texture(self._copy.value, self.frame.size, 4, 0, "f1").use(0)
                self._mesh.render(moderngl.TRIANGLES)

    def close(self) -> None:
        """Free what it holds of GL."""
        with restored(self._driver):
            for held in self._held:
                held.release()
        self._driver.glDeleteFramebuffers(1, byref(self._framebuffer))
        self._driver.glDeleteTextures(1, byref(self._copy))

    def _make_copy(self) -> None:
        gl = self._driver
        gl.glBindBuffer(_PIXEL_BUFFER, 0)
        gl.glGenTextures(1, byref(self._copy))
        gl.glBindTexture(_TEXTURE_2D, self._copy)
        for parameter in _FILTERS:
            gl.glTexParameteri(_TEXTURE_2D, parameter, _LINEAR)
        for parameter in _WRAPS:
            gl.glTexParameteri(_TEXTURE_2D, parameter, _CLAMP_TO_EDGE)
        gl.glTexImage2D(_TEXTURE_2D, 0, _RGBA8, *self.frame.size, 0, _RGBA, _BYTE, None)
        gl.glGenFramebuffers(1, byref(self._framebuffer))
        gl.glBindFramebuffer(_FRAMEBUFFER, self._framebuffer)
        gl.glFramebufferTexture2D(_FRAMEBUFFER, _COLOR_ATTACHMENT, _TEXTURE_2D, self._copy, 0)


def whole_frame(frame: Frame) -> WarpMesh:
    """The mesh that leaves the picture where it is."""
    x, y, side, _ = frame.square
    size = np.array(frame.size, float)
    corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    places = corners * 2 - 1
    picture = (corners * size - (x, y)) / side
    return WarpMesh(places, picture, np.ones(4), np.array([[0, 1, 2], [0, 2, 3]]))


def mirrored(mesh: WarpMesh, *, across: bool, over: bool) -> WarpMesh:
    """The mesh as seen from the other side; across: left for right, over: top for bottom."""
    turn = np.array([-1.0 if across else 1.0, -1.0 if over else 1.0])
    return WarpMesh(mesh.places * turn, mesh.picture, mesh.intensity, mesh.triangles)
