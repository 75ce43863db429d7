"""The bound on an edge's angle holds for every edge, wherever the mesh is."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from domeshim.draw.extent import Extent, Spheres
from domeshim.draw.patches import corners, longest_edge


def angles(points, edges):
    a, b = points[edges[:, 0]], points[edges[:, 1]]
    return np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), (a * b).sum(1))


@given(st.integers(0, 100_000), st.floats(0.01, 100), st.floats(-2, 2))
def test_no_edge_subtends_more_than_the_bound(seed, size, shear):
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(12, 3)) * size
    to_eye = np.eye(4)
    to_eye[:3, :3] = rng.normal(size=(3, 3))
    to_eye[0, 1] += shear
    to_eye[:3, 3] = rng.normal(size=3) * 10
    edges = corners(1, 12)
    eye = points @ to_eye[:3, :3].T + to_eye[:3, 3]
    matrix = to_eye.T.ravel().tolist()
    largest = angles(eye, edges).max()
    exact = Extent.of(points, longest_edge(points, edges))
    few = Extent.of_few(points.ravel().tolist())
    assert exact.largest_angle(matrix) >= largest - 1e-9
    assert few.largest_angle(matrix) >= largest - 1e-9
    for allowed in (0.01, 0.1, 1.0):
        if exact.surely_seen_from(matrix, 0.5 / np.tan(allowed / 2)):
            assert largest <= allowed + 1e-9


def test_bound_is_close_for_a_short_edge_ahead():
    extent = Extent.of_few([-0.5, 0, -10, 0.5, 0, -10])
    assert extent.largest_angle(np.eye(4).T.ravel().tolist()) < 1.1 * 2 * np.arctan(0.05)


def test_a_mesh_across_infinity_is_bound_by_nothing():
    """w = z + 1: it changes its sign within the mesh, and is below 0 in all of the second."""
    matrix = np.eye(4)
    matrix[3, 2] = 1
    to_eye = matrix.T.ravel().tolist()
    across, behind = Extent.of_few([0, 0, -1.4, 1, 0, -1]), Extent.of_few([0, 0, -9, 1, 0, -9])
    assert across.largest_angle(to_eye) == np.pi
    assert (across.smallest_line(to_eye), across.least_angle_from((0, 0, 1), to_eye)) == (0, 0)
    assert behind.largest_angle(to_eye) < 0.2
    assert behind.least_angle_from((0, 0, 1), to_eye) == 0
    assert not behind.surely_seen_from(to_eye, 0.0)


@given(st.integers(0, 100_000), st.floats(0.01, 10), st.floats(0, 1))
def test_the_bounds_hold_under_a_perspective(seed, size, strength):
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(12, 3)) * size
    to_eye = np.eye(4) + rng.normal(size=(4, 4)) * [[1], [1], [1], [strength]]
    to_eye[:3, 3] *= 10
    homogeneous = np.append(points, np.ones((12, 1)), 1) @ to_eye.T
    edges, matrix = corners(1, 12), to_eye.T.ravel().tolist()
    extent = Extent.of(points, longest_edge(points, edges))
    bound = extent.largest_angle(matrix)
    if np.ptp(np.sign(homogeneous[:, 3])):
        assert bound == np.pi
        return
    eye = homogeneous[:, :3] * np.sign(homogeneous[0, 3])
    largest = angles(eye, edges)
    assert bound >= largest.max() - 1e-9
    if extent.surely_seen_from(matrix, 0.5 / np.tan(0.1 / 2)):
        assert largest.max() <= 0.1 + 1e-9
    closest = np.arccos((eye[:, 2] / np.linalg.norm(eye, axis=1)).clip(-1, 1)).min()
    assert extent.least_angle_from((0, 0, 1), matrix) <= closest + 1e-6
    bounds = Spheres.of(points[edges]).largest_angles(to_eye)
    assert (bounds >= largest - 1e-9).all()


def test_rounding_of_the_fourth_coordinate_leaves_the_bound_close():
    """As where gluPerspective went to MODELVIEW and is taken out of it again."""
    to_eye = np.eye(4)
    to_eye[3] = 3e-8, -1e-9, 1e-7, 0.99999
    matrix, places = to_eye.T.ravel().tolist(), np.array([[-0.5, 0, -10], [0.5, 0, -10]])
    extent = Extent.of(places, 1.0)
    assert extent.largest_angle(matrix) < 1.1 * 2 * np.arctan(0.05)
    assert extent.surely_seen_from(matrix, 4.0)
    assert Spheres.of(places[None]).largest_angles(to_eye) < 0.12


def test_what_is_far_is_quickly_said():
    extent = Extent.of_few([-0.5, 0, -10, 0.5, 0, -10])
    matrix = np.eye(4).T.ravel().tolist()
    assert extent.surely_seen_from(matrix, 4.0)
    assert not extent.surely_seen_from(matrix, 10.0)
    assert not Extent.unknown().surely_seen_from(matrix, 0.0)


@given(st.integers(0, 100_000), st.sampled_from([1e-3, 1.0, 1e3]))
def test_no_point_is_closer_to_a_direction_than_the_bound(seed, scale):
    random = np.random.default_rng(seed)
    points = (random.normal(size=(12, 3)) * scale + random.normal(size=3) * 10).astype(np.float32)
    to_eye = np.eye(4)
    to_eye[:3] = random.normal(size=(3, 4))
    aft = random.normal(size=3)
    aft /= np.linalg.norm(aft)
    eye = points @ to_eye[:3, :3].T + to_eye[:3, 3]
    closest = np.arccos((eye @ aft / np.linalg.norm(eye, axis=1)).max().clip(-1, 1))
    extent = Extent.of(points, 1.0)
    assert extent.least_angle_from(aft.tolist(), to_eye.T.ravel().tolist()) <= closest + 1e-6


def test_the_bound_from_a_direction_is_close_for_a_small_mesh():
    extent = Extent.of_few([-0.5, 0, -10, 0.5, 0, -10])
    assert extent.least_angle_from((0, 0, 1), np.eye(4).ravel().tolist()) == pytest.approx(np.pi, abs=0.1)


def placed(seed, size, shear):
    """Corners of triangles, (40, 3, 3), and a matrix to eye space."""
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(40, 3, 3)) * size * rng.uniform(0.01, 1, (40, 1, 1))
    to_eye = np.eye(4)
    to_eye[:3, :3] = rng.normal(size=(3, 3))
    to_eye[0, 1] += shear
    to_eye[:3, 3] = rng.normal(size=3) * 10
    return points + rng.normal(size=(40, 1, 3)), to_eye


@given(st.integers(0, 100_000), st.floats(0.01, 100), st.floats(-2, 2))
def test_no_edge_of_a_primitive_subtends_more_than_its_bound(seed, size, shear):
    points, to_eye = placed(seed, size, shear)
    for kind in (points, points[:, :2]):
        bounds = Spheres.of(kind).largest_angles(to_eye)
        eye = kind @ to_eye[:3, :3].T + to_eye[:3, 3]
        largest = [
            angles(corners, np.array([(0, 1), (1, 2), (2, 0)]) % len(corners)).max() for corners in eye
        ]
        assert (bounds >= np.array(largest) - 1e-9).all()


@given(st.integers(0, 100_000), st.floats(0.01, 100), st.floats(-2, 2))
def test_no_corner_of_a_primitive_is_closer_to_a_direction_than_its_bound(seed, size, shear):
    points, to_eye = placed(seed, size, shear)
    aft = points[0, 0] / np.linalg.norm(points[0, 0])
    eye = points @ to_eye[:3, :3].T + to_eye[:3, 3]
    closest = np.arccos((eye @ aft / np.linalg.norm(eye, axis=-1)).clip(-1, 1)).min(1)
    assert (Spheres.of(points).least_angles_from(aft.tolist(), to_eye) <= closest + 1e-6).all()


@given(st.integers(0, 100_000), st.floats(0.001, 0.5), st.floats(0, 60))
def test_what_is_small_enough_is_told_by_blocks(seed, enough, away):
    """6,000 triangles in a row of blocks that lie ever farther away."""
    rng = np.random.default_rng(seed)
    places = np.linspace([0, 0, -away - 1], [20, 0, -away - 500], 6000)[:, None]
    spheres = Spheres.of(places + rng.normal(size=(6000, 3, 3)) * 0.05)
    told, exact = spheres.largest_angles(np.eye(4), enough), spheres.largest_angles(np.eye(4))
    assert (told >= exact - 1e-12).all()
    assert ((told > enough) == (exact > enough)).all()
    assert (told[told != exact] == enough).all()


def test_a_primitive_is_judged_by_its_own_distance():
    spheres = Spheres.of(np.array([[[0.0, 0, -5], [1, 0, -5]], [[0, 0, -500], [1, 0, -500]]]))
    assert spheres.largest_angles(np.eye(4)) == pytest.approx([1 / 4.5, 1 / 499.5], rel=0.01)


def test_primitives_are_bound_by_nothing_without_an_inverse_across_infinity_or_without_a_place():
    spheres = Spheres.of(np.array([[[4.0, 4, 4], [5, 5, 5]]]))
    flat, projective = np.diag([1.0, 1, 0, 1]), np.eye(4)
    projective[3, 2] = -1
    assert spheres.largest_angles(flat) == [np.inf]
    assert spheres.largest_angles(projective) == [np.inf]
    nowhere = Spheres.of(np.array([[[4.0, 4, 4], [np.nan, 5, 5]], [[4, 4, 4], [np.inf, 5, 5]]]))
    assert nowhere.largest_angles(np.eye(4)).tolist() == [np.inf, np.inf]
    assert nowhere.least_angles_from((0, 0, 1), np.eye(4)).tolist() == [0, 0]
