"""Lenses whose radius is a polynomial in the angle."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from domeshim.lens.catalogue import Numbers
from domeshim.lens.inversion import inverse, stops_rising
from domeshim.lens.landing import Floats
from domeshim.lens.models import LensError
from domeshim.lens.radial import RadialLens


class _Series(RadialLens):
    """radius = sum c_i phi^i from i = 1; never 0 beyond the axis."""

    @property
    def _powers(self) -> tuple[float, ...]:
        """c1, c2, .."""
        raise NotImplementedError

    def _radius(self, phi: Floats) -> Floats:
        return np.asarray(np.polyval((*self._powers[::-1], 0.0), phi), float)

    def _slope(self, phi: Floats) -> Floats:
        return np.asarray(np.polyval(np.polyder((*self._powers[::-1], 0.0)), phi), float)

    def _angle(self, radius: Floats) -> Floats:
        return inverse(self._radius, self._slope, self.end, radius)


@dataclass(frozen=True)
class Polynomial(_Series):
    """radius = c1 phi + .. + c5 phi^5, phi in radians: a measured lens (Bailey, Clothier, Gebbie 2006).

    The radius is the lens's own, 1 at the frame's inscribed circle: the field of view cuts it and does
    not scale it.
    """

    coefficients: tuple[float, float, float, float, float]
    fov: float
    name: ClassVar[str] = "polynomial"

    @classmethod
    def of(cls, numbers: Numbers, fov: float) -> Polynomial:
        """The lens with 1 to 5 coefficients.

        Raises LensError where its radius does not rise all the way to half of fov.
        """
        _must_rise(numbers, fov)
        c1, c2, c3, c4, c5 = (*numbers, 0.0, 0.0, 0.0, 0.0, 0.0)[:5]
        return cls((c1, c2, c3, c4, c5), fov)

    @property
    def uniform(self) -> tuple[float, ...]:
        """(end, slope there, c1, .., c5)."""
        return *self._edge, *self.coefficients

    @property
    def _powers(self) -> tuple[float, ...]:
        return self.coefficients


@dataclass(frozen=True)
class OpenCV(_Series):
    """radius = f (phi + k1 phi^3 + k2 phi^5 + k3 phi^7 + k4 phi^9): the model of OpenCV's cv::fisheye.

    Source of the formula: OpenCV's documentation of its fisheye camera model.
    """

    k: tuple[float, float, float, float]
    f: float
    """The focal length in the disc's radii."""
    fov: float
    name: ClassVar[str] = "opencv"

    @classmethod
    def of(cls, numbers: Numbers, fov: float) -> OpenCV:
        """The lens with k1 to k4 and f; without f the radius is 1 at half of fov.

        Raises LensError where its radius does not rise all the way there.
        """
        k1, k2, k3, k4 = (*numbers[:4], 0.0, 0.0, 0.0, 0.0)[:4]
        f = numbers[4] if len(numbers) > 4 else 1.0
        _must_rise((f, 0.0, f * k1, 0.0, f * k2, 0.0, f * k3, 0.0, f * k4), fov)
        lens = cls((k1, k2, k3, k4), f, fov)
        if len(numbers) > 4:
            return lens
        return cls(lens.k, float(1.0 / lens._radius(np.array(lens.end))), fov)

    @property
    def uniform(self) -> tuple[float, ...]:
        """(end, slope there, f, k1, .., k4)."""
        return *self._edge, self.f, *self.k

    @property
    def _powers(self) -> tuple[float, ...]:
        k1, k2, k3, k4 = (self.f * k for k in self.k)
        return self.f, 0.0, k1, 0.0, k2, 0.0, k3, 0.0, k4


def _must_rise(powers: Numbers, fov: float) -> None:
    stop = stops_rising(powers, math.radians(fov) / 2)
    if stop is not None:
        reason = f"the radius stops rising {math.degrees(stop):.4g} degrees from the axis"
        raise LensError(f"{reason}, within {fov / 2:g} degrees, half of DOME_FOV")
