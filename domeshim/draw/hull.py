"""How large what GL evaluates can be at most, by the control points alone, so that far meshes need no look.

A Bézier patch lies within the hull of its control points, and its derivative within the hull of their
differences times the degree (Farin, "Curves and Surfaces for CAGD", chapters 5 and 15).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from ctypes import c_double, c_float, c_int
from functools import lru_cache

import numpy as np

from domeshim.draw.extent import Extent
from domeshim.driver import Driver

_COEFF, _ORDER, _DOMAIN = 0x0A00, 0x0A01, 0x0A02
_VERTEX_3 = {1: 0x0D97, 2: 0x0DB7}
_VERTEX_4 = {1: 0x0D98, 2: 0x0DB8}
_GRID_DOMAIN = {1: 0x0DD0, 2: 0x0DD2}
_GRID_SEGMENTS = {1: 0x0DD1, 2: 0x0DD3}


def mesh_extent(gl: Driver, limits: Sequence[int]) -> Extent | None:
    """What the program's glEvalMesh draws now lies within this; None where the control points do not tell.

    limits: the first and last step of the grid, for each parameter. Lines may be as short as can be.
    """
    parameters = len(limits) // 2
    if parameters not in _VERTEX_3 or gl.glIsEnabled(_VERTEX_4[parameters]):
        return None
    target = _VERTEX_3[parameters]
    orders = (c_int * parameters)()
    gl.glGetMapiv(target, _ORDER, orders)
    domain, points = (c_double * len(limits))(), (c_float * (3 * math.prod(orders)))()
    gl.glGetMapdv(target, _DOMAIN, domain)
    gl.glGetMapfv(target, _COEFF, points)
    segments = gl.integers(_GRID_SEGMENTS[parameters], parameters)
    grid = gl.doubles(_GRID_DOMAIN[parameters], len(limits))
    steps = []
    for i, count in enumerate(segments):
        low, high = sorted(domain[2 * i : 2 * i + 2])
        if min(grid[2 * i : 2 * i + 2]) < low or max(grid[2 * i : 2 * i + 2]) > high:
            return None  # beyond its domain a patch leaves the hull
        if min(limits[2 * i : 2 * i + 2]) < 0 or max(limits[2 * i : 2 * i + 2]) > count:
            return None
        steps.append(abs(grid[2 * i + 1] - grid[2 * i]) / (count * (high - low)))
    return _extent(bytes(points), tuple(orders), tuple(steps))


@lru_cache(maxsize=256)
def _extent(data: bytes, orders: tuple[int, ...], steps: tuple[float, ...]) -> Extent:
    """data: the control points, (*orders, 3) float32; steps: of the grid, as shares of the patch."""
    points = np.frombuffer(data, np.float32).reshape(*orders, 3).astype(float)
    longest = 0.0
    for axis, step in enumerate(steps):
        spans = np.linalg.norm(np.diff(points, axis=axis), axis=-1)
        longest += step * (orders[axis] - 1) * float(spans.max(initial=0.0))
    return Extent.of(points.reshape(-1, 3), longest)._replace(shortest_line=0.0)
