"""Where the dome looks; and rays from a seat and from a projector, followed to the dome by themselves."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from domeshim.lens.models import Equidistant
from domeshim.lens.orientation import Orientation
from domeshim.lens.projection import direction_of, disc_of
from domeshim.options import Options

AHEAD, RIGHT, UP, BEHIND = ((0.0, 0.0, -1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
LENS = Equidistant(180)
RNG = np.random.default_rng(11)


def lands(direction, **fields):
    return disc_of(np.array(direction), LENS, Orientation(**fields))


@pytest.mark.parametrize(
    ("direction", "fields", "place"),
    [
        (AHEAD, {"tilt": 30}, (0, -1 / 3)),
        (UP, {"tilt": 90}, (0, 0)),
        (RIGHT, {"tilt": 90}, (1, 0)),
        (RIGHT, {"heading": 90}, (0, 0)),
        (AHEAD, {"heading": 45}, (-0.5, 0)),
        (UP, {"roll": 90}, (1, 0)),
        (RIGHT, {"roll": 90}, (0, -1)),
        # First turned to the right, then raised, then the picture turned.
        (RIGHT, {"heading": 90, "tilt": 45}, (0, -0.5)),
        (RIGHT, {"heading": 90, "tilt": 45, "roll": 90}, (-0.5, 0)),
    ],
)
def test_where_directions_land(direction, fields, place):
    assert lands(direction, **fields) == pytest.approx(place, abs=1e-12)


def test_a_dome_master_has_its_front_at_the_bottom_edge():
    orientation = Orientation.of(Options.from_environment({"DOME_PRESET": "domemaster"}))
    places = [disc_of(np.array(d), LENS, orientation) for d in (AHEAD, RIGHT, UP)]
    assert np.array(places) == pytest.approx(np.array([(0, -1), (1, 0), (0, 0)]), abs=1e-12)


TURN, PLACE = st.floats(-180, 180), st.tuples(*[st.floats(-0.5, 0.5)] * 3)


@given(TURN, TURN, TURN, PLACE, PLACE)
def test_what_is_seen_leads_back(tilt, heading, roll, seat, projector):
    orientation = Orientation(tilt, heading, roll, seat, projector)
    directions = RNG.normal(size=(50, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    back = orientation.seen(orientation.aimed(directions))
    assert back / np.linalg.norm(back, axis=1, keepdims=True) == pytest.approx(directions, abs=1e-9)
    disc = RNG.uniform(-0.7, 0.7, (50, 2))
    lens = Equidistant(180)
    assert disc_of(direction_of(disc, lens, orientation), lens, orientation) == pytest.approx(disc, abs=1e-9)


def marched(origin, direction, steps=60):
    """Where a ray from within the unit sphere leaves it, by halving: (3,)."""
    low, high = 0.0, 2.0
    for _ in range(steps):
        middle = (low + high) / 2
        low, high = (middle, high) if np.linalg.norm(origin + middle * direction) < 1 else (low, middle)
    return origin + low * direction


def test_a_seat_sees_the_right_point_of_the_dome():
    """A dome of 5 m, a viewer 1 m to the right and 2 m to the top of the disc, a projector 1 m below."""
    options = Options(seat=(1.0, 2.0, 0.0), projector=(0.0, 0.0, -1.0), radius=5.0)
    orientation = Orientation.of(options)
    seat, projector = np.array([1.0, 2.0, 0.0]) / 5, np.array([0.0, 0.0, 1.0]) / 5  # the pole is at -z
    for _ in range(50):
        direction = RNG.normal(size=3)
        direction /= np.linalg.norm(direction)
        ray = marched(seat, direction) - projector
        aimed = orientation.aimed(direction)
        assert aimed / np.linalg.norm(aimed) == pytest.approx(ray / np.linalg.norm(ray), abs=1e-9)


def test_the_way_the_correction_goes():
    """Sitting to the right, what is straight above falls on the dome to the right of its pole."""
    assert lands(AHEAD, seat=(0.5, 0.0, 0.0))[0] == pytest.approx(1 / 3)  # 30 degrees: sin is 0.5
    # A projector to the right throws to its left what shall fall on the pole.
    assert lands(AHEAD, projector=(0.5, 0.0, 0.0))[0] == pytest.approx(-np.degrees(np.arctan(0.5)) / 90)
    # Closer to the pole, the pole's surroundings look wider, so their picture on the dome is narrower.
    beside = (0.1, 0.0, -1.0)
    assert lands(beside, seat=(0.0, 0.0, -0.5))[0] < lands(beside)[0]


def test_a_centred_dome_asks_for_nothing():
    assert (Orientation().aim, Orientation().uniforms) == ("straight", ())
    assert Orientation(roll=5).aim == "turned"
    assert Orientation.of(Options(radius=8.0, seat=(0.0, 0.0, 0.0))).aim == "straight"
