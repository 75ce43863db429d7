from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from OpenGL import GL
from OpenGL.error import GLError

from domeshim.measure.pixels import PACK_LAYOUT, TRANSFER, read_pixels
from domeshim.window.contract import SurfaceFormat, Window, WindowEvents
from domeshim.window.offscreen import OffscreenBackend

WIDTH, HEIGHT = 37, 21  # rows of 111 bytes: no multiple of any alignment


@pytest.fixture
def window() -> Iterator[Window]:
    backend = OffscreenBackend()
    yield backend.open_window("pixels", (WIDTH, HEIGHT), None, SurfaceFormat(), WindowEvents())
    backend.close()


@pytest.fixture
def picture(window: Window) -> np.ndarray:
    """A picture with a colour of its own for each pixel; rows from the top."""
    rows, columns = np.mgrid[0:HEIGHT, 0:WIDTH]
    picture = np.stack([rows * 7, columns * 5, (rows + columns) % 256], axis=-1).astype(np.uint8)
    GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
    GL.glWindowPos2i(0, 0)
    GL.glDrawPixels(WIDTH, HEIGHT, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, picture[::-1].tobytes())
    return picture


def read() -> np.ndarray:
    return np.frombuffer(read_pixels(WIDTH, HEIGHT), np.uint8).reshape(HEIGHT, WIDTH, 3)


def test_the_picture_comes_with_its_top_row_first(picture):
    assert (read() == picture).all()


def test_whatever_the_program_has_set_is_neither_heard_nor_lost(picture):
    odd_layout = dict(zip(PACK_LAYOUT, (1, 1, 50, 3, 2, 8), strict=True))
    odd_transfer = dict(zip(TRANSFER, (1.0, 0.5, 0.25, 2.0, -0.25, 0.5, 0.125), strict=True))
    buffer, framebuffer, texture = GL.glGenBuffers(1), GL.glGenFramebuffers(1), GL.glGenTextures(1)
    GL.glBindBuffer(GL.GL_PIXEL_PACK_BUFFER, buffer)
    GL.glBufferData(GL.GL_PIXEL_PACK_BUFFER, 64, None, GL.GL_STREAM_READ)
    GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
    GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGBA, 4, 4, 0, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, None)
    GL.glReadBuffer(GL.GL_FRONT)
    GL.glBindFramebuffer(GL.GL_READ_FRAMEBUFFER, framebuffer)
    GL.glFramebufferTexture2D(GL.GL_READ_FRAMEBUFFER, GL.GL_COLOR_ATTACHMENT0, GL.GL_TEXTURE_2D, texture, 0)
    for name, value in odd_layout.items():
        GL.glPixelStorei(name, value)
    for name, value in odd_transfer.items():
        GL.glPixelTransferf(name, value)

    assert (read() == picture).all()

    assert {name: GL.glGetIntegerv(name) for name in odd_layout} == odd_layout
    assert {name: float(GL.glGetFloatv(name)) for name in odd_transfer} == odd_transfer
    assert GL.glGetIntegerv(GL.GL_PIXEL_PACK_BUFFER_BINDING) == buffer
    assert GL.glGetIntegerv(GL.GL_READ_FRAMEBUFFER_BINDING) == framebuffer
    assert GL.glGetIntegerv(GL.GL_READ_BUFFER) == GL.GL_COLOR_ATTACHMENT0
    GL.glBindFramebuffer(GL.GL_READ_FRAMEBUFFER, 0)
    assert GL.glGetIntegerv(GL.GL_READ_BUFFER) == GL.GL_FRONT


def test_an_error_that_the_program_has_yet_to_ask_for_is_kept(picture):
    from OpenGL.platform import PLATFORM

    PLATFORM.GL.glEnable(0xFFFF)  # unseen by PyOpenGL's own checking
    assert (read() == picture).all()
    with pytest.raises(GLError, match="invalid enumerant"):
        GL.glFlush()


def test_nothing_of_it_ends_up_in_a_display_list(picture):
    GL.glNewList(1, GL.GL_COMPILE)
    assert (read() == picture).all()
    GL.glEndList()
    GL.glReadBuffer(GL.GL_FRONT)
    GL.glCallList(1)
    assert GL.glGetIntegerv(GL.GL_READ_BUFFER) == GL.GL_FRONT
