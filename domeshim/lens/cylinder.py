"""A cylindrical screen around the viewer: the numpy twin of glsl/bend/cylinder.glsl."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from domeshim.lens.landing import Bools, Clip, Floats, Lens


@dataclass(frozen=True)
class Cylinder(Lens):
    """Across the frame goes the azimuth, up it the tangent of the elevation: the screen unrolled.

    The axis stands upright in the dome's space, the screen's middle is straight ahead of it.
    """

    angle: float
    """From the screen's left end to its right one, degrees."""
    bottom: float
    """The elevation of its lower edge, degrees."""
    top: float
    cells: ClassVar[str] = "frame/cells_cylinder"
    singular: ClassVar[bool] = False

    @property
    def snippets(self) -> tuple[str, ...]:
        """As for Lens."""
        return ("bend/cylinder",)

    @property
    def uniform(self) -> tuple[float, ...]:
        """(1 / half the angle, 1 / half the height, the height of the middle), radians and radii."""
        low, high = self._edges
        return 2 / math.radians(self.angle), 2 / (high - low), (low + high) / 2

    @property
    def rim(self) -> None:
        """As for Lens: none."""
        return

    def landed(self, rays: Floats) -> Floats:
        """As for Lens."""
        rays = np.asarray(rays, float)
        across, up, middle = self.uniform
        away = np.hypot(rays[..., 0], rays[..., 2])
        height = rays[..., 1] / np.maximum(away, 1e-6 * np.abs(rays).max(-1))
        azimuth = np.arctan2(rays[..., 0], -rays[..., 2])
        return np.stack([across * azimuth, up * (height - middle)], -1)

    def ray(self, places: Floats) -> Floats:
        """As for Lens; every place of the plane less than a turn away has one."""
        across, up, middle = self.uniform
        azimuth = np.asarray(places)[..., 0] / across
        height = np.asarray(places)[..., 1] / up + middle
        found = np.stack([np.sin(azimuth), height, -np.cos(azimuth)], -1)
        return np.where(np.abs(azimuth)[..., None] <= math.pi, found, np.nan)

    def within(self, places: Floats) -> Bools:
        """As for Lens: the whole frame."""
        return np.asarray((np.abs(places) <= 1).all(-1))

    def nearest(self, places: Floats) -> Floats:
        """As for Lens."""
        return np.clip(places, -1, 1)

    def spread(self, around: bool) -> Floats:  # noqa: ARG002 - all is looked at
        """As for Lens: a grid, its edges included."""
        across, up = np.meshgrid(np.linspace(-1, 1, 25), np.linspace(-1, 1, 65))
        return self.ray(np.stack([across, up], -1))

    def clip(self, exact: bool) -> Clip:  # noqa: ARG002 - it is exact for any angle
        """As for Lens."""
        return "wedge"

    def left_out(self, detail: float) -> float:
        """As for Lens: of what is open behind, a piece's width beside each end is drawn all the same."""
        return min(self._open - 1 / (detail * self._narrowest), math.pi / 2)

    @property
    def least_detail(self) -> float:
        """As for Lens: a piece is at most a third as wide as half of what is open behind."""
        return 3 / (self._open * self._narrowest)

    @property
    def _open(self) -> float:
        """The azimuth from the screen's end to straight behind, radians."""
        return math.pi - math.radians(self.angle / 2)

    @property
    def _narrowest(self) -> float:
        """The least that a radian of azimuth spans, at the edge that is farther from the horizon."""
        return math.cos(math.radians(max(abs(self.bottom), abs(self.top))))

    @property
    def _edges(self) -> tuple[float, float]:
        return math.tan(math.radians(self.bottom)), math.tan(math.radians(self.top))
