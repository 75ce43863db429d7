"""Blender's fisheye lens polynomial: the angle as a polynomial in the radius, so the radius by inversion."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from domeshim.lens.catalogue import Numbers
from domeshim.lens.inversion import inverse, stops_rising
from domeshim.lens.knots import MOST, Knotted
from domeshim.lens.landing import Floats
from domeshim.lens.models import LensError

_SENSOR = 36.0
"""Width of Blender's default sensor, millimetres."""
_LARGEST_K0 = 1e-3


@dataclass(frozen=True)
class Blender(Knotted):
    """phi = -(k1 r + k2 r^2 + k3 r^3 + k4 r^4), r in millimetres on a sensor as wide as the disc.

    The picture ends at half the field of view, or where the sensor does. Source of the formula: Blender 3.4's
    reference of its camera, panoramic type Fisheye Lens Polynomial.
    """

    powers: tuple[float, float, float, float]
    """c1, .., c4: phi = c1 x + .. + c4 x^4 for a radius x on the disc."""
    fov: float

    @classmethod
    def of(cls, numbers: Numbers, fov: float) -> Blender:
        """The lens with Blender's k0 to k4 and the sensor's width in millimetres (36).

        k0 tells by how much the picture's middle misses the axis: it must be nearly 0, and is left out.
        Raises LensError where the angle does not rise all the way to half of fov, or to the disc's edge.
        """
        k0, *k = numbers[:5]
        half = (numbers[5] if len(numbers) > 5 else _SENSOR) / 2
        if half <= 0:
            raise LensError("the sensor's width must be over 0")
        if abs(k0) > _LARGEST_K0:
            raise LensError(f"k0 is the angle on the axis, and must lie within {_LARGEST_K0} radians of 0")
        c1, c2, c3, c4 = (-kn * half**n for n, kn in enumerate(k, 1))
        lens = cls((c1, c2, c3, c4), fov)
        stop = stops_rising(lens.powers, 1.0)
        if stop is not None and lens._angle(np.array(stop)) < np.radians(fov / 2):
            reached = np.degrees(lens._angle(np.array(stop)))
            raise LensError(
                f"the angle stops rising at {reached:.4g} degrees, {stop * half:.4g} mm from the axis, "
                f"within {fov / 2:g} degrees, half of DOME_FOV"
            )
        return lens

    @cached_property
    def end(self) -> float:
        """Half the field of view, or the angle at the disc's edge where that is less, radians."""
        grid = np.linspace(0.0, 1.0, 1025)
        return float(min(np.radians(self.fov / 2), self._angle(grid).max()))

    @cached_property
    def _edge_radius(self) -> float:
        """The radius at the lens's end: up to there the angle rises."""
        stop = stops_rising(self.powers, 1.0)
        grid = np.linspace(0.0, 1.0 if stop is None else stop, 4097)
        return float(grid[min(int(np.searchsorted(self._angle(grid), self.end)), 4096)])

    @cached_property
    def knots(self) -> Floats:
        """(64, 3): evenly in angle."""
        phi = np.linspace(0.0, self.end, MOST)
        return np.stack([phi, self._radius(phi), self._slope(phi)], -1)

    def _radius(self, phi: Floats) -> Floats:
        return inverse(self._angle, self._angle_slope, self._edge_radius, phi)

    def _slope(self, phi: Floats) -> Floats:
        return 1 / self._angle_slope(self._radius(phi))

    def _angle(self, radius: Floats) -> Floats:
        return np.asarray(np.polyval((*self.powers[::-1], 0.0), radius), float)

    def _angle_slope(self, radius: Floats) -> Floats:
        return np.asarray(np.polyval(np.polyder((*self.powers[::-1], 0.0)), radius), float)
