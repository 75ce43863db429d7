"""What was drawn, as arrays: the blocks of a recording that follow each other."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

INDEPENDENT = {0: 1, 1: 2, 4: 3, 7: 4}
"""Modes whose primitives share no vertices, with their size: points, lines, triangles, quads."""


@dataclass(slots=True)
class Block:
    """One glBegin..glEnd: its mode, its vertices, and the calls made inside that are no attributes."""

    mode: int
    first: int
    end: int = 0
    extras: dict[int, Callable[[], object]] = field(default_factory=dict)
    """By the place that they take among the vertices."""


@dataclass(frozen=True)
class Run:
    """Blocks that follow each other, as arrays.

    positions: (n, 3) or (n, 4) float32; attributes: name -> (n, size) float32; a row of nan where the
    vertex has the value that was current before the run.
    """

    positions: NDArray[np.float32]
    attributes: dict[str, NDArray[np.float32]]
    blocks: tuple[Block, ...]
    last: tuple[tuple[str, tuple[float, ...]], ...] = ()
    """What each attribute was set to last."""
    constant: tuple[tuple[str, tuple[float, ...]], ...] = ()
    """Attributes that are the same for every vertex, and not among the arrays."""


def stretches(blocks: tuple[Block, ...]) -> Iterator[tuple[int, int, int]]:
    """(mode, first, count) of each draw; touching blocks whose primitives share nothing are one."""
    waiting: tuple[int, int, int] | None = None
    for block in blocks:
        size = INDEPENDENT.get(block.mode)
        count = block.end - block.first
        count -= count % size if size else 0
        if waiting is not None and size and waiting[0] == block.mode and sum(waiting[1:]) == block.first:
            waiting = (block.mode, waiting[1], waiting[2] + count)
            continue
        if waiting is not None:
            yield waiting
        waiting = (block.mode, block.first, count)
    if waiting is not None:
        yield waiting
