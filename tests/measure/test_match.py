"""The measure of two pictures: what it forgives, and what it does not."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from domeshim.measure.match import INNER, Match, match, match_discs

SIZE = 128
Picture = NDArray[np.uint8]


def square(left: int = 40, top: int = 40, side: int = 40, colour: tuple[int, ...] = (200, 120, 0)) -> Picture:
    picture = np.full((SIZE, SIZE, 3), 20, np.uint8)
    picture[top : top + side, left : left + side] = colour
    return picture


def test_a_picture_matches_itself_and_counts_what_it_shows():
    found = match(square(), square())
    assert (found.wrong, found.share) == (0, 0.0)
    # The blur spreads the square by a pixel or two each way.
    assert 40**2 <= found.content <= 46**2


@pytest.mark.parametrize(("shift", "right"), [(1, True), (2, True), (6, False)])
@pytest.mark.parametrize("axis", [0, 1])
def test_a_shift_of_two_pixels_is_forgiven_and_one_of_six_is_not(shift, right, axis):
    found = match(square(), np.roll(square(), shift, axis=axis))
    assert (found.wrong == 0) == right


def test_a_shift_spoils_the_edges_alone():
    # Strips six pixels wide at both ends of a square 40 pixels high, give or take the blur.
    assert 2 * 4 * 38 < match(square(), square(left=46)).wrong < 2 * 8 * 46


@pytest.mark.parametrize(("difference", "right"), [(25, True), (35, False)])
def test_a_channel_may_differ_by_the_tolerance(difference, right):
    found = match(square(), square(colour=(200, 120, difference)))
    assert (found.wrong == 0) == right


def test_something_that_one_picture_lacks_is_wrong_whichever_it_is():
    nothing = square(side=0)
    for found in (match(nothing, square()), match(square(), nothing)):
        assert found.wrong > 0.9 * found.content
        assert found.share == found.wrong / found.content


def test_two_empty_pictures_match():
    assert match(square(side=0), square(side=0)) == Match(content=0, wrong=0)
    assert match(square(side=0), square(side=0)).share == 0


def test_single_pixels_are_evened_out():
    picture = square(side=0)
    speckled = picture.copy()
    speckled[60, 60] = 255
    assert match(picture, speckled).wrong == 0


def test_only_the_mask_counts():
    left = np.zeros((SIZE, SIZE), bool)
    left[:, :30] = True
    assert match(square(), square(side=0), left) == Match(0, 0)
    assert match(square(), square(side=0), np.zeros_like(left)) == Match(0, 0)


def test_discs_are_compared_short_of_the_rim():
    nothing = square(side=0)
    outside = square(left=1, top=1, side=10)
    assert match_discs(nothing, outside).content == 0
    inside = SIZE // 2 - 4
    wholly = match_discs(nothing, square(left=inside, top=0, side=20))
    assert 0 < wholly.wrong < match(nothing, square(left=inside, top=0, side=20)).wrong
    full = match_discs(nothing, square(left=0, top=0, side=SIZE))
    assert full.content == pytest.approx(np.pi * (INNER * SIZE / 2) ** 2, rel=0.01)


def test_pictures_of_other_shapes_are_refused():
    with pytest.raises(ValueError, match="differ in shape"):
        match(square(), square()[:-1])
