"""glCopyTexImage and glCopyTexSubImage: the program makes a texture of its window, and gets the monitor's."""

from __future__ import annotations

import re
from collections.abc import Callable
from ctypes import byref, c_int
from typing import TYPE_CHECKING, Any

from domeshim.intercept.dome import Dome
from domeshim.intercept.monitor_pixels import in_place_of_window, reads_window

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext
Call = Callable[..., Any]
Maker = Callable[[Dome, Call], Call]

COPIES = re.compile(r"glCopyTex(Sub)?Image([123])D")

_DEPTHS = {0x1902, 0x81A5, 0x81A6, 0x81A7, 0x8CAC, 0x84F9, 0x88F0, 0x8CAD}
"""GL_DEPTH_COMPONENT with and without a size, GL_DEPTH_STENCIL likewise."""
_TEXTURE_DEPTH_SIZE = 0x884A


def copy_texture(name: str) -> Maker:
    """The maker of one of the calls.

    The texture gets what the monitor's window would hold: for each pixel the frame's nearest, a depth as the
    monitor's buffer has it. So it is as fine as the dome shows that part. What was drawn in a small viewport,
    or without a perspective, is found on the panel.

    Left to GL: copying from a framebuffer object of the program's, and while the dome stays out of its draws.
    """
    found = COPIES.fullmatch(name)
    assert found is not None
    sub, dimensions = found[1] is not None, int(found[2])
    x = 2 + dimensions if sub else 3
    """Where the window's x stands among the arguments; y, the width and the height come after it."""

    def make(dome: Dome, original: Call) -> Call:
        def call(*args: Any) -> Any:
            context = dome.context
            if context is None:
                return original(*args)
            dome.reading()
            deep = _has_depths(context, *args[:2]) if sub else int(args[2]) in _DEPTHS
            context.settle(deep=deep)
            left, bottom, width = (int(v) for v in args[x : x + 3])
            area = (left, bottom, width, 1 if dimensions == 1 else int(args[x + 3]))
            if not reads_window(context, area, deep=deep):
                return original(*args)
            planar = context.seen.placement.place == "panel"
            with in_place_of_window(context, context.pixels.shown(area), deep=deep, planar=planar):
                return original(*args[:x], 0, 0, *args[x + 2 :])

        return call

    return make


def _has_depths(context: DomeContext, target: Any, level: Any) -> bool:
    """The bound texture holds depths."""
    bits = c_int()
    context.driver.glGetTexLevelParameteriv(int(target), int(level), _TEXTURE_DEPTH_SIZE, byref(bits))
    return bits.value > 0
