"""A framebuffer beside the window, multisampled as the window is, whose picture can be read as textures."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from ctypes import byref, c_uint

from domeshim.driver import Driver
from domeshim.errors import DriverError
from domeshim.wording import counted

_FRAMEBUFFER, _READ, _DRAW, _RENDERBUFFER, _TEXTURE_2D = 0x8D40, 0x8CA8, 0x8CA9, 0x8D41, 0x0DE1
_READ_BINDING, _DRAW_BINDING, _RENDERBUFFER_BINDING = 0x8CAA, 0x8CA6, 0x8CA7
_CURRENT_PROGRAM, _VERTEX_ARRAY, _ARRAY_BUFFER, _ARRAY_BUFFER_BINDING = 0x8B8D, 0x85B5, 0x8892, 0x8894
_PIXEL_BUFFER, _PIXEL_BUFFER_BINDING = 0x88EC, 0x88EF
_COLOR_ATTACHMENT, _DEPTH_STENCIL_ATTACHMENT, _COMPLETE = 0x8CE0, 0x821A, 0x8CD5
_RGBA8, _RGBA, _BYTE = 0x8058, 0x1908, 0x1401
_DEPTH24_STENCIL8, _DEPTH_STENCIL, _UINT_24_8 = 0x88F0, 0x84F9, 0x84FA
_FILTERS, _LINEAR, _NEAREST = (0x2801, 0x2800), 0x2601, 0x2600
_WRAPS, _CLAMP_TO_EDGE = (0x2802, 0x2803), 0x812F
_SAMPLES, _SCISSOR_TEST, _COLOR_BIT, _DEPTH_BIT = 0x80A9, 0x0C11, 0x4000, 0x0100
_ALL_ATTRIBUTES, _ALL_CLIENT_ATTRIBUTES = 0xFFFFFFFF, 0xFFFFFFFF


class Atlas:
    """Colours, depths and stencils of one size; the window it belongs to must be current throughout."""

    def __init__(self, driver: Driver, size: tuple[int, int]) -> None:
        """Raises DriverError where this GL has no such framebuffer."""
        self._driver = driver
        self.size = size
        """Width and height, pixels."""
        samples = driver.integer(_SAMPLES)
        self._renderbuffers: list[c_uint] = []
        with restored(driver):
            driver.glBindBuffer(_PIXEL_BUFFER, 0)
            self.textures = (
                self._texture(_RGBA8, _RGBA, _BYTE, _LINEAR),
                self._texture(_DEPTH24_STENCIL8, _DEPTH_STENCIL, _UINT_24_8, _NEAREST),
            )
            self._plain = self._framebuffer()
            for point, texture in zip(
                (_COLOR_ATTACHMENT, _DEPTH_STENCIL_ATTACHMENT), self.textures, strict=True
            ):
                driver.glFramebufferTexture2D(_FRAMEBUFFER, point, _TEXTURE_2D, texture, 0)
            self._check(0)
            self._drawn_to = self._sampled(samples) if samples else self._plain

    @property
    def framebuffer(self) -> int:
        """The one to draw to."""
        return self._drawn_to.value

    def resolve(self, *, deep: bool) -> None:
        """Bring what was drawn into the textures; deep: depths too. Changes bindings and the scissor test."""
        gl = self._driver
        if self._drawn_to is self._plain:
            return
        gl.glDisable(_SCISSOR_TEST)
        gl.glBindFramebuffer(_READ, self._drawn_to)
        gl.glBindFramebuffer(_DRAW, self._plain)
        box = (0, 0, *self.size)
        gl.glBlitFramebuffer(*box, *box, _COLOR_BIT | (_DEPTH_BIT if deep else 0), _NEAREST)

    def delete(self) -> None:
        """Free all of it."""
        gl = self._driver
        for framebuffer in {id(f): f for f in (self._plain, self._drawn_to)}.values():
            gl.glDeleteFramebuffers(1, byref(framebuffer))
        for texture in self.textures:
            gl.glDeleteTextures(1, byref(texture))
        for renderbuffer in self._renderbuffers:
            gl.glDeleteRenderbuffers(1, byref(renderbuffer))

    def _framebuffer(self) -> c_uint:
        name = c_uint()
        self._driver.glGenFramebuffers(1, byref(name))
        self._driver.glBindFramebuffer(_FRAMEBUFFER, name)
        return name

    def _texture(self, internal: int, layout: int, kind: int, filtered: int) -> c_uint:
        gl, name = self._driver, c_uint()
        gl.glGenTextures(1, byref(name))
        gl.glBindTexture(_TEXTURE_2D, name)
        for parameter in _FILTERS:
            gl.glTexParameteri(_TEXTURE_2D, parameter, filtered)
        for parameter in _WRAPS:
            gl.glTexParameteri(_TEXTURE_2D, parameter, _CLAMP_TO_EDGE)
        gl.glTexImage2D(_TEXTURE_2D, 0, internal, *self.size, 0, layout, kind, None)
        return name

    def _sampled(self, samples: int) -> c_uint:
        gl, framebuffer = self._driver, self._framebuffer()
        for point, internal in ((_COLOR_ATTACHMENT, _RGBA8), (_DEPTH_STENCIL_ATTACHMENT, _DEPTH24_STENCIL8)):
            name = c_uint()
            gl.glGenRenderbuffers(1, byref(name))
            gl.glBindRenderbuffer(_RENDERBUFFER, name)
            gl.glRenderbufferStorageMultisample(_RENDERBUFFER, samples, internal, *self.size)
            gl.glFramebufferRenderbuffer(_FRAMEBUFFER, point, _RENDERBUFFER, name)
            self._renderbuffers.append(name)
        self._check(samples)
        return framebuffer

    def _check(self, samples: int) -> None:
        if self._driver.glCheckFramebufferStatus(_FRAMEBUFFER) != _COMPLETE:
            size = f"{self.size[0]}x{self.size[1]} pixels with {counted(samples, 'sample')}"
            raise DriverError(
                f"this OpenGL has no framebuffer of {size}; ask for smaller: DOME_METHOD=cubemap:SIZE"
            )


@contextmanager
def restored(gl: Driver) -> Iterator[None]:
    """After it GL is as before: attributes, and the objects that are bound for drawing and reading."""
    bound = [gl.integer(name) for name in (_DRAW_BINDING, _READ_BINDING, _RENDERBUFFER_BINDING)]
    program, arrays = gl.integer(_CURRENT_PROGRAM), gl.integer(_VERTEX_ARRAY)
    buffers = gl.integer(_ARRAY_BUFFER_BINDING), gl.integer(_PIXEL_BUFFER_BINDING)
    gl.glPushAttrib(_ALL_ATTRIBUTES)
    gl.glPushClientAttrib(_ALL_CLIENT_ATTRIBUTES)
    try:
        yield
    finally:
        gl.glBindFramebuffer(_DRAW, bound[0])  # first: its buffers for drawing and reading are attributes
        gl.glBindFramebuffer(_READ, bound[1])
        gl.glPopClientAttrib()
        gl.glPopAttrib()
        gl.glUseProgram(program)
        gl.glBindVertexArray(arrays)
        gl.glBindBuffer(_ARRAY_BUFFER, buffers[0])
        gl.glBindBuffer(_PIXEL_BUFFER, buffers[1])
        gl.glBindRenderbuffer(_RENDERBUFFER, bound[2])
