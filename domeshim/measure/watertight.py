"""Random closed meshes, white on black: what is drawn of one must have no hole."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

TRIANGLES, STRIP, FAN, QUADS, QUAD_STRIP, POLYGON = range(4, 10)


@dataclass(frozen=True)
class Part:
    """One glBegin..glEnd."""

    mode: int
    vertices: Floats
    """(n, 3)."""


def random_mesh(seed: int) -> list[Part]:
    """Cells, all around the viewer or on a sheet before him, of mixed primitives that share their edges.

    Every cell's corners are the very same numbers as its neighbours'; the cells of a row go by one mode.
    Those of a box around the viewer are parallelograms.
    """
    random = np.random.default_rng(seed)
    around, box = bool(random.integers(2)), bool(random.integers(2))
    rows, columns = random.integers(2, 7, 2)
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    if not around:
        grids = [_sheet(random, rows, columns)]
    elif box:
        grids = list(_box(random, rows))
    else:
        grids = [_sphere(random, rows, columns + 2)]
    if around:
        grids = [(grid[..., None] * turn).sum(-2) for grid in grids]  # to the bit, whatever the grid's shape
    return [
        part
        for grid in grids
        for upper, lower in pairwise(np.float32(grid).astype(float))
        for part in _row(random, upper, lower)
    ]


def surrounds(seed: int) -> bool:
    """The mesh lies all around the viewer."""
    return bool(np.random.default_rng(seed).integers(2))


def holes(picture: NDArray[np.uint8]) -> int:
    """How many black pixels of (size, size, 3) do not belong to what lies around the mesh and the disc."""
    from scipy import ndimage  # noqa: PLC0415 - needed for measuring alone

    size = len(picture)
    across = (2 * np.arange(size) + 1 - size) / size
    outside = np.hypot(*np.meshgrid(across, across)) >= 1 - 1 / size
    black = (picture.max(-1) == 0) | outside
    parts, _ = ndimage.label(black, np.ones((3, 3)))
    return int((black & (parts != parts[0, 0])).sum())


def _box(random: np.random.Generator, cells: int) -> Iterator[Floats]:
    """(cells + 1, cells + 1, 3) six times: the sides of a box, the viewer anywhere within."""
    edge = 10 ** random.uniform(-1, 2, 3)
    low = -edge * random.uniform(0.02, 0.98, 3)
    steps = low + edge * np.arange(cells + 1)[:, None] / cells
    for axis in range(3):
        across, up = (axis + 1) % 3, (axis + 2) % 3
        for end in (0, -1):
            side = np.empty((cells + 1, cells + 1, 3))
            side[..., axis] = steps[end, axis]
            side[..., across] = steps[:, across]
            side[..., up] = steps[:, None, up]
            yield side


def _sphere(random: np.random.Generator, rows: int, columns: int) -> Floats:
    """(rows + 1, columns + 1, 3): rings from pole to pole around the viewer, at unlike distances."""
    theta = np.linspace(0, 2 * np.pi, columns + 1)
    phi = np.linspace(0, np.pi, rows + 1)
    size = 10 ** random.uniform(-1, 2)
    distance = size * 10 ** random.uniform(-0.4, 0.4, (rows + 1, columns + 1))
    distance[[0, -1]] = distance[[0, -1], :1]
    distance[:, -1] = distance[:, 0]
    away = np.sin(phi)[:, None, None] * np.stack([np.cos(theta), np.sin(theta), 0 * theta], -1)
    away[..., 2] = np.cos(phi)[:, None]
    away[[0, -1], :, :2] = 0
    away[:, -1] = away[:, 0]
    return np.asarray(away * distance[..., None])


def _sheet(random: np.random.Generator, rows: int, columns: int) -> Floats:
    """(rows + 1, columns + 1, 3): a crumpled sheet before the viewer, of any size, never folded."""
    size, away = 10 ** random.uniform(-1.5, 1.5), 10 ** random.uniform(-0.5, 1)
    y, x = np.meshgrid(np.linspace(-1, 1, rows + 1), np.linspace(-1, 1, columns + 1), indexing="ij")
    x, y = (axis + random.uniform(-0.25, 0.25, x.shape) / max(rows, columns) for axis in (x, y))
    distance = away * 10 ** random.uniform(-0.2, 0.2, x.shape)
    return np.stack([x * size, y * size, np.full_like(x, -1)], -1) * distance[..., None]


def _row(random: np.random.Generator, upper: Floats, lower: Floats) -> Iterator[Part]:
    """The cells between two rows of corners, by a mode that chance chooses."""
    mode = int(random.choice([TRIANGLES, STRIP, FAN, QUADS, QUAD_STRIP, POLYGON]))
    if mode in (STRIP, QUAD_STRIP):
        yield Part(mode, np.stack([upper, lower], 1).reshape(-1, 3))
        return
    for a, b, c, d in zip(upper[:-1], lower[:-1], lower[1:], upper[1:], strict=True):
        corners = [a, b, c, a, c, d] if mode == TRIANGLES else [a, b, c, d]
        yield Part(mode, np.array(corners))
