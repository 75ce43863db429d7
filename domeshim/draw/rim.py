"""The rim: black outside the disc, exact to the pixel, drawn once over each finished picture."""

from __future__ import annotations

from domeshim.driver import Driver
from domeshim.shading.compose import Source
from domeshim.shading.program import Program
from domeshim.shading.snippets import snippet
from domeshim.window.frame import Frame

_ALL_ATTRIBUTES = 0xFFFFFFFF
IN_THE_WAY = (
    0x0B71,  # GL_DEPTH_TEST
    0x0B90,  # GL_STENCIL_TEST
    0x0BC0,  # GL_ALPHA_TEST
    0x0BE2,  # GL_BLEND
    0x0BF2,  # GL_COLOR_LOGIC_OP
    0x0C11,  # GL_SCISSOR_TEST
    0x0B44,  # GL_CULL_FACE
    0x0B42,  # GL_POLYGON_STIPPLE
    0x8C89,  # GL_RASTERIZER_DISCARD
    0x8037,  # GL_POLYGON_OFFSET_FILL
    *range(0x3000, 0x3008),  # GL_CLIP_PLANEi
)
"""What the dome's own draws over a picture must not be subject to."""

_CURRENT_PROGRAM = 0x8B8D
_FRONT_AND_BACK, _FILL, _TRIANGLE_STRIP = 0x0408, 0x1B02, 0x0005
_RING = 2 * (128 + 1)
"""Vertices of the ring that glsl/frame/rim.vert.glsl makes."""


def _source(name: str) -> Source:
    return Source.join([(name, snippet(name))])


class Rim:
    """The rim of one context."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._program = Program(driver, _source("frame/rim.vert"), _source("frame/rim.frag"))

    def draw(self, frame: Frame, radius: float) -> None:
        """Blacken all of the frame outside the disc; radius: of the picture, 1 the inscribed circle."""
        gl = self._driver
        x, y, side, _ = frame.square
        program = gl.integer(_CURRENT_PROGRAM)
        gl.glPushAttrib(_ALL_ATTRIBUTES)
        for capability in IN_THE_WAY:
            gl.glDisable(capability)
        gl.glColorMask(1, 1, 1, 1)
        gl.glPolygonMode(_FRONT_AND_BACK, _FILL)
        gl.glViewport(0, 0, *frame.size)
        gl.glUseProgram(self._program.name)
        self._program.set("domeDisc", (x + side / 2, y + side / 2, radius * side / 2))
        self._program.set("domeFrame", frame.size)
        gl.glDrawArrays(_TRIANGLE_STRIP, 0, _RING)
        gl.glUseProgram(program)
        gl.glPopAttrib()
