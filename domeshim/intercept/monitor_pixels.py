"""What the monitor's window would hold, found on the dome and handed to GL to be read in its place."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from ctypes import byref, c_uint
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.transfer import plain_transfer

if TYPE_CHECKING:
    from domeshim.driver import Driver
    from domeshim.state.context import DomeContext
    from domeshim.state.shown import Shown
    from domeshim.window.frame import Rectangle

_DEPTH_COMPONENT, _RGBA, _UNSIGNED_BYTE, _FLOAT = 0x1902, 0x1908, 0x1401, 0x1406
_RGBA8, _DEPTH_COMPONENT32F = 0x8058, 0x8CAC
_READ_FRAMEBUFFER, _READ_FRAMEBUFFER_BINDING = 0x8CA8, 0x8CAA
_COLOR_ATTACHMENT, _DEPTH_ATTACHMENT, _TEXTURE_2D, _TEXTURE_MAX_LEVEL = 0x8CE0, 0x8D00, 0x0DE1, 0x813D
_DEPTH_BITS, _DEPTH_RANGE, _DEPTH_CLEAR_VALUE, _COLOR_CLEAR_VALUE = 0x0D56, 0x0B70, 0x0B73, 0x0C22
_RESOLUTION = 2.0**-22
"""Depths nearer to each other than this are taken for the same."""


def reads_window(context: DomeContext, area: Rectangle, *, deep: bool) -> bool:
    """What is asked for is what the dome has drawn; deep: its depths."""
    gl = context.driver
    if not gl.has("glBindFramebuffer"):
        context.say_once(
            "this OpenGL has no framebuffer objects: what is read of the window is the dome's picture"
        )
        return False
    return (
        context.pixels.placed
        and min(area[2:]) > 0
        and gl.integer(_READ_FRAMEBUFFER_BINDING) == context.window()
        and (not deep or gl.integer(_DEPTH_BITS) > 0)
    )


@contextmanager
def in_place_of_window(
    context: DomeContext, shown: Shown, *, deep: bool, planar: bool = False
) -> Iterator[None]:
    """While this lasts GL reads, from the corner on, what the frame holds at these pixels.

    deep: their depths, as the monitor's depth buffer would hold them; else their colours. planar: the depths
    are the monitor's already, as those of what is drawn flat are.
    """
    gl = context.driver
    with plain_transfer(gl):
        values = _depths(context, shown, planar=planar) if deep else _colours(gl, shown)
        framebuffer, texture = _stored(gl, values)
    try:
        yield
    finally:
        gl.glBindFramebuffer(_READ_FRAMEBUFFER, context.window())
        gl.glDeleteFramebuffers(1, byref(framebuffer))
        gl.glDeleteTextures(1, byref(texture))


def _colours(gl: Driver, shown: Shown) -> NDArray[Any]:
    """(height, width, 4) bytes; the clear colour outside the disc."""
    cleared = np.round(255 * np.clip(gl.doubles(_COLOR_CLEAR_VALUE, 4), 0, 1)).astype(np.uint8)
    return (
        _gathered(gl, shown, _RGBA, cleared.view(np.uint32)[0]).view(np.uint8).reshape(*shown.inside.shape, 4)
    )


def _depths(context: DomeContext, shown: Shown, *, planar: bool) -> NDArray[Any]:
    """(height, width) single-precision depths of the monitor; the clear value where nothing is."""
    gl = context.driver
    cleared = np.float32(gl.doubles(_DEPTH_CLEAR_VALUE, 1)[0])
    near, far = gl.doubles(_DEPTH_RANGE, 2)
    found = _gathered(gl, shown, _DEPTH_COMPONENT, cleared)
    seen = np.abs(found - cleared) > _RESOLUTION
    found[~seen] = cleared
    if not planar and context.placer.has_perspective and near != far:
        depths = (found[seen].astype(np.float64) - near) / (far - near)
        found[seen] = near + (far - near) * shown.monitor_depth(depths, seen[shown.inside])
    return found


def _gathered(gl: Driver, shown: Shown, kind: int, missing: np.generic) -> NDArray[Any]:
    """(height, width): what the frame holds there, read in one rectangle; missing: off the dome."""
    values = np.full(shown.inside.shape, missing)
    if shown.inside.any():
        held = np.empty(shown.box[2] * shown.box[3], missing.dtype)
        of = _FLOAT if kind == _DEPTH_COMPONENT else _UNSIGNED_BYTE
        gl.glReadPixels(*shown.box, kind, of, held.ctypes.data)
        values[shown.inside] = held[shown.in_box]
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
