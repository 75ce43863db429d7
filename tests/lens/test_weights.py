"""The split evenly in angle: symmetric, monotone, exact at its ends, and even to a millionth of a radian."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from domeshim.draw.split import Limit, split_wide
from domeshim.lens.weights import line_weights, triangle_weights
from domeshim.record.runs import Run

angles = st.floats(1e-6, 3.1)
distances = st.floats(1e-12, 1e12)
seeds = st.integers(0, 1_000_000)


def cut(angle, r0, r1, shares):
    """The weights of the second end at rising shares of a line."""
    s = np.stack([1 - shares, shares], -1)
    n = len(shares)
    return line_weights(s, np.full(n, angle), np.tile([[r0, r1]], (n, 1)))


def between(a, b):
    return np.arctan2(np.linalg.norm(np.cross(a, b), axis=-1), (a * b).sum(-1))


@given(angles, distances, distances, seeds)
def test_symmetric(angle, r0, r1, seed):
    shares = np.random.default_rng(seed).uniform(size=50)
    shares = np.append(shares, [0.25, 0.5])
    one, other = cut(angle, r0, r1, shares), cut(angle, r1, r0, 1 - shares)
    assert np.abs(one - other[:, ::-1]).max() < 1e-12
    assert (one[-2:] == other[-2:, ::-1]).all()  # what is exact in binary is so to the bit


@given(angles, distances, distances)
def test_monotone_and_exact_at_the_ends(angle, r0, r1):
    weights = cut(angle, r0, r1, np.linspace(0, 1, 65))
    assert (weights[0] == [1, 0]).all()
    assert (weights[-1] == [0, 1]).all()
    rising = np.diff(weights, axis=0) * [-1, 1]
    assert rising.min() >= -np.finfo(float).eps  # next to 1 each is rounded for itself


@given(angles, st.floats(1e-4, 1e4), st.floats(1e-4, 1e4), seeds)
def test_even_in_angle(angle, r0, r1, seed):
    rng = np.random.default_rng(seed)
    u = rng.normal(size=3)
    v = np.cross(u, rng.normal(size=3))
    u, v = u / np.linalg.norm(u), v / np.linalg.norm(v)
    ends = np.stack([r0 * u, r1 * (u * np.cos(angle) + v * np.sin(angle))])
    shares = np.linspace(0, 1, 33)
    points = cut(angle, r0, r1, shares) @ ends
    assert np.abs(between(points, u) - shares * angle).max() < 1e-6


@given(seeds)
def test_a_triangles_edges_are_cut_as_lines(seed):
    rng = np.random.default_rng(seed)
    of_edges, of_corners = rng.uniform(1e-4, 1.75, 3), 10 ** rng.uniform(-6, 6, 3)
    shares = np.linspace(0, 1, 17)
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        s = np.zeros((17, 3))
        s[:, i], s[:, j] = 1 - shares, shares
        got = triangle_weights(s, np.tile(of_edges, (17, 1)), np.tile(of_corners, (17, 1)))
        assert np.abs(got[:, [i, j]] - cut(of_edges[k], of_corners[i], of_corners[j], shares)).max() < 1e-12
        assert (got[:, k] == 0).all()


@given(seeds)
def test_a_triangles_weights_are_a_point_of_it(seed):
    rng = np.random.default_rng(seed)
    shares = rng.dirichlet([0.5, 0.5, 0.5], 50)
    got = triangle_weights(shares, rng.uniform(1e-6, 1.75, (50, 3)), 10 ** rng.uniform(-9, 9, (50, 3)))
    assert (got >= 0).all()
    assert np.abs(got.sum(1) - 1).max() < 1e-12


@given(seeds)
def test_halving_cuts_an_edge_in_the_middle_of_its_angle_from_either_side(seed):
    rng = np.random.default_rng(seed)
    a, b = (rng.normal(size=(2, 3)) * 10 ** rng.uniform(-3, 3, (2, 1))).astype(np.float32)
    angle = float(between(a.astype(float), b.astype(float)))

    def halves(*ends):
        return split_wide(Run(np.stack(ends), {}, ()), 2, np.eye(4), Limit(angle * 0.75)).attributes

    one, other = halves(a, b), halves(b, a)
    middle = one["place"][1, :3].astype(float)
    assert (one["place"][1] == other["place"][1]).all()
    assert (one["weights"][1, :2] == other["weights"][1, 1::-1]).all()
    assert abs(between(a.astype(float), middle) - angle / 2) < 1e-6
    assert abs(between(middle, b.astype(float)) - angle / 2) < 1e-6
