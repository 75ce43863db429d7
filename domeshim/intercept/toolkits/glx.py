"""OpenGL.GLX where there is no display: it can be imported, and has none of its functions."""

from __future__ import annotations

from typing import Any


def without_functions(platform: Any) -> None:
    """Let OpenGL.GLX be imported on EGL: each function is there and false, as one that the driver lacks.

    platform: PyOpenGL's. Calling such a function raises NullFunctionError, which names it.
    """
    if not hasattr(platform, "GLX") and hasattr(platform, "EGL"):
        platform.GLX = platform.EGL  # which has no function of GLX's names
