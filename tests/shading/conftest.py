"""A GL context off screen for tests of shaders."""

import pytest

from domeshim.driver import Driver
from domeshim.window.contract import SurfaceFormat, WindowEvents
from domeshim.window.offscreen import OffscreenBackend


@pytest.fixture(scope="module")
def driver():
    backend = OffscreenBackend()
    window = backend.open_window("test", (64, 64), None, SurfaceFormat(), WindowEvents())
    window.make_current()
    yield Driver()
    backend.close()
