"""Primitives of a mesh that are drawn in different ways: which go together, and which after which."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from domeshim.driver import Driver

_DEPTH_TEST, _DEPTH_WRITEMASK, _DEPTH_FUNC = 0x0B71, 0x0B72, 0x0B74
_NEAREST_OR_FARTHEST = (0x0201, 0x0203, 0x0204, 0x0206)  # GL_LESS, GL_LEQUAL, GL_GREATER, GL_GEQUAL
_BLEND, _STENCIL_TEST, _COLOR_LOGIC_OP, _INDEX_LOGIC_OP = 0x0BE2, 0x0B90, 0x0BF2, 0x0BF1
_GAP = 64
"""Up to so many primitives between two that need more are drawn as those are: a change costs as much."""

Numbers = NDArray[np.intp]


def order_shows(driver: Driver) -> bool:
    """Whether it shows in which order the primitives of a mesh are drawn.

    It does not where the depth test decides alone: what is nearest is seen, whenever it was drawn. Places of
    the same depth are left, where surfaces of a mesh coincide; pieces of one and the other whole have not
    the same depth all over in any order.
    """
    gl = driver
    if any(gl.glIsEnabled(test) for test in (_BLEND, _STENCIL_TEST, _COLOR_LOGIC_OP, _INDEX_LOGIC_OP)):
        return True
    if not gl.glIsEnabled(_DEPTH_TEST) or not gl.integer(_DEPTH_WRITEMASK):
        return True
    return gl.integer(_DEPTH_FUNC) not in _NEAREST_OR_FARTHEST


def alike(levels: NDArray[np.int8], *, ordered: bool) -> Iterator[tuple[int, Numbers]]:
    """The primitives of each level, one level after the other; ordered: in stretches that keep their order.

    A stretch has the highest level of its primitives.
    """
    if not ordered:
        for level in range(levels.max(initial=-1) + 1):
            numbers = np.flatnonzero(levels == level)
            if len(numbers):
                yield level, numbers
        return
    raised = np.flatnonzero(levels)
    breaks = np.flatnonzero(np.diff(raised) > _GAP) + 1
    done = 0
    for stretch in np.split(raised, breaks) if len(raised) else []:
        first, end = int(stretch[0]), int(stretch[-1]) + 1
        if first > done:
            yield 0, np.arange(done, first)
        yield int(levels[first:end].max()), np.arange(first, end)
        done = end
    if done < len(levels):
        yield 0, np.arange(done, len(levels))
