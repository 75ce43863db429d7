"""A cylindrical screen's places against its formula, and back."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from domeshim.errors import OptionError
from domeshim.lens.chosen import lens_chosen
from domeshim.lens.cylinder import Cylinder
from domeshim.lens.detail import SQUARE, pieces_per_radian
from domeshim.lens.orientation import STRAIGHT
from domeshim.options import Options

SCREENS = [Cylinder(120, -30, 30), Cylinder(340, -75, 75), Cylinder(60, 10, 50), Cylinder(270, -20, 60)]


def test_azimuth_and_tangent_of_elevation():
    azimuth, elevation = np.radians(40.0), np.radians(20.0)
    ray = [np.sin(azimuth) * np.cos(elevation), np.sin(elevation), -np.cos(azimuth) * np.cos(elevation)]
    x, y = Cylinder(160, -10, 45).landed(np.array(ray))
    assert x == pytest.approx(40 / 80)
    low, high = np.tan(np.radians([-10, 45]))
    assert y == pytest.approx(2 * (np.tan(elevation) - low) / (high - low) - 1)


@given(st.sampled_from(SCREENS), st.floats(-1, 1), st.floats(-1, 1))
def test_every_place_has_its_ray(screen, x, y):
    assert screen.landed(7 * screen.ray(np.array([x, y]))) == pytest.approx([x, y], abs=1e-9)


def test_the_edges_of_the_frame_are_the_screens():
    corner = Cylinder(160, -10, 45).ray(np.array([1.0, 1.0]))
    assert np.degrees(np.arctan2(corner[0], -corner[2])) == pytest.approx(80)
    assert np.degrees(np.arctan2(corner[1], np.hypot(corner[0], corner[2]))) == pytest.approx(45)


def test_no_place_beyond_a_turn_and_none_outside_is_within():
    screen = Cylinder(340, -20, 20)
    assert np.isnan(screen.ray(np.array([1.1, 0.0]))).all()
    assert screen.within(np.array([[1.0, -1.0], [1.01, 0.0], [0.0, -1.01]])).tolist() == [True, False, False]
    assert screen.nearest(np.array([3.0, -0.5])).tolist() == [1.0, -0.5]


@pytest.mark.parametrize("screen", SCREENS, ids=str)
@pytest.mark.parametrize("shape", [SQUARE, (1.0, 0.4), (1.0, 2.0)])
def test_pieces_of_the_longest_kind_keep_within_the_tolerance(screen, shape):
    radius, tolerance = 512.0, 0.5
    half = 0.5 / pieces_per_radian(screen, radius, tolerance, STRAIGHT, shape)
    rng = np.random.default_rng(3)
    middle = screen.ray(rng.uniform(-1, 1, (6000, 2)))
    middle /= np.linalg.norm(middle, axis=1, keepdims=True)
    across = np.cross(middle, rng.normal(size=middle.shape))
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    a, m, b = (screen.landed(middle * np.cos(half) + s * across * np.sin(half)) for s in (-1, 0, 1))
    off = radius * np.linalg.norm((m - (a + b) / 2) * shape, axis=1)
    inside = (np.abs(np.stack([a, b])) <= 1).all((0, 2))
    assert inside.sum() > 3000
    assert off[inside].max() < 1.02 * tolerance
    if screen.least_detail < 1 / (2 * half) - 1:
        assert off[inside].max() > 0.5 * tolerance


@pytest.mark.parametrize("screen", SCREENS, ids=str)
def test_no_piece_that_is_drawn_reaches_round_behind(screen):
    """One with an end that is not cut off, and the other beyond the half plane behind, would be torn."""
    detail = pieces_per_radian(screen, 256.0, 2.0)
    steepest = max(abs(screen.bottom), abs(screen.top))
    widest = 1 / (detail * np.cos(np.radians(steepest)))
    assert 0 < widest < screen.left_out(detail) <= np.pi / 2
    drawn = np.pi - screen.left_out(detail)
    assert drawn >= np.radians(screen.angle / 2)


def test_the_options_choose_it():
    options = Options.from_environment({"DOME_SURFACE": "Cylinder: 200"})
    assert lens_chosen(options) == Cylinder(200, -30, 30)
    options = Options.from_environment({"DOME_SURFACE": "cylinder:90,-5,40.5"})
    assert lens_chosen(options) == Cylinder(90, -5, 40.5)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("cylinder:", "not numbers"),
        ("cylinder:350", "an angle that is not over 0 to 340 degrees"),
        ("cylinder:nan", "an angle that is not over 0"),
        ("cylinder:90,10", "2 numbers, not one or three"),
        ("cylinder:90,10,-10", "its lower edge is not below its upper one"),
        ("cylinder:90,-80,10", "an edge beyond 75 degrees"),
        ("cylinder:90,nan,10", "an edge beyond 75 degrees"),
    ],
)
def test_what_is_no_cylinder_is_refused(text, reason):
    with pytest.raises(OptionError, match=f"DOME_SURFACE={text}: {reason}.*; accepted: dome, keystone"):
        Options.from_environment({"DOME_SURFACE": text})


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("FOV", "180"),
        ("LENS", "equisolid"),
        ("SEAT", "0,0,.1"),
        ("DISC", "9,9,9"),
        ("FADE", "5"),
        ("METHOD", "paper"),
    ],
)
def test_it_takes_nothing_of_a_domes(name, text):
    settings = {"DOME_SURFACE": "cylinder:90", f"DOME_{name}": text}
    with pytest.raises(OptionError, match=f"DOME_SURFACE=cylinder:90: DOME_{name} is for a dome"):
        Options.from_environment(settings)


def test_it_is_not_made_of_cube_faces():
    with pytest.raises(OptionError, match="method cubemap knows no cylinder"):
        Options.from_environment({"DOME_SURFACE": "cylinder:90", "DOME_METHOD": "cubemap"})
