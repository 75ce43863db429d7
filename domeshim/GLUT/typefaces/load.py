"""Which glyphs are in use: those of the program's own GLUT where they can be had."""

from __future__ import annotations

import ctypes
import warnings
from functools import lru_cache

from OpenGL.platform import PLATFORM

from domeshim.GLUT.typefaces.faces import Typefaces
from domeshim.GLUT.typefaces.freeglut import UnreadableFontError, read_typefaces
from domeshim.GLUT.typefaces.substitute import substitute_typefaces


@lru_cache(maxsize=1)
def typefaces() -> Typefaces:
    """The faces of the installed freeglut; without one, or with one that is not understood, the substitutes.

    The latter case is said in a warning.
    """
    library = glut_library()
    if library is None:
        return substitute_typefaces()
    try:
        return read_typefaces(library)
    except UnreadableFontError as error:
        warnings.warn(
            f"the fonts inside the installed GLUT library are not as expected ({error}); "
            "text is drawn with Hershey-Fonts and Pillow",
            RuntimeWarning,
            stacklevel=2,
        )
        return substitute_typefaces()


def glut_library() -> ctypes.CDLL | None:
    """The GLUT library that PyOpenGL uses, None where none is installed."""
    library: ctypes.CDLL | None = PLATFORM.GLUT
    return library
