"""The way cleared for draws of our own over a picture, whatever the program has set."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from domeshim.driver import Driver

_ALL_ATTRIBUTES, _CURRENT_PROGRAM, _FRONT_AND_BACK, _FILL = 0xFFFFFFFF, 0x8B8D, 0x0408, 0x1B02
_IN_THE_WAY = (
    0x0B71,  # GL_DEPTH_TEST
    0x0B90,  # GL_STENCIL_TEST
    0x0BC0,  # GL_ALPHA_TEST
    0x0BE2,  # GL_BLEND
    0x0BF2,  # GL_COLOR_LOGIC_OP
    0x0C11,  # GL_SCISSOR_TEST
    0x0B44,  # GL_CULL_FACE
    0x0B42,  # GL_POLYGON_STIPPLE
    0x8037,  # GL_POLYGON_OFFSET_FILL
    0x0B50,  # GL_LIGHTING
    0x0B60,  # GL_FOG, which drawn pixels would get as well, and so the textures:
    0x0DE0,  # GL_TEXTURE_1D
    0x0DE1,  # GL_TEXTURE_2D
    0x806F,  # GL_TEXTURE_3D
    0x8513,  # GL_TEXTURE_CUBE_MAP
)
_CLIP_PLANE0, _RASTERIZER_DISCARD = 0x3000, 0x8C89


@contextmanager
def way_cleared(gl: Driver) -> Iterator[None]:
    """Within it nothing of the program's changes or hides what is drawn; after it all is as it was.

    No GLSL program is bound. Colour mask, viewport, pixel transfer and the depth's range are the program's.
    """
    program = gl.integer(_CURRENT_PROGRAM)
    gl.glPushAttrib(_ALL_ATTRIBUTES)
    for capability in _IN_THE_WAY:
        gl.glDisable(capability)
    for plane in range(gl.clip_planes):
        gl.glDisable(_CLIP_PLANE0 + plane)
    if not gl.legacy:
        gl.glDisable(_RASTERIZER_DISCARD)
    gl.glPolygonMode(_FRONT_AND_BACK, _FILL)
    gl.glUseProgram(0)
    try:
        yield
    finally:
        gl.glUseProgram(program)
        gl.glPopAttrib()
