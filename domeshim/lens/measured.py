"""A lens by measured angles and radii, with a smooth rising curve between them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from domeshim.lens.catalogue import Numbers
from domeshim.lens.knots import MOST, Knotted, rising_slopes
from domeshim.lens.landing import Floats
from domeshim.lens.models import LensError

_CLOSE = 1e-3
"""Where a table has more points than the curve knots, it may miss them by so much radius."""


@dataclass(frozen=True)
class Measured(Knotted):
    """A rising curve through measured points (PCHIP).

    A lens is the same on both sides of its axis: the curve goes through (0, 0) as if the points were there
    with both signs.
    """

    points: tuple[tuple[float, float], ...]
    """(angle in degrees, radius), both rising from over 0."""
    fov: float

    @classmethod
    def of(cls, numbers: Numbers, fov: float) -> Measured:
        """The lens through numbers = angle, radius, angle, radius, ..; angles in degrees, both rising.

        Raises LensError where they end before half of fov and before the disc's edge, or are too rough.
        """
        points = tuple(zip(numbers[::2], numbers[1::2], strict=True))
        angle, radius = points[-1]
        if angle < fov / 2 and radius < 1:
            half = f"{fov / 2:g} degrees, half of DOME_FOV"
            raise LensError(f"the table ends {angle:g} degrees from the axis, before {half}")
        lens = cls(points, fov)
        missed = lens._missed()
        if missed.max() > _CLOSE:
            worst = points[int(missed.argmax())]
            raise LensError(
                f"the table is too rough for {MOST} points of a curve (worst at {worst[0]:g} degrees): "
                "smooth it with `domeshim lens fit`"
            )
        return lens

    @cached_property
    def knots(self) -> Floats:
        """(n, 3): the axis and the points; of more than 63 the means of neighbours, and the last."""
        points = np.array(self.points)
        if len(points) > MOST - 1:
            groups = np.array_split(points[:-1], MOST - 2)
            points = np.array([*(group.mean(0) for group in groups), points[-1]])
        phi, radius = np.radians(points[:, 0]), points[:, 1]
        both = (np.concatenate([-end[::-1], [0.0], end]) for end in (phi, radius))
        slopes = rising_slopes(*both)[len(phi) :]
        return np.stack([np.append(0.0, phi), np.append(0.0, radius), slopes], -1)

    def _missed(self) -> Floats:
        """(n,): by how much radius the curve misses each point."""
        angles, radii = np.array(self.points).T
        return np.asarray(np.abs(self._radius(np.radians(angles)) - radii))
