"""Shapes that the shim itself has in memory, GLUT's solids: GL need not be asked what there is to draw."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.client_arrays import client_arrays
from domeshim.draw.extent import Extent
from domeshim.draw.primitives import extent_of
from domeshim.driver import Driver
from domeshim.record.runs import Block, Run

_LAYOUTS = {6: 0x2A25, 8: 0x2A2B}  # GL_N3F_V3F, GL_T2F_N3F_V3F
_TYPES = {np.dtype(np.uint16): 0x1403, np.dtype(np.uint32): 0x1405}


class Shape:
    """One draw by indices.

    vertices: (n, 6) normal and position, or (n, 8) with texture coordinates before them, float32;
    mode: GL_TRIANGLES or GL_LINES; indices: of unsigned integers, 16 or 32 bits.
    """

    def __init__(
        self, vertices: NDArray[np.float32], mode: int, indices: NDArray[np.unsignedinteger]
    ) -> None:
        self._vertices, self._mode, self._indices = vertices, mode, indices
        self._arrays = (_LAYOUTS[vertices.shape[1]], 0, vertices.ctypes.data)
        self._elements = (mode, indices.size, _TYPES[indices.dtype], indices.ctypes.data)

    @cached_property
    def run(self) -> Run:
        """Every vertex as often as it is drawn."""
        drawn = self._vertices[self._indices.ravel()]
        attributes = {"normal": np.ascontiguousarray(drawn[:, -6:-3])}
        if drawn.shape[1] == 8:
            rest = np.broadcast_to(np.array((0, 1), np.float32), (len(drawn), 2))
            attributes["texture0"] = np.hstack([drawn[:, :2], rest])
        positions = np.ascontiguousarray(drawn[:, -3:])
        return Run(positions, attributes, (Block(self._mode, 0, len(drawn)),))

    @cached_property
    def extent(self) -> Extent | None:
        """How large it is."""
        return extent_of(self.run)

    def draw(self, gl: Driver) -> None:
        """Draw it whole, whatever arrays the program has bound, and leave those as they were."""
        with client_arrays(gl):
            gl.glInterleavedArrays(*self._arrays)
            gl.glDrawElements(*self._elements)
