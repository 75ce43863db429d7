"""What the program draws by glBegin..glEnd, gathered until something else happens to GL.

PyOpenGL passes over arguments too many (glColor3f with an alpha), so the functions here do.

A recorded vertex costs a tenth of a PyOpenGL call. Attributes are kept as events, (vertex, values), so that
a colour set once costs once; blocks that follow each other become one draw.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from domeshim.record.attributes import DEFAULTS, Setter
from domeshim.record.runs import INDEPENDENT, Block, Run

Call = Callable[..., None]

_FREQUENT = ("color", "normal", "texture0")


@dataclass
class Events:
    """One attribute's changes: before which float of the positions, and to what."""

    size: int
    places: list[int] = field(default_factory=list)
    values: list[float] = field(default_factory=list)

    @property
    def last(self) -> tuple[float, ...]:
        """The value set last."""
        return tuple(self.values[-self.size :])


class Immediate:
    """The recorder of one session: GL's Begin/End paradigm allows one at a time."""

    def __init__(self) -> None:
        self.positions: list[float] = []
        """x, y, z of each vertex."""
        self.attributes = {name: Events(len(default)) for name, default in DEFAULTS.items()}
        self.block: Block | None = None
        self.blocks: list[Block] = []
        self.rare: list[None] = []
        """Not empty where an attribute that is none of _FREQUENT was set."""
        self.extras = False
        """Calls were made between glBegin and glEnd that set no attribute."""
        self._w: dict[int, float] = {}

    def pending(self) -> Callable[[], object]:
        """A function that tells whether GL has yet to see something; it is called before every GL call."""
        blocks, positions, rare = self.blocks, self.positions, self.rare
        color, normal, texture = (self.attributes[name].places for name in _FREQUENT)
        return lambda: blocks or color or normal or texture or positions or rare

    @property
    def used(self) -> list[tuple[str, Events]]:
        """The attributes that were set, by name."""
        names = self.attributes if self.rare else _FREQUENT
        return [(name, self.attributes[name]) for name in names if self.attributes[name].places]

    @property
    def materials(self) -> bool:
        """A material was set between the vertices of a primitive."""
        return bool(self.rare) and any(" " in name for name, _ in self.used)

    def begin(self, mode: int) -> None:
        """glBegin."""
        if self.block is None:
            self.block = Block(int(mode), len(self.positions) // 3)
            self.blocks.append(self.block)

    def end(self) -> None:
        """glEnd."""
        block = self.block
        if block is not None:
            block.end = len(self.positions) // 3
            self.block = None
            if block.end == block.first:
                self.blocks.pop()

    @property
    def has_w(self) -> bool:
        """Some vertex has a fourth coordinate other than 1."""
        return bool(self._w)

    @property
    def sets_late(self) -> bool:
        """Some attribute is first set after vertices that have whatever value is current."""
        first = 3 * self.blocks[0].first if self.blocks else -1
        return any(events.places[0] > first for _, events in self.used)

    def w(self, vertex: int) -> float:
        """A vertex's fourth coordinate."""
        return self._w.get(vertex, 1.0)

    @property
    def on_border(self) -> bool:
        """Between glBegin and glEnd no primitive has been begun and not finished."""
        assert self.block is not None
        count = len(self.positions) // 3 - self.block.first
        return count % INDEPENDENT.get(self.block.mode, count + 1) == 0 and not self.block.extras

    def material(self, parts: dict[str, tuple[float, ...]]) -> None:
        """A glMaterial between glBegin and glEnd; parts: attribute -> values."""
        for name, values in parts.items():
            self.rare.append(None)
            self.attributes[name].places.append(len(self.positions))
            self.attributes[name].values.extend(values)

    def inside(self, extra: Callable[[], object]) -> None:
        """A call between glBegin and glEnd that is no attribute is kept in its place."""
        assert self.block is not None
        self.extras = True
        self.block.extras[len(self.positions) // 3] = extra
        self.positions.extend((0.0, 0.0, 0.0))

    def take(self) -> Run:
        """What was recorded since the last time, as arrays; the recorder is empty then."""
        positions = _floats(self.positions).reshape(-1, 3)
        count = len(positions)
        if self._w:
            w = np.ones((count, 1), np.float32)
            w[list(self._w), 0] = list(self._w.values())
            positions = np.hstack([positions, w])
        first = 3 * self.blocks[0].first if self.blocks else 0
        varying = {n: events for n, events in self.used if events.places[-1] > first or " " in n}
        run = Run(
            positions,
            {name: _spread(events, count) for name, events in varying.items()},
            tuple(self.blocks),
            tuple((name, events.last) for name, events in varying.items()),
            tuple((name, events.last) for name, events in self.used if name not in varying),
        )
        self.clear()
        return run

    def clear(self) -> None:
        """Forget what was recorded."""
        for _, events in self.used:
            events.places.clear()
            events.values.clear()
        self.positions.clear()
        self._w.clear()
        self.blocks.clear()
        self.rare.clear()
        self.extras = False

    def recording(self, setter: Setter) -> Call:
        """The function that records one GL name; it is called for each vertex, so it does nothing else."""
        if setter.attribute == "vertex":
            return self._vertex(setter)
        if setter.attribute == "texture":
            return self._unit_texture(setter)
        return self._attribute(setter, self.attributes[setter.attribute])

    def _vertex(self, setter: Setter) -> Call:
        positions, extend, w = self.positions, self.positions.extend, self._w

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

    def _attribute(self, setter: Setter, events: Events) -> Call:
        positions, mark, extend = self.positions, events.places.append, events.values.extend
        scale, offset, most = setter.scale, setter.offset, setter.count or events.size
        default = DEFAULTS[setter.attribute]
        note = self.rare.append

        def rarely(*values: float) -> None:
            values = values[:most]
            note(None)
            mark(len(positions))
            extend([scale * v + offset for v in values])
            extend(default[len(values) :])

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
            values = values[:most]
            mark(len(positions))
            extend([scale * v + offset for v in values])
            extend(default[len(values) :])

        def in_bytes(*values: int) -> None:
            values = values[:most]
            mark(len(positions))
            extend([table[v & 255] for v in values])
            extend(default[len(values) :])

        def plain(*values: float) -> None:
            values = values[:most]
            mark(len(positions))
            extend(values)
            extend(default[len(values) :])

        if setter.attribute not in _FREQUENT:
            return _by_arguments(setter, dict.fromkeys(range(1, 5), rarely))
        if setter.bytes_as:
            table = setter.bytes_as
            return _by_arguments(setter, dict.fromkeys(range(1, 5), in_bytes))
        if scale != 1:
            return _by_arguments(setter, dict.fromkeys(range(1, 5), scaled))
        fast: dict[int, Call] = {3: three} if events.size == 3 else {2: texture2, 3: color3}
        return _by_arguments(setter, dict.fromkeys(range(1, 5), plain) | fast)

    def _unit_texture(self, setter: Setter) -> Call:
        units = [
            self._attribute(
                Setter(f"texture{unit}", setter.count, setter.vector, 1.0, 0.0),
                self.attributes[f"texture{unit}"],
            )
            for unit in range(8)
        ]

        def call(target: int, *values: Any) -> None:
            unit = int(target) - 0x84C0
            if 0 <= unit < len(units):  # GL has no coordinates for others
                units[unit](*values)

        return call


def _by_arguments(setter: Setter, by_count: dict[int, Call]) -> Call:
    """The function for a name's number of values, given one by one or as a vector."""
    if setter.count is None:

        def any_count(*values: Any) -> None:
            values = tuple(values[0]) if len(values) == 1 else values
            by_count[min(len(values), 4)](*values)

        return any_count
    call, count = by_count[setter.count], setter.count
    if not setter.vector:
        return call

    def vector1(v: Any) -> None:
        call(v[0] if isinstance(v, Sequence) or hasattr(v, "__getitem__") else v)

    def vector2(v: Any) -> None:
        try:
            call(v[0], v[1])
        except IndexError:
            call(*_nested(setter, v))

    def vector3(v: Any) -> None:
        try:
            call(v[0], v[1], v[2])
        except IndexError:
            call(*_nested(setter, v))

    def vector4(v: Any) -> None:
        try:
            call(v[0], v[1], v[2], v[3])
        except IndexError:
            call(*_nested(setter, v))

    return (vector1, vector2, vector3, vector4)[count - 1]


def _nested(setter: Setter, vector: Any) -> list[Any]:
    """The numbers of a vector that is the one row of a matrix."""
    numbers: list[Any] = np.ravel(vector).tolist()
    if len(numbers) != setter.count:
        raise ValueError(f"{setter.count} numbers are wanted, not {vector!r}")
    return numbers


def _floats(values: list[float]) -> NDArray[np.float32]:
    try:
        return np.array(values, np.float32)
    except ValueError:  # arrays of one number among them, which GL's own calls take as well
        return np.array([float(value) for value in values], np.float32)


def _spread(events: Events, count: int) -> NDArray[np.float32]:
    """Each vertex's value: that of the last event before it, nan before the first."""
    values = _floats(events.values).reshape(-1, events.size)
    starts = np.array([*events.places, 3 * count]) // 3
    spread = np.repeat(values, starts[1:] - starts[:-1], axis=0)
    if starts[0] == 0:
        return spread
    return np.concatenate([np.full((starts[0], events.size), np.nan, np.float32), spread])
