"""What all fisheyes have in common: a direction lands out from the middle, as far as its angle says."""

from __future__ import annotations

import math
from abc import abstractmethod
from functools import cached_property
from typing import ClassVar

import numpy as np

from domeshim.lens.catalogue import Numbers
from domeshim.lens.landing import Bools, Clip, Floats, Lens

_CLOSEST = 0.02
"""The least angle from straight behind at which the bend is looked at, radians; it changes little beyond."""


class RadialLens(Lens):
    """A fisheye: an angle's radius on the disc, and back.

    A model holds from the axis to the lens's end, and rises there. Beyond its end a lens goes straight on,
    for what is drawn may reach there, and must not fold back into the picture.
    """

    name: ClassVar[str]
    """The snippet's name in glsl/lens."""
    cells: ClassVar[str] = "frame/cells_disc"
    fov: float
    """Full angle, degrees: the picture ends here."""

    @classmethod
    @abstractmethod
    def of(cls, numbers: Numbers, fov: float) -> RadialLens:
        """The lens with these numbers of the catalogue's.

        Raises LensError where the model cannot do so; says why.
        """

    @property
    def snippets(self) -> tuple[str, ...]:
        """The radius, and what becomes of it."""
        return f"lens/{self.name}", "bend/radial"

    @cached_property
    def rim(self) -> float:
        """The radius of half the field of view, at most the inscribed circle's."""
        return min(1.0, float(self.radius(np.array(self.half))))

    def landed(self, rays: Floats) -> Floats:
        """As for Lens: glsl/bend/radial."""
        d = rays / np.abs(rays).max(-1, keepdims=True)
        rxy = np.hypot(d[..., 0], d[..., 1])
        phi = np.arctan2(rxy, -d[..., 2])
        with np.errstate(invalid="ignore", divide="ignore"):
            factor = np.where(rxy > 0, self.radius(phi) / rxy, 0.0)
        disc: Floats = d[..., :2] * factor[..., None]
        return disc

    def ray(self, places: Floats) -> Floats:
        """As for Lens: unit vectors, nan outside the lens."""
        places = np.asarray(places, float)
        radius = np.hypot(places[..., 0], places[..., 1])
        phi = self.angle(radius)
        with np.errstate(invalid="ignore", divide="ignore"):
            factor = np.where(radius > 0, np.sin(phi) / radius, 0.0)
        return np.concatenate([places * factor[..., None], -np.cos(phi)[..., None]], -1)

    def within(self, places: Floats) -> Bools:
        """As for Lens: a disc."""
        return np.asarray(np.hypot(places[..., 0], places[..., 1]) <= self.rim)

    def nearest(self, places: Floats) -> Floats:
        """As for Lens: straight inward."""
        radius = np.hypot(places[..., 0], places[..., 1])
        end = self.rim * (1 - 1e-9)
        return np.asarray(places * (end / np.maximum(radius, end))[..., None])

    def spread(self, around: bool) -> Floats:
        """As for Lens: from the axis to the end, or nearly straight behind."""
        phi, theta = np.meshgrid(
            np.linspace(1e-3, min(self.half, math.pi - _CLOSEST), 181 if around else 721),
            np.linspace(0, 2 * np.pi, 48, endpoint=False) if around else np.zeros(1),
            indexing="ij",
        )
        return np.stack([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), -np.cos(phi)], -1)

    def clip(self, exact: bool) -> Clip:
        """As for Lens: the half space behind does for up to 180 degrees."""
        return "cone" if exact or self.fov > 180 else "behind"

    def left_out(self, detail: float) -> float:
        """As for Lens: within a cone around straight behind nothing is drawn.

        What is drawn reaches one piece beyond the rim, which is then cut to the pixel. But straight behind
        there is no direction, and a piece around it would be drawn inside out, over all the disc: a lens of
        360 degrees leaves out about a quarter of the tolerance, in pixels of radius.
        """
        return max(math.pi - self.half - 1 / detail, min(0.1 / detail**2, 0.05))

    @property
    def half(self) -> float:
        """Half the field of view, radians."""
        return math.radians(self.fov) / 2

    @property
    def end(self) -> float:
        """The angle from the axis up to which the model holds, radians: half the field of view."""
        return self.half

    def radius(self, phi: Floats) -> Floats:
        """phi: (...) radians from the axis -> (...) radius, 1 at the frame's inscribed circle."""
        phi = np.asarray(phi, float)
        known = np.minimum(phi, self.end)
        radius: Floats = np.asarray(self._radius(known)) + self.slope(np.array(self.end)) * (phi - known)
        return radius

    def slope(self, phi: Floats) -> Floats:
        """phi: (...) radians from the axis -> (...) how much radius one more radian is."""
        return self._slope(np.minimum(np.asarray(phi, float), self.end))

    def angle(self, radius: Floats) -> Floats:
        """radius: (...) -> (...) radians from the axis; nan where the lens never reaches that far."""
        radius = np.asarray(radius, float)
        last = self._radius(np.array(self.end))
        within = radius <= last * (1 + 1e-9)
        return np.where(within, self._angle(np.clip(radius, 0.0, last)), np.nan)

    @property
    def _edge(self) -> tuple[float, float]:
        """The uniform's first two values: where the lens goes straight on, and how steeply."""
        return self.end, float(self.slope(np.array(self.end)))

    @abstractmethod
    def _radius(self, phi: Floats) -> Floats:
        """The radius up to the end."""

    @abstractmethod
    def _slope(self, phi: Floats) -> Floats:
        """The slope up to the end."""

    @abstractmethod
    def _angle(self, radius: Floats) -> Floats:
        """The angle of radii that the lens reaches."""
