"""Which screen a program gets when nobody said."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec

from domeshim.window.contract import Backend

_LIBRARY, _VARIANT = "PYGLFW_LIBRARY", "PYGLFW_LIBRARY_VARIANT"
"""glfw's own variables: which library it loads, or which of those in its package."""


def choose_backend() -> Backend:
    """Open the display's windows; off-screen work is asked for by name, never taken silently.

    Raises ScreenError where there is no display.
    """
    with _library_named():
        from domeshim.window.screen import ScreenBackend  # noqa: PLC0415 - glfw only when a window is wanted

    return ScreenBackend()


@contextmanager
def _library_named() -> Iterator[None]:
    """Within it glfw is told to load the library of its own package, where no other was chosen.

    Left alone it starts a Python, and a dome in it, to ask each library on the machine for its version.
    """
    library = _library_in_package()
    if library is None or os.environ.get(_LIBRARY):
        yield
        return
    os.environ[_LIBRARY] = library
    try:
        yield
    finally:
        del os.environ[_LIBRARY]


def _library_in_package() -> str | None:
    """The library that glfw's package has for this kind of display."""
    package = find_spec("glfw")
    kind = os.environ.get(_VARIANT) or os.environ.get("XDG_SESSION_TYPE", "")
    for folder in package.submodule_search_locations or () if package is not None else ():
        library = os.path.join(folder, "wayland" if kind.lower() == "wayland" else "x11", "libglfw.so")
        if os.path.isfile(library):
            return library
    return None
