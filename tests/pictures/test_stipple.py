"""A stipple pattern is counted along the whole line or strip, however many pieces it is drawn in."""

import numpy as np
import pytest

from tests.pictures.test_subdivision import immediately, listed, perspective

SIZE = 512
DASH = 24
"""Pixels that are on, and then off, by the pattern of dashes()."""
SLACK = 2
"""GL itself may be off by one pixel at each joint of a strip, and a dash spans one or two."""
LINE = [(-40, 0.5, -3), (40, 0.5, -3)]
"""Over the middle of the picture it goes on by columns everywhere."""


def dashes(gl):
    perspective(gl)
    gl.glEnable(gl.GL_LINE_STIPPLE)
    gl.glLineStipple(3, 0x00FF)


def runs(picture):
    """(m, 2): for each stretch of columns that are alike, whether they are on and how many there are."""
    on = (picture.max(-1) > 128).any(0)
    starts = np.flatnonzero(np.diff(on, prepend=~on[0]))
    return [(bool(on[a]), b - a) for a, b in zip(starts, [*starts[1:], len(on)], strict=True)]


@pytest.mark.parametrize("method", ["auto", "tessellate", "geometry", "cpu"])
@pytest.mark.parametrize("way", [immediately, listed])
@pytest.mark.parametrize("shape", ["one line", "a strip"])
def test_the_pattern_runs_on(beside, shape, way, method):
    def scene(gl):
        dashes(gl)
        between = [] if shape == "one line" else [(x, 0.5, -3) for x in (-9, -2.5, 0.3, 7)]
        way(gl, gl.GL_LINE_STRIP if between else gl.GL_LINES, [LINE[0], *between, LINE[1]])

    found = runs(beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method=method).picture)
    whole = found[1:-2]  # it begins with its first column and ends where it ends
    assert len(whole) > 15
    assert whole[0][0]
    assert all(abs(length - DASH) <= SLACK for _, length in whole)


def test_each_line_begins_the_pattern_anew(beside):
    def scene(gl):
        dashes(gl)
        gl.glLineStipple(3, 0x0FFF)  # 36 on, 12 off
        immediately(gl, gl.GL_LINES, [(-9, 0.5, -3), (-1, 0.5, -3), (1, 0.5, -3), (40, 0.5, -3)])

    found = runs(beside.through_dome(scene, (SIZE, SIZE), fov=180.0).picture)
    middle = next(k for k, (on, length) in enumerate(found) if not on and length > 60)
    for on, length in (found[1], found[middle + 1]):
        assert on
        assert abs(length - 36) <= SLACK
