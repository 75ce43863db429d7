"""The field's box: on the dome each of its twelve plain lines lies on its great circle."""

from __future__ import annotations

from itertools import product
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import ndimage
from scipy.spatial import cKDTree

from tests.demos.captures import DEMOS, Picture, capture

SIZE = 1024
EYE = np.array((0.13, -0.16, 0.83))
"""The demo's, in the box from -1 to 1."""
CLEAR = 25.0
"""Pixels around the rim and the box's corners that are not looked at: there lines meet."""
Points = NDArray[np.float64]


def on_disc(directions: Points) -> Points:
    """Pixels (n, 2), x and y downwards, of eye-space directions (n, 3)."""
    x, y, z = directions.T
    radius = np.arctan2(np.hypot(x, y), -z) / (np.pi / 2) * SIZE / 2
    theta = np.arctan2(y, x)
    return np.stack([SIZE / 2 + radius * np.cos(theta), SIZE / 2 - radius * np.sin(theta)], -1)


def edges() -> list[Points]:
    """Each edge of the box as pixels, a tenth of a pixel apart or less, where the dome shows it."""
    corners = np.array(list(product((-1.0, 1.0), repeat=3)))
    pairs = [(a, b) for a, b in product(corners, repeat=2) if tuple(a) < tuple(b) and (a != b).sum() == 1]
    assert len(pairs) == 12
    curves = []
    for one, two in pairs:
        share = np.linspace(0.0, 1.0, 40_001)[:, None]
        places = one + share * (two - one) - EYE
        shown = on_disc(places[places[:, 2] < 0.0])
        if len(shown):
            curves.append(shown)
    return curves


def looked_at(points: Points, ends: Points) -> NDArray[np.bool_]:
    """Which points are neither near the rim nor near a corner."""
    inside = np.hypot(*(points - SIZE / 2).T) < SIZE / 2 - CLEAR
    return inside & (cKDTree(ends).query(points)[0] > CLEAR)


def deviations(picture: Picture) -> tuple[Points, Points]:
    """How far the drawn lines are from the true curves, pixels, and how far the curves from what is drawn.

    First: at each place of the curves, how far across it the middle of the light within 8 pixels is; where
    there is no light, 8. Second: of each lit pixel, how far the nearest curve is.
    """
    curves = edges()
    ends = np.concatenate([curve[[0, -1]] for curve in curves])
    light = np.clip(picture.max(-1).astype(float) - 40.0, 0.0, None)  # over the background
    off = []
    for curve in curves:
        length = np.r_[0.0, np.cumsum(np.hypot(*np.diff(curve, axis=0).T))]
        even = np.stack([np.interp(np.arange(0.0, length[-1], 2.0), length, c) for c in curve.T], -1)
        along = np.gradient(even, axis=0)
        across = np.stack([-along[:, 1], along[:, 0]], -1) / np.hypot(*along.T)[:, None]
        even, across = (rows[looked_at(even, ends)] for rows in (even, across))
        steps = np.arange(-8.0, 8.01, 0.25)
        places = even[:, None] + steps[:, None] * across[:, None] - 0.5
        profile = ndimage.map_coordinates(light, places[..., ::-1].transpose(2, 0, 1), order=1)
        total = profile.sum(1)
        middle = (profile * steps).sum(1) / np.maximum(total, 1e-9)
        off.append(np.where(total > 100.0, abs(middle), 8.0))
    lit = np.argwhere(light > 60.0)[:, ::-1] + 0.5
    lit = lit[looked_at(lit, ends)]
    return np.concatenate(off), cKDTree(np.concatenate(curves)).query(lit)[0]


@pytest.fixture
def box(tmp_path: Path):
    """The box alone, by a method."""

    def take(method: str) -> Picture:
        options = ("--size", str(SIZE), "--method", method)
        given = ("abc", "--without", "arrows,lines,text")
        return capture(tmp_path / f"{method}.png", DEMOS / "field.py", *given, options=options)[0]

    return take


def test_the_boxs_edges_are_great_circles(box):
    across, astray = deviations(box("auto"))
    assert len(across) > 900
    assert across.max() < 0.5
    assert astray.max() < 2.5, "half a line's width, and a pixel"


def test_as_published_they_are_not(box):
    across, astray = deviations(box("paper"))
    assert (across > 4.0).mean() > 0.3
    assert astray.max() > 10.0
