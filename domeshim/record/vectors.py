"""What the functions ending in v read, as PyOpenGL reads it, whatever it is that a program gives.

Plain rows of numbers are taken as they are. All else (raw memory such as struct.pack's, ctypes' arrays,
matrices, numbers that GL would round) goes through PyOpenGL's own converters, and the memory that GL would
look at is read. So what PyOpenGL refuses is refused in its words.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import numpy as np

PLAIN = frozenset((tuple, list))
"""Their members are numbers."""
Reader = Callable[[Any], Sequence[float]]

_TYPES = {
    "b": "byte", "ub": "ubyte", "s": "short", "us": "ushort", "i": "int", "ui": "uint", "f": "float",
    "d": "double", "": "boolean",
}  # fmt: skip
"""GL's name for each ending; the flags of edges have none."""
_EXACT: dict[str, tuple[type, ...]] = {
    "f": (float, int, bool), "d": (float, int, bool), "b": (int,), "ub": (int,),
}  # fmt: skip
"""Which numbers of an array are recorded as they are; of integers the recorder takes the byte wanted."""


def vector_reader(kind: str, count: int) -> Reader:
    """What reads so many numbers of a GL type, by a function's ending such as f or ub."""
    exact = _EXACT.get(kind, ())

    def read(vector: Any) -> Sequence[float]:
        if type(vector) is np.ndarray:
            numbers = vector.tolist()
            if type(numbers) is list and len(numbers) == count and type(numbers[0]) in exact:
                return numbers
        return _by_pyopengl(kind, count)(vector)

    return read


def size_of_vector(vector: Any) -> int:
    """How many floats PyOpenGL finds in it, for glColor."""
    from OpenGL.arrays import GLfloatArray  # noqa: PLC0415 - not before the program has imported OpenGL

    return int(GLfloatArray.arraySize(GLfloatArray.asArray(vector)))


@cache
def _by_pyopengl(kind: str, count: int) -> Reader:
    """What copies the memory that GL would read."""
    from OpenGL import arrays  # noqa: PLC0415 - not before the program has imported OpenGL
    from OpenGL.arrays.arrayhelpers import asArrayTypeSize  # noqa: PLC0415

    array = getattr(arrays, f"GL{_TYPES[kind]}Array")
    converted = asArrayTypeSize(array, count)
    memory = array.baseType * count

    def read(vector: Any) -> Sequence[float]:
        found = memory()
        held = converted(vector, None, ())
        ctypes.memmove(found, array.from_param(held), ctypes.sizeof(found))
        return tuple(found)

    return read
