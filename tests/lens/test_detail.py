"""The promise of the tolerance: pieces as long as the curvature allows keep within it, on every lens."""

import numpy as np
import pytest

from domeshim.lens.detail import cone, curvature, pieces_per_radian, straight_behind
from domeshim.lens.models import Equidistant
from domeshim.lens.orientation import STRAIGHT, Orientation
from domeshim.lens.projection import disc_of
from tests.lens.lenses import every_lens

RADIUS, TOLERANCE = 512.0, 0.5
RNG = np.random.default_rng(8)


def arcs(angle, count=4000):
    """(3, count, 3): the ends and the middle of great circles' arcs of this angle, all over the sphere."""
    middle = RNG.normal(size=(count, 3))
    middle /= np.linalg.norm(middle, axis=1, keepdims=True)
    across = np.cross(middle, RNG.normal(size=(count, 3)))
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    half = angle / 2
    return np.stack([middle * np.cos(half) + side * across * np.sin(half) for side in (-1, 0, 1)])


def off_in_pixels(lens, orientation):
    """How far the middle of each piece is from its chord, for pieces within the field of view."""
    pieces = pieces_per_radian(lens, RADIUS, TOLERANCE, orientation)
    directions = arcs(1 / pieces)
    rays = orientation.aimed(directions)
    phi = np.arctan2(np.hypot(rays[..., 0], rays[..., 1]), -rays[..., 2])
    behind = np.arccos(np.clip(directions @ straight_behind(orientation), -1, 1))
    within = ((phi <= np.radians(lens.fov / 2)) & (behind > 1)).all(0)
    assert within.sum() > 20
    before, middle, after = disc_of(directions[:, within], lens, orientation)
    return RADIUS * np.linalg.norm(middle - (before + after) / 2, axis=1)


@pytest.mark.parametrize("lens", every_lens(), ids=str)
def test_pieces_of_the_longest_kind_keep_within_the_tolerance(lens):
    assert off_in_pixels(lens, STRAIGHT).max() < TOLERANCE * 1.02


@pytest.mark.parametrize(
    "orientation",
    [
        Orientation(tilt=50, seat=(0, 0.5, 0)),
        Orientation(seat=(0.2, -0.3, 0.4), projector=(0, 0.4, 0)),
        Orientation(heading=20, projector=(0, 0, -0.7)),
    ],
    ids=str,
)
def test_they_do_so_from_a_seat(orientation):
    off = off_in_pixels(Equidistant(180), orientation)
    assert TOLERANCE * 0.2 < off.max() < TOLERANCE * 1.02


def test_the_pieces_are_not_shorter_than_they_must_be():
    assert curvature(Equidistant(180)) == pytest.approx(1, abs=0.01)
    assert off_in_pixels(Equidistant(180), STRAIGHT).max() > 0.7 * TOLERANCE


def test_turning_the_dome_changes_nothing():
    lens = Equidistant(220)
    assert curvature(lens, Orientation(40, 50, 60)) == curvature(lens)


@pytest.mark.parametrize("behind", [2.0, 1.0, 0.3, 0.03])
def test_no_arc_is_off_by_more_than_the_bound(behind):
    """Across the meridian, where a great circle bends most: a piece's middle against its chord."""
    lens, angle = Equidistant(360.0), 0.02 * min(behind, 1)
    middle = np.array([np.sin(behind), 0.0, np.cos(behind)])
    ends = [middle * np.cos(angle / 2) + np.array([0, sign * np.sin(angle / 2), 0]) for sign in (-1, 1)]
    chord = (disc_of(ends[0], lens) + disc_of(ends[1], lens)) / 2
    off = np.linalg.norm(disc_of(middle, lens) - chord)
    bound = curvature(lens) * angle**2 / 8 / min(behind, 1) ** 2
    assert 0.2 * bound < off < 1.01 * bound


def test_what_is_drawn_reaches_one_piece_beyond_the_rim():
    assert Equidistant(180.0).left_out(10.0) == pytest.approx(np.pi / 2 - 0.1)
    assert Equidistant(220.0).left_out(10.0) == pytest.approx(np.radians(70) - 0.1)


def test_at_360_degrees_less_than_the_tolerance_is_left_out():
    radius, tolerance = 512.0, 0.5
    detail = np.sqrt(radius * curvature(Equidistant(360.0)) / (6 * tolerance))
    assert 0 < Equidistant(360.0).left_out(detail) / np.pi * radius < tolerance


def test_a_cone_narrower_than_single_precision_of_its_cosine_is_still_one():
    cosine, sine = np.float32(cone(1e-5))
    assert cosine == 1
    inside, outside = (cosine * np.sin(a) - sine * np.cos(a) for a in (0.9e-5, 1.1e-5))
    assert inside < 0 < outside
