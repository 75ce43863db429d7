"""The intercepted draws from vertex arrays, and the calls that change what lies in buffers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from domeshim.intercept.dome import Dome

Call = Callable[..., Any]

_POINTS = 0


def draw_arrays(dome: Dome, original: Call) -> Call:
    """glDrawArrays."""

    def call(mode: int, first: int, count: int) -> Any:
        context = dome.context
        if context is None:
            return original(mode, first, count)
        dome.drawing()
        if (
            context.may_subdivide
            and mode != _POINTS
            and dome.draw_arrays(int(mode), range(first, first + count))
        ):
            return None
        context.dress()
        return original(mode, first, count)

    return call


def draw_elements(dome: Dome, original: Call) -> Call:
    """glDrawElements."""

    def call(mode: int, count: int, type: int, indices: Any) -> Any:  # noqa: A002 - PyOpenGL's own name
        context = dome.context
        if context is None:
            return original(mode, count, type, indices)
        dome.drawing()
        if context.may_subdivide and mode != _POINTS:
            elements = dome.read_elements(int(count), int(type), indices)
            if dome.draw_arrays(int(mode), elements):
                return None
        context.dress()
        return original(mode, count, type, indices)

    return call


def draw_range_elements(dome: Dome, original: Call) -> Call:
    """glDrawRangeElements."""

    def call(mode: int, start: int, end: int, count: int, type: int, indices: Any) -> Any:  # noqa: A002
        def whole(*_: Any) -> Any:
            return original(mode, start, end, count, type, indices)

        return draw_elements(dome, whole)(mode, count, type, indices)

    return call


def writes_buffer(dome: Dome, original: Call) -> Call:
    """A call after which a buffer may hold something else."""

    def call(*args: Any, **named: Any) -> Any:
        dome.buffers_changed()
        return original(*args, **named)

    return call
