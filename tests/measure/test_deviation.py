"""What is drawn beside what is true: pieces made by hand, each with a known error."""

import numpy as np
import pytest

from domeshim.lens.models import Equidistant
from domeshim.lens.orientation import STRAIGHT
from domeshim.lens.projection import disc_of
from domeshim.measure.deviation import Sight, deviation
from domeshim.measure.feedback import Caught

SIGHT = Sight(Equidistant(180.0), 180.0, STRAIGHT, (1.0, -2e-3))
NOTHING = np.zeros((0, 2, 4))
EDGE = np.array([[-3.0, 1, -1, 1], [3, 1, -1, 1]])
TRIANGLE = np.array([[-1.0, -1, -2, 1], [1, -1, -2, 1], [0, 1, -2, 1]])


def caught(points, keep=1.0):
    """Pieces whose corners are bent without error; points: (n, corners, 4)."""
    r = np.linalg.norm(points[..., :3], axis=-1)
    disc = disc_of(points[..., :3], SIGHT.lens)
    positions = np.stack([disc[..., 0] * r, disc[..., 1] * r, 0.5 * r, r], -1)
    return [Caught(positions.astype(np.float32), np.full(r.shape, keep, np.float32))]


def pieces(count):
    directions = EDGE[:, :3] / np.linalg.norm(EDGE[:, :3], axis=1, keepdims=True)
    angle = np.arccos(directions[0] @ directions[1])
    s = np.linspace(0, 1, count + 1)[:, None]
    cut = np.sin((1 - s) * angle) * directions[0] + np.sin(s * angle) * directions[1]
    cut = np.column_stack([cut, np.ones(count + 1)])
    return np.stack([cut[:-1], cut[1:]], 1)


def outline(triangle):
    return np.stack([triangle, np.roll(triangle, -1, 0)], 1)


def test_a_line_in_many_pieces_is_where_it_should_be():
    edges, inside = deviation(caught(pieces(500)), EDGE[None], NOTHING, SIGHT)
    assert edges < 1e-5
    assert inside == 0


def test_a_short_edge_where_a_long_one_ends_hides_nothing_of_it():
    short = np.array([EDGE[1], EDGE[1] + [0, 1e-5, 0, 0]])
    drawn = np.concatenate([pieces(500), short[None]])
    assert deviation(caught(drawn), np.array([EDGE, short]), NOTHING, SIGHT).edges < 1e-5


@pytest.mark.parametrize("count", [4, 8, 16])
def test_the_chord_error_of_a_line_is_as_the_formula_says(count):
    angle = np.arccos(EDGE[0, :3] @ EDGE[1, :3] / (EDGE[0, :3] @ EDGE[0, :3]))
    edges = deviation(caught(pieces(count)), EDGE[None], NOTHING, SIGHT).edges
    assert 0.3 < edges / ((angle / count) ** 2 / 8) <= 1.02


def test_a_missing_piece_counts():
    whole = pieces(100)
    edges = deviation(caught(np.delete(whole, slice(45, 55), 0)), EDGE[None], NOTHING, SIGHT).edges
    ends = disc_of(np.array([whole[45, 0, :3], whole[54, 1, :3]]), SIGHT.lens)
    assert edges == pytest.approx(np.linalg.norm(ends[0] - ends[1]) / 2, rel=0.02)


def test_what_is_clipped_is_missing():
    edges = deviation(caught(pieces(100), keep=-1.0), EDGE[None], NOTHING, SIGHT).edges
    assert edges == np.inf


def test_a_line_that_should_not_be_there_counts_unless_it_is_allowed():
    alone = caught(pieces(100))
    assert deviation(alone, NOTHING, NOTHING, SIGHT).edges > 0.2
    assert deviation(alone, NOTHING, EDGE[None], SIGHT).edges < 1e-3
    assert deviation([], NOTHING, EDGE[None], SIGHT).edges == 0


def test_a_surface_bends_at_its_edges_and_inside():
    edges, inside = deviation(caught(TRIANGLE[None]), outline(TRIANGLE), NOTHING, SIGHT)
    assert edges > 0.01
    assert inside > 0.99 * edges


def test_a_tear_inside_a_surface_counts():
    middle = TRIANGLE.mean(0)
    parts = np.array([[a, b, middle] for a, b in outline(TRIANGLE)])
    whole = deviation(caught(parts), outline(TRIANGLE), NOTHING, SIGHT).edges
    parts[0, 2] += [1e-6, 0, 0, 0]
    torn = deviation(caught(parts), outline(TRIANGLE), NOTHING, SIGHT).edges
    assert torn > 3 * whole


def test_a_surface_cut_short_of_the_rim_counts():
    [part] = caught(TRIANGLE[None])
    cut = Caught(part.positions, np.array([[1, 1, -1]], np.float32))
    assert deviation([cut], outline(TRIANGLE), NOTHING, SIGHT).edges > 0.5


def test_what_has_no_finite_place_is_not_drawn():
    broken = caught(pieces(100))[0]
    positions = np.concatenate([broken.positions, np.full((1, 2, 4), np.nan, np.float32)])
    distances = np.concatenate([broken.distances, np.ones((1, 2), np.float32)])
    assert deviation([Caught(positions, distances)], EDGE[None], NOTHING, SIGHT).edges < 1e-3
