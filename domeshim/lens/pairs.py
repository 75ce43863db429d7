"""Measured pairs of angle and radius, from a .csv or .toml file."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from domeshim.wording import counted

ORDERS = {"angle-to-radius": ("angle", "radius"), "radius-to-angle": ("radius", "angle")}
"""The columns of a file without a header, by the direction in which it was measured."""


@dataclass(frozen=True)
class Pair:
    """One measured pair."""

    place: str
    """Where it stands, as in "line 7"."""
    angle: float
    """Degrees from the lens's axis."""
    radius: float
    """From the disc's centre, in the file's own unit."""


def read_pairs(path: Path, direction: str = "angle-to-radius") -> list[Pair]:
    """The pairs of a file, in its order.

    A .toml file has lists named angle and radius. A .csv file has two columns, parted by commas, semicolons
    or blanks; a first line of words says which is the angle (degrees) and which the radius, else direction
    does. Empty lines, and what follows a #, are left out.
    Raises ValueError with the reason and the line.
    """
    try:
        text = path.read_text("utf-8-sig")
    except OSError as error:
        raise ValueError(error.strerror or "cannot be read") from None
    except UnicodeDecodeError:
        raise ValueError("not text in UTF-8") from None
    found = _from_toml(text) if path.suffix.lower() == ".toml" else _from_columns(text, direction)
    for pair in found:
        if not 0 <= pair.angle <= 180:
            raise ValueError(f"{pair.place}: an angle of {pair.angle:g} degrees is not within 0 to 180")
        if pair.radius < 0:
            raise ValueError(f"{pair.place}: a radius of {pair.radius:g} is under 0")
    return found


def _from_toml(text: str) -> list[Pair]:
    try:
        table = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"not TOML: {error}") from None
    columns = [table.get(name) for name in ("angle", "radius")]
    if not all(isinstance(column, list) for column in columns):
        raise ValueError("a lens file has two lists, angle = [..] in degrees and radius = [..]")
    angles, radii = (column or [] for column in columns)
    if len(angles) != len(radii):
        raise ValueError(f"{len(angles)} angles, but {len(radii)} radii")
    return [
        Pair(f"pair {n}", _number(f"pair {n}", angle), _number(f"pair {n}", radius))
        for n, (angle, radius) in enumerate(zip(angles, radii, strict=True), 1)
    ]


def _from_columns(text: str, direction: str) -> list[Pair]:
    columns: Sequence[str] = ORDERS[direction]
    found: list[Pair] = []
    for number, line in enumerate(text.splitlines(), 1):
        place = f"line {number}"
        cells = [cell for cell in re.split(r"[\s,;]+", line.partition("#")[0].strip()) if cell]
        if not cells:
            continue
        if not found and all(re.match(r"[^\W\d]", cell) for cell in cells) and cells[0].lower() != "nan":
            columns = _header(place, cells)
            continue
        if len(cells) != len(columns):
            raise ValueError(f"{place}: {counted(len(cells), 'value')}, not {len(columns)}")
        row = {name: _number(place, cell) for name, cell in zip(columns, cells, strict=True)}
        found.append(Pair(place, row["angle"], row["radius"]))
    return found


def _header(place: str, cells: list[str]) -> list[str]:
    names = [cell.lower() for cell in cells]
    if not {"angle", "radius"} <= {*names} or len({*names}) < len(names):
        raise ValueError(f"{place}: the columns are {', '.join(cells)}; needed: angle, radius")
    return names


def _number(place: str, value: object) -> float:
    try:
        number = float(value) if isinstance(value, str | int | float) else math.nan
    except ValueError:
        raise ValueError(f"{place}: {value} is not a number") from None
    if not math.isfinite(number):
        raise ValueError(f"{place}: {value} is not a finite number")
    return number
