"""By how much one picture is shifted, scaled and turned against another of the same view.

Each tile tells how far its edges have moved, across themselves alone: along a straight edge nothing can be
seen (the aperture problem). The steps are those of Lucas and Kanade, "An iterative image registration
technique", IJCAI 1981, from coarse to fine; a similarity is then fitted to all of them, by how much each is
to be trusted.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from domeshim.measure.match import Mask, Picture

Floats = NDArray[np.float64]

SPACING = 16
"""Pixels between the tiles' middles."""
REACH = 8.0
"""Standard deviation, pixels, of the weights with which a tile looks around its middle."""
_FINE, _COARSE = 2.0, 8.0
"""A tile looks at details between these, standard deviations in pixels: smooth shades tell no place."""
_LEVELS = 3
_STEPS = 4
_TRUSTED = 0.2
"""The standard error, pixels, up to which a tile's word counts."""
_LEAST_GRADIENT = 4.0
"""The mean square, in (levels of 255 a pixel)^2, under which there is no edge to be seen."""
_FEWEST = 12
"""So many words at least for a fit."""


@dataclass(frozen=True)
class Displacement:
    """A similarity: where a point of the first picture is in the second, from the picture's middle."""

    shift: tuple[float, float]
    """Pixels to the right and down."""
    scale: float
    """The growth as a share: 0.01 is 1 %."""
    turn: float
    """Radians, clockwise as seen."""
    largest: float
    """Pixels: how far this moves the part of the picture that it was found in, at most."""
    error: float
    """The standard error of largest."""
    growth: float
    """Pixels: how far scale alone moves that part, at most."""
    growth_error: float
    """The standard error of growth."""
    words: int
    """In how many places an edge has told."""


def displacement(first: Picture | Floats, second: Picture | Floats, where: Mask) -> Displacement | None:
    """How the second picture is moved against the first inside the mask; None where too little tells."""
    middles, moved, axes, errors = _tiles(first, second, where)
    trusted = errors < _TRUSTED
    if trusted.sum() < _FEWEST:
        return None
    return _fitted(middles, moved, axes, errors, trusted, where.shape)


def _tiles(
    first: Picture | Floats, second: Picture | Floats, where: Mask
) -> tuple[Floats, Floats, Floats, Floats]:
    """Each tile's middle (n, 2), movement (n, 2), two axes (n, 2, 2) as columns, and the error along each."""
    height, width = where.shape
    ys, xs = (np.arange(SPACING // 2, size, SPACING) for size in (height, width))
    flow = np.zeros((len(ys), len(xs), 2))
    for level in reversed(range(_LEVELS)):
        step = 2**level
        a, b = (_reduced(_details(picture, step), step) for picture in (first, second))
        inside = _reduced(_inner(where, round(_COARSE * step))[..., None].astype(float), step)[..., 0]
        seen = _Tiles(a, inside, ys / step, xs / step)
        for _ in range(_STEPS):
            flow = flow + step * seen.step(b, flow / step)
        axes, errors = seen.axes, seen.errors
    y, x = np.meshgrid(ys + 0.5 - height / 2, xs + 0.5 - width / 2, indexing="ij")
    middles = np.stack([x, y], -1).reshape(-1, 2)
    return middles, flow.reshape(-1, 2), axes.reshape(-1, 2, 2), errors.reshape(-1, 2)


class _Tiles:
    """The tiles of one level of detail, and what each sees."""

    def __init__(self, first: Floats, inside: Floats, ys: Floats, xs: Floats) -> None:
        self._first = first
        self._inside = inside
        self._slope = _slopes(first)
        self._grid = np.meshgrid(ys, xs, indexing="ij")
        self._pixels = np.mgrid[: first.shape[0], : first.shape[1]].astype(float)
        self.axes = np.zeros((len(ys), len(xs), 2, 2))
        self.errors = np.full((len(ys), len(xs), 2), np.inf)

    def step(self, second: Floats, flow: Floats) -> Floats:
        """How much farther than flow, (m, n, 2) pixels, the second picture has moved."""
        shown = self._moved(second, flow)
        difference = self._first - shown
        slope_x, slope_y = (self._slope + _slopes(shown)) / 2
        xx, xy, yy = (
            self._around(p * q) for p, q in ((slope_x, slope_x), (slope_x, slope_y), (slope_y, slope_y))
        )
        strengths, self.axes = np.linalg.eigh(np.stack([np.stack([xx, xy], -1), np.stack([xy, yy], -1)], -2))
        towards = np.stack([self._around(slope * difference) for slope in (slope_x, slope_y)], -1)
        along = np.einsum("...ji,...j->...i", self.axes, towards)
        told = strengths > np.maximum(_LEAST_GRADIENT, 0.02 * strengths[..., 1:])
        safe = np.where(told, strengths, 1.0)
        # Blurred noise repeats itself: so many independent pixels there are in a tile.
        independent = REACH**2 / (2 * _FINE**2)
        unexplained = self._around(difference * difference)[..., None]
        self.errors = np.where(told, np.sqrt(unexplained / safe / independent), np.inf)
        moves = np.clip(np.where(told, along / safe, 0.0), -2, 2)
        found: Floats = np.einsum("...ij,...j->...i", self.axes, moves)
        return found

    def _moved(self, picture: Floats, flow: Floats) -> Floats:
        """The picture as it is where the flow leads."""
        from scipy import ndimage  # noqa: PLC0415 - needed for measuring alone

        rows, columns = self._pixels
        ys, xs = self._grid[0][:, 0], self._grid[1][0]
        place = (
            np.interp(rows[:, 0], ys, np.arange(len(ys)))[:, None] + 0 * columns,
            np.interp(columns[0], xs, np.arange(len(xs)))[None] + 0 * rows,
        )
        right, down = (ndimage.map_coordinates(flow[..., k], place, order=1) for k in (0, 1))
        return _sampled(picture, rows + down, columns + right)

    def _around(self, values: Floats) -> Floats:
        """The weighted mean around each tile's middle of values, (h, w, channels), inside the mask."""
        from scipy import ndimage  # noqa: PLC0415 - as above

        smooth = ndimage.gaussian_filter(values.sum(-1) * self._inside, REACH)
        found: Floats = ndimage.map_coordinates(smooth, self._grid, order=1, mode="nearest")
        return found


def _fitted(
    middles: Floats, moved: Floats, axes: Floats, errors: Floats, trusted: Mask, shape: tuple[int, ...]
) -> Displacement:
    """The similarity that explains most of the words; those that are far off count less and less."""
    reach = min(shape) / 2
    tile, axis = np.nonzero(trusted)
    x, y = (middles[tile] / reach).T
    to_x, to_y = axes[tile, :, axis].T
    told = np.einsum("ni,ni->n", axes[tile, :, axis], moved[tile])
    terms = np.stack([to_x, to_y, to_x * x + to_y * y, to_y * x - to_x * y], -1)
    basic = 1 / np.hypot(errors[tile, axis], 0.1)
    weights = basic
    for _ in range(15):
        found, *_rest = np.linalg.lstsq(terms * weights[:, None], told * weights, rcond=1e-3)
        left = told - terms @ found
        spread = max(1.48 * float(np.median(abs(left))), 0.05)
        weights = basic / np.sqrt(1 + (left / (2 * spread)) ** 2)
    normal = (terms * weights[:, None] ** 2).T @ terms
    # Neighbouring tiles overlap: a word is told so many times over.
    repeated = (2 * np.sqrt(np.pi) * REACH / SPACING) ** 2
    variance = np.linalg.pinv(normal) * np.median(weights) ** 2 * spread**2 * repeated
    places = np.stack(
        [
            np.stack([np.ones_like(x), np.zeros_like(x), x, -y], -1),
            np.stack([np.zeros_like(x), np.ones_like(x), y, x], -1),
        ]
    )
    field = np.hypot(*(places @ found))
    farthest = int(np.argmax(field))
    rows = places[:, farthest]
    error = float(np.sqrt(np.trace(rows @ variance @ rows.T)))
    shift_x, shift_y, scale, turn = found
    return Displacement(
        (float(shift_x), float(shift_y)),
        float(scale / reach),
        float(turn / reach),
        float(field[farthest]),
        error,
        abs(float(scale)) * (farthest_out := float(np.hypot(x, y).max())),
        float(np.sqrt(variance[2, 2])) * farthest_out,
        len(told),
    )


def _details(picture: Picture | Floats, step: int) -> Floats:
    """What lies between the fine and the coarse scale: (height, width, channels)."""
    from scipy import ndimage  # noqa: PLC0415 - as above

    values = picture.astype(np.float32)
    fine, coarse = (
        ndimage.gaussian_filter(values, (sigma * step, sigma * step, 0)) for sigma in (_FINE, _COARSE)
    )
    return np.asarray(fine - coarse, float)


def _slopes(picture: Floats) -> Floats:
    """(2, height, width, channels): how the picture rises to the right and down."""
    return np.stack([np.asarray(np.gradient(picture, axis=axis)) for axis in (1, 0)])


def _reduced(picture: Floats, step: int) -> Floats:
    """Every step-th pixel of a picture that has been blurred enough for that."""
    return picture[::step, ::step]


def _inner(where: Mask, margin: int) -> Mask:
    """The mask without its margin: what is blurred there comes from outside."""
    from scipy import ndimage  # noqa: PLC0415 - as above

    padded = np.pad(where, 1)
    return np.asarray(ndimage.distance_transform_edt(padded)[1:-1, 1:-1] > min(margin, min(where.shape) / 8))


def _sampled(picture: Floats, rows: Floats, columns: Floats) -> Floats:
    """The picture's colours at places, in pixels, linear between pixels."""
    from scipy import ndimage  # noqa: PLC0415 - as above

    return np.stack(
        [
            ndimage.map_coordinates(picture[..., channel], (rows, columns), order=1, mode="nearest")
            for channel in range(picture.shape[-1])
        ],
        -1,
    )
