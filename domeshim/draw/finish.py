"""The finished picture as the projector needs it: through a mesh, mirrored, faded, its light set."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import byref, c_uint
from typing import Any

import moderngl
import numpy as np

from domeshim.draw.atlas import restored
from domeshim.draw.attached import attached
from domeshim.draw.finishing import Finishing
from domeshim.draw.over import way_cleared
from domeshim.driver import Driver
from domeshim.shading.snippets import snippet

_VERSION = "#version 330\n"
_FRAMEBUFFER, _READ, _DRAW, _TEXTURE_2D = 0x8D40, 0x8CA8, 0x8CA9, 0x0DE1
_COLOR_ATTACHMENT, _COLOR_BIT, _NEAREST, _LINEAR, _CLAMP_TO_EDGE = 0x8CE0, 0x4000, 0x2600, 0x2601, 0x812F
_FILTERS, _WRAPS = (0x2801, 0x2800), (0x2802, 0x2803)
_RGBA8, _RGBA, _BYTE, _PIXEL_BUFFER = 0x8058, 0x1908, 0x1401, 0x88EC


class Finish:
    """Draws one window's finished pictures once more; the window must be current in all calls."""

    def __init__(self, driver: Driver, finishing: Finishing, window: Callable[[], int] = lambda: 0) -> None:
        """window: asks for the number of the window's framebuffer."""
        self._driver = driver
        self._window = window
        self._size = finishing.frame.size
        mesh = finishing.mesh
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
            self._picture: Any = self._context.external_texture(self._copy.value, self._size, 4, 0, "f1")
            self._held = (self._mesh, content[0][0], index, self._program, self._context)
            part = np.reshape(finishing.frame.square, (2, 2)) / self._size
            self._program["part"].value = tuple(part.ravel().tolist())
            self._program["fade"].value = finishing.fade
            self._program["tone"].value = finishing.tone
            self._program["picture"].value = 0

    def draw(self) -> None:
        """Put the window's picture, which is the dome's, through the mesh."""
        gl, window = self._driver, self._window()
        box = (0, 0, *self._size)
        with restored(gl), way_cleared(gl):
            gl.glColorMask(1, 1, 1, 1)
            gl.glBindFramebuffer(_READ, window)
            gl.glBindFramebuffer(_DRAW, self._framebuffer)
            gl.glBlitFramebuffer(*box, *box, _COLOR_BIT, _NEAREST)
            gl.glBindFramebuffer(_DRAW, window)
            gl.glViewport(*box)
            gl.glClearColor(0.0, 0.0, 0.0, 1.0)
            gl.glClear(_COLOR_BIT)
            self._picture.use(0)
            self._mesh.render(moderngl.TRIANGLES)

    def put_back(self) -> None:
        """Put the picture as it was before into the window, for the program to go on with."""
        gl = self._driver
        box = (0, 0, *self._size)
        with restored(gl), way_cleared(gl):
            gl.glBindFramebuffer(_READ, self._framebuffer)
            gl.glBindFramebuffer(_DRAW, self._window())
            gl.glBlitFramebuffer(*box, *box, _COLOR_BIT, _NEAREST)

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
        gl.glTexImage2D(_TEXTURE_2D, 0, _RGBA8, *self._size, 0, _RGBA, _BYTE, None)
        gl.glGenFramebuffers(1, byref(self._framebuffer))
        gl.glBindFramebuffer(_FRAMEBUFFER, self._framebuffer)
        gl.glFramebufferTexture2D(_FRAMEBUFFER, _COLOR_ATTACHMENT, _TEXTURE_2D, self._copy, 0)
