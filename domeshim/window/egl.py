"""OpenGL.EGL, which PyOpenGL 3.1.10 cannot import by itself under OpenGL.ERROR_CHECKING = False."""

from __future__ import annotations

from OpenGL.raw.EGL import _errors

if not hasattr(_errors, "_error_checker"):
    _errors._error_checker = None  # it forgets to say that there is none

from OpenGL import EGL

__all__ = ["EGL"]
