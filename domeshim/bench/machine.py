"""Where the bench ran: GL's own strings, the processor, the versions."""

from __future__ import annotations

import os
import platform
from importlib.metadata import version

from domeshim.window.contract import SurfaceFormat, WindowEvents
from domeshim.window.offscreen import OffscreenBackend


def machine() -> dict[str, str]:
    """In words, by what it is. Raises ScreenError where there is no off-screen GL."""
    from OpenGL import GL  # noqa: PLC0415 - not before PYOPENGL_PLATFORM is chosen

    backend = OffscreenBackend()
    try:
        backend.open_window("bench", (16, 16), None, SurfaceFormat(), WindowEvents())
        strings = [GL.glGetString(name).decode() for name in (GL.GL_RENDERER, GL.GL_VERSION, GL.GL_VENDOR)]
    finally:
        backend.close()
    return {
        "renderer": strings[0],
        "version": strings[1],
        "vendor": strings[2],
        "processors": f"{os.cpu_count()} x {_processor()}",
        "python": f"Python {platform.python_version()}, PyOpenGL {version('PyOpenGL')}",
    }


def _processor() -> str:
    try:
        with open("/proc/cpuinfo") as told:
            names = (line.partition(":")[2].strip() for line in told if line.startswith("model name"))
            return next(names, platform.machine())
    except OSError:
        return platform.machine()
