"""Lens models: where on the disc an angle from the dome's axis lands. Numpy twins of glsl/lens."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


class Lens(Protocol):
    """An angle's radius on the disc, and back; hashable, so that what follows from it is found once."""

    def __hash__(self) -> int:
        """Equal lenses have equal numbers."""

    @property
    def name(self) -> Literal["equidistant", "polynomial"]:
        """The snippet's name in glsl/lens."""

    @property
    def uniform(self) -> tuple[float, ...]:
        """The values of the snippet's domeLens."""

    def radius(self, phi: Floats) -> Floats:
        """phi: (...) radians from the axis -> (...) radius, 1 at the frame's inscribed circle."""

    def angle(self, radius: Floats) -> Floats:
        """radius: (...) -> (...) radians from the axis; nan where the lens never reaches that far."""


@dataclass(frozen=True)
class Equidistant:
    """The radius grows evenly with the angle and is 1 at half the field of view."""

    fov: float
    """Full angle, degrees."""
    name: Literal["equidistant"] = "equidistant"

    @property
    def uniform(self) -> tuple[float, ...]:
        """1 / (fov / 2), radians."""
        return (1.0 / np.radians(self.fov / 2),)

    def radius(self, phi: Floats) -> Floats:
        """phi: (...) radians -> (...) radius."""
        return np.asarray(phi, float) * self.uniform[0]

    def angle(self, radius: Floats) -> Floats:
        """radius: (...) -> (...) radians."""
        return np.asarray(radius, float) / self.uniform[0]


@dataclass(frozen=True)
class Polynomial:
    """radius = c1 phi + .. + c5 phi^5, phi in radians: a measured lens (Bailey, Clothier, Gebbie 2006).

    The radius is the lens's own, 1 at the frame's inscribed circle: the field of view cuts it and does
    not scale it.
    """

    coefficients: tuple[float, float, float, float, float]
    fov: float
    """Full angle, degrees: the picture ends here."""
    name: Literal["polynomial"] = "polynomial"

    @property
    def uniform(self) -> tuple[float, ...]:
        """c1, .., c5."""
        return self.coefficients

    def radius(self, phi: Floats) -> Floats:
        """phi: (...) radians -> (...) radius."""
        return np.polyval((*self.coefficients[::-1], 0.0), np.asarray(phi, float))

    def angle(self, radius: Floats) -> Floats:
        """radius: (...) -> (...) radians, by interpolation refined with Newton's steps."""
        radius = np.asarray(radius, float)
        phi = np.linspace(0.0, np.radians(self.fov / 2), 2049)
        found = np.interp(radius, self.radius(phi), phi, right=np.nan)
        slope = np.polyder((*self.coefficients[::-1], 0.0))
        for _ in range(3):
            found = found - (self.radius(found) - radius) / np.polyval(slope, found)
        return found


def lens_of(model: str, coefficients: tuple[float, ...], fov: float) -> Lens:
    """The lens that the options name; fov in degrees."""
    if model == "polynomial":
        c1, c2, c3, c4, c5 = (*coefficients, 0.0, 0.0, 0.0, 0.0, 0.0)[:5]
        return Polynomial((c1, c2, c3, c4, c5), fov)
    return Equidistant(fov)


def rim_radius(lens: Lens, fov: float) -> float:
    """Where the picture ends on the disc: half the field of view, at most the inscribed circle."""
    return min(1.0, float(lens.radius(np.radians(fov / 2))))
