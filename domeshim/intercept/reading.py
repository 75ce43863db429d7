"""glReadPixels: the program asks for pixels of its window and gets what the dome shows there."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from domeshim.intercept.dome import Dome
from domeshim.intercept.monitor_pixels import in_place_of_window, reads_window

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext
    from domeshim.state.shown import Shown
    from domeshim.window.frame import Rectangle

Call = Callable[..., Any]

PICKED = 16
"""A colour request at most so many pixels wide and high asks what is there, a larger one for the picture."""

_DEPTH_COMPONENT, _DEPTH_STENCIL, _STENCIL_INDEX = 0x1902, 0x84F9, 0x1901


def read_pixels(dome: Dome, original: Call) -> Call:
    """glReadPixels in the program's window coordinates.

    Depth: each pixel's is found on the dome and given as the monitor's depth buffer would hold it, so that
    gluUnProject leads to the point that is seen there, to about tolerance / disc radius of its distance (the
    chords of bent edges lie that much nearer); where nothing was drawn it is the clear value. Pixels
    outside of the program's window ask for directions beyond its view, and are answered as well.

    Colours, up to PICKED pixels wide and high: the frame's nearest pixel for each, never a blend of several.
    A multisampled pixel on an edge is what the driver makes of it: Mesa gives one sample, others the mean.
    Larger requests, a screenshot's, read the dome's picture as it is, scaled where the frame's size is not
    the program's. One pixel of the stencil buffer is found as colours are; the depth packed with it is the
    dome's own.

    Off the dome's disc there is nothing: the clear colour and depth.

    Left to GL: reading from a framebuffer object of the program's, and while the dome stays out of its draws.
    """

    def call(x: Any, y: Any, width: Any, height: Any, format: Any, *args: Any, **named: Any) -> Any:  # noqa: A002 - GL's own name
        context = dome.context
        if context is None:
            return original(x, y, width, height, format, *args, **named)
        deep = int(format) in (_DEPTH_COMPONENT, _DEPTH_STENCIL)
        context.settle(deep=deep)
        dome.reading()
        area, kind = (int(x), int(y), int(width), int(height)), int(format)
        shown = _shown(context, area, kind) if reads_window(context, area, deep=deep) else None
        if shown is None:
            return original(*area, format, *args, **named)
        if kind in (_STENCIL_INDEX, _DEPTH_STENCIL):
            return original(*shown.pixels[0, 0].tolist(), 1, 1, format, *args, **named)
        with in_place_of_window(context, shown, deep=deep):
            return original(0, 0, *area[2:], format, *args, **named)

    return call


def _shown(context: DomeContext, area: Rectangle, kind: int) -> Shown | None:
    """The frame's pixels that answer a request; None where it is for the frame's own."""
    from domeshim.state.shown import Shown, middles  # noqa: PLC0415 - only a program that reads pays

    frame, sight = context.frame, context.pixels.sight
    size, stencil = max(area[2:]), kind in (_STENCIL_INDEX, _DEPTH_STENCIL)
    if kind == _DEPTH_COMPONENT or size <= (1 if stencil else PICKED):
        return Shown(sight, sight.to_frame(middles(area)))
    if stencil:
        context.say_once("glReadPixels of stencil areas reads the dome's picture, not the program's window")
        return None
    if frame.size == frame.program_size:
        return None
    return Shown(sight, middles(area) * (np.array(frame.size) / frame.program_size))
