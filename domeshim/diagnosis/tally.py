"""What is counted of draws and of the programs that make them."""

from __future__ import annotations

from dataclasses import dataclass

from domeshim.draw.patches import corners

PATCHES = 0x000E
_QUADS, _QUAD_STRIP, _POLYGON = 7, 8, 9


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
