"""The rim: black outside the disc, exact to the pixel, drawn once over each finished picture."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from domeshim.draw.numbered import draw_numbered, numbered, source
from domeshim.draw.over import way_cleared
from domeshim.driver import Driver
from domeshim.lens.keystone import Keystone
from domeshim.shading.program import Program
from domeshim.window.frame import Frame

_TRIANGLES, _TRIANGLE_STRIP, _SCISSOR_TEST = 0x0004, 0x0005, 0x0C11
_BEYOND = 4
"""So many pixels beyond the disc's square lines and points may reach where they are not blackened."""
_RING = 2 * (32 + 1)
"""Vertices of each ring that glsl/frame/rim.vert.glsl makes."""


class Rim:
    """The rim of one context."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver

    @cached_property
    def _rings(self) -> tuple[Program, Program]:
        """Over the disc's edge, and from there on."""
        vertex = numbered(self._driver, "frame/rim.vert")
        edge, outside = (source(self._driver, name) for name in ("frame/rim.frag", "frame/black.frag"))
        return Program(self._driver, vertex, edge), Program(self._driver, vertex, outside)

    @cached_property
    def _keystone(self) -> Program:
        gl = self._driver
        return Program(gl, numbered(gl, "frame/whole.vert"), source(gl, "frame/rim_keystone.frag"))

    def draw(self, frame: Frame, radius: float | None) -> None:
        """Blacken all outside the disc; radius: of the picture, 1 the inscribed circle, None: it has none."""
        if radius is None:
            return
        gl = self._driver
        with way_cleared(gl):
            gl.glColorMask(1, 1, 1, 1)
            gl.glViewport(0, 0, *frame.size)
            if len(frame.parts) > 1 or frame.aside:
                gl.glEnable(_SCISSOR_TEST)
            for square, part in zip(frame.squares, frame.parts, strict=True):
                x, y, side, _ = square
                around = (x - _BEYOND, y - _BEYOND, side + 2 * _BEYOND, side + 2 * _BEYOND)
                gl.glScissor(*(around if frame.aside else part))
                disc = x + side / 2, y + side / 2, radius * side / 2
                if frame.keystone is None:
                    self._around(frame, disc)
                else:
                    self._around_corners(frame.keystone, disc, side / 2)

    def _around(self, frame: Frame, disc: tuple[float, float, float]) -> None:
        """Blacken what is outside one disc: its centre and radius, pixels."""
        for ring, program in enumerate(self._rings):
            self._driver.glUseProgram(program.name)
            program.set("domeDisc", disc)
            program.set("domeFrame", frame.size)
            draw_numbered(self._driver, _TRIANGLE_STRIP, ring * _RING, _RING)

    def _around_corners(self, keystone: Keystone, disc: tuple[float, float, float], half: float) -> None:
        """Blacken what is outside a disc whose square, of this half a side, goes to four corners."""
        program = self._keystone
        self._driver.glUseProgram(program.name)
        program.set("domeDisc", disc)
        program.set("domeHalfSide", (half,))
        program.set("domeToSquare", tuple(np.linalg.inv(keystone.matrix).T.ravel().tolist()))
        draw_numbered(self._driver, _TRIANGLES, 0, 3)
