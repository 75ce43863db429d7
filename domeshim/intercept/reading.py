"""glReadPixels: the program asks for pixels of its window and gets what the dome shows there."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import byref, c_uint
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.transfer import plain_transfer
from domeshim.intercept.dome import Dome

if TYPE_CHECKING:
    from domeshim.driver import Driver
    from domeshim.state.context import DomeContext
Call = Callable[..., Any]
Pixels = NDArray[np.int64]
"""(height, width, 2): for each pixel of the program's, one of the frame's."""

PICKED = 16
"""A colour request at most so many pixels wide and high asks what is there, a larger one for the picture."""

_DEPTH_COMPONENT, _DEPTH_STENCIL, _STENCIL_INDEX = 0x1902, 0x84F9, 0x1901
_RGBA, _RGBA8, _DEPTH_COMPONENT32F, _UNSIGNED_BYTE, _FLOAT = 0x1908, 0x8058, 0x8CAC, 0x1401, 0x1406
_READ_FRAMEBUFFER, _READ_FRAMEBUFFER_BINDING = 0x8CA8, 0x8CAA
_COLOR_ATTACHMENT, _DEPTH_ATTACHMENT, _TEXTURE_2D, _TEXTURE_MAX_LEVEL = 0x8CE0, 0x8D00, 0x0DE1, 0x813D
_DEPTH_BITS, _DEPTH_RANGE, _DEPTH_CLEAR_VALUE, _COLOR_CLEAR_VALUE = 0x0D56, 0x0B70, 0x0B73, 0x0C22
_RESOLUTION = 2.0**-22
"""Depths nearer to each other than this are taken for the same."""


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
        context.settle(deep=int(format) in (_DEPTH_COMPONENT, _DEPTH_STENCIL))
        dome.reading()
        area, kind = (int(x), int(y), int(width), int(height)), int(format)
        pixels = _pixels_of(context, area, kind) if _reads_window(context, area, kind) else None
        if pixels is None:
            return original(*area, format, *args, **named)
        if kind in (_STENCIL_INDEX, _DEPTH_STENCIL):
            return original(*pixels[0, 0].tolist(), 1, 1, format, *args, **named)
        gl = context.driver
        with plain_transfer(gl):
            values = _depths(context, pixels) if kind == _DEPTH_COMPONENT else _colours(context, pixels)
            framebuffer, texture = _stored(gl, values)
        try:
            return original(0, 0, *area[2:], format, *args, **named)
        finally:
            gl.glBindFramebuffer(_READ_FRAMEBUFFER, context.window())
            gl.glDeleteFramebuffers(1, byref(framebuffer))
            gl.glDeleteTextures(1, byref(texture))

    return call


def _reads_window(context: DomeContext, area: tuple[int, int, int, int], kind: int) -> bool:
    """The request is for what the dome has drawn."""
    gl = context.driver
    if not gl.has("glBindFramebuffer"):
        context.say_once(
            "this OpenGL has no framebuffer objects: glReadPixels reads the dome's picture, not the window's"
        )
        return False
    return (
        context.pixels.placed
        and min(area[2:]) > 0
        and gl.integer(_READ_FRAMEBUFFER_BINDING) == context.window()
        and (kind not in (_DEPTH_COMPONENT, _DEPTH_STENCIL) or gl.integer(_DEPTH_BITS) > 0)
    )


def _pixels_of(context: DomeContext, area: tuple[int, int, int, int], kind: int) -> Pixels | None:
    """The frame's pixels that answer a request; None where it is for the frame's own."""
    frame = context.frame
    size, stencil = max(area[2:]), kind in (_STENCIL_INDEX, _DEPTH_STENCIL)
    if kind == _DEPTH_COMPONENT or size <= (1 if stencil else PICKED):
        return np.floor(context.pixels.sight.to_frame(_places(area))).astype(np.int64)
    if stencil:
        context.say_once("glReadPixels of stencil areas reads the dome's picture, not the program's window")
        return None
    if frame.size == frame.program_size:
        return None
    scale = np.array(frame.size) / frame.program_size
    return np.floor(_places(area) * scale).astype(np.int64)


def _places(area: tuple[int, int, int, int]) -> NDArray[np.float64]:
    """(height, width, 2): the middles of the program's pixels."""
    x, y, width, height = area
    return np.stack(np.meshgrid(x + 0.5 + np.arange(width), y + 0.5 + np.arange(height)), -1)


def _colours(context: DomeContext, pixels: Pixels) -> NDArray[Any]:
    """(height, width, 4) bytes; the clear colour outside the disc."""
    cleared = np.clip(context.driver.doubles(_COLOR_CLEAR_VALUE, 4), 0, 1)
    return _gathered(context, pixels, _RGBA, np.round(255 * cleared).astype(np.uint8))


def _depths(context: DomeContext, pixels: Pixels) -> NDArray[Any]:
    """(height, width) single-precision depths of the monitor; the clear value where nothing is."""
    gl, sight = context.driver, context.pixels.sight
    cleared = np.float32(gl.doubles(_DEPTH_CLEAR_VALUE, 1)[0])
    found = _gathered(context, pixels, _DEPTH_COMPONENT, cleared)
    near, far = gl.doubles(_DEPTH_RANGE, 2)
    seen = np.abs(found - cleared) > _RESOLUTION
    if not context.placer.has_perspective or near == far:
        return np.where(seen, found, cleared)
    depths = (found[seen].astype(np.float64) - near) / (far - near)
    directions = sight.directions_on_dome(pixels[seen] + 0.5)
    found[~seen] = cleared
    found[seen] = near + (far - near) * sight.monitor_depth(depths, directions)
    return found


def _gathered(
    context: DomeContext, pixels: Pixels, kind: int, missing: NDArray[Any] | np.float32
) -> NDArray[Any]:
    """What these pixels of the frame hold, read in one rectangle; missing: what those off the dome do."""
    values = np.empty((*pixels.shape[:2], *missing.shape), missing.dtype)
    values[...] = missing
    inside = ((pixels >= 0) & (pixels < context.frame.size)).all(-1) & context.pixels.sight.within(
        pixels + 0.5
    )
    if inside.any():
        columns, rows = pixels[inside].T
        left, bottom = int(columns.min()), int(rows.min())
        width, height = int(columns.max()) - left + 1, int(rows.max()) - bottom + 1
        held = np.empty((height, width, *missing.shape), missing.dtype)
        of = _FLOAT if kind == _DEPTH_COMPONENT else _UNSIGNED_BYTE
        context.driver.glReadPixels(left, bottom, width, height, kind, of, held.ctypes.data)
        values[inside] = held[rows - bottom, columns - left]
    return values


def _stored(gl: Driver, values: NDArray[Any]) -> tuple[c_uint, c_uint]:
    """A framebuffer that holds these values, and its texture: GL reads from it now, as from the window."""
    framebuffer, texture = c_uint(), c_uint()
    deep = values.ndim == 2
    gl.glGenTextures(1, byref(texture))
    gl.glBindTexture(_TEXTURE_2D, texture)
    gl.glTexParameteri(_TEXTURE_2D, _TEXTURE_MAX_LEVEL, 0)
    height, width = values.shape[:2]
    internal, kind, of = (
        (_DEPTH_COMPONENT32F, _DEPTH_COMPONENT, _FLOAT) if deep else (_RGBA8, _RGBA, _UNSIGNED_BYTE)
    )
    data = np.ascontiguousarray(values)
    gl.glTexImage2D(_TEXTURE_2D, 0, internal, width, height, 0, kind, of, data.ctypes.data)
    gl.glGenFramebuffers(1, byref(framebuffer))
    gl.glBindFramebuffer(_READ_FRAMEBUFFER, framebuffer)
    attachment = _DEPTH_ATTACHMENT if deep else _COLOR_ATTACHMENT
    gl.glFramebufferTexture2D(_READ_FRAMEBUFFER, attachment, _TEXTURE_2D, texture, 0)
    return framebuffer, texture
