"""Draw from client memory whatever the program has bound, enabled or stippled, and leave all that as it was.

The GL functions are looked up at each call, so that whoever overlays OpenGL.GL sees these draws too.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from OpenGL import GL

from domeshim import session as sessions
from domeshim.draw.shape import Shape
from domeshim.GLUT.shapes.mesh import Floats, Indices, Solid, Strips, Wire

_LAYOUTS = {2: "GL_V2F", 6: "GL_N3F_V3F", 8: "GL_T2F_N3F_V3F"}
"""glInterleavedArrays' formats by floats a vertex."""


def draw_solid(solid: Solid) -> None:
    """Draw the triangles, in one call."""
    if not _on_dome(solid):
        draw(solid.vertices.interleaved, [(GL.GL_TRIANGLES, solid.triangles)])


def draw_wire(wire: Wire) -> None:
    """Draw the lines, in one call; strip by strip where a stipple pattern has to run on from line to line."""
    if GL.glIsEnabled(GL.GL_LINE_STIPPLE) or not _on_dome(wire):
        draw_lines(wire.vertices.interleaved, wire.lines, wire.strips)


def _on_dome(what: Solid | Wire) -> bool:
    dome = sessions.current().dome
    return dome is not None and dome.draw_shape(_shape(what))


@lru_cache(maxsize=64)
def _shape(what: Solid | Wire) -> Shape:
    if isinstance(what, Solid):
        return Shape(what.vertices.interleaved, GL.GL_TRIANGLES, what.triangles)
    return Shape(what.vertices.interleaved, GL.GL_LINES, what.lines)


def draw_lines(vertices: Floats, lines: Indices, strips: Iterable[Strips]) -> None:
    """Draw lines (m, 2), or, under a stipple pattern, the strips that they were cut from."""
    if GL.glIsEnabled(GL.GL_LINE_STIPPLE):
        rows = [(strip.closed, row) for strip in strips for row in strip.indices]
        draw(vertices, [(GL.GL_LINE_LOOP if closed else GL.GL_LINE_STRIP, row) for closed, row in rows])
    else:
        draw(vertices, [(GL.GL_LINES, lines)])


def draw(vertices: Floats, parts: Iterable[tuple[int, Indices]]) -> None:
    """Draw parts (mode, indices) of an interleaved block: (n, 2) position, (n, 6) normal and position,
    (n, 8) texture coordinates, normal and position.

    glPopClientAttrib brings back the program's arrays, and its buffer and array object bindings, which belong
    to the same attribute group (ARB_vertex_buffer_object, ARB_vertex_array_object).
    """
    GL.glPushClientAttrib(GL.GL_CLIENT_VERTEX_ARRAY_BIT)
    try:
        _unbind_buffers()
        # This one call also switches off the program's colour, index, edge flag, and fog arrays.
        GL.glInterleavedArrays(getattr(GL, _LAYOUTS[vertices.shape[1]]), 0, vertices)
        for mode, indices in parts:
            GL.glDrawElements(mode, indices.size, _index_type(indices), indices)
    finally:
        GL.glPopClientAttrib()


def _unbind_buffers() -> None:
    # Unasked, for asking takes ten times as long. The functions are false where the driver has none such.
    if GL.glBindVertexArray:
        GL.glBindVertexArray(0)
    if GL.glBindBuffer:
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, 0)
        GL.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, 0)


def _index_type(indices: NDArray[np.unsignedinteger]) -> int:
    return int(GL.GL_UNSIGNED_SHORT if indices.dtype == np.uint16 else GL.GL_UNSIGNED_INT)
