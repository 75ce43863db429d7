"""glBlitFramebuffer between the program's window and framebuffers of its own."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from domeshim.draw.copied import copied_to_texture
from domeshim.draw.target import drawn_to
from domeshim.intercept.dome import Dome
from domeshim.intercept.monitor_pixels import in_place_of_window
from domeshim.state.context import DomeContext
from domeshim.window.frame import Rectangle

Call = Callable[..., Any]

_READ_FRAMEBUFFER_BINDING, _CURRENT_PROGRAM = 0x8CAA, 0x8B8D
_COLOR_BIT, _DEPTH_BIT = 0x4000, 0x100


def blit_framebuffer(dome: Dome, original: Call) -> Call:
    """glBlitFramebuffer.

    Into the window: colours go onto the panel, where the monitor would show them; depths and stencils go
    nowhere. Out of the window: the monitor's colours, as for glCopyTexImage, and the dome's own depths and
    stencils. Left to GL: from one framebuffer object to another, and within the window.
    """

    def call(*args: Any) -> Any:
        context = dome.context
        if context is None or context.compiling:
            return original(*args)
        numbers = [int(value) for value in args]
        source, target, mask = numbers[:4], numbers[4:8], numbers[8]
        context.undress()
        window = context.window()
        reads = context.driver.integer(_READ_FRAMEBUFFER_BINDING) == window
        draws = drawn_to(context.driver) == window
        if draws and not reads:
            dome.drawing()
            return _show(context, source, target, mask, lambda *box: original(*box, *args[8:]))
        dome.reading()
        context.settle(deep=bool(mask & _DEPTH_BIT))
        if reads and not draws:
            return _take(context, source, target, mask, args[9], original)
        return original(*args)

    return call


def _show(context: DomeContext, source: list[int], target: list[int], mask: int, original: Call) -> None:
    """Draw colours of the framebuffer that is read onto the panel; original: of the corners alone."""
    gl, area = context.driver, _around(source)
    if not mask & _COLOR_BIT or min(area[2:]) <= 0:
        return
    x0, x1 = target[::2] if source[0] < source[2] else target[2::-2]
    y0, y1 = target[1::2] if source[1] < source[3] else target[3::-2]
    program = gl.integer(_CURRENT_PROGRAM)
    gl.glUseProgram(0)
    context.binding.used(0)
    if not context.panel.picture((x0, y0, x1 - x0, y1 - y0), partial(copied_to_texture, gl, area)):
        original(*source, *target)
    context.undress()
    gl.glUseProgram(program)
    context.binding.used(program)


def _take(
    context: DomeContext, source: list[int], target: list[int], mask: int, how: Any, original: Call
) -> None:
    """Give a framebuffer of the program's own the colours that the monitor's window would hold."""
    left, bottom, right, top = source
    area = x, y, width, height = _around(source)
    if mask & _COLOR_BIT and width and height:
        with in_place_of_window(context, context.pixels.shown(area), deep=False):
            original(left - x, bottom - y, right - x, top - y, *target, _COLOR_BIT, how)
    if mask & ~_COLOR_BIT:
        original(*source, *target, mask & ~_COLOR_BIT, how)


def _around(corners: list[int]) -> Rectangle:
    (left, right), (bottom, top) = sorted(corners[::2]), sorted(corners[1::2])
    return left, bottom, right - left, top - bottom
