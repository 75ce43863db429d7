"""Parallelograms: two triangles that make one are subdivided as one, into far fewer pieces.

The tessellator's grid of a quad follows a wide surface both ways; that of a triangle has to be finer by half
inside. Walls, floors and sides of boxes are parallelograms, whatever mode a program draws them by.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.patches import Indices, corners
from domeshim.record.runs import Run

_MOST = 512
"""More triangles are a mesh of small ones, where a quad has as many pieces as two triangles."""
_MOST_STRETCHES = 8
"""Triangles and quads that take turns more often than this cost more as draws than they save as pieces."""
_ROUNDING = 1e-6
"""How far from a parallelogram's a corner may be, as a share of the largest coordinate."""


def as_quads(
    run: Run, triangles: Indices, *, flat: bool
) -> Iterator[tuple[Literal["quads", "triangles"], Indices]]:
    """The triangles in their order: stretches of parallelograms, (m, 4), and of those that are none, (m, 3).

    A quad's two triangles share the way from its second corner to its fourth; flat: its last corner is the
    one that gives both their colour. triangles: (n, 3) indices into the run's vertices.
    """
    quads, pairs = _pairs(run, triangles, flat=flat)
    if 2 * len(pairs) == len(triangles):
        yield "quads", quads
        return
    single = np.ones(len(triangles), bool)
    single[pairs] = single[pairs + 1] = False
    drawn = np.delete(np.arange(len(triangles)), pairs + 1)
    changes = np.flatnonzero(np.diff(single[drawn])) + 1
    if not len(pairs) or len(changes) >= _MOST_STRETCHES:
        yield "triangles", triangles
        return
    done = 0
    for stretch in np.split(drawn, changes):
        if single[stretch[0]]:
            yield "triangles", triangles[stretch]
        else:
            yield "quads", quads[done : done + len(stretch)]
            done += len(stretch)


def few_as_quads(
    mode: int, positions: Sequence[float], first: int, count: int, *, flat: bool
) -> tuple[int, ...] | None:
    """The vertices of a few primitives as parallelograms, four by four; None where they are not all such.

    positions: x, y, z in a row; the count vertices begin at the first, from which the result counts.
    """
    order = _quads_of_mode(mode, count, flat=flat)
    rounding = 0.0
    for quad in range(0, len(order), 4):
        a, b, c, d = order[quad : quad + 4]
        for k in (3 * first, 3 * first + 1, 3 * first + 2):
            off = positions[k + 3 * a] + positions[k + 3 * c] - positions[k + 3 * b] - positions[k + 3 * d]
            if off:
                rounding = rounding or _ROUNDING * max(map(abs, positions[3 * first : 3 * (first + count)]))
                if not abs(off) <= rounding:
                    return None
    return order or None


@lru_cache(maxsize=256)
def _quads_of_mode(mode: int, count: int, *, flat: bool) -> tuple[int, ...]:
    """The vertices of what a mode's triangles make two by two; nothing where one is left over."""
    triangles = corners(mode, count)
    places, first = _meeting(triangles.tobytes(), flat=flat)
    chosen = _every_second(first)
    whole = 2 * len(chosen) == len(triangles)
    return tuple(triangles.ravel()[places[chosen]].ravel().tolist()) if whole else ()


def _pairs(run: Run, triangles: Indices, *, flat: bool) -> tuple[Indices, Indices]:
    """The corners of each parallelogram, (m, 4), and the first of its two triangles, (m,)."""
    none = np.empty((0, 4), np.int64), np.empty(0, np.int64)
    if not 1 < len(triangles) <= _MOST or (run.positions.shape[1] == 4 and (run.positions[:, 3] != 1).any()):
        return none
    places, first = _meeting(triangles.tobytes(), flat=flat)
    if not len(first):
        places, first = _meeting(_vertex_numbers(run)[triangles].tobytes(), flat=flat)
    quads = triangles.ravel()[places]
    alike = _parallelograms(run.positions[quads, :3])
    chosen = _every_second(first[alike])
    return quads[alike][chosen], first[alike][chosen]


@lru_cache(maxsize=128)
def _meeting(triangles: bytes, *, flat: bool) -> tuple[Indices, Indices]:
    """Triangles that share an edge with the next: their four corners' places among all corners, and which.

    triangles: (n, 3) int64, the numbers of their vertices.
    """
    same = np.frombuffer(triangles, np.int64).reshape(-1, 3)
    one, other = same[:-1], same[1:]
    shared = one[:, :, None] == other[:, None, :]
    # The corners are a, b, d and b, c, d: where a is in the one, and c in the other.
    a, c = shared.any(2).argmin(1), shared.any(1).argmin(1)
    rows = np.arange(len(one))
    b, d = (a + 1) % 3, (a + 2) % 3
    meet = (
        (shared.sum((1, 2)) == 2)
        & (one[rows, b] == other[rows, (c + 2) % 3])
        & (one[rows, d] == other[rows, (c + 1) % 3])
    )
    if flat:
        meet &= one[:, 2] == other[:, 2]
    places = np.stack([3 * rows + a, 3 * rows + b, 3 * rows + 3 + c, 3 * rows + d], -1)
    gives_b = other[:, 2] == one[rows, b]
    places = np.where(gives_b[:, None], np.roll(places, 2, 1), places)
    return places[meet], rows[meet]


def _vertex_numbers(run: Run) -> NDArray[np.int64]:
    """A number for each vertex, the same for those that are alike in everything."""
    rows = np.ascontiguousarray(np.hstack([run.positions, *run.attributes.values()]))
    numbers = np.unique(rows.view(np.dtype((np.void, rows.strides[0]))).ravel(), return_inverse=True)[1]
    return numbers.astype(np.int64)


def _parallelograms(corners: NDArray[np.floating]) -> NDArray[np.bool_]:
    """Which quads are parallelograms. corners: (n, 4, 3)."""
    with np.errstate(invalid="ignore", over="ignore"):
        off = np.abs(corners[:, 0] + corners[:, 2] - corners[:, 1] - corners[:, 3]).max(1)
        return np.asarray(off <= _ROUNDING * np.abs(corners).max((1, 2)))


def _every_second(places: Indices) -> NDArray[np.intp]:
    """Of rising places, those that leave out the next: none shares a triangle with the one before."""
    if len(places) < 2:
        return np.arange(len(places))
    begins = np.flatnonzero(np.diff(places, prepend=-2) > 1)
    since = np.arange(len(places)) - np.repeat(begins, np.diff(begins, append=len(places)))
    return np.flatnonzero(since % 2 == 0)
