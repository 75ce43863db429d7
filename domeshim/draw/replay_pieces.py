"""A few recorded vertices are drawn in another order and mode, call by call: cheaper than arrays for them."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache, partial

from domeshim.draw.patches import corners
from domeshim.driver import Driver
from domeshim.record.immediate import Events, Immediate
from domeshim.record.runs import Block

Setters = Mapping[str, Callable[..., None]]
_Call = tuple[Callable[..., None], Sequence[float]]


def drawing_of(
    gl: Driver,
    recorder: Immediate,
    setters: Setters,
    block: Block,
    mode: int,
    order: Sequence[int] | None = None,
) -> Callable[[], None]:
    """What draws the primitives of a block by a mode, each with its own vertices and all their attributes.

    The block must be one that knows_all says yes to. order: of its vertices, if not that of its primitives.
    """
    before: list[_Call] = []
    varying: list[tuple[Callable[..., None], Events]] = []
    for name, events in recorder.used:
        if events.places[-1] <= 3 * block.first:
            before.append((setters[name], events.last))
        elif _inside(events, block):
            varying.append((setters[name], events))
        elif events.places[0] <= 3 * block.first:
            before.append((setters[name], _value_at(events, block.first)))
    order = order or _order(block.mode, block.end - block.first)
    return partial(_draw, gl, recorder, before, varying, block.first, mode, order)


def knows_all(recorder: Immediate) -> bool:
    """No vertex has a value that was current before all that is recorded, and then another."""
    return not any(
        _inside(events, block) and events.places[0] > 3 * block.first
        for _, events in recorder.used
        for block in recorder.blocks
    )


def _inside(events: Events, block: Block) -> bool:
    """The attribute changes between the vertices of a block."""
    places = events.places
    return bisect_right(places, 3 * block.first) != bisect_right(places, 3 * block.end - 3)


def _value_at(events: Events, vertex: int) -> Sequence[float]:
    number = bisect_right(events.places, 3 * vertex) - 1
    return events.values[events.size * number : events.size * (number + 1)]


def _draw(
    gl: Driver,
    recorder: Immediate,
    before: Sequence[_Call],
    varying: Sequence[tuple[Callable[..., None], Events]],
    first: int,
    mode: int,
    order: Sequence[int],
) -> None:
    positions, has_w, vertex3, vertex4 = recorder.positions, recorder.has_w, gl.glVertex3f, gl.glVertex4f
    for setter, value in before:
        setter(*value)
    gl.glBegin(mode)
    if not varying and not has_w:
        for corner in order:
            place = 3 * (first + corner)
            vertex3(*positions[place : place + 3])
        gl.glEnd()
        return
    for corner in order:
        vertex = first + corner
        for setter, events in varying:
            setter(*_value_at(events, vertex))
        x, y, z = positions[3 * vertex : 3 * vertex + 3]
        if has_w:
            vertex4(x, y, z, recorder.w.get(vertex, 1.0))
        else:
            vertex3(x, y, z)
    gl.glEnd()


@lru_cache(maxsize=256)
def _order(mode: int, count: int) -> tuple[int, ...]:
    """The vertices of a block's primitives, one primitive after the other."""
    return tuple(corners(mode, count).ravel().tolist())
