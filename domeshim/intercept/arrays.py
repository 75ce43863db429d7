"""The intercepted draws from vertex arrays, and the calls that change what lies in buffers."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from domeshim.intercept.dome import Dome

if TYPE_CHECKING:
    from domeshim.record.arrays import Elements

Call = Callable[..., Any]

_POINTS = 0


def draw_arrays(dome: Dome, original: Call) -> Call:
    """glDrawArrays."""

    def call(mode: int, first: int, count: int, *_more: object) -> Any:
        return _draw(dome, mode, lambda: range(first, first + count), lambda: original(mode, first, count))

    return call


def draw_elements(dome: Dome, original: Call) -> Call:
    """glDrawElements."""

    def call(mode: int, count: int, type: int, indices: Any) -> Any:  # noqa: A002 - PyOpenGL's own name
        return _draw(
            dome,
            mode,
            lambda: dome.read_elements(int(count), int(type), indices),
            lambda: original(mode, count, type, indices),
        )

    return call


def draw_range_elements(dome: Dome, original: Call) -> Call:
    """glDrawRangeElements."""

    def call(mode: int, start: int, end: int, count: int, type: int, indices: Any) -> Any:  # noqa: A002
        return _draw(
            dome,
            mode,
            lambda: dome.read_elements(int(count), int(type), indices),
            lambda: original(mode, start, end, count, type, indices),
        )

    return call


def _draw(
    dome: Dome, mode: int, vertices: Callable[[], range | Elements], whole: Callable[[], object]
) -> object:
    """Draw from arrays in patches where that is needed, else whole, by GL's own call."""
    context = dome.context
    if context is None:
        return whole()
    dome.drawing()
    if context.own.current is not None:
        if dome.draw_own(int(mode), vertices):
            return None
    elif context.subdividing.may_subdivide and mode != _POINTS and dome.draw_arrays(int(mode), vertices()):
        return None
    return None if dome.listed(whole) else context.draw(whole)


def writes_buffer(dome: Dome, original: Call) -> Call:
    """A call after which a buffer may hold something else."""

    def call(*args: Any, **named: Any) -> Any:
        dome.buffers_changed()
        return original(*args, **named)

    return call
