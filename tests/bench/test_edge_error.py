"""The judge of edges knows by how much a line is off, whatever its width."""

from __future__ import annotations

import numpy as np
import pytest

from domeshim.bench.edge_error import TrueEdge, summary, telling
from domeshim.lens.models import lens_of

SIZE = 512
LENS = lens_of("equidistant", (), 180.0)
EDGE = np.array([[-50.0, 3.0, -2.0], [50.0, 3.0, -2.0]])


def picture(curve: TrueEdge, off: float, width: int = 1) -> np.ndarray:
    """The curve as ink, shifted across itself by so many pixels."""
    ink = np.zeros((SIZE, SIZE), np.uint8)
    for place in curve.places:
        x, y = (place + 1) * SIZE / 2
        for step in range(width):
            across = off + step - (width - 1) / 2
            normal = curve.normals[len(curve.places) // 2]
            column, row = int(x + across * normal[0]), int(SIZE - (y + across * normal[1]))
            ink[min(row, SIZE - 1), min(column, SIZE - 1)] = 255
    return ink


@pytest.fixture
def curve() -> TrueEdge:
    found = TrueEdge.of(EDGE, LENS, SIZE)
    assert found is not None
    return found


@pytest.mark.parametrize("width", [1, 4])
@pytest.mark.parametrize("off", [0.0, 3.0])
def test_a_line_is_off_by_what_it_was_moved(curve, off, width):
    error = summary([curve.deviations(picture(curve, off, width))], SIZE)
    assert error.mean <= off + 0.5
    assert error.largest >= off - 0.7
    assert error.largest <= off + 1.0


def test_a_line_that_is_not_there_is_lost(curve):
    error = summary([curve.deviations(np.zeros((SIZE, SIZE), np.uint8))], SIZE)
    assert error.lost == 1
    assert error.mean == np.inf


def test_half_a_line_is_half_lost(curve):
    ink = picture(curve, 0.0)
    ink[:, : SIZE // 2] = 0
    assert summary([curve.deviations(ink)], SIZE).lost == pytest.approx(0.5, abs=0.02)


def test_the_widest_edges_are_among_those_judged():
    short = np.array([[0.0, 0.0, -5.0], [0.5, 0.0, -5.0]])
    edges = np.concatenate([np.repeat(short[None], 40, 0), EDGE[None]])
    judged = telling(edges, LENS, SIZE, 4)
    assert len(judged) == 4
    assert any((edge == EDGE).all() for edge, _ in judged)


def test_an_edge_behind_the_viewer_is_not_judged():
    assert TrueEdge.of(EDGE * [1, 1, -1], LENS, SIZE) is None
