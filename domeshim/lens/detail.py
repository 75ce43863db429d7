"""How long a straight piece may be: the chord error of a lens."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from domeshim.lens.models import Lens
from domeshim.lens.orientation import STRAIGHT, Orientation
from domeshim.lens.projection import disc_of

_STEP = 1e-3
_CLOSEST = 0.02
"""The least angle from straight behind at which the bend is looked at, radians; it changes little beyond."""


def curvature(lens: Lens, fov: float, orientation: Orientation = STRAIGHT) -> float:
    """The k of "a chord of angle a is off by at most R k a^2 / 8 b^2": the strongest bend of a great circle.

    The largest second derivative of the disc position along great circles within the field of view (fov in
    degrees), over all places and headings, times b^2; b is the place's angle from straight behind, in
    radians and at most 1: there every lens is singular, and the bend grows like 1 / b^2. 1 for an
    equidistant lens of 180 degrees.
    """
    return _curvature(lens, fov, replace(orientation, tilt=0.0, heading=0.0, roll=0.0))


@lru_cache(maxsize=16)
def _curvature(lens: Lens, fov: float, orientation: Orientation) -> float:
    reach = min(np.radians(fov / 2), np.pi - _CLOSEST)
    # Around a lens all ways from the axis are alike; from a seat they are not.
    around = np.linspace(0, 2 * np.pi, 48, endpoint=False) if orientation.off_centre else np.zeros(1)
    farthest = np.pi if orientation.off_centre else reach
    phi, theta, heading = np.meshgrid(
        np.linspace(1e-3, farthest, 181 if orientation.off_centre else 721),
        around,
        np.linspace(0, np.pi, 13 if orientation.off_centre else 31),
        indexing="ij",
    )
    cos, sin = np.cos(theta), np.sin(theta)
    here = np.stack([np.sin(phi) * cos, np.sin(phi) * sin, -np.cos(phi)], -1)
    outward = np.stack([np.cos(phi) * cos, np.cos(phi) * sin, np.sin(phi)], -1)
    across = np.stack([-sin, cos, np.zeros_like(phi)], -1)
    along = outward * np.cos(heading)[..., None] + across * np.sin(heading)[..., None]
    before, after = (here * np.cos(_STEP) + sign * along * np.sin(_STEP) for sign in (-1, 1))
    discs = [disc_of(place, lens, orientation) for place in (before, here, after)]
    second = np.linalg.norm(discs[0] - 2 * discs[1] + discs[2], axis=-1) / _STEP**2
    rays = orientation.aimed(here)
    seen = np.arctan2(np.hypot(rays[..., 0], rays[..., 1]), -rays[..., 2]) <= reach + 1e-9
    behind = np.minimum(np.arccos(np.clip(here @ straight_behind(orientation), -1, 1)), 1)
    return float((second * behind**2)[seen].max())


def straight_behind(orientation: Orientation) -> NDArray[np.float64]:
    """(3,): the unit direction of eye space that the lens has straight behind."""
    direction = orientation.seen(np.array([0.0, 0.0, 1.0]))
    return np.asarray(direction / np.linalg.norm(direction))


def pieces_per_radian(
    lens: Lens, fov: float, radius: float, tolerance: float, orientation: Orientation = STRAIGHT
) -> float:
    """How many straight pieces an arc of one radian needs; radius of the disc and tolerance in pixels.

    Places inside an even triangle of edges a are off by up to R k a^2 / 6, more than those on its edges. It
    is more by 1 / b where the arc comes closer than one radian to straight behind.
    """
    return float(np.sqrt(radius * curvature(lens, fov, orientation) / (6 * tolerance)))


def least_from_behind(fov: float, detail: float) -> float:
    """The angle from straight behind, radians, within which nothing is drawn; fov: in degrees.

    What is drawn reaches one piece beyond the rim, which is then cut to the pixel. But straight behind there
    is no direction, and a piece around it would be drawn inside out, over all the disc: a lens of 360 degrees
    leaves out about a quarter of the tolerance, in pixels of radius. detail: pieces an arc of one radian is
    cut into.
    """
    return float(max(np.pi - np.radians(fov / 2) - 1 / detail, min(0.1 / detail**2, 0.05)))


def cone(half_angle: float) -> tuple[float, float]:
    """The uniform domeRim of a cone around straight behind, by its half angle in radians."""
    return float(np.cos(half_angle)), float(np.sin(half_angle))
