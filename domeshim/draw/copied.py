"""A part of the framebuffer that is read, as the image of the texture that is bound."""

from __future__ import annotations

from ctypes import byref, c_uint

from domeshim.draw.target import drawing_to
from domeshim.driver import Driver
from domeshim.window.frame import Rectangle

_READ, _READ_BINDING, _DRAW, _COLOR_ATTACHMENT = 0x8CA8, 0x8CAA, 0x8CA9, 0x8CE0
_RENDERBUFFER, _RENDERBUFFER_BINDING, _RGBA8, _TEXTURE_2D = 0x8D41, 0x8CA7, 0x8058, 0x0DE1
_COLOR_BIT, _NEAREST, _SCISSOR_TEST, _SCISSOR_BIT = 0x4000, 0x2600, 0x0C11, 0x80000


def copied_to_texture(gl: Driver, area: Rectangle) -> None:
    """Make the area's colours the image; of several samples the mean, where glCopyTexImage refuses them."""
    x, y, width, height = area
    read, held = gl.integer(_READ_BINDING), gl.integer(_RENDERBUFFER_BINDING)
    framebuffer, colours = c_uint(), c_uint()
    gl.glGenFramebuffers(1, byref(framebuffer))
    gl.glGenRenderbuffers(1, byref(colours))
    gl.glPushAttrib(_SCISSOR_BIT)
    gl.glDisable(_SCISSOR_TEST)
    try:
        gl.glBindRenderbuffer(_RENDERBUFFER, colours)
        gl.glRenderbufferStorageMultisample(_RENDERBUFFER, 0, _RGBA8, width, height)
        with drawing_to(gl, framebuffer.value):
            gl.glFramebufferRenderbuffer(_DRAW, _COLOR_ATTACHMENT, _RENDERBUFFER, colours)
            box = (x, y, x + width, y + height)
            gl.glBlitFramebuffer(*box, 0, 0, width, height, _COLOR_BIT, _NEAREST)
        gl.glBindFramebuffer(_READ, framebuffer)
        gl.glCopyTexImage2D(_TEXTURE_2D, 0, _RGBA8, 0, 0, width, height, 0)
    finally:
        gl.glPopAttrib()
        gl.glBindRenderbuffer(_RENDERBUFFER, held)
        gl.glBindFramebuffer(_READ, read)
        gl.glDeleteFramebuffers(1, byref(framebuffer))
        gl.glDeleteRenderbuffers(1, byref(colours))
