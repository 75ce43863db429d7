"""What the GPU makes of a draw: the final vertices, caught by transform feedback before they are rasterised.

A driver of this kind stands where the dome's own does, and the pipeline notices nothing.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from ctypes import POINTER, c_char, c_char_p, c_int, c_void_p, cast
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from domeshim.driver import Driver

_FEEDBACK_BUFFER, _INTERLEAVED, _STREAM_READ, _WRITTEN = 0x8C8E, 0x8C8C, 0x88E1, 0x8C88
_QUERY_RESULT, _RASTERIZER_DISCARD, _CURRENT_PROGRAM, _LINK_STATUS = 0x8866, 0x8C89, 0x8B8D, 0x8B82
_PATCHES, _PATCH_VERTICES = 0x000E, 0x8E72
_POSITION, _DISTANCE = b"gl_Position", b"gl_ClipDistance[0]"
_FIRST_ROOM = 1 << 22


@dataclass(frozen=True)
class Caught:
    """Primitives of one kind as they go to the rasteriser."""

    positions: NDArray[np.float32]
    """(n, corners, 4): gl_Position; corners: 1, 2 or 3."""
    distances: NDArray[np.float32]
    """(n, corners): the dome's own clip distance, else the near plane's; negative where it cuts."""


class CatchingDriver(Driver):
    """GL whose draws, made through this driver, are caught and not rasterised.

    Needs a current context of GL 3.0 or later; its programs must be linked through it.
    """

    def __init__(self) -> None:
        from OpenGL import GL  # noqa: PLC0415 - not before PYOPENGL_PLATFORM is chosen

        self._gl: Any = GL
        self._plain = Driver()
        self._buffer = int(GL.glGenBuffers(1))
        self._room = 0
        self._query = int(np.ravel(GL.glGenQueries(1))[0])
        self._cuts: dict[int, bool] = {}
        self.caught: list[Caught] = []
        """All that was drawn since this was last emptied."""

    def glLinkProgram(self, program: int) -> None:  # noqa: N802 - GL's own name
        """Link a program so that its vertices can be caught."""
        self._cuts[program] = self._link(program, (_POSITION, _DISTANCE))
        if not self._cuts[program]:
            self._link(program, (_POSITION,))

    def _link(self, program: int, names: tuple[bytes, ...]) -> bool:
        pointers = cast((c_char_p * len(names))(*names), POINTER(POINTER(c_char)))
        self._gl.glTransformFeedbackVaryings(program, len(names), pointers, _INTERLEAVED)
        self._plain.glLinkProgram(program)
        linked = c_int()
        self._plain.glGetProgramiv(program, _LINK_STATUS, linked)
        return bool(linked.value)

    def glDrawArrays(self, mode: int, first: int, count: int) -> None:  # noqa: N802 - GL's own name
        """Draw, and keep what comes out; once more with more room where it did not fit."""
        corners = self._corners(mode)
        cuts = self._cuts[self.integer(_CURRENT_PROGRAM)]
        numbers = 5 if cuts else 4
        primitive = 4 * corners * numbers
        self._make_room(_FIRST_ROOM)
        while True:
            with self._catching(corners):
                self._plain.glDrawArrays(mode, first, count)
            written = int(np.ravel(self._gl.glGetQueryObjectuiv(self._query, _QUERY_RESULT))[0])
            if (written + 1) * primitive <= self._room:
                break
            self._make_room(4 * self._room)
        data = np.empty((written, corners, numbers), np.float32)
        if written:
            self._gl.glBindBuffer(_FEEDBACK_BUFFER, self._buffer)
            self._plain.glGetBufferSubData(_FEEDBACK_BUFFER, 0, data.nbytes, data.ctypes.data_as(c_void_p))
            self._gl.glBindBuffer(_FEEDBACK_BUFFER, 0)
        distances = data[..., 4] if cuts else data[..., 2] + data[..., 3]
        self.caught.append(Caught(data[..., :4], distances))

    def glMultiDrawArrays(self, mode: int, firsts: Any, counts: Any, draws: int) -> None:  # noqa: N802
        """Draw, and keep what comes out."""
        for first, count in zip(firsts[:draws], counts[:draws], strict=True):
            self.glDrawArrays(mode, first, count)

    @contextmanager
    def _catching(self, corners: int) -> Iterator[None]:
        gl = self._gl
        gl.glEnable(_RASTERIZER_DISCARD)
        gl.glBindBufferBase(_FEEDBACK_BUFFER, 0, self._buffer)
        gl.glBeginQuery(_WRITTEN, self._query)
        gl.glBeginTransformFeedback((0, 1, 4)[corners - 1])
        try:
            yield
        finally:
            gl.glEndTransformFeedback()
            gl.glEndQuery(_WRITTEN)
            gl.glBindBufferBase(_FEEDBACK_BUFFER, 0, 0)
            gl.glDisable(_RASTERIZER_DISCARD)

    def _corners(self, mode: int) -> int:
        if mode == _PATCHES:
            return min(self.integer(_PATCH_VERTICES), 3)  # a quad comes out as triangles
        return 1 if mode == 0 else 2 if mode <= 3 else 3

    def _make_room(self, size: int) -> None:
        if size > self._room:
            self._gl.glBindBuffer(_FEEDBACK_BUFFER, self._buffer)
            self._gl.glBufferData(_FEEDBACK_BUFFER, size, None, _STREAM_READ)
            self._gl.glBindBuffer(_FEEDBACK_BUFFER, 0)
            self._room = size
