"""The functions that record what a program sets between glBegin and glEnd, one for each GL name.

PyOpenGL passes over arguments too many (glColor3f with an alpha), so they do.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from domeshim.record.attributes import DEFAULTS, Setter
from domeshim.record.immediate import FREQUENT, Immediate
from domeshim.record.vectors import PLAIN, size_of_vector, vector_reader

Call = Callable[..., None]

_TEXTURE0, _UNITS = 0x84C0, 8


def recording(recorder: Immediate, setter: Setter) -> Call:
    """The function that records one GL name; it is called for each vertex, so it does nothing else."""
    if setter.attribute == "vertex":
        return _vertex(recorder, setter)
    if setter.attribute == "texture":
        return _unit_texture(recorder, setter)
    return _attribute(recorder, setter)


def _vertex(recorder: Immediate, setter: Setter) -> Call:
    positions, extend, w = recorder.positions, recorder.positions.extend, recorder.w

    def vertex2(x: float, y: float, *_more: object) -> None:
        extend((x, y, 0.0))

    def vertex3(x: float, y: float, z: float, *_more: object) -> None:
        extend((x, y, z))

    def vertex4(x: float, y: float, z: float, homogeneous: float, *_more: object) -> None:
        if homogeneous != 1:
            w[len(positions) // 3] = homogeneous
        extend((x, y, z))

    by_count: dict[int, Call] = {2: vertex2, 3: vertex3, 4: vertex4}
    return _by_arguments(setter, by_count)


def _attribute(recorder: Immediate, setter: Setter) -> Call:
    events = recorder.attributes[setter.attribute]
    positions, mark, extend = recorder.positions, events.places.append, events.values.extend
    scale, offset, most = setter.scale, setter.offset, setter.count or events.size
    default = DEFAULTS[setter.attribute]
    note = recorder.rare.append

    def rarely(*values: float) -> None:
        found = [scale * v + offset for v in values[:most]]
        note(None)
        mark(len(positions))
        extend(found)
        extend(default[len(found) :])

    def three(x: float, y: float, z: float, *_more: object) -> None:
        mark(len(positions))
        extend((x, y, z))

    def color3(r: float, g: float, b: float, *_more: object) -> None:
        mark(len(positions))
        extend((r, g, b, 1.0))

    def texture2(s: float, t: float, *_more: object) -> None:
        mark(len(positions))
        extend((s, t, 0.0, 1.0))

    def scaled(*values: float) -> None:
        found = [scale * v + offset for v in values[:most]]
        mark(len(positions))
        extend(found)
        extend(default[len(found) :])

    def in_bytes(*values: int) -> None:
        found = [table[v & 255] for v in values[:most]]
        mark(len(positions))
        extend(found)
        extend(default[len(found) :])

    def plain(*values: float) -> None:
        values = values[:most]
        mark(len(positions))
        extend(values)
        extend(default[len(values) :])

    if setter.attribute not in FREQUENT:
        return _by_arguments(setter, dict.fromkeys(range(1, 5), rarely))
    if setter.bytes_as:
        table = setter.bytes_as
        return _by_arguments(setter, dict.fromkeys(range(1, 5), in_bytes))
    if scale != 1:
        return _by_arguments(setter, dict.fromkeys(range(1, 5), scaled))
    fast: dict[int, Call] = {3: three} if events.size == 3 else {2: texture2, 3: color3}
    return _by_arguments(setter, dict.fromkeys(range(1, 5), plain) | fast)


def _unit_texture(recorder: Immediate, setter: Setter) -> Call:
    units: dict[int, Call] = {}

    def call(target: int, *values: Any) -> None:
        unit = int(target) - _TEXTURE0
        if unit not in units:
            if not 0 <= unit < _UNITS:
                return  # GL has no coordinates for it
            of_unit = replace(setter, attribute=f"texture{unit}")
            units[unit] = _attribute(recorder, of_unit)
        units[unit](*values)

    return call


def _by_arguments(setter: Setter, by_count: dict[int, Call]) -> Call:
    """The function for a name's number of values, given one by one or as a vector."""
    if setter.count is None:
        return _any_count(setter, by_count)
    call, count = by_count[setter.count], setter.count
    if not setter.vector:
        return call
    read = vector_reader(setter.kind, count)

    def vector1(v: Any, *_more: object) -> None:
        call(*read(v))

    # In each, a row that does not fit is PyOpenGL's to judge.

    def vector2(v: Any, *_more: object) -> None:
        try:
            x, y = v if type(v) in PLAIN else read(v)
        except ValueError:
            x, y = read(v)
        call(x, y)

    def vector3(v: Any, *_more: object) -> None:
        try:
            x, y, z = v if type(v) in PLAIN else read(v)
        except ValueError:
            x, y, z = read(v)
        call(x, y, z)

    def vector4(v: Any, *_more: object) -> None:
        try:
            x, y, z, w = v if type(v) in PLAIN else read(v)
        except ValueError:
            x, y, z, w = read(v)
        call(x, y, z, w)

    return (vector1, vector2, vector3, vector4)[count - 1]


def _any_count(setter: Setter, by_count: dict[int, Call]) -> Call:
    """The function of a name that says no number: glVertex and glColor."""
    readers = {count: vector_reader("f", count) for count in (3, 4)}

    def any_count(*values: Any) -> None:
        given: Any = values[0] if len(values) == 1 else values
        if setter.attribute == "color" and not (type(given) in PLAIN and len(given) in readers):
            given = readers[size_of_vector(given)](given)
        by_count[len(given)](*given)

    return any_count
