"""A glClear inside a scissor rectangle: the same part of the dome, drawn over in one colour and depth."""

from __future__ import annotations

from ctypes import c_float
from typing import Literal

import numpy as np

from domeshim.draw.canvas import Canvas
from domeshim.draw.numbered import draw_numbered, numbered, source
from domeshim.draw.over import way_cleared
from domeshim.draw.target import drawing_to
from domeshim.driver import Driver
from domeshim.lens.keystone import WHOLE, Keystone
from domeshim.lens.landing import Lens
from domeshim.lens.orientation import Orientation
from domeshim.lens.radial import RadialLens
from domeshim.shading.program import Program
from domeshim.state.perspective import Matrix
from domeshim.state.scissor import Edges

COLOR, DEPTH, STENCIL = 0x4000, 0x0100, 0x0400
_TRIANGLES, _ALWAYS, _REPLACE, _DEPTH_TEST, _STENCIL_TEST = 4, 0x0207, 0x1E01, 0x0B71, 0x0B90
_COLOR_CLEAR_VALUE, _DEPTH_CLEAR_VALUE, _STENCIL_CLEAR_VALUE = 0x0C22, 0x0B73, 0x0B91
_CELLS = 64 * 128


class PartClear:
    """Clears parts of one context's dome."""

    def __init__(
        self, driver: Driver, lens: Lens, orientation: Orientation, keystone: Keystone | None
    ) -> None:
        self._keystone = keystone or Keystone(WHOLE)
        self._driver = driver
        self._lens = lens
        self._orientation = orientation
        self._program: Program | None = None

    def clear(self, mask: int, canvas: Canvas, camera: Matrix, edges: Edges) -> None:
        """Clear the buffers of a glClear mask to the program's own clear values.

        camera: (3, 3), a direction's x, y and w in the main view; edges: in that view, only inner ones cut.
        """
        gl = self._driver
        with drawing_to(gl, canvas.framebuffer), way_cleared(gl):
            gl.glDepthRange(0.0, 1.0)
            self._choose_buffers(mask)
            program = self._set_up(canvas.kind, camera, edges)
            for view in canvas.views:
                gl.glViewport(*view.viewport)
                for name, values in view.uniforms:
                    program.set(name, values)
                draw_numbered(gl, _TRIANGLES, 0, 6 * _CELLS if canvas.kind == "disc" else 6)

    def _choose_buffers(self, mask: int) -> None:
        gl = self._driver
        if not mask & COLOR:
            gl.glColorMask(0, 0, 0, 0)
        if mask & DEPTH:
            gl.glEnable(_DEPTH_TEST)
            gl.glDepthFunc(_ALWAYS)
        if mask & STENCIL:
            gl.glEnable(_STENCIL_TEST)
            gl.glStencilFunc(_ALWAYS, gl.integer(_STENCIL_CLEAR_VALUE), 0xFFFFFFFF)
            gl.glStencilOp(_REPLACE, _REPLACE, _REPLACE)

    def _set_up(self, kind: Literal["disc", "face"], camera: Matrix, edges: Edges) -> Program:
        gl = self._driver
        if self._program is None:
            seen_along = "aim/seen_seated" if self._orientation.off_centre else "aim/seen_centred"
            disc = (
                *self._lens.snippets,
                self._lens.cells,
                seen_along,
                "surface/keystone",
                "frame/clear.vert",
            )
            names = disc if kind == "disc" else ("frame/clear_face.vert",)
            self._program = Program(gl, numbered(gl, *names), source(gl, "frame/clear.frag"))
        seen = np.zeros((4, 4))
        seen[[0, 1, 3], :3] = camera @ self._orientation.turn.T
        color = (c_float * 4)()
        gl.glGetFloatv(_COLOR_CLEAR_VALUE, color)
        gl.glUseProgram(self._program.name)
        if kind == "disc":
            self._program.set("domeLens", self._lens.uniform)
            for uniform, values in self._orientation.uniforms:
                self._program.set(uniform, values)
            if isinstance(self._lens, RadialLens):
                self._program.set("domeHalf", (self._lens.half,))
            self._program.set("domeKeystone", self._keystone.uniform)
        self._program.set("domeDepth", (2 * gl.doubles(_DEPTH_CLEAR_VALUE, 1)[0] - 1,))
        self._program.set("domeSeen", tuple(seen.T.ravel()))
        self._program.set("domeEdges", edges.bounds)
        self._program.set("domeSides", tuple(float(i in edges.inner) for i in range(4)))
        self._program.set("domeColor", tuple(color))
        return self._program
