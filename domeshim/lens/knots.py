"""A curve through knots, cubic between two: lenses that have no formula for the radius."""

from __future__ import annotations

from abc import abstractmethod
from typing import ClassVar

import numpy as np

from domeshim.lens.inversion import inverse
from domeshim.lens.landing import Floats
from domeshim.lens.radial import RadialLens

MOST = 64
"""So many knots the snippet holds."""


class Knotted(RadialLens):
    """A lens by its radius and slope at knots: a cubic (Hermite's) between two of them."""

    name: ClassVar[str] = "knots"

    @property
    @abstractmethod
    def knots(self) -> Floats:
        """(n, 3), n at most MOST: angle, radius and slope, the angles rising from 0."""

    @property
    def end(self) -> float:
        """The last knot's angle, radians."""
        return float(self.knots[-1, 0])

    @property
    def uniform(self) -> tuple[float, ...]:
        """(angle, radius, slope, 0) of 64 knots; where there are fewer, the first is repeated."""
        knots = self.knots
        padded = np.concatenate([np.repeat(knots[:1], MOST - len(knots), 0), knots])
        return tuple(np.pad(padded, ((0, 0), (0, 1))).ravel().tolist())

    def _radius(self, phi: Floats) -> Floats:
        return radius_at(self.knots, phi)

    def _slope(self, phi: Floats) -> Floats:
        return slope_at(self.knots, phi)

    def _angle(self, radius: Floats) -> Floats:
        return inverse(self._radius, self._slope, self.end, radius)


def radius_at(knots: Floats, phi: Floats) -> Floats:
    """The curve through knots, (n, 3), at angles, (...), of 0 to the last knot's -> (...)."""
    t, width, a, b = _pieces(knots, phi)
    u = 1 - t
    before = (1 + 2 * t) * a[..., 1] + t * width * a[..., 2]
    after = (1 + 2 * u) * b[..., 1] - u * width * b[..., 2]
    radius: Floats = u * u * before + t * t * after
    return radius


def slope_at(knots: Floats, phi: Floats) -> Floats:
    """The slope of the curve through knots, (n, 3), at angles, (...), of 0 to the last knot's -> (...)."""
    t, width, a, b = _pieces(knots, phi)
    secant = (b[..., 1] - a[..., 1]) / width
    ends = (1 - t) * (1 - 3 * t) * a[..., 2] + t * (3 * t - 2) * b[..., 2]
    slope: Floats = 6 * t * (1 - t) * secant + ends
    return slope


def _pieces(knots: Floats, phi: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """Where in its piece each angle lies, 0 to 1, the piece's width, and the knots at its ends."""
    i = np.clip(np.searchsorted(knots[:, 0], phi, side="right") - 1, 0, len(knots) - 2)
    a, b = knots[i], knots[i + 1]
    width = b[..., 0] - a[..., 0]
    return (phi - a[..., 0]) / width, width, a, b


def rising_slopes(x: Floats, y: Floats) -> Floats:
    """Slopes, (n,), at points, n at least 3 and both rising, with which the pieces between them rise too.

    Inside by Fritsch and Butland 1984 (harmonic means), at the ends by three points: PCHIP.
    """
    width, rise = np.diff(x), np.diff(y) / np.diff(x)
    one, two = 2 * width[1:] + width[:-1], width[1:] + 2 * width[:-1]
    inside = (one + two) / (one / rise[:-1] + two / rise[1:])
    first = _end_slope(width[0], width[1], rise[0], rise[1])
    last = _end_slope(width[-1], width[-2], rise[-1], rise[-2])
    return np.concatenate([[first], inside, [last]])


def _end_slope(width: float, next_width: float, rise: float, next_rise: float) -> float:
    return max(0.0, ((2 * width + next_width) * rise - width * next_rise) / (width + next_width))
