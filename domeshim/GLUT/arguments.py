"""What programs may pass to GLUT's functions: what PyOpenGL's own wrappers take, refused in the same way.

Arguments too many are passed over, as there: hence *_more in all but what takes a callback.
"""

from __future__ import annotations

import ctypes
import operator
from collections.abc import Callable
from typing import Any

Callback = Callable[..., Any]


def integer(function: str, name: str, value: Any) -> int:
    """Return an int argument; also a GL constant, a numpy integer or a ctypes one.

    Raises ctypes.ArgumentError for anything else, floats among them, as PyOpenGL does.
    """
    try:
        return operator.index(value.value if isinstance(value, ctypes._SimpleCData) else value)
    except TypeError:
        raise _refused(function, f"{name} must be an integer", value) from None


def real(function: str, name: str, value: Any) -> float:
    """Return a float argument.

    Raises ctypes.ArgumentError for what is no number.
    """
    try:
        return float(value.value if isinstance(value, ctypes._SimpleCData) else value)
    except (TypeError, ValueError):
        raise _refused(function, f"{name} must be a number", value) from None


def text(function: str, name: str, value: Any) -> str:
    """Return a str from str or UTF-8 bytes; None is the empty text.

    Raises ctypes.ArgumentError for anything else, as PyOpenGL does.
    """
    if isinstance(value, ctypes.c_char_p):
        value = value.value
    if value is None:
        return ""
    if isinstance(value, bytes | bytearray):
        return bytes(value).split(b"\0")[0].decode("utf-8", "replace")
    if isinstance(value, str):
        return value.split("\0")[0]
    raise _refused(function, f"{name} must be str or bytes", value)


def callback(function: str, value: Any) -> Callback | None:
    """Return a callable, or None where the program takes its callback back (None or 0).

    Raises ctypes.ArgumentError for anything else.
    """
    if callable(value):
        return value  # type: ignore[no-any-return] # whatever it returns, nobody looks at it
    if value is None or (isinstance(value, int) and value == 0):
        return None
    raise _refused(function, "a function or None is needed", value)


def _refused(function: str, rule: str, value: Any) -> ctypes.ArgumentError:
    return ctypes.ArgumentError(f"{function}: {rule}, not {type(value).__name__} {value!r}")
