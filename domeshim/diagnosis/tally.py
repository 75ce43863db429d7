"""What is counted of draws and of the programs that make them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from domeshim.draw.patches import LINE_STRIP, POINTS, TRIANGLE_STRIP, corners

PATCHES = 0x000E
_QUADS, _QUAD_STRIP, _POLYGON = 7, 8, 9
_POINT, _LINE = 0x1B00, 0x1B01


@dataclass
class Tally:
    """What one program drew in a picture."""

    draws: int = 0
    vertices: int = 0
    """Handed to GL."""
    primitives: int = 0
    """Points, lines and triangles that these make."""
    generated: int = 0
    """What came of them, subdivided or not."""
    cut: bool = False
    """Some of it was cut on the CPU."""

    def add(self, other: Tally) -> None:
        """Count the other's as well."""
        self.draws += other.draws
        self.vertices += other.vertices
        self.primitives += other.primitives
        self.cut = self.cut or other.cut


@dataclass
class Made:
    """What it took to make one program."""

    shaders: int = 0
    characters: int = 0
    seconds: float = 0.0
    """To compile and link it, as far as the dome did that."""


def tally_of(mode: int, count: int, patch: int) -> Tally:
    """One draw of so many vertices; GL counts a quad, or a polygon, as one. patch: vertices of one."""
    if mode == PATCHES:
        return Tally(1, count, count // patch)
    primitives = len(corners(mode, count)) if mode < 10 else 0
    if mode in (_QUADS, _QUAD_STRIP):
        primitives //= 2
    elif mode == _POLYGON:
        primitives = min(primitives, 1)
    return Tally(1, count, primitives)


def strips_of(mode: int, limits: list[int]) -> list[int]:
    """The mode of glBegin that a glEvalMesh comes to, and the number of vertices of each block."""
    columns = limits[1] - limits[0] + 1
    rows = limits[3] - limits[2] + 1 if len(limits) == 4 else 1
    if mode == _POINT:
        return [POINTS, columns * rows]
    if mode == _LINE:
        across = [rows] * columns if len(limits) == 4 else []
        return [LINE_STRIP, *[columns] * rows, *across]
    return [TRIANGLE_STRIP, *[2 * columns] * (rows - 1)]


def count_of(name: str, args: tuple[Any, ...]) -> int:
    """How many vertices a call of the program's draws."""
    place = {"glDrawElements": 1, "glDrawArrays": 2, "glDrawRangeElements": 3}.get(name)
    try:
        return int(args[place]) if place is not None else int(sum(args[2]))
    except (IndexError, TypeError, ValueError):
        return 0
