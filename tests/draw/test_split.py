"""Wide primitives are halved evenly in angle, alike on both sides of an edge."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from domeshim.draw.split import Limit, ahead_of_viewer, split_wide
from domeshim.record.runs import Run

WIDEST = 1.0


def split(positions, corners, to_eye=None, **attributes):
    piece = Run(
        np.asarray(positions, np.float32), {n: np.asarray(v, np.float32) for n, v in attributes.items()}, ()
    )
    return split_wide(piece, corners, np.eye(4) if to_eye is None else to_eye, Limit(WIDEST))


def places(run):
    return run.attributes["place"][:, :3]


def edge_angles(run, corners):
    d = places(run).astype(float).reshape(-1, corners, 3)
    d /= np.linalg.norm(d, axis=-1, keepdims=True)
    following = np.roll(d, -1, 1)
    return np.arctan2(np.linalg.norm(np.cross(d, following), axis=-1), (d * following).sum(-1))


@given(st.integers(0, 100_000))
def test_every_edge_is_narrow_and_no_area_is_lost(seed):
    points = np.random.default_rng(seed).normal(size=(3, 3)) * 10 + [0, 0, -1]
    run = split(points, 3)
    assert edge_angles(run, 3).max() <= WIDEST + 1e-4
    p = places(run).astype(float).reshape(-1, 3, 3)
    areas = np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=-1) / 2
    whole = np.linalg.norm(np.cross(points[1] - points[0], points[2] - points[0])) / 2
    assert areas.sum() == pytest.approx(whole, rel=1e-3)


def on_edge(run, a, b):
    """The vertices of a run that lie on the edge from a to b, as exact numbers."""
    p = places(run)
    t = ((p - a) @ (b - a)) / ((b - a) @ (b - a))
    near = np.linalg.norm(p - (a + t[:, None] * (b - a)), axis=1) < 1e-4 * np.linalg.norm(b - a)
    return {tuple(row) for row in p[near]}


def test_neighbours_share_every_vertex_of_their_edge():
    a, b = np.array([-50, -1, -50], np.float32), np.array([50, -1, 50], np.float32)
    left = split([a, b, [-50, -1, 50]], 3)
    right = split([b, a, [50, -1, -50]], 3)
    assert len(on_edge(left, a, b)) > 2
    assert on_edge(left, a, b) == on_edge(right, a, b)


def test_lines_are_cut_evenly_in_angle():
    run = split([[-50, 3, -2], [50, 3, -2]], 2)
    angles = edge_angles(run, 2)[:, 0]
    assert angles.max() - angles.min() < 1e-4


@pytest.mark.parametrize("corners", [2, 3])
def test_pieces_keep_the_corners_and_say_where_they_lie_between(corners):
    whole = np.array([[-5, -1, -5], [5, -1, -5], [0, -1, 5]], np.float32)[:corners]
    run = split(whole, corners, color=np.eye(4)[:corners])
    assert len(run.positions) > corners
    assert (run.positions.reshape(-1, corners, 3) == whole).all()
    assert (run.attributes["color"].reshape(-1, corners, 4) == np.eye(4)[:corners]).all()
    weights = run.attributes["weights"][:, :corners]
    assert weights @ whole == pytest.approx(places(run), abs=1e-5)
    assert weights.sum(1) == pytest.approx(np.ones(len(weights)))


@given(st.integers(0, 100_000))
def test_a_parallelogram_is_cut_into_quads_that_cover_it_once(seed):
    rng = np.random.default_rng(seed)
    corner, across, up = rng.normal(size=(3, 3)) * 10
    whole = np.array([corner, corner + across, corner + across + up, corner + up])
    run = split(whole, 4, color=np.eye(4))
    p = places(run).astype(float).reshape(-1, 4, 3)
    assert edge_angles(run, 4).max() <= WIDEST + 1e-4
    assert (run.attributes["color"].reshape(-1, 4, 4) == np.eye(4)).all()
    area = np.cross(across, up)
    size = np.linalg.norm(area)
    areas = np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1]) @ area / size / 2
    assert areas.min() > -1e-4 * size  # none is turned round
    assert areas.sum() == pytest.approx(size, rel=1e-3)
    s, t = run.attributes["weights"][:, :2].T
    assert corner + s[:, None] * across + t[:, None] * up == pytest.approx(places(run), abs=1e-4)


def test_a_parallelogram_and_a_triangle_share_every_vertex_of_their_edge():
    a, b = np.array([-50, -1, -50], np.float32), np.array([50, -1, 50], np.float32)
    left = split([a, b, [40, -1, 90], [-60, -1, -10]], 4)
    right = split([b, a, [50, -1, -50]], 3)
    assert len(on_edge(left, a, b)) > 2
    assert on_edge(left, a, b) == on_edge(right, a, b)


def test_what_has_no_finite_place_is_left_out_and_nothing_else():
    run = split([[0, 0, -1], [1, 0, -2], [np.nan, 0, -1], [0, 0, -9], [1, 0, -9], [0, 1, -9]], 3)
    assert len(run.positions) == 3
    assert np.isfinite(run.positions).all()


AFT = (0.0, 0.0, 1.0)


def behind_and_angles(run):
    places = run.attributes["place"][:, :3].astype(float)
    behind = np.arctan2(np.hypot(places[:, 0], places[:, 1]), places[:, 2]).reshape(-1, 3)
    return behind, edge_angles(run, 3)


def test_around_straight_behind_edges_shrink_with_their_distance_from_it():
    wall = Run(np.array([[-4, -3, 1], [5, -3, 1], [0, 6, 1]], np.float32), {}, ())
    run = split_wide(wall, 3, np.eye(4), Limit(WIDEST, AFT, 0.01))
    behind, angles = behind_and_angles(run)
    closest = np.maximum(np.minimum(behind, np.roll(behind, -1, 1)) - angles / 2, 0.01)
    assert (angles <= closest * 0.5 + 1e-6).all()
    assert (behind.max(1) < 0.01).any()  # the piece around it lies wholly in what is left out
    assert len(run.positions) < 3 * 2500


def test_straight_behind_makes_no_difference_where_it_is_not_seen():
    assert Limit(WIDEST).at(0.0) == WIDEST
    assert Limit(WIDEST, AFT, 0.01).at(2.5) == WIDEST
    assert Limit(WIDEST, AFT, 0.01).at(0.1) == pytest.approx((0.1 - 0.01 / 2) / 2)
    assert Limit(WIDEST, AFT, 0.01).at(0.0) == pytest.approx(0.01 / 4)


def test_an_edge_too_stiff_for_single_precision_is_cut_until_it_may_stay_whole():
    piece = 0.1
    edge = Run(np.array([[1e-30, 0, -1e-30], [-3e29, 8e29, -1e29]], np.float32), {}, ())
    run = split_wide(edge, 2, np.eye(4), Limit(WIDEST, piece=piece))
    d = places(run).astype(float).reshape(-1, 2, 3)
    lengths = np.linalg.norm(d, axis=-1)
    stiff = lengths.max(1) / lengths.min(1) > 1e30
    assert (edge_angles(run, 2)[stiff] <= piece).all()
    assert (edge_angles(run, 2) <= WIDEST).all()


SMALL_VIEW = np.array([[0.3, 0, 0, 0], [0, 0.3, 0, 0], [0, 0, 1, 0], [0, 0, -1, 0]])
"""A perspective on the panel: w is how far ahead a point lies."""


@pytest.mark.parametrize("corners", [2, 3])
@given(st.integers(0, 100_000))
def test_what_passes_the_viewer_of_a_small_view_is_seen_up_to_there(corners, seed):
    points = np.random.default_rng(seed).normal(size=(30 * corners, 3)) * 10
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("domeshim.draw.split._MOST_ROUNDS", 14)
        run = split(points, corners, SMALL_VIEW)
    ahead = points[:, 2].reshape(-1, corners) < 0
    z = run.attributes["place"][:, 2].reshape(-1, corners)
    straddling = ahead.any(1) & ~ahead.all(1)
    assert len(z) < 60 * len(ahead), "halving comes to an end"
    assert ((z < 0).all(1) | (z >= 0).all(1)).all()
    parents = np.round(run.attributes["weights"].reshape(-1, corners, 3)[:, :, :corners].sum(-1), 3)
    assert (parents == 1).all()
    assert z.min() == pytest.approx(points[:, 2].min(), rel=1e-5)
    assert straddling.any()


@pytest.mark.parametrize("corners", [2, 3])
def test_an_edge_through_infinity_is_cut_there(corners, monkeypatch):
    monkeypatch.setattr("domeshim.draw.split._MOST_ROUNDS", 14)
    points = [[1, 0.2, -1, 1], [1, -0.1, 1, -1], [0, 1, -3, 1]][:corners]
    run = split(points, corners)
    assert len(run.positions) < 12 * corners
    assert run.attributes["place"][:, 3].min() > 0


@pytest.mark.parametrize("least", [0.0, 1e-6])
def test_an_edge_of_any_w_that_does_not_pass_the_viewer_stays_whole(least):
    w = np.array([[least, 1e6]])
    pieces = np.concatenate([np.array([[[5.0, 3, -2], [-5, 3, -2]]]), w[..., None]], -1)
    kept, parents = ahead_of_viewer(pieces, np.array([0]), np.eye(4))
    assert (kept == pieces).all()
    assert parents.tolist() == [0]
