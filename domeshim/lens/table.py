"""A lens file: a measured table of angle and radius, checked."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

from domeshim.lens.pairs import Pair, read_pairs
from domeshim.wording import counted

_FEWEST = 3
_LARGEST = 2.0
"""No radius of a lens file is larger: the frame's corner is at 1.41."""


def read_table(path: Path) -> tuple[float, ...]:
    """The points of a lens file as angle, radius, angle, radius, ..: degrees, and 1 at the disc's rim.

    Raises ValueError with the reason where there are too few, or where they contradict each other or do not
    rise.
    """
    points = sorted(read_pairs(path), key=lambda pair: (pair.angle, pair.radius))
    for pair in points:
        if pair.radius > _LARGEST:
            raise ValueError(f"{pair.place}: a radius of {pair.radius:g}, where 1 is the disc's rim")
        if pair.angle == 0 and pair.radius != 0:
            raise ValueError(f"{pair.place}: the angle 0 has the radius {pair.radius:g} and not 0")
    points = [pair for pair in points if pair.angle > 0]
    if len(points) < _FEWEST:
        raise ValueError(f"{counted(len(points), 'point')} off the axis; a table needs {_FEWEST} or more")
    for before, after in pairwise([Pair("the axis", 0.0, 0.0), *points]):
        if after.angle == before.angle:
            raise ValueError(
                f"{before.place} and {after.place} contradict each other: {after.angle:g} degrees twice"
            )
        if after.radius <= before.radius:
            raise ValueError(
                f"{after.place}: the radius {after.radius:g} at {after.angle:g} degrees is not above "
                f"{before.radius:g} at {before.angle:g}"
            )
    return tuple(value for pair in points for value in (pair.angle, pair.radius))
