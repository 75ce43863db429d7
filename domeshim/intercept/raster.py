"""glGet of the raster position: the program asks where its text goes, and is told of its own window."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from domeshim.intercept.dome import Dome
from domeshim.intercept.state_calls import get as get_state

Call = Callable[..., Any]

_POSITION, _DISTANCE = 0x0B07, 0x0B09
"""GL_CURRENT_RASTER_POSITION and GL_CURRENT_RASTER_DISTANCE."""


def get(dome: Dome, original: Call) -> Call:
    """glGet and glIsEnabled."""
    call = get_state(dome, original)

    def answer(name: int, *args: Any) -> Any:
        found = call(name, *args)
        context = dome.context
        if name not in (_POSITION, _DISTANCE) or context is None or not context.pixels.placed:
            return found
        raster = context.pixels.raster
        told = (raster.position if name == _POSITION else raster.distance) if raster else None
        return found if told is None else _in_the_form_of(found, told)

    return answer


def _in_the_form_of(found: Any, told: tuple[float, ...] | float) -> Any:
    """What is told, as the array that was found, or the number."""
    values = np.asarray(told)
    if np.asarray(found).dtype.kind in "iu":
        values = np.rint(values)
    if isinstance(found, float | int | np.number):
        return type(found)(values)
    found[: values.size] = values.ravel().tolist()
    return found
