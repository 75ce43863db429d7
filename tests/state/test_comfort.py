"""The dome's view follows the program's no faster than it may, by the shortest way, and gets there."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from domeshim.state.comfort import SteadyView, looking_at


def angle(turn):
    return np.degrees(Rotation.from_matrix(turn).magnitude())


def test_looking_at_is_glulookat():
    view = looking_at(np.array([1.0, 2, 3]), np.array([4.0, 2, 3]), np.array([0.0, 0, 5]))
    assert np.allclose(view @ [1, 0, 0], [0, 0, -1])
    assert np.allclose(view @ [0, 0, 1], [0, 1, 0])
    assert np.allclose(view @ view.T, np.eye(3))
    assert looking_at(np.zeros(3), np.zeros(3), np.array([0.0, 1, 0])) is None
    assert looking_at(np.zeros(3), np.array([0.0, 1, 0]), np.array([0.0, 1, 0])) is None


@given(st.integers(0, 10_000), st.floats(1, 90))
def test_shown_view_turns_no_faster_than_it_may(seed, fastest):
    steady = SteadyView(fastest)
    views = Rotation.random(40, random_state=seed).as_matrix()
    shown = [views[0]]
    for frame, view in enumerate(views):
        steady.look(view, frame / 60)
        shown.append(steady.turn @ view)
        assert np.allclose(shown[-1] @ shown[-1].T, np.eye(3))
        assert angle(shown[-1] @ shown[-2].T) <= fastest / 60 + 1e-6


@given(st.integers(0, 10_000))
def test_it_arrives_by_the_shortest_way(seed):
    start, goal = Rotation.random(2, random_state=seed).as_matrix()
    steady = SteadyView(30)
    steady.look(start, 0.0)
    far = angle(goal @ start.T)
    for frame in range(1, 8 * 60):
        steady.look(goal, frame / 60)
        left = angle(steady.turn)
        assert left == pytest.approx(max(far - frame * 30 / 60, 0), abs=1e-4)
    assert left == pytest.approx(0, abs=1e-4)


def test_slow_view_is_shown_as_it_is():
    steady = SteadyView(30)
    for frame in range(100):
        view = Rotation.from_euler("y", frame * 0.4, degrees=True).as_matrix()
        steady.look(view, frame / 60)
        assert np.array_equal(steady.turn, np.eye(3)) or np.allclose(steady.turn, np.eye(3))


def test_views_of_one_picture_count_once_and_a_pause_is_not_saved_up():
    steady = SteadyView(30)
    quarter = Rotation.from_euler("y", 90, degrees=True).as_matrix()
    steady.look(np.eye(3), 0.0)
    steady.look(quarter, 0.0)
    assert np.array_equal(steady.turn, np.eye(3))
    steady.look(quarter, 50.0)
    assert angle(steady.turn) == pytest.approx(87)
