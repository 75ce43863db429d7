"""Which glyphs are in use: those of the program's own GLUT where they can be had."""

from __future__ import annotations

import ctypes
import warnings
from functools import lru_cache
from typing import TYPE_CHECKING

from OpenGL.platform import PLATFORM

if TYPE_CHECKING:
    from domeshim.GLUT.typefaces.faces import Typefaces


@lru_cache(maxsize=1)
def typefaces() -> Typefaces:
    """The faces of the installed freeglut; without one, or with one that is not understood, the substitutes.

    The latter case is said in a warning.
    """
    from domeshim.GLUT.typefaces.freeglut import (  # noqa: PLC0415 - only a program that writes pays
        UnreadableFontError,
        read_typefaces,
    )

    library = glut_library()
    if library is None:
        return _substitutes()
    try:
        return read_typefaces(library)
    except UnreadableFontError as error:
        warnings.warn(
            f"the fonts inside the installed GLUT library are not as expected ({error}); "
            "text is drawn with Hershey-Fonts and Pillow",
            RuntimeWarning,
            stacklevel=2,
        )
        return _substitutes()


def _substitutes() -> Typefaces:
    from domeshim.GLUT.typefaces.substitute import (  # noqa: PLC0415 - Pillow where there is no freeglut
        substitute_typefaces,
    )

    return substitute_typefaces()


def glut_library() -> ctypes.CDLL | None:
    """The GLUT library that PyOpenGL uses, None where none is installed."""
    library: ctypes.CDLL | None = PLATFORM.GLUT
    return library
