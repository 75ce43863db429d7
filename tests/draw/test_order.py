"""Primitives drawn in different ways keep their order where it shows."""

from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from domeshim.draw.order import alike, order_shows

LEVELS = st.lists(st.sampled_from([0, 0, 0, 0, 1, 2]), max_size=400).map(lambda v: np.array(v, np.int8))


@given(LEVELS)
def test_in_order_every_primitive_is_drawn_once_and_as_finely_as_it_needs(levels):
    stretches = list(alike(levels, ordered=True))
    numbers = np.concatenate([numbers for _, numbers in stretches]) if stretches else np.zeros(0)
    assert numbers.tolist() == list(range(len(levels)))
    for level, chosen in stretches:
        assert level == levels[chosen].max()
    for (_, before), (_, after) in pairwise(stretches):
        assert before[-1] + 1 == after[0]


@given(LEVELS)
def test_out_of_order_each_level_is_one_draw(levels):
    found = dict(alike(levels, ordered=False))
    assert sum(map(len, found.values())) == len(levels)
    for level, numbers in found.items():
        assert numbers.tolist() == np.flatnonzero(levels == level).tolist()


def test_short_primitives_between_near_long_ones_are_drawn_with_them():
    levels = np.zeros(1000, np.int8)
    levels[[10, 30, 500]] = 1, 2, 1
    stretches = [(level, numbers[0], numbers[-1]) for level, numbers in alike(levels, ordered=True)]
    assert stretches == [(0, 0, 9), (2, 10, 30), (0, 31, 499), (1, 500, 500), (0, 501, 999)]


DEPTH_TEST, DEPTH_MASK, DEPTH_FUNC, BLEND, STENCIL_TEST, LOGIC_OP = (
    0x0B71,
    0x0B72,
    0x0B74,
    0x0BE2,
    0x0B90,
    0x0BF2,
)
LESS, EQUAL, ALWAYS = 0x0201, 0x0202, 0x0207


@pytest.mark.parametrize(
    ("change", "shows"),
    [
        ({}, False),
        ({DEPTH_TEST: 0}, True),
        ({DEPTH_MASK: 0}, True),
        ({DEPTH_FUNC: ALWAYS}, True),
        ({DEPTH_FUNC: EQUAL}, True),
        ({BLEND: 1}, True),
        ({STENCIL_TEST: 1}, True),
        ({LOGIC_OP: 1}, True),
    ],
)
def test_order_shows_unless_the_depth_test_decides_alone(change, shows):
    state = {DEPTH_TEST: 1, DEPTH_MASK: 1, DEPTH_FUNC: LESS, **change}
    gl = SimpleNamespace(glIsEnabled=lambda name: state.get(name, 0), integer=lambda name: state[name])
    assert order_shows(gl) == shows
