"""Arrays in memory of our own, whatever arrays the program has."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from domeshim.driver import Driver

_CLIENT_VERTEX_ARRAY_BIT, _ARRAY_BUFFER, _ELEMENT_ARRAY_BUFFER = 0x2, 0x8892, 0x8893
_ARRAYS = (0x8074, 0x8075, 0x8076, 0x8077, 0x8079, 0x8457, 0x845E)
"""Of vertices, normals, colours, indices, edge flags, fog coordinates, secondary colours."""
_TEXTURE_COORD_ARRAY, _MAX_TEXTURE_COORDS, _MAX_VERTEX_ATTRIBS, _TEXTURE0 = 0x8078, 0x8871, 0x8869, 0x84C0


@contextmanager
def client_arrays(gl: Driver) -> Iterator[None]:
    """Within it pointers go to memory; after it the program's arrays are as they were.

    glPopClientAttrib brings back the program's arrays, and its buffer and array object bindings, which
    belong to the same attribute group (ARB_vertex_buffer_object, ARB_vertex_array_object).
    """
    gl.glPushClientAttrib(_CLIENT_VERTEX_ARRAY_BIT)
    if gl.has("glBindVertexArray"):
        gl.glBindVertexArray(0)
    gl.glBindBuffer(_ARRAY_BUFFER, 0)
    gl.glBindBuffer(_ELEMENT_ARRAY_BUFFER, 0)
    try:
        yield
    finally:
        gl.glPopClientAttrib()


def switch_off(gl: Driver) -> None:
    """Switch off every array of the program's; client_arrays brings them back."""
    for unit in reversed(range(gl.integer(_MAX_TEXTURE_COORDS))):
        gl.glClientActiveTexture(_TEXTURE0 + unit)
        gl.glDisableClientState(_TEXTURE_COORD_ARRAY)
    for array in _ARRAYS:
        gl.glDisableClientState(array)
    for number in range(gl.integer(_MAX_VERTEX_ATTRIBS)):
        gl.glDisableVertexAttribArray(number)
