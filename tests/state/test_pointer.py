"""Places of the frame and of the program's window lead to each other."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from domeshim.lens.models import lens_of
from domeshim.lens.orientation import Orientation
from domeshim.lens.projection import disc_of
from domeshim.options import Options
from domeshim.state.perspective import depth_range, frustum, perspective
from domeshim.state.placement import Placer
from domeshim.state.pointer import LARGEST_PLACE, Sight
from domeshim.window.frame import Frame

POLYNOMIAL = (0.62, 0.004, -0.012)
"""Rises all the way to 180 degrees from its axis."""


@st.composite
def sights(draw):
    size = draw(st.tuples(st.integers(64, 2000), st.integers(64, 2000)))
    frame = Frame(draw(st.tuples(st.integers(64, 4096), st.integers(64, 4096))), size)
    fov = draw(st.floats(90, 360))
    name = draw(st.sampled_from(["equidistant", "polynomial"]))
    lens = lens_of(name, POLYNOMIAL if name == "polynomial" else (), fov)
    placer = Placer(Options(fill=draw(st.none() | st.floats(20, 160))))
    if draw(st.booleans()):
        p = perspective(draw(st.floats(20, 120)), draw(st.floats(0.5, 2)), 0.1, 100)
        placer.perspective_set(p, on_modelview=False)
        placer.place(p, None, (0, 0, *size), frame)
    tilt = draw(st.floats(-90, 90))
    return Sight(placer.through_window(frame), frame, lens, Orientation(tilt))


def sight(*, fov=180.0, tilt=0.0, size=(800, 600), frame=None, lens=("equidistant", ()), p=None, **options):
    frame = Frame(frame or size, size)
    placer = Placer(Options(**options))
    p = perspective(45, size[0] / size[1], 0.1, 100) if p is None else p
    placer.perspective_set(p, on_modelview=False)
    placer.place(p, None, (0, 0, *size), frame)
    optics = lens_of(*lens, fov)
    return Sight(placer.through_window(frame), frame, optics, Orientation(tilt))


@settings(max_examples=300)
@given(sights(), st.floats(0, 1), st.floats(0, 1))
def test_a_place_of_the_window_comes_back(s, x, y):
    place = np.array([x, y]) * s.frame.program_size
    landed = s.to_frame(place)
    assume(s.within(landed + 1e-3 * np.sign(landed - np.array(s.frame.size) / 2)))
    assert np.abs(s.to_program(landed) - place).max() < 0.01


@settings(max_examples=300)
@given(sights(), st.floats(-0.5, 1.5), st.floats(-0.5, 1.5))
def test_every_place_of_the_frame_has_a_finite_place(s, x, y):
    place = s.to_program(np.array([x, y]) * s.frame.size)
    assert np.isfinite(place).all()
    assert np.abs(place).max() <= LARGEST_PLACE
    assert np.abs(s.frame.program_size[1] - place[1]) <= LARGEST_PLACE


@settings(max_examples=100)
@given(sights(), st.floats(0, 2 * np.pi))
def test_farther_from_the_axis_is_farther_out(s, azimuth):
    phi = np.linspace(0, np.radians(179), 400)
    away = np.stack([np.cos(azimuth) * np.sin(phi), np.sin(azimuth) * np.sin(phi), -np.cos(phi)], -1)
    out = np.linalg.norm(s.seen(away) - s.seen(away[:1]), axis=1)
    assert (np.diff(out) >= -1e-6).all()
    assert out[-1] > 10_000


@settings(max_examples=200)
@given(sights(), st.floats(-2, 2), st.floats(-1.5, 1.5), st.floats(0.2, 90))
def test_a_point_in_space_is_pointed_at_where_it_lands(s, x, y, distance):
    """The dome's picture of a point and gluProject's meet, by the matrices alone."""
    eye = np.array([x, y, -1.0]) * distance
    x0, y0, side, _ = s.frame.square
    landed = (disc_of(eye, s.lens, s.orientation) + 1) * side / 2 + (x0, y0)
    assume(s.within(landed * (1 + 1e-9)))
    clip = s.view.camera @ [*eye, 1.0]
    vx, vy, w, h = s.view.viewport
    on_monitor = (clip[:2] / clip[3] + 1) * (w / 2, h / 2) + (vx, vy)
    assume(np.abs(on_monitor).max() < 10_000)
    assert np.abs(s.to_program(landed) - on_monitor).max() < 0.5


@settings(max_examples=200)
@given(sights(), st.floats(0.3, 80), st.floats(0, 1), st.floats(0, 1))
def test_a_depth_of_the_dome_becomes_the_monitors(s, distance, x, y):
    direction = s.directions(np.array([x, y]) * s.frame.program_size)
    direction = direction / np.linalg.norm(direction)
    clip = s.view.camera @ [*(direction * distance), 1.0]
    a, b = depth_range(s.view.camera).uniform
    on_dome = (a + b / distance + 1) / 2
    found = s.monitor_depth(np.array(on_dome), direction)
    assert found == pytest.approx((clip[2] / clip[3] + 1) / 2, abs=1e-9)


def test_the_papers_depth_becomes_the_monitors():
    s = sight(tilt=20)
    s = Sight(s.view, s.frame, s.lens, s.orientation, paper=True)
    eye = np.array([1.0, 2.0, -7.0])
    tilt = np.radians(20)
    z = np.cos(tilt) * eye[2] - np.sin(tilt) * eye[1]
    on_dome = ((-z / 500 - 1) + 1) / 2
    clip = s.view.camera @ [*eye, 1.0]
    found = s.monitor_depth(np.array(on_dome), eye / np.linalg.norm(eye))
    assert found == pytest.approx((clip[2] / clip[3] + 1) / 2)


def test_the_middle_stays_the_middle():
    assert sight().to_program(np.array([400.0, 300.0])) == pytest.approx([400, 300])


def test_the_top_of_the_view_is_half_its_angle_up():
    """45 degrees of a 180 degree dome of 600 pixels: 22.5 degrees are 75 pixels."""
    assert sight().to_program(np.array([400.0, 375.0])) == pytest.approx([400, 600])


def test_filling_brings_the_programs_edge_to_the_dome():
    assert sight(fill=90).to_program(np.array([400.0, 450.0])) == pytest.approx([400, 600])


def test_tilt_moves_the_middle_down():
    place = sight(tilt=30).to_frame(np.array([400.0, 300.0]))
    assert place == pytest.approx([400, 300 - 100])


def test_off_centre_views_keep_their_own_middle():
    p = frustum(-1, 3, -1, 1, 1, 10)
    assert sight(p=p).to_program(np.array([400.0, 300.0])) == pytest.approx([200, 300])


@pytest.mark.parametrize("fov", [180, 250, 360])
def test_ninety_degrees_and_more_are_as_far_out_as_can_be(fov):
    s = sight(fov=fov)
    x, y = s.to_program(np.array([400 + 300 * 180 / fov - 1e-6, 300.0]))
    assert x > 32000 - 800
    assert y == pytest.approx(300, abs=1e-3)


def test_straight_behind_is_far_out_as_well():
    x, y = sight(fov=360).seen(np.array([0.0, 0.0, 1.0]))
    assert max(abs(x), abs(y)) > 30_000


def test_outside_the_disc_the_rims_nearest_place_counts():
    s = sight(fov=90)
    at_rim, beyond = s.to_program(np.array([[700.0, 300.0], [795.0, 300.0]]))
    assert beyond == pytest.approx(at_rim, rel=1e-6)


def test_free_sides_of_a_wide_frame_are_not_within():
    s = sight(frame=(1000, 600))
    places = np.array([[500.0, 300.0], [201.0, 300.0], [199.0, 300.0]])
    assert s.within(places).tolist() == [True, True, False]
