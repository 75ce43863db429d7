"""How long a straight piece may be: the chord error of a lens."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from domeshim.lens.models import Lens
from domeshim.lens.projection import disc_of

_STEP = 1e-3
_CLOSEST_TO_ANTI_AXIS = 0.9 * np.pi
"""Straight behind every lens is singular: no bound holds there."""


@lru_cache(maxsize=16)
def curvature(lens: Lens, fov: float) -> float:
    """The k of "a chord of angle a is off by at most R k a^2 / 8": the strongest bend of a great circle.

    The largest second derivative of the disc position along great circles within the field of view (fov in
    degrees), over all places and headings. 1 for an equidistant lens of 180 degrees.
    """
    phi, heading = np.meshgrid(
        np.linspace(1e-3, min(np.radians(fov / 2), _CLOSEST_TO_ANTI_AXIS), 181), np.linspace(0, np.pi / 2, 31)
    )
    here = np.stack([np.sin(phi), np.zeros_like(phi), -np.cos(phi)], -1)
    along = np.stack([np.cos(phi), np.zeros_like(phi), np.sin(phi)], -1) * np.cos(heading)[..., None]
    along[..., 1] += np.sin(heading)
    before, after = (here * np.cos(_STEP) + sign * along * np.sin(_STEP) for sign in (-1, 1))
    second = (disc_of(before, lens) - 2 * disc_of(here, lens) + disc_of(after, lens)) / _STEP**2
    return float(np.linalg.norm(second, axis=-1).max())


def pieces_per_radian(lens: Lens, fov: float, radius: float, tolerance: float) -> float:
    """How many straight pieces an arc of one radian needs; radius of the disc and tolerance in pixels."""
    return float(np.sqrt(radius * curvature(lens, fov) / (8 * tolerance)))


def farthest(fov: float, detail: float) -> float:
    """The angle from the axis, radians, up to which primitives are drawn: half of fov, given in degrees.

    Straight behind there is no direction, and a piece around it would be drawn inside out, over all the disc:
    the last one and a half pieces before it are left out. detail: pieces an arc of one radian is cut into.
    """
    return float(min(np.radians(fov / 2), np.pi - 1.5 / detail))
