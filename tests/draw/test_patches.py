"""Modes cut into triangles and lines as GL cuts them."""

import numpy as np
import pytest

from domeshim.draw.patches import (
    LINE_LOOP,
    POLYGON,
    QUAD_STRIP,
    QUADS,
    corners,
    kind_of,
    longest_edge,
    outlines,
)

COUNTS = {
    0: (5, 5),
    1: (5, 2),
    2: (5, 5),
    3: (5, 4),
    4: (7, 2),
    5: (5, 3),
    6: (5, 3),
    7: (9, 4),
    8: (7, 4),
    9: (5, 3),
}


@pytest.mark.parametrize(("mode", "given", "made"), [(m, *c) for m, c in COUNTS.items()])
def test_number_of_primitives(mode, given, made):
    primitives = corners(mode, given)
    assert len(primitives) == made
    assert primitives.shape[1] == {"points": 1, "lines": 2, "triangles": 3}[kind_of(mode)]
    assert primitives.max() < given


@pytest.mark.parametrize("mode", range(10))
def test_too_few_vertices_make_nothing(mode):
    for count in range({0: 1, 1: 2, 2: 2, 3: 2}.get(mode, 3)):
        assert len(corners(mode, count)) == 0


def area(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    (ux, uy), (vx, vy) = (b - a).T, (c - a).T
    return (ux * vy - uy * vx) / 2


@pytest.mark.parametrize("mode", range(4, 10))
def test_triangles_keep_the_winding(mode):
    if mode in (5, 8):  # strips zigzag
        points = np.array([[x, y] for x in range(4) for y in (1, 0)], float)
    elif mode == 7:
        points = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [2, 0], [3, 0], [3, 1], [2, 1]], float)
    else:
        turn = np.linspace(0, 2 * np.pi, 7)[:-1]
        points = np.stack([np.cos(turn), np.sin(turn)], -1)
    assert (area(points, corners(mode, len(points))) > 0).all() or (
        area(points, corners(mode, len(points))) < 0
    ).all()


def test_the_colour_giving_vertex_is_the_last():
    assert set(corners(QUADS, 8)[:, 2]) == {3, 7}
    assert set(corners(QUAD_STRIP, 6)[:, 2]) == {3, 5}
    assert set(corners(POLYGON, 6)[:, 2]) == {0}
    assert corners(LINE_LOOP, 3)[-1].tolist() == [2, 0]


def test_outlines_are_the_polygons_own_edges():
    assert len(outlines(QUADS, 8)) == 8
    assert len(outlines(POLYGON, 6)) == 6
    assert {frozenset(edge) for edge in outlines(QUAD_STRIP, 4).tolist()} == {
        frozenset(e) for e in ((0, 1), (1, 3), (3, 2), (2, 0))
    }


def test_longest_edge():
    points = np.array([[0, 0, 0], [3, 4, 0], [0, 1, 0]], np.float32)
    assert longest_edge(points, corners(4, 3)) == pytest.approx(5)
    assert longest_edge(points, corners(0, 3)) == 0
