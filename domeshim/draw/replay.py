"""A recorded run goes to GL as it was given, call by call: the cheaper way for a few vertices."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from operator import itemgetter
from typing import TYPE_CHECKING

from domeshim.driver import Driver
from domeshim.record.immediate import Immediate
from domeshim.record.runs import Block

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext

_Change = tuple[int, Callable[..., None], list[float]]
"""Before which vertex, and what to call with which values."""
_NEVER = 1 << 62


def replay(
    gl: Driver, recorder: Immediate, setters: Mapping[str, Callable[..., None]], mode: int | None = None
) -> None:
    """Make the recorded calls; vertices outside glBegin..glEnd as well where there is no block at all.

    Such vertices are a display list's, to be called between the caller's glBegin and glEnd. mode: of all
    blocks, if not their own.
    """
    if recorder.alike:
        for name, events in recorder.used:
            setters[name](*events.last)
        for block in recorder.blocks:
            _plain_block(gl, recorder.positions, block)
        return
    changes = _changes(recorder, setters)
    k = 0
    for block in recorder.blocks or [_loose(recorder)]:
        while changes[k][0] <= block.first:
            changes[k][1](*changes[k][2])
            k += 1
        if recorder.blocks:
            gl.glBegin(block.mode if mode is None else mode)
        k = _vertices(gl, recorder, block, changes, k)
        if recorder.blocks:
            gl.glEnd()
    for _, setter, values in changes[k:-1]:
        setter(*values)


def _plain_block(gl: Driver, positions: Sequence[float], block: Block) -> None:
    vertex, coordinates = gl.glVertex3f, iter(positions[3 * block.first : 3 * block.end])
    gl.glBegin(block.mode)
    for x, y, z in zip(coordinates, coordinates, coordinates, strict=True):
        vertex(x, y, z)
    gl.glEnd()


def _loose(recorder: Immediate) -> Block:
    return Block(-1, 0, len(recorder.positions) // 3)


def _vertices(gl: Driver, recorder: Immediate, block: Block, changes: list[_Change], k: int) -> int:
    """One block's vertices, the changes and the other calls between them; the number of the next change."""
    positions, has_w, vertex3, vertex4 = recorder.positions, recorder.has_w, gl.glVertex3f, gl.glVertex4f
    next_change = changes[k][0]
    extras = block.extras
    for vertex in range(block.first, block.end):
        while next_change <= vertex:
            changes[k][1](*changes[k][2])
            k += 1
            next_change = changes[k][0]
        if extras and vertex in extras:
            extras[vertex]()
            continue
        x, y, z = positions[3 * vertex : 3 * vertex + 3]
        if has_w:
            vertex4(x, y, z, recorder.w.get(vertex, 1.0))
        else:
            vertex3(x, y, z)
    return k


def _changes(recorder: Immediate, setters: Mapping[str, Callable[..., None]]) -> list[_Change]:
    """All attributes' changes, rising; the last one never comes."""
    changes = [
        (place // 3, setters[name], events.values[events.size * i : events.size * (i + 1)])
        for name, events in recorder.used
        for i, place in enumerate(events.places)
    ]
    changes.sort(key=itemgetter(0))
    changes.append((_NEVER, setters["edge"], []))
    return changes


@contextmanager
def inside_block(context: DomeContext) -> Iterator[None]:
    """GL stands between glBegin and glEnd: nothing of ours comes in, nor PyOpenGL's question for errors."""
    from OpenGL.raw.GL import _errors  # noqa: PLC0415 - not before the program has imported OpenGL

    checker, compiling = _errors._error_checker, context.compiling
    context.compiling = True
    if checker:
        checker.onBegin()
    try:
        yield
    finally:
        context.compiling = compiling
        if checker:
            checker.onEnd()
