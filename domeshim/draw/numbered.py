"""Draws whose vertices have nothing but their numbers, from which the shader makes their places."""

from __future__ import annotations

import numpy as np

from domeshim.draw.client_arrays import client_arrays, switch_off
from domeshim.driver import Driver
from domeshim.shading.draft import Source, version_for
from domeshim.shading.snippets import snippet

_V2F = 0x2A20


def source(gl: Driver, *names: str) -> Source:
    """A shader of these snippets, in the GLSL that this OpenGL has."""
    return Source.join(((name, snippet(name)) for name in names), version_for(legacy=gl.legacy))


def numbered(gl: Driver, *names: str) -> Source:
    """The same of a vertex shader; number() is there the vertex's."""
    return source(gl, "frame/number_legacy" if gl.legacy else "frame/number", *names)


def draw_numbered(gl: Driver, mode: int, first: int, count: int) -> None:
    """Draw so many vertices, the first of which has this number."""
    if not gl.legacy:
        gl.glDrawArrays(mode, first, count)
        return
    numbers = np.zeros((count, 2), np.float32)
    numbers[:, 0] = np.arange(first, first + count)
    with client_arrays(gl):
        switch_off(gl)
        gl.glInterleavedArrays(_V2F, 0, numbers.ctypes.data)
        gl.glDrawArrays(mode, 0, count)
