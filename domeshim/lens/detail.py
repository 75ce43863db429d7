"""How long a straight piece may be: the chord error of a lens."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from domeshim.lens.landing import Lens
from domeshim.lens.orientation import STRAIGHT, Orientation
from domeshim.lens.projection import disc_of

_STEP = 1e-3
SQUARE = (1.0, 1.0)


def curvature(lens: Lens, orientation: Orientation = STRAIGHT, shape: tuple[float, float] = SQUARE) -> float:
    """The k of "a chord of angle a is off by at most R k a^2 / 8 b^2": the strongest bend of a great circle.

    The largest second derivative of the place along great circles within the picture, over all places and
    headings, times b^2; b is the place's angle from straight behind, in radians and at most 1: there a
    fisheye is singular, and the bend grows like 1 / b^2. 1 for an equidistant lens of 180 degrees. shape: how
    many R a unit is in x and in y.
    """
    return _curvature(lens, replace(orientation, tilt=0.0, heading=0.0, roll=0.0), shape)


@lru_cache(maxsize=16)
def _curvature(lens: Lens, orientation: Orientation, shape: tuple[float, float]) -> float:
    # Around a lens all ways from the axis are alike; from a seat they are not.
    here = orientation.seen(lens.spread(orientation.off_centre))
    here = (here / np.linalg.norm(here, axis=-1, keepdims=True)).reshape(-1, 1, 3)
    aside = np.cross(here, np.eye(3)[np.abs(here).argmin(-1)])
    outward = aside / np.linalg.norm(aside, axis=-1, keepdims=True)
    heading = np.linspace(0, np.pi, 13 if orientation.off_centre else 31)[:, None]
    along = outward * np.cos(heading) + np.cross(here, outward) * np.sin(heading)
    before, after = (here * np.cos(_STEP) + sign * along * np.sin(_STEP) for sign in (-1, 1))
    places = [disc_of(place, lens, orientation) * shape for place in (before, here, after)]
    second = np.linalg.norm(places[0] - 2 * places[1] + places[2], axis=-1) / _STEP**2
    if lens.singular:
        behind = np.minimum(np.arccos(np.clip(here @ straight_behind(orientation), -1, 1)), 1)
        second = second * behind**2
    return float(second.max())


def straight_behind(orientation: Orientation) -> NDArray[np.float64]:
    """(3,): the unit direction of eye space that the lens has straight behind."""
    direction = orientation.seen(np.array([0.0, 0.0, 1.0]))
    return np.asarray(direction / np.linalg.norm(direction))


def pieces_per_radian(
    lens: Lens,
    radius: float,
    tolerance: float,
    orientation: Orientation = STRAIGHT,
    shape: tuple[float, float] = SQUARE,
) -> float:
    """How many straight pieces an arc of one radian needs; radius of the disc and tolerance in pixels.

    Places inside an even triangle of edges a are off by up to R k a^2 / 6, more than those on its edges. It
    is more by 1 / b where the arc comes closer than one radian to straight behind, and there a fisheye is
    singular. shape: as for curvature.
    """
    wanted = float(np.sqrt(radius * curvature(lens, orientation, shape) / (6 * tolerance)))
    return max(wanted, lens.least_detail)


def room_behind(behind: NDArray[np.floating], least: float) -> NDArray[np.floating]:
    """How long an arc's pieces may be as a share of those elsewhere, and how much room it has behind.

    behind: (...), the arc's least angle from straight behind; least: nothing closer is drawn; in radians.
    The share is at most 1, wherever this is more. Where what is drawn ends, the inside of triangles is seen,
    which is less even than their edges: there pieces are half as long. Twin of tessellate/need_behind.
    """
    return np.asarray(np.maximum(behind, least) - least / 2)


def cone(half_angle: float) -> tuple[float, float]:
    """The uniform domeRim of what is left out behind, a cone or a wedge, by its half angle in radians."""
    return float(np.cos(half_angle)), float(np.sin(half_angle))
