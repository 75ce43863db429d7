"""Reads a window's picture back, and leaves the context as it was.

The calls go to the driver's library itself: PyOpenGL's own would look for errors after each, and so take away
one that the program has yet to ask for.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from ctypes import byref, c_float, c_int, c_uint, create_string_buffer
from typing import Any

from domeshim.driver import Driver

GL_BACK, GL_RGB, GL_UNSIGNED_BYTE, GL_PACK_ALIGNMENT = 0x0405, 0x1907, 0x1401, 0x0D05
READ_BUFFER = 0x0C02
READ_FRAMEBUFFER, READ_FRAMEBUFFER_BINDING = 0x8CA8, 0x8CAA
DRAW_FRAMEBUFFER, DRAW_FRAMEBUFFER_BINDING = 0x8CA9, 0x8CA6
RENDERBUFFER, RENDERBUFFER_BINDING, COLOR_ATTACHMENT0 = 0x8D41, 0x8CA7, 0x8CE0
SAMPLES, SCISSOR_TEST, COLOR_BUFFER_BIT, GL_RGB8, GL_NEAREST = 0x80A9, 0x0C11, 0x4000, 0x8051, 0x2600
PIXEL_PACK_BUFFER, PIXEL_PACK_BUFFER_BINDING = 0x88EB, 0x88ED
PACK_LAYOUT = {
    0x0D00: 0,  # swap bytes
    0x0D01: 0,  # least significant bit first
    0x0D02: 0,  # row length
    0x0D03: 0,  # skip rows
    0x0D04: 0,  # skip pixels
    GL_PACK_ALIGNMENT: 1,
}
TRANSFER = {
    0x0D10: 0.0,  # map colour
    0x0D14: 1.0,  # red scale
    0x0D15: 0.0,  # red bias
    0x0D18: 1.0,  # green scale
    0x0D19: 0.0,  # green bias
    0x0D1A: 1.0,  # blue scale
    0x0D1B: 0.0,  # blue bias
}


def read_pixels(width: int, height: int, *, corner: tuple[int, int] = (0, 0), buffer: int = GL_BACK) -> bytes:
    """Pixels of the current window: height rows of width RGB pixels, a byte each, the top row first.

    corner: their lower left one, x and y from the window's lower left; buffer: GL_BACK or GL_FRONT.
    """
    from OpenGL.platform import PLATFORM  # noqa: PLC0415 - the program may still set PyOpenGL's flags

    gl = PLATFORM.GL
    pixels = create_string_buffer(3 * width * height)
    with plain_reading(gl, buffer), resolved(gl, corner, width, height) as (left, bottom):
        gl.glReadPixels(left, bottom, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels)
    row, rows = 3 * width, memoryview(pixels).cast("B")
    return b"".join(rows[start : start + row] for start in range(row * (height - 1), -1, -row))


@contextmanager
def plain_reading(gl: Any, buffer: int, framebuffer: int = 0) -> Iterator[None]:
    """Reading goes from a framebuffer to memory, tightly packed and unchanged, while this lasts.

    buffer: which of its colour buffers; framebuffer: 0 is GL's own, the window.
    """
    restore = []

    def put(setter: Any, name: int, former: Any, wanted: Any) -> None:
        # Only what differs is touched: some of these calls would end up in a display list that is being made.
        if former.value != wanted.value:
            restore.append((setter, name, former))
            setter(name, wanted)

    put(gl.glBindBuffer, PIXEL_PACK_BUFFER, _integer(gl, PIXEL_PACK_BUFFER_BINDING), c_int(0))
    if Driver().has("glBindFramebuffer"):
        put(
            gl.glBindFramebuffer, READ_FRAMEBUFFER, _integer(gl, READ_FRAMEBUFFER_BINDING), c_int(framebuffer)
        )
    put(lambda _, buffer: gl.glReadBuffer(buffer), 0, _integer(gl, READ_BUFFER), c_int(buffer))
    for name, plain in PACK_LAYOUT.items():
        put(gl.glPixelStorei, name, _integer(gl, name), c_int(plain))
    for name, scale in TRANSFER.items():
        put(gl.glPixelTransferf, name, _number(gl, name), c_float(scale))
    try:
        yield
    finally:
        for setter, name, former in reversed(restore):
            setter(name, former)


@contextmanager
def resolved(gl: Any, corner: tuple[int, int], width: int, height: int) -> Iterator[tuple[int, int]]:
    """A multisampled framebuffer gives the mean of each pixel's samples while this lasts, in plain_reading.

    Mesa's glReadPixels alone gives one of them, also where OpenGL 2 has no framebuffer objects. Yields where
    the corner is to be read then.
    """
    if not Driver().has("glBindFramebuffer"):
        yield corner
        return
    source, drawn_to = _integer(gl, READ_FRAMEBUFFER_BINDING), _integer(gl, DRAW_FRAMEBUFFER_BINDING)
    gl.glBindFramebuffer(DRAW_FRAMEBUFFER, source)
    samples = _integer(gl, SAMPLES).value
    gl.glBindFramebuffer(DRAW_FRAMEBUFFER, drawn_to)
    if not samples:
        yield corner
        return
    left, bottom = corner
    framebuffer, colour = c_uint(), c_uint()
    renderbuffer = _integer(gl, RENDERBUFFER_BINDING)
    scissored = gl.glIsEnabled(SCISSOR_TEST)
    gl.glGenFramebuffers(1, byref(framebuffer))
    gl.glGenRenderbuffers(1, byref(colour))
    gl.glBindRenderbuffer(RENDERBUFFER, colour)
    gl.glRenderbufferStorage(RENDERBUFFER, GL_RGB8, width, height)
    gl.glBindFramebuffer(DRAW_FRAMEBUFFER, framebuffer)
    gl.glFramebufferRenderbuffer(DRAW_FRAMEBUFFER, COLOR_ATTACHMENT0, RENDERBUFFER, colour)
    gl.glDisable(SCISSOR_TEST)
    area = (left, bottom, left + width, bottom + height)
    gl.glBlitFramebuffer(*area, 0, 0, width, height, COLOR_BUFFER_BIT, GL_NEAREST)
    gl.glBindFramebuffer(READ_FRAMEBUFFER, framebuffer)
    try:
        yield 0, 0
    finally:
        gl.glBindFramebuffer(READ_FRAMEBUFFER, source)
        gl.glBindFramebuffer(DRAW_FRAMEBUFFER, drawn_to)
        gl.glBindRenderbuffer(RENDERBUFFER, renderbuffer)
        if scissored:
            gl.glEnable(SCISSOR_TEST)
        gl.glDeleteFramebuffers(1, byref(framebuffer))
        gl.glDeleteRenderbuffers(1, byref(colour))


def _integer(gl: Any, name: int) -> c_int:
    value = c_int()
    gl.glGetIntegerv(name, byref(value))
    return value


def _number(gl: Any, name: int) -> c_float:
    value = c_float()
    gl.glGetFloatv(name, byref(value))
    return value
