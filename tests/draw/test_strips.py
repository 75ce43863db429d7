"""Lines become strips of pieces even in angle: what was joined stays joined."""

import numpy as np
import pytest

from domeshim.draw.patches import LINE_LOOP, LINE_STRIP, LINES, QUADS, corners, outlines
from domeshim.draw.split import Limit
from domeshim.draw.strips import line_strips
from domeshim.record.runs import Run

WIDEST = 0.1
RNG = np.random.default_rng(4)


def cut(points, lines, *, flat=False, **attributes):
    named = {name: np.asarray(values, np.float32) for name, values in attributes.items()}
    run = Run(np.asarray(points, np.float32), named, ())
    return line_strips(run, lines, np.eye(4), Limit(WIDEST), flat=flat)


def steps(run):
    """The angle of every step within each strip, strip by strip."""
    for block in run.blocks:
        d = run.positions[block.first : block.end, :3].astype(float)
        d /= np.linalg.norm(d, axis=1, keepdims=True)
        yield np.arctan2(np.linalg.norm(np.cross(d[:-1], d[1:]), axis=1), (d[:-1] * d[1:]).sum(1))


@pytest.mark.parametrize(
    ("lines", "strips"),
    [
        (corners(LINES, 8), 4),
        (corners(LINE_STRIP, 8), 1),
        (corners(LINE_LOOP, 8), 1),
        (outlines(QUADS, 8), 2),
    ],
    ids=["lines", "strip", "loop", "outlined quads"],
)
def test_what_is_joined_is_one_strip_of_narrow_pieces(lines, strips):
    run = cut(RNG.normal(size=(8, 3)) - np.array([0, 0, 3]), lines)
    assert len(run.blocks) == strips
    assert [block.first for block in run.blocks[1:]] == [block.end for block in run.blocks[:-1]]
    assert run.blocks[-1].end == len(run.positions)
    assert max(angles.max() for angles in steps(run)) <= WIDEST + 1e-6


def test_a_line_is_cut_evenly_between_its_own_ends():
    ends = [[-50, 3, -2], [50, 3, -2]]
    run = cut(ends, corners(LINES, 2), color=[[0, 0, 0, 1], [1, 1, 1, 1]])
    assert run.positions[[0, -1], :3].tolist() == ends
    (angles,) = steps(run)
    assert np.ptp(angles) < 1e-5
    assert run.attributes["color"][:, 0] == pytest.approx(run.positions[:, 0] / 100 + 0.5, abs=1e-5)


def test_flat_lines_have_their_second_ends_colour():
    run = cut([[-5, 0, -2], [5, 0, -2], [5, 5, -2]], corners(LINE_STRIP, 3), flat=True, color=np.eye(4)[:3])
    assert set(np.argmax(run.attributes["color"][1:], 1)) == {1, 2}
    assert set(run.attributes["color"].ravel().tolist()) == {0, 1}


def test_lines_without_a_finite_place_are_left_out():
    run = cut([[0, 0, -1], [np.nan, 0, -1], [1, 0, -1], [1, 1, -1]], corners(LINE_STRIP, 4))
    assert len(run.blocks) == 1
    assert np.isfinite(run.positions).all()
    assert len(cut([[np.inf, 0, 0], [1, 0, 0]], corners(LINES, 2)).blocks) == 0


def test_a_line_through_the_eye_or_of_no_length_is_harmless():
    points = [[0, 0, -1], [0, 0, 1], [1, 1, -1], [1, 1, -1], [0, 0, 0], [1, 0, -1]]
    run = cut(points, corners(LINES, 6))
    assert np.isfinite(run.positions).all()
    assert len(run.blocks) == 3
