"""What the bench found, row by row, as JSON and as a table."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, field
from math import inf
from statistics import median
from typing import Any

from domeshim import __version__
from domeshim.bench.edge_error import EdgeError


@dataclass(frozen=True)
class Seconds:
    """What one picture took: by the clock, and of the processors (all threads of the process)."""

    wall: float
    processor: float


@dataclass(frozen=True)
class Cost:
    """What a picture takes, against the stock monitor's in the same process, in turns: medians."""

    ratio: float
    """By the clock."""
    processor_ratio: float
    """Of the processors' time: what else runs on the machine matters less."""
    milliseconds: float
    stock_milliseconds: float
    rounds: int

    @classmethod
    def of(cls, pairs: Sequence[tuple[Seconds, Seconds]]) -> Cost:
        """From what it took and what the stock monitor took, round by round."""
        return cls(
            median(ours.wall / theirs.wall for ours, theirs in pairs),
            median(ours.processor / theirs.processor for ours, theirs in pairs),
            1000 * median(ours.wall for ours, _ in pairs),
            1000 * median(theirs.wall for _, theirs in pairs),
            len(pairs),
        )


@dataclass(frozen=True)
class Seen:
    """A program's dome picture, seen through the program's own perspective, against its monitor picture."""

    moved: float | None
    """The largest displacement in the monitor's pixels; None where too little is to be seen."""
    wrong: float
    """The share of the pixels that are wrong."""


@dataclass(frozen=True)
class Row:
    """One method on one scene at one size."""

    scene: str
    title: str
    size: int
    family: str
    detail: str
    cost: Cost
    edges: EdgeError | None = None
    colour: float | None = None
    """Root mean square, of 255."""
    seen: Seen | None = None
    """Of a user's program."""

    @classmethod
    def from_json(cls, read: dict[str, Any]) -> Row:
        """As asdict told it, infinities as None."""
        parts: dict[str, Any] = {"cost": Cost(**read["cost"])}
        if read["edges"] is not None:
            edges = {name: inf if value is None else value for name, value in read["edges"].items()}
            parts["edges"] = EdgeError(**edges)
        if read["seen"] is not None:
            parts["seen"] = Seen(**read["seen"])
        return cls(**{**read, **parts})


@dataclass
class Results:
    """All of it, and where it was measured."""

    machine: dict[str, str]
    rows: list[Row] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    """What could not be measured, and why."""

    def scenes(self) -> Iterator[tuple[str, int, list[Row]]]:
        """(title, size, rows) of each scene and size."""
        keys = dict.fromkeys((row.scene, row.size) for row in self.rows)
        for scene, size in keys:
            rows = [row for row in self.rows if (row.scene, row.size) == (scene, size)]
            yield rows[0].title, size, rows

    def as_json(self) -> dict[str, Any]:
        """For other programs."""
        return {
            "domeshim": __version__,
            "machine": self.machine,
            "rows": [_finite(asdict(row)) for row in self.rows],
            "notes": self.notes,
        }

    @classmethod
    def from_json(cls, read: dict[str, Any]) -> Results:
        """As as_json told it."""
        return cls(read["machine"], [Row.from_json(row) for row in read["rows"]], read["notes"])

    def markdown(self) -> str:
        """A table for each scene and size."""
        parts = [" · ".join(self.machine.values()), *self.tables(), *(f"- {note}" for note in self.notes)]
        return "\n\n".join(parts) + "\n"

    def tables(self) -> list[str]:
        """A table for each scene and size, as Markdown."""
        return [f"**{title}**, {size}x{size}\n\n{_table(rows)}" for title, size, rows in self.scenes()]


_HEAD = ("method", "time", "processor", "ms")
_TRUE = ("edges: mean", "largest", "lost", "colour")
_SEEN = ("displacement", "wrong pixels")


def _table(rows: Sequence[Row]) -> str:
    head = (*_HEAD, *(_SEEN if any(row.seen for row in rows) else _TRUE))
    lines = [head, ("---", *("---:",) * (len(head) - 1))]
    for row in rows:
        cost = row.cost
        times = (f"{cost.ratio:.2f}", f"{cost.processor_ratio:.2f}", f"{cost.milliseconds:.1f}")
        lines.append((f"{row.family} {row.detail}".strip(), *times, *_errors(row)))
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _errors(row: Row) -> tuple[str, ...]:
    if row.seen is not None:
        return "" if row.seen.moved is None else _figure(row.seen.moved), f"{row.seen.wrong:.2%}"
    edges = row.edges
    off = (
        ("", "", "") if edges is None else (_figure(edges.mean), _figure(edges.largest), f"{edges.lost:.1%}")
    )
    return *off, "" if row.colour is None else f"{row.colour:.1f}"


def _finite(value: Any) -> Any:
    """The same with None for what is infinite: JSON knows no infinity."""
    if isinstance(value, dict):
        return {key: _finite(each) for key, each in value.items()}
    return None if value == inf else value


def _figure(value: float) -> str:
    return f"{value:.2g}" if value < 10 else f"{value:.0f}"
