"""Vertices that GL makes for itself, caught by transform feedback before anything is drawn of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from ctypes import c_uint, c_void_p

import numpy as np
from numpy.typing import NDArray

from domeshim.driver import Driver

_FEEDBACK_BUFFER, _STREAM_READ, _WRITTEN = 0x8C8E, 0x88E1, 0x8C88
_FEEDBACK_BUFFER_BINDING, _QUERY_RESULT, _RASTERIZER_DISCARD = 0x8C8F, 0x8866, 0x8C89
_PRIMITIVES = {1: 0, 2: 1, 3: 4}
"""GL_POINTS, GL_LINES, GL_TRIANGLES, by how many corners they have."""
_FIRST_ROOM = 1 << 20
OLDEST_GL = (3, 0)
"""From here on GL has transform feedback."""


class Catcher:
    """Catches what draws hand to the rasteriser, which draws nothing. Needs OLDEST_GL."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._buffer = self._query = self._room = 0

    def catch(self, draw: Callable[[], object], corners: int, numbers: int) -> NDArray[np.float32]:
        """(n, corners, numbers): each primitive that draw() makes, strips and fans taken apart.

        corners: 1, 2 or 3, of those that are wanted: GL refuses to make others meanwhile, and the errors that
        it leaves then are cleared. numbers: how many the bound program has transform feedback take of each
        vertex. What does not fit is drawn once more.
        """
        self._make_room(_FIRST_ROOM)
        primitive = 4 * corners * numbers
        while True:
            with self._catching(corners):
                draw()
            written = c_uint()
            self._driver.glGetQueryObjectuiv(self._query, _QUERY_RESULT, written)
            if (written.value + 1) * primitive <= self._room:
                return self._read((written.value, corners, numbers))
            self._make_room(4 * self._room)

    @contextmanager
    def _catching(self, corners: int) -> Iterator[None]:
        gl = self._driver
        discarded, bound = gl.glIsEnabled(_RASTERIZER_DISCARD), gl.integer(_FEEDBACK_BUFFER_BINDING)
        gl.glEnable(_RASTERIZER_DISCARD)
        gl.glBindBufferBase(_FEEDBACK_BUFFER, 0, self._buffer)
        gl.glBeginQuery(_WRITTEN, self._query)
        gl.glBeginTransformFeedback(_PRIMITIVES[corners])
        try:
            yield
        finally:
            gl.glEndTransformFeedback()
            while gl.glGetError():
                pass
            gl.glEndQuery(_WRITTEN)
            gl.glBindBufferBase(_FEEDBACK_BUFFER, 0, bound)
            if not discarded:
                gl.glDisable(_RASTERIZER_DISCARD)

    def _read(self, shape: tuple[int, ...]) -> NDArray[np.float32]:
        data = np.empty(shape, np.float32)
        if data.size:
            with self._bound():
                where = data.ctypes.data_as(c_void_p)
                self._driver.glGetBufferSubData(_FEEDBACK_BUFFER, 0, data.nbytes, where)
        return data

    def _make_room(self, size: int) -> None:
        if size <= self._room:
            return
        gl = self._driver
        if not self._buffer:
            buffer, query = c_uint(), c_uint()
            gl.glGenBuffers(1, buffer)
            gl.glGenQueries(1, query)
            self._buffer, self._query = buffer.value, query.value
        with self._bound():
            gl.glBufferData(_FEEDBACK_BUFFER, size, None, _STREAM_READ)
        self._room = size

    @contextmanager
    def _bound(self) -> Iterator[None]:
        bound = self._driver.integer(_FEEDBACK_BUFFER_BINDING)
        self._driver.glBindBuffer(_FEEDBACK_BUFFER, self._buffer)
        yield
        self._driver.glBindBuffer(_FEEDBACK_BUFFER, bound)
