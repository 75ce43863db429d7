"""A still picture as the projector needs it, made off screen or in a window that is there."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.finish import Finish
from domeshim.draw.finishing import Finishing
from domeshim.draw.paste import paste
from domeshim.driver import Driver
from domeshim.measure.pixels import read_pixels
from domeshim.options import Options
from domeshim.window.contract import SurfaceFormat, WindowEvents
from domeshim.window.frame import Frame
from domeshim.window.offscreen import OffscreenBackend


def finished(picture: NDArray[np.uint8], frame: Frame, options: Options) -> NDArray[np.uint8]:
    """(height, width, 3), the top row first -> the same, through the options' mesh, mirror and light.

    Raises MeshError.
    """
    backend = OffscreenBackend()
    try:
        backend.open_window("still", frame.size, None, SurfaceFormat(), WindowEvents()).make_current()
        driver = Driver()
        paste(driver, picture)
        finish_now(driver, frame, options)
        return np.frombuffer(read_pixels(*frame.size), np.uint8).reshape(picture.shape)
    finally:
        backend.close()


def finish_now(driver: Driver, frame: Frame, options: Options) -> None:
    """The same with what is in the back buffer of the current window."""
    finish = Finish(driver, Finishing(options, frame))
    finish.draw()
    finish.close()
