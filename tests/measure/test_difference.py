"""The comparison's measures on pictures made by hand, whose difference is known."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import ndimage

from domeshim.measure.difference import difference, same_picture, unwarped
from domeshim.measure.displacement import displacement

SIZE = 192


def blobs(**change) -> np.ndarray:
    """Coloured discs on grey, antialiased; change: shift and scale about the middle, or a disc left out."""
    shift, scale, without = change.get("shift", (0, 0)), change.get("scale", 0.0), change.get("without")
    y, x = np.mgrid[:SIZE, :SIZE] + 0.5 - SIZE / 2
    x, y = (x - shift[0]) / (1 + scale), (y - shift[1]) / (1 + scale)
    picture = np.full((SIZE, SIZE, 3), 60.0)
    middles = [(-60, -50), (40, -60), (0, 0), (-50, 55), (60, 50)]
    colours = [(250, 40, 40), (40, 250, 40), (250, 250, 40), (40, 60, 250), (230, 230, 230)]
    for number, ((cx, cy), colour) in enumerate(zip(middles, colours, strict=True)):
        if number != without:
            cover = np.clip(15 - np.hypot(x - cx, y - cy) + 0.5, 0, 1)[..., None]
            picture = picture * (1 - cover) + np.array(colour) * cover
    return picture.astype(np.uint8)


ALL = np.ones((SIZE, SIZE), bool)


@pytest.mark.parametrize(
    ("shift", "scale"), [((0, 0), 0.0), ((3.5, -2.25), 0.0), ((0.4, 0), 0.01), ((9, 6), 0)]
)
def test_a_known_movement_is_found(shift, scale):
    found = displacement(blobs(), blobs(shift=shift, scale=scale), ALL)
    assert found is not None
    assert found.shift == pytest.approx(shift, abs=0.1)
    assert found.scale == pytest.approx(scale, abs=0.002)
    assert abs(found.turn) < 0.002
    assert found.error < 0.2


def test_a_turn_is_found():
    turned = ndimage.rotate(blobs(), -2.0, axes=(1, 0), reshape=False, order=1, mode="nearest")
    found = displacement(blobs(), turned, ALL)
    assert abs(np.degrees(found.turn)) == pytest.approx(2.0, abs=0.1)


def test_nothing_is_said_of_a_movement_where_nothing_is_to_be_seen():
    assert (
        displacement(np.full((SIZE, SIZE, 3), 9, np.uint8), np.full((SIZE, SIZE, 3), 9, np.uint8), ALL)
        is None
    )


@pytest.mark.parametrize(
    ("change", "verdict"),
    [
        ({}, "alike"),
        ({"shift": (0.3, 0.2)}, "alike"),
        ({"shift": (2, 0)}, "different"),
        ({"scale": 0.015}, "different"),
        ({"without": 2}, "different"),
    ],
)
def test_the_verdict(change, verdict):
    found = difference(blobs(), blobs(**change), ALL)
    assert (found.verdict, bool(found.reason)) == (verdict, verdict == "different")


def test_swapped_colours_differ_and_what_is_not_seen_does_not_count():
    swapped = np.ascontiguousarray(blobs()[..., ::-1])
    assert difference(blobs(), swapped, ALL).verdict == "different"
    spoilt = blobs()
    spoilt[:60] = 255
    assert difference(blobs(), spoilt, ALL).verdict == "different"
    below = ALL.copy()
    below[:70] = False
    found = difference(blobs(), spoilt, below)
    assert found.verdict == "alike"
    assert found.seen == pytest.approx(1 - 70 / SIZE)


def test_two_blank_pictures_are_never_alike():
    blank = np.full((SIZE, SIZE, 3), 7, np.uint8)
    assert difference(blank, blank, ALL).verdict == "undecided"
    assert difference(blank, blank + 90, ALL).verdict == "undecided"
    for pair in ((blank, blobs()), (blobs(), blank)):
        found = difference(*pair, ALL)
        assert found.verdict == "different"
        assert "blank" in found.reason


def test_too_little_in_common_is_undecided():
    corner = np.zeros((SIZE, SIZE), bool)
    corner[:20, :20] = True
    assert difference(blobs(), blobs(), corner).verdict == "undecided"


def test_thin_lines_of_another_width_are_held_loosely_but_must_be_there():
    thin, wide, none = (np.zeros((SIZE, SIZE, 3), np.uint8) for _ in range(3))
    for at in range(20, SIZE - 20, 24):
        thin[at, 20:-20] = wide[at : at + 3, 20:-20] = 255
    found = difference(thin, wide, ALL)
    assert (found.verdict, found.loose) == ("alike", True)
    none[0, 0] = 255
    assert difference(thin, none, ALL).verdict == "different"


def test_a_picture_is_seen_through_its_places():
    y, x = np.mgrid[:SIZE, :SIZE] + 0.5
    places = np.stack([SIZE - x, y], -1).astype(np.float32)
    seen = ALL.copy()
    seen[0] = False
    flat = unwarped(blobs(), places, seen)
    assert (flat[1:] == blobs()[1:, ::-1]).all()
    assert not flat[0].any()


def test_runs_are_the_same_up_to_rounding_and_no_further():
    assert same_picture(blobs(), np.minimum(blobs().astype(int) + 1, 255).astype(np.uint8))
    assert not same_picture(blobs(), np.minimum(blobs().astype(int) + 5, 255).astype(np.uint8))
    assert not same_picture(blobs(), blobs(without=1))
    assert not same_picture(blobs(), blobs()[:-1])
