"""Perspective matrices: as GLU makes them, found again inside products, and read."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from domeshim.state.perspective import (
    depth_range,
    frustum,
    is_perspective,
    perspective,
    perspective_part,
    perspective_within,
    planar,
)


def rigid(seed):
    rng = np.random.default_rng(seed)
    turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    m = np.eye(4)
    m[:3, :3] = turn * np.sign(np.linalg.det(turn))
    m[:3, 3] = rng.normal(size=3) * 10
    return m


def test_perspective_is_a_symmetric_frustum():
    top = np.tan(np.radians(30)) * 0.5
    assert perspective(60, 2, 0.5, 50) == pytest.approx(frustum(-2 * top, 2 * top, -top, top, 0.5, 50))


@pytest.mark.parametrize("wrong", [(0, 1, 1, 2), (45, 0, 1, 2), (45, 1, 3, 3)])
def test_perspective_that_glu_ignores_is_none(wrong):
    assert perspective(*wrong) is None


def test_frustum_that_gl_refuses_is_none():
    assert frustum(-1, 1, -1, 1, 0, 10) is None
    assert frustum(1, 1, -1, 1, 1, 10) is None


@given(st.integers(0, 10_000), st.floats(5, 170), st.floats(0.3, 3), st.floats(-0.5, 0.5))
def test_perspective_part_is_found_behind_any_rigid_motion(seed, fovy, aspect, shift):
    p = perspective(fovy, aspect, 0.1, 100)
    p[0, 2] = shift
    assert perspective_part(p @ rigid(seed)) == pytest.approx(p, rel=1e-6, abs=1e-6)


def test_orthographic_and_identity_are_no_perspective():
    assert not is_perspective(np.eye(4))
    assert not is_perspective(np.diag([0.1, 0.1, -1, 1]))
    assert is_perspective(perspective(45, 1, 0.1, 100))


@pytest.mark.parametrize(("near", "far"), [(0.1, 100), (1e-3, 1e4), (1, 1.5)])
def test_depth_range_reads_near_and_far(near, far):
    found = depth_range(perspective(45, 1, near, far))
    assert (found.near, found.far) == pytest.approx((near, far), rel=1e-6)
    a, b = found.uniform
    assert (a * near + b) / near == pytest.approx(-1)


def test_depth_range_of_senseless_planes_is_still_a_range():
    for p in (perspective(45, 1, 0, 100), perspective(45, 1, -1, 100)):
        found = depth_range(p)
        assert 0 < found.near < found.far < np.inf


def test_without_a_far_plane_everything_beyond_the_near_one_is_seen():
    infinite = perspective(45, 1, 0.1, 100)
    infinite[2, 2], infinite[2, 3] = -1, -0.2
    found = depth_range(infinite)
    assert (found.near, found.far) == (0.1, np.inf)
    a, b = found.uniform
    assert (a * 0.1 + b) / 0.1 == pytest.approx(-1)
    assert a + b / 1e30 <= 1
    a, b = planar(found.uniform)
    assert a + b / 1e30 <= 1
    assert (a * 0.1 / np.sqrt(3) + b) / (0.1 / np.sqrt(3)) == pytest.approx(-1)


def in_float32(m):
    return m.astype(np.float32).astype(float)


def stretched(x, y, z):
    return np.diag([x, y, z, 1.0])


SCALES = st.floats(0.05, 20)


@given(st.integers(0, 10_000), st.floats(20, 140), st.floats(0.5, 2), SCALES, SCALES, SCALES)
def test_a_stretched_mesh_is_seen_by_the_same_perspective(seed, fovy, aspect, x, y, z):
    p = perspective(fovy, aspect, 0.1, 100)
    found = perspective_within(in_float32(p @ rigid(seed) @ stretched(x, y, z)), aspect)
    assert found[[0, 1, 3]] == pytest.approx(p[[0, 1, 3]], rel=2e-2, abs=2e-2)


@given(st.integers(0, 10_000), st.floats(20, 140), st.floats(0.5, 2), SCALES, st.sampled_from([-1, 1]))
def test_a_mesh_of_one_scale_may_be_mirrored(seed, fovy, aspect, scale, side):
    p = perspective(fovy, aspect, 0.1, 100)
    found = perspective_within(in_float32(p @ rigid(seed) @ stretched(side * scale, scale, scale)), aspect)
    assert found[[0, 1, 3]] == pytest.approx(p[[0, 1, 3]], rel=1e-3, abs=1e-3)


@given(st.integers(0, 10_000), st.floats(0.2, 0.5), st.floats(-0.5, 0.5))
def test_a_perspective_to_one_side_is_found_where_pixels_are_square(seed, right, up):
    p = frustum(-1, 1, -1, 1, 2, 50)
    p[0, 2], p[1, 2] = right, up
    assert perspective_within(in_float32(p @ rigid(seed)), 1.0) == pytest.approx(p, rel=1e-3, abs=1e-3)


def test_what_no_turn_tells_apart_is_told_by_a_known_perspective():
    p = perspective(60, 1.5, 0.1, 100)
    slab = p @ stretched(50, 0.1, 50)
    assert perspective_within(slab, 1.5, [p]) is p
    assert perspective_within(slab, 1.5, [perspective(60, 1.5, 0.1, 400), p]) is p


def test_a_known_perspective_does_not_outlive_the_windows_shape():
    before, after = perspective(60, 1.0, 0.1, 100), perspective(60, 1.5, 0.1, 100)
    shifted = np.eye(4)
    shifted[:3, 3] = 1, 2, -9
    assert perspective_within(after @ shifted, 1.5, [before]) == pytest.approx(after)


def test_a_perspective_that_heeds_no_shape_is_found_behind_one_scale():
    p = perspective(60, 1.0, 0.1, 100)
    assert perspective_within(p @ rigid(3) @ stretched(2, 2, 2), 1.5) == pytest.approx(p)


@pytest.mark.parametrize("m", [np.eye(4), np.zeros((4, 4)), np.diag([1.0, 1.0, 0.0, 1.0])])
def test_no_perspective_is_within_what_has_none(m):
    assert perspective_within(m, 1.0) is None


def test_what_ends_in_a_texture_is_no_pictures_perspective():
    into_texture = np.array([[0.5, 0, 0, 0.5], [0, 0.5, 0, 0.5], [0, 0, 0.5, 0.5], [0, 0, 0, 1]])
    assert perspective_within(into_texture @ perspective(45, 1.0, 1, 50) @ rigid(5), 1.0) is None
