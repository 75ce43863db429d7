"""The functions ending in v read what PyOpenGL reads, and refuse what it refuses."""

from __future__ import annotations

import array
import ctypes
import struct
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from tests.pictures.beside import GL, Beside

Given = Callable[[list[float], str], Any]
"""What a program gives, of these numbers and a type by its letter in struct, which numpy and array share."""

C_TYPES = {
    "f": ctypes.c_float, "d": ctypes.c_double, "b": ctypes.c_byte, "B": ctypes.c_ubyte,
    "h": ctypes.c_short, "i": ctypes.c_int,
}  # fmt: skip


def packed(numbers: list[float], letter: str) -> bytes:
    return struct.pack(f"{len(numbers)}{letter}", *numbers)


def of_ctypes(numbers: list[float], letter: str) -> Any:
    return (C_TYPES[letter] * len(numbers))(*numbers)


GIVEN: dict[str, Given] = {
    "tuple": lambda n, _: tuple(n),
    "list": lambda n, _: n,
    "longer list": lambda n, _: [*n, 1],
    "shorter list": lambda n, _: n[:-1],
    "row": lambda n, _: [n],
    "rows": lambda n, _: [n] * (len(n) + 1),
    "no list": lambda _n, _: [],
    "bytes": packed,
    "longer bytes": lambda n, t: packed([*n, *n], t),
    "shorter bytes": lambda n, t: packed(n, t)[:-1],
    "a byte each": lambda n, _: bytes(len(n)),
    "bytearray": lambda n, t: bytearray(packed(n, t)),
    "tobytes": lambda n, t: np.array(n, t).tobytes(),
    "memoryview": lambda n, t: memoryview(packed(n, t)),
    "typed memoryview": lambda n, t: memoryview(np.array(n, t)),
    "array": lambda n, t: array.array(t, n),
    "ctypes": of_ctypes,
    "longer ctypes": lambda n, t: of_ctypes([*n, 1], t),
    "ctypes of another type": lambda n, t: of_ctypes([int(v) for v in n], "h" if t != "h" else "i"),
    "rows of ctypes": lambda n, t: (C_TYPES[t] * len(n) * 1)(of_ctypes(n, t)),
    "byref": lambda n, t: ctypes.byref(of_ctypes(n, t)),
    "pointer": lambda n, t: ctypes.pointer(of_ctypes(n, t)),
    **{f"numpy {t}": lambda n, _, t=t: np.array(n).astype(t) for t in "?bBhHiIlLqQefdO"},
    "numpy text": lambda n, t: np.array([str(int(v) if t in "bBhi" else v) for v in n]),
    "numpy row": lambda n, t: np.array([n], t),
    "numpy column": lambda n, t: np.array([n], t).T,
    "every other": lambda n, t: np.repeat(np.array(n, t), 2)[::2],
    "longer numpy": lambda n, t: np.array([*n, 1], t),
    "numpy rows": lambda n, t: np.array([n, n], t),
    "numpy number": lambda n, t: np.array(n, t)[0],
    "text": lambda n, _: "1" * len(n),
    "range": lambda n, _: range(len(n)),
    "dict": lambda n, _: dict.fromkeys(range(len(n)), 1.0),
    "number": lambda n, _: n[0],
    "none": lambda _n, _: None,
}
VECTORS = {
    "glVertex2fv": (2, "f"), "glVertex3fv": (3, "f"), "glVertex4fv": (4, "f"), "glVertex3dv": (3, "d"),
    "glVertex3iv": (3, "i"), "glVertex2sv": (2, "h"), "glColor3ubv": (3, "B"), "glColor4ubv": (4, "B"),
    "glColor3bv": (3, "b"), "glColor3fv": (3, "f"), "glColor4dv": (4, "d"), "glNormal3fv": (3, "f"),
    "glNormal3bv": (3, "b"), "glTexCoord2fv": (2, "f"), "glTexCoord4dv": (4, "d"),
}  # fmt: skip


def drawn_at(gl: GL, call: Callable[[], object]) -> list[float]:
    """Where the vertex lies that the call gives."""
    gl.glFeedbackBuffer(64, gl.GL_3D)
    gl.glRenderMode(gl.GL_FEEDBACK)
    gl.glBegin(gl.GL_POINTS)
    try:
        call()
    finally:
        gl.glEnd()
        found = gl.glRenderMode(gl.GL_RENDER)
    return [round(float(x), 4) for _, vertex in found for x in vertex.vertex]


def answers(gl: GL, name: str) -> dict[str, Any]:
    """What becomes of each thing given: numbers, or the class of what is raised."""
    count, letter = VECTORS[name]
    numbers = [0.5, 0.25, 0.75, 1.0][:count] if letter in "fd" else [1, 0, 1, 1][:count]
    gl.glOrtho(-2, 2, -2, 2, -2, 2)
    current = next(
        (what for key, what in (("Color", "COLOR"), ("Normal", "NORMAL")) if key in name), "TEXTURE_COORDS"
    )
    found = {}
    for kind, given in GIVEN.items():
        vector = given(list(numbers), letter)
        try:
            if "Vertex" in name:
                answer: Any = drawn_at(gl, lambda: getattr(gl, name)(vector))  # noqa: B023 - called at once
            else:
                getattr(gl, name)(vector)
                answer = gl.glGetFloatv(getattr(gl, f"GL_CURRENT_{current}")).round(5).tolist()
        except Exception as error:  # noqa: BLE001,RUF100 - whichever it is
            answer = type(error).__name__
        found[kind] = answer
    return found


@pytest.mark.parametrize("name", VECTORS)
def test_vectors_are_read_as_pyopengl_reads_them(beside: Beside, name: str) -> None:
    """But for members of plain lists that are no numbers: those are refused when they are drawn."""
    stock = beside.monitor(lambda gl: answers(gl, name)).answer
    dome = beside.through_dome(lambda gl: answers(gl, name)).answer
    assert not isinstance(stock["bytes"], str)
    assert dome == stock
