"""What the program draws by a vertex shader of its own, as patches, which the GPU subdivides.

Where a vertex lands is known to that shader alone. So each primitive goes to the GPU as often as it may have
parts that are halved off it (glsl/own/halves.glsl), and there each of them finds what it is, if anything.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.patches import POINTS, POLYGON, Indices, Kind
from domeshim.draw.primitives import primitives_in
from domeshim.draw.subdivide import loses_smooth_lines, shown_polygon_mode, stippled
from domeshim.driver import Driver
from domeshim.record.runs import Block
from domeshim.shading.recipe import Patch

if TYPE_CHECKING:
    from domeshim.draw.extent import Extent
    from domeshim.shading.program import Uniforms
    from domeshim.state.context import DomeContext

_LINE_SMOOTH = 0x0B20
_NOT_SMOOTHED = (
    "this driver cannot smooth long lines of the program's own GLSL: they are drawn without GL_LINE_SMOOTH"
)
_MOST = 4096
"""A draw of more primitives stays as it is: a mesh so dense seldom has a long edge."""

ByNumber = Callable[[int, NDArray[np.uint32]], object]
"""Draws vertices by a mode and their numbers."""


class Parts(NamedTuple):
    """What the program's own shader is to draw."""

    primitives: Sequence[tuple[Kind, Indices]]
    """Neighbours of one kind together: what they are, and their vertices."""
    halvings: int
    """So often the widest edge of each may have to be halved."""


def own_parts(
    context: DomeContext, blocks: Sequence[Block], extent: Callable[[], Extent | None]
) -> Parts | None:
    """What blocks consist of, to be drawn subdivided by the program's own bound shader.

    None where they are to be drawn whole: where that cannot be done, or surely no edge needs it. extent:
    tells how large they are where the fixed pipeline would put them, or None.
    """
    if context.own.current is None or not context.subdividing.subdivides_own:
        return None
    parts = _edged(context, blocks)
    halvings = None if parts is None else context.subdividing.own_halvings(extent())
    if parts is None or halvings is None:
        return None
    can = all(kind == "points" or context.own.subdividing(kind) for kind, _ in parts)
    return Parts(parts, halvings) if can else None


def _edged(context: DomeContext, blocks: Sequence[Block]) -> Sequence[tuple[Kind, Indices]] | None:
    """The primitives of blocks; None where they have no edges, or cannot be patches, or are too many."""
    polygon_mode = shown_polygon_mode(context)
    vertices = sum(block.end - block.first for block in blocks)
    if polygon_mode is None or vertices > 3 * _MOST or any(block.mode > POLYGON for block in blocks):
        return None
    parts = list(primitives_in(tuple(blocks), polygon_mode))
    kinds = {kind for kind, _ in parts}
    if not kinds - {"points"} or sum(len(indices) for _, indices in parts) > _MOST:
        return None
    return None if "lines" in kinds and stippled(context) else parts  # a line's pattern goes on with the next


def draw_parts(context: DomeContext, parts: Parts, by_number: ByNumber) -> None:
    """Draw them in pieces."""
    for kind, indices in parts.primitives:
        numbers = indices.astype(np.uint32)
        if kind == "points":
            context.draw(partial(by_number, POINTS, numbers.ravel()))
            continue
        program, patch = context.own.subdividing(kind), Patch(kind)
        assert program is not None
        halvings = min(parts.halvings, (_MOST // len(indices)).bit_length() - 1)
        copies = np.repeat(numbers, 1 << halvings, axis=0).ravel()
        drawn = partial(draw_copies, patch, program, halvings, by_number, copies)
        if kind == "lines" and loses_smooth_lines(context):
            context.say_once(_NOT_SMOOTHED)
            drawn = partial(_unsmoothed, context.driver, drawn)
        context.draw(drawn, patch)


def _unsmoothed(gl: Driver, draw: Callable[[], object]) -> None:
    gl.glDisable(_LINE_SMOOTH)
    try:
        draw()
    finally:
        gl.glEnable(_LINE_SMOOTH)


def draw_copies(
    patch: Patch, program: Uniforms, halvings: int, by_number: ByNumber, copies: NDArray[np.uint32]
) -> None:
    """Draw the 2^halvings copies of each primitive, by a program that is bound."""
    program.set("domeHalvings", (halvings,))
    by_number(patch.mode, copies)
