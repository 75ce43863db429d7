"""What X11 offers and glfw does not: the order of windows."""

from __future__ import annotations

import ctypes
from typing import Any

import glfw


def order_on_x11(handle: Any, *, highest: bool) -> None:
    """Put one of glfw's windows over all others of the display, or under them."""
    native: Any = glfw  # its stubs leave these two out
    display, window = ctypes.c_void_p(native.get_x11_display()), ctypes.c_ulong(native.get_x11_window(handle))
    x11 = ctypes.CDLL("libX11.so.6")  # glfw itself has loaded it
    (x11.XRaiseWindow if highest else x11.XLowerWindow)(display, window)
    x11.XFlush(display)
