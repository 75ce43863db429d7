"""Triangles that make parallelograms are found, in their order, whatever mode they were drawn by."""

import numpy as np
import pytest

from domeshim.draw.patches import corners
from domeshim.draw.quads import as_quads, few_as_quads
from domeshim.record.runs import Run

SQUARE = [[0, 0, -1], [1, 0, -1], [1, 1, -1], [0, 1, -1]]
ROOF = [[0, 1, -1], [1, 1, -1], [0.5, 2, -1]]
TRIANGLES, STRIP, FAN, QUADS, QUAD_STRIP, POLYGON = range(4, 10)
BY_INDEX = [
    (QUADS, [0, 1, 2, 3]),
    (POLYGON, [0, 1, 2, 3]),
    (FAN, [0, 1, 2, 3]),
    (STRIP, [0, 1, 3, 2]),
    (QUAD_STRIP, [0, 1, 3, 2]),
]
"""Modes whose two triangles share vertices, and the square's corners in their order."""


def run(positions, **attributes):
    given = {name: np.asarray(values, np.float32) for name, values in attributes.items()}
    return Run(np.asarray(positions, np.float32), given, ())


def stretches(of, triangles, *, flat=False):
    return list(as_quads(of, np.asarray(triangles, np.int64), flat=flat))


def surface(positions, kind, found):
    """The area that the shapes enclose, and which way round."""
    p = np.asarray(positions, float)[found]
    a, b = (
        (p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
        if kind == "triangles"
        else (p[:, 2] - p[:, 0], p[:, 3] - p[:, 1])
    )
    return (np.cross(a, b) / 2).sum(0)


@pytest.mark.parametrize(
    ("mode", "order"), [*BY_INDEX, (TRIANGLES, [0, 1, 2, 0, 2, 3]), (TRIANGLES, [2, 3, 1, 1, 3, 0])]
)
def test_a_square_is_one_quad_by_any_mode(mode, order):
    positions = np.array(SQUARE)[order]
    triangles = corners(mode, len(order))
    ((kind, found),) = stretches(run(positions), triangles)
    assert kind == "quads"
    assert len(found) == 1
    assert surface(positions, kind, found) == pytest.approx(surface(positions, "triangles", triangles))
    middle = positions[triangles[0]].astype(float)
    shared = positions[found[0, [1, 3]]]
    assert all((corner == middle).all(1).any() for corner in shared)  # the way that the triangles share


@pytest.mark.parametrize("mode", [QUADS, QUAD_STRIP, POLYGON])
def test_the_last_corner_gives_the_colour(mode):
    order = [0, 1, 2, 3] if mode != QUAD_STRIP else [0, 1, 3, 2]
    triangles = corners(mode, 4)
    ((_, found),) = stretches(run(np.array(SQUARE)[order]), triangles, flat=True)
    assert found[0, 3] == triangles[0, 2] == triangles[1, 2]


def test_flat_triangles_of_two_colours_stay_two():
    assert stretches(run(SQUARE), corners(FAN, 4), flat=False)[0][0] == "quads"
    assert stretches(run(SQUARE), corners(FAN, 4), flat=True)[0][0] == "triangles"


def test_what_is_no_parallelogram_stays_triangles():
    for corner in ([1, 1.001, -1], [1, 1, -1.001], [np.nan, 1, -1]):
        positions = [*SQUARE[:2], corner, SQUARE[3]]
        ((kind, found),) = stretches(run(positions), corners(QUADS, 4))
        assert kind == "triangles"
        assert len(found) == 2
    homogeneous = np.hstack([SQUARE, [[1], [1], [2], [1]]])
    assert stretches(run(homogeneous), corners(QUADS, 4))[0][0] == "triangles"


def test_triangles_that_meet_in_place_but_not_in_colour_stay_two():
    order = [0, 1, 2, 0, 2, 3]
    colors = np.ones((6, 4))
    positions = np.array(SQUARE)[order]
    assert stretches(run(positions, color=colors), corners(TRIANGLES, 6))[0][0] == "quads"
    colors[3] = 0
    assert stretches(run(positions, color=colors), corners(TRIANGLES, 6))[0][0] == "triangles"


def test_triangles_that_turn_their_backs_on_each_other_stay_two():
    positions = np.array(SQUARE)[[0, 1, 2, 0, 3, 2]]
    assert stretches(run(positions), corners(TRIANGLES, 6))[0][0] == "triangles"


def test_quads_and_triangles_keep_their_order():
    positions = np.array([*SQUARE, *ROOF, *SQUARE, *SQUARE])
    triangles = np.concatenate([corners(QUADS, 4), [[4, 5, 6]], corners(QUADS, 8) + 7])
    found = stretches(run(positions), triangles)
    assert [(kind, len(shapes)) for kind, shapes in found] == [("quads", 1), ("triangles", 1), ("quads", 2)]
    assert [shapes.min() for _, shapes in found] == [0, 4, 7]


def test_a_strip_is_paired_from_its_start():
    positions = [[k, y, -1] for k in range(5) for y in (1, 0)]
    ((kind, found),) = stretches(run(positions), corners(QUAD_STRIP, 10))
    assert kind == "quads"
    assert len(found) == 4
    assert (np.ptp(np.array(positions)[found], axis=1) == [1, 1, 0]).all()  # upright squares, none leaning


def test_many_turns_are_not_worth_it():
    positions = np.tile([*SQUARE, *ROOF], (9, 1))
    one = np.concatenate([corners(QUADS, 4), [[4, 5, 6]]])
    triangles = np.concatenate([one + 7 * k for k in range(9)])
    ((kind, found),) = stretches(run(positions), triangles)
    assert kind == "triangles"
    assert (found == triangles).all()


@pytest.mark.parametrize(("mode", "order"), BY_INDEX)
def test_a_few_vertices_are_judged_alike(mode, order):
    square = np.array(SQUARE)[order]
    ((_, want),) = stretches(run(square), corners(mode, 4))
    positions = [9.0, 9.0, 9.0, *square.ravel().tolist()]
    assert few_as_quads(mode, positions, 1, 4, flat=False) == tuple(want[0])
    positions[-1] += 1e-3
    assert few_as_quads(mode, positions, 1, 4, flat=False) is None


def test_a_few_vertices_of_which_one_triangle_is_left_over_are_none():
    positions = np.array([*SQUARE, [2, 2, -1]], float).ravel().tolist()
    assert few_as_quads(STRIP, positions, 0, 5, flat=False) is None
    assert few_as_quads(FAN, positions[:12], 0, 4, flat=True) is None
    assert few_as_quads(QUADS, [], 0, 0, flat=False) is None
