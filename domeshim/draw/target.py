"""Which framebuffer draws of our own go to."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from domeshim.driver import Driver

_DRAW_FRAMEBUFFER, _DRAW_FRAMEBUFFER_BINDING = 0x8CA9, 0x8CA6


def drawn_to(gl: Driver) -> int:
    """The number of the framebuffer that draws go to now."""
    return gl.integer(_DRAW_FRAMEBUFFER_BINDING) if gl.has("glBindFramebuffer") else 0


@contextmanager
def drawing_to(gl: Driver, framebuffer: int | None) -> Iterator[None]:
    """Within it draws go to this framebuffer, after it to where they went before.

    None: to where they go already.
    """
    bound = drawn_to(gl)
    if framebuffer in (None, bound):
        yield
        return
    gl.glBindFramebuffer(_DRAW_FRAMEBUFFER, framebuffer)
    try:
        yield
    finally:
        gl.glBindFramebuffer(_DRAW_FRAMEBUFFER, bound)
