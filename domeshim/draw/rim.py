"""The rim: black outside the disc, exact to the pixel, drawn once over each finished picture."""

from __future__ import annotations

from domeshim.draw.over import way_cleared
from domeshim.driver import Driver
from domeshim.shading.compose import Source
from domeshim.shading.program import Program
from domeshim.shading.snippets import snippet
from domeshim.window.frame import Frame

_TRIANGLE_STRIP, _SCISSOR_TEST = 0x0005, 0x0C11
_RING = 2 * (128 + 1)
"""Vertices of each ring that glsl/frame/rim.vert.glsl makes."""


def _source(name: str) -> Source:
    return Source.join([(name, snippet(name))])


class Rim:
    """The rim of one context."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        vertex = _source("frame/rim.vert")
        self._edge = Program(driver, vertex, _source("frame/rim.frag"))
        self._outside = Program(driver, vertex, _source("frame/black.frag"))

    def draw(self, frame: Frame, radius: float) -> None:
        """Blacken all of the frame outside the disc; radius: of the picture, 1 the inscribed circle."""
        gl = self._driver
        with way_cleared(gl):
            gl.glColorMask(1, 1, 1, 1)
            gl.glViewport(0, 0, *frame.size)
            if len(frame.parts) > 1:
                gl.glEnable(_SCISSOR_TEST)
            for (x, y, side, _), part in zip(frame.squares, frame.parts, strict=True):
                gl.glScissor(*part)
                self._around(frame, (x + side / 2, y + side / 2, radius * side / 2))

    def _around(self, frame: Frame, disc: tuple[float, float, float]) -> None:
        """Blacken what is outside one disc: its centre and radius, pixels."""
        for ring, program in enumerate((self._edge, self._outside)):
            self._driver.glUseProgram(program.name)
            program.set("domeDisc", disc)
            program.set("domeFrame", frame.size)
            self._driver.glDrawArrays(_TRIANGLE_STRIP, ring * _RING, _RING)
