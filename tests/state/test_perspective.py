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
