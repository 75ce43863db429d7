"""The intercepted calls on the matrix stacks, in which a perspective may come."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from domeshim.intercept.dome import Dome
from domeshim.intercept.state_calls import kept_in_lists
from domeshim.state.perspective import frustum as frustum_matrix
from domeshim.state.perspective import is_perspective, perspective_part

Call = Callable[..., Any]

_PROJECTION = 0x1701


def matrix_mode(dome: Dome, original: Call) -> Call:
    """glMatrixMode."""

    def set_mode(mode: int) -> Any:
        if dome.context is not None:
            dome.context.matrix_mode_changed(int(mode))
        return original(mode)

    kept = kept_in_lists(lambda _dome, _original: set_mode)(dome, original)

    def call(mode: int) -> Any:
        if dome.building is not None:
            dome.building.matrix_mode = int(mode)
        return kept(mode)

    return call


def frustum(dome: Dome, original: Call) -> Call:
    """glFrustum."""

    def call(*planes: float) -> Any:
        if dome.context is not None and len(planes) == 6:
            dome.context.perspective_set(frustum_matrix(*planes))
        return original(*planes)

    return call


def load_matrix(dome: Dome, original: Call) -> Call:
    """glLoadMatrix and glMultMatrix: a perspective may come in either."""

    transposed = "Transpose" in getattr(original, "__name__", "")

    def load(m: Any) -> Any:
        context = dome.context
        if context is not None and context.on_projection:
            matrix = np.array(m, float).reshape(4, 4)
            matrix = matrix if transposed else matrix.T
            if is_perspective(matrix):
                context.perspective_set(perspective_part(matrix))
        return original(m)

    kept = kept_in_lists(lambda _dome, _original: load)(dome, original)

    def call(m: Any) -> Any:
        building = dome.building
        return kept(m) if building is None or building.matrix_mode == _PROJECTION else original(m)

    return call
