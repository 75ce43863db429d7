"""What draws in this display's windows: asked of one that nobody sees, before a toolkit opens its own."""

from __future__ import annotations

from domeshim.driver import Driver
from domeshim.errors import ScreenError
from domeshim.window.contract import DOME_SAMPLES, SurfaceFormat, WindowEvents, suiting_samples
from domeshim.window.screen import ScreenBackend


def probed_samples() -> int:
    """As many samples a pixel as suit the dome; no window of GL's may be current, or be glfw's."""
    backend = ScreenBackend()
    try:
        backend.open_window("", (1, 1), None, SurfaceFormat(), WindowEvents(), shown=False)
        return suiting_samples(Driver().renderer)
    except ScreenError:
        return DOME_SAMPLES  # the toolkit may know a way to a window
    finally:
        backend.close()
