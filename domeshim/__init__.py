"""Existing PyOpenGL programs on a planetarium dome, without a changed line.

Importing this package loads nothing else; the work begins with install(), or with DOME=1 in the environment.
"""

from __future__ import annotations

__all__ = ["__version__", "install", "uninstall"]

__version__ = "0.1.0"


def install(dome: bool = True) -> None:
    """Put the program's OpenGL.GL, GLU and GLUT, loaded or yet to come, under domeshim.

    dome=False replaces GLUT alone and leaves the picture as on the monitor. A second call changes nothing,
    unless it asks for the other kind of picture.

    Raises OptionError for a malformed DOME* variable.
    """
    from domeshim import startup  # noqa: PLC0415 - see the module's docstring

    startup.install(dome)


def uninstall() -> None:
    """Put back exactly what was there before install()."""
    from domeshim import startup  # noqa: PLC0415 - see the module's docstring

    startup.uninstall()
