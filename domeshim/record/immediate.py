"""What the program draws by glBegin..glEnd or as bitmaps, gathered until something else happens to GL.

A recorded vertex costs a tenth of a PyOpenGL call. Attributes are kept as events, (vertex, values), so that
a colour set once costs once; blocks that follow each other become one draw.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from domeshim.record.attributes import DEFAULTS
from domeshim.record.bitmaps import Bitmap
from domeshim.record.runs import INDEPENDENT, Block, Run

_ARRAYS: tuple[type, ...] = (np.ndarray, np.matrix)
FREQUENT = ("color", "normal", "texture0")
"""The attributes that most programs set; of the others Immediate.rare tells."""


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
        self._frequent = tuple((name, self.attributes[name]) for name in FREQUENT)
        self.block: Block | None = None
        self.blocks: list[Block] = []
        self.rare: list[None] = []
        """Not empty where an attribute that is none of FREQUENT was set."""
        self.extras = False
        """Calls were made between glBegin and glEnd that set no attribute."""
        self.evaluates = True
        """Each of them evaluates a vertex."""
        self.w: dict[int, float] = {}
        """The fourth coordinates other than 1, by vertex."""
        self.bitmaps: list[Bitmap] = []
        """Bitmaps at the raster position, drawn before all else that is recorded."""
        self._in_arrays = False
        """Some block's last vertex was made of arrays of one number: the column of a matrix."""
        self.pending = self._pending()
        """Tells whether GL has yet to see something; it is called before every GL call."""

    def _pending(self) -> Callable[[], object]:
        blocks, positions, rare, bitmaps = self.blocks, self.positions, self.rare, self.bitmaps
        color, normal, texture = (self.attributes[name].places for name in FREQUENT)
        return lambda: blocks or color or normal or texture or positions or rare or bitmaps

    @property
    def used(self) -> list[tuple[str, Events]]:
        """The attributes that were set, by name."""
        return [one for one in self._possible if one[1].places]

    @property
    def _possible(self) -> Iterable[tuple[str, Events]]:
        return self.attributes.items() if self.rare else self._frequent

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
            elif type(self.positions[-3]) in _ARRAYS:
                self._in_arrays = True

    @property
    def alike(self) -> bool:
        """Every vertex has the same attributes, and there is nothing else beside its place."""
        if not self.blocks or self.extras or self.w:
            return False
        first = 3 * self.blocks[0].first
        return not any(events.places and events.places[-1] > first for _, events in self._possible)

    @property
    def has_w(self) -> bool:
        """Some vertex has a fourth coordinate other than 1."""
        return bool(self.w)

    @property
    def sets_late(self) -> bool:
        """Some attribute is first set after vertices that have whatever value is current."""
        first = 3 * self.blocks[0].first if self.blocks else -1
        return any(events.places[0] > first for _, events in self.used)

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

    def inside(self, extra: Callable[[], object], *, evaluates: bool) -> None:
        """A call between glBegin and glEnd that is no attribute is kept in its place."""
        assert self.block is not None
        self.extras = True
        self.evaluates = self.evaluates and evaluates
        self.block.extras[len(self.positions) // 3] = extra
        self.positions.extend((0.0, 0.0, 0.0))

    @property
    def plain(self) -> bool:
        """It holds numbers, and not arrays of one number, as far as a look at a few of them tells."""
        for _, events in self._frequent:
            if events.values and type(events.values[0]) in _ARRAYS:
                return False
        return not self._in_arrays

    def settle(self) -> None:
        """Make plain numbers of what was recorded. Raises TypeError where something is no number."""
        for values in (self.positions, *(events.values for _, events in self.used)):
            values[:] = [_number(value) for value in values]

    def take(self) -> Run:
        """What was recorded since the last time, as arrays; the recorder is empty then.

        Raises TypeError where something is no number.
        """
        try:
            return self._run()
        finally:
            self.clear()

    def _run(self) -> Run:
        positions = _floats(self.positions).reshape(-1, 3)
        count = len(positions)
        if self.w:
            w = np.ones((count, 1), np.float32)
            w[list(self.w), 0] = list(self.w.values())
            positions = np.hstack([positions, w])
        first = 3 * self.blocks[0].first if self.blocks else 0
        varying = {n: events for n, events in self.used if events.places[-1] > first or " " in n}
        return Run(
            positions,
            {name: _spread(events, count) for name, events in varying.items()},
            tuple(self.blocks),
            tuple((name, events.last) for name, events in varying.items()),
            tuple((name, events.last) for name, events in self.used if name not in varying),
        )

    def moved(self) -> Immediate:
        """What was recorded, as plain numbers in a recorder of its own; this one is empty then.

        Raises TypeError where something is no number.
        """
        taken = Immediate()
        try:
            self.settle()
            self._copy_to(taken)
        finally:
            self.clear()
        return taken

    def _copy_to(self, taken: Immediate) -> None:
        for name, events in self.used:
            taken.attributes[name].places += events.places
            taken.attributes[name].values += events.values
        taken.positions += self.positions
        taken.blocks += self.blocks
        taken.rare += self.rare
        taken.w |= self.w
        taken.extras, taken.evaluates = self.extras, self.evaluates

    def clear(self) -> None:
        """Forget what was recorded."""
        for _, events in self._possible:
            events.places.clear()
            events.values.clear()
        self.positions.clear()
        self.w.clear()
        self.blocks.clear()
        self.bitmaps.clear()
        self.rare.clear()
        self.extras = self._in_arrays = False
        self.evaluates = True


def _floats(values: list[float]) -> NDArray[np.float32]:
    try:
        return np.array(values, np.float32)
    except (TypeError, ValueError):
        return np.array([_number(value) for value in values], np.float32)


def _number(value: Any) -> float:
    found = np.ravel(value).tolist()
    if len(found) == 1 and not isinstance(found[0], str | bytes):
        try:
            return float(found[0])
        except TypeError:
            pass
    raise TypeError(f"a vertex and its attributes are numbers, not {value!r}")


def _spread(events: Events, count: int) -> NDArray[np.float32]:
    """Each vertex's value: that of the last event before it, nan before the first."""
    values = _floats(events.values).reshape(-1, events.size)
    starts = np.array([*events.places, 3 * count]) // 3
    spread = np.repeat(values, starts[1:] - starts[:-1], axis=0)
    if starts[0] == 0:
        return spread
    return np.concatenate([np.full((starts[0], events.size), np.nan, np.float32), spread])
