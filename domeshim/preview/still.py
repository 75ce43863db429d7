"""One view of the virtual dome as a picture, without a display."""

from __future__ import annotations

import os

import numpy as np
from numpy.typing import NDArray

from domeshim.preview.dome import VirtualDome
from domeshim.preview.viewer import Viewer

Picture = NDArray[np.uint8]
_SAMPLES = 4


def view(picture: Picture, dome: VirtualDome, viewer: Viewer, size: tuple[int, int]) -> Picture:
    """(height, width, 3): what the viewer sees of a picture (h, w, 3) that hangs in the dome; top rows first.

    Raises ScreenError where this machine can draw nothing without a display, DriverError where its GL is too
    old.
    """
    os.environ["PYOPENGL_PLATFORM"] = "egl"  # before anything imports OpenGL
    from domeshim.draw.attached import attached  # noqa: PLC0415
    from domeshim.driver import Driver  # noqa: PLC0415
    from domeshim.preview.room import Room  # noqa: PLC0415
    from domeshim.window.contract import SurfaceFormat, WindowEvents  # noqa: PLC0415
    from domeshim.window.offscreen import OffscreenBackend  # noqa: PLC0415

    backend = OffscreenBackend()
    try:
        backend.open_window("", (16, 16), None, SurfaceFormat(), WindowEvents())
        context = attached(Driver(), "domeshim preview")
        drawn = context.framebuffer(
            [context.renderbuffer(size, 3, samples=_SAMPLES)],
            context.depth_renderbuffer(size, samples=_SAMPLES),
        )
        seen = context.framebuffer([context.renderbuffer(size, 3)])
        room = Room(context, dome)
        room.show(picture)
        drawn.use()
        room.draw(viewer, size)
        context.copy_framebuffer(seen, drawn)
        pixels = np.frombuffer(seen.read(alignment=1), np.uint8)
        return pixels.reshape(size[1], size[0], 3)[::-1]
    finally:
        backend.close()
