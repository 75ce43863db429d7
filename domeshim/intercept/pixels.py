"""The intercepted calls on pixels: where bitmaps and images go, what is drawn there, and what is cleared."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from domeshim.intercept.dome import Dome

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext

Call = Callable[..., Any]


def raster_position(dome: Dome, original: Call) -> Call:
    """glRasterPos."""

    def call(*args: Any) -> Any:
        if dome.context is None:
            return original(*args)
        return dome.context.raster.set(partial(original, *args))

    return call


def at_raster(dome: Dome, original: Call) -> Call:
    """A draw at the raster position, in the dome's own pixels."""

    def call(*args: Any, **named: Any) -> Any:
        context = dome.context
        if context is None:
            return original(*args, **named)
        dome.drawing()
        draw = partial(original, *args, **named)
        return None if dome.listed(draw, at_raster=True) else context.raster.draw(draw)

    return call


def bitmap(dome: Dome, original: Call) -> Call:
    """glBitmap, recorded where it can be; original: what else it does, once GL has seen what was recorded."""

    def call(*args: Any, **named: Any) -> Any:
        if len(args) == 7 and not named and dome.context is not None:
            width, height, *numbers, bits = args
            if dome.write_bits(width, height, tuple(numbers), bits):
                return None
        return original(*args, **named)

    return call


def image(dome: Dome, original: Call) -> Call:
    """glDrawPixels: likewise, where it draws colours."""

    draw = at_raster(dome, original)

    def call(width: int, height: int, kind: int, *more: Any) -> Any:
        context = dome.context
        on_panel = context is not None and dome.building is None and context.panel.due
        if context is None or not on_panel or kind in _NO_COLOURS or len(more) != 2:
            return draw(width, height, kind, *more)
        dome.drawing()
        load = partial(_texture_image, width, height, kind, *more)
        return None if context.panel.image(width, height, load) else draw(width, height, kind, *more)

    return call


_NO_COLOURS = frozenset((0x1900, 0x1901, 0x1902, 0x84F9))
"""Colour indices, stencil, depth, and both."""


def _texture_image(width: int, height: int, kind: int, values: int, data: Any) -> None:
    from OpenGL import GL  # noqa: PLC0415 - the program has imported it

    GL.glTexImage2D(_TEXTURE_2D, 0, _RGBA8, width, height, 0, kind, values, data)


_TEXTURE_2D, _RGBA8 = 0x0DE1, 0x8058


def copied(dome: Dome, original: Call) -> Call:
    """glCopyPixels: what is to be copied must be in the window."""

    draw = at_raster(dome, original)

    def call(*args: Any) -> Any:
        if dome.context is not None and dome.building is None:
            dome.context.settle(deep=True)
        return draw(*args)

    return call


def window_position(dome: Dome, original: Call) -> Call:
    """glWindowPos: a place in the program's window lies where the panel has it."""

    def call(*args: Any) -> Any:
        context = dome.context
        if context is None or not context.pixels.placed:
            return original(*args)
        x, y, z = (*_numbers(args), 0.0)[:3]
        return context.raster.put(context.pixels.positions(x, y, z))

    return call


def _numbers(args: tuple[Any, ...]) -> list[float]:
    values = args[0] if len(args) == 1 else args
    return [float(value) for value in np.ravel(values)]


def clear(dome: Dome, original: Call) -> Call:
    """glClear, also within a scissor rectangle."""

    def call(mask: int, *_more: object) -> Any:
        context = dome.context
        if context is None:
            return original(mask)
        context.undress()
        if context.aside.in_own_framebuffer:
            return original(mask)
        context.go_on()
        if context.pixels.scissor_cuts:
            _clear_part(dome, context, int(mask))
            mask = int(mask) & ~_DRAWN
            if not mask:
                return None
        with context.pixels.unscissored():
            original(mask)
            context.canvas.clear(int(mask))
        if int(mask) & _COLOR_BUFFER_BIT:
            context.pixels.blacken_sides()
        return None

    return call


_COLOR_BUFFER_BIT = 0x4000
_DRAWN = 0x4500
"""The colour, depth and stencil bits."""


def _clear_part(dome: Dome, context: DomeContext, mask: int) -> None:
    dome.clearing(colour=bool(mask & _COLOR_BUFFER_BIT))
    context.pixels.clear_part(mask & _DRAWN)
