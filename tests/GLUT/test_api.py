"""Every name of OpenGL.GLUT is here, with its number."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest

from domeshim import GLUT

LEFT_OUT = {
    **dict.fromkeys(
        ("GLUTCallback", "GLUTMenuCallback", "GLUTTimerCallback", "FUNCTION_TYPE", "GLUT_GUARD_CALLBACKS"),
        "PyOpenGL's own machinery for calling a C library",
    ),
    **dict.fromkeys(("GLUT", "PLATFORM", "CurrentContextIsValid", "INITIALIZED"), "the C library itself"),
    **dict.fromkeys(
        [
            "arrays",
            "constant",
            "contextdata",
            "error",
            "fonts",
            "freeglut",
            "logs",
            "osx",
            "special",
        ],
        "a module of PyOpenGL's that its star lets through",
    ),
    "platform": "PyOpenGL's module, not Python's",
    **dict.fromkeys(
        ("as_8_bit", "bytes", "integer_types", "long", "unicode", "logging", "ctypes_version", "sizeof"),
        "an import of PyOpenGL's for its own use",
    ),
    **dict.fromkeys(
        ("c_char_p", "c_int", "c_ubyte", "c_void_p", "int32_t", "int64_t", "size_t", "void"),
        "ctypes under another name",
    ),
    **dict.fromkeys(("ARRAY_TYPE_TO_CONSTANT",), "PyOpenGL's table of array types"),
}


@pytest.fixture(scope="module")
def stock() -> dict[str, int | None]:
    """Give OpenGL.GLUT's names and the constants' numbers, from a process without domeshim."""
    script = (
        "import json; names = {}; exec('from OpenGL.GLUT import *', names); "
        "numbers = {k: int(v) if isinstance(v, int) else None for k, v in names.items() if k[0] != '_'}; "
        "print(json.dumps(numbers))"
    )
    out = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout
    return json.loads(out)  # type: ignore[no-any-return]


def test_every_stock_name_is_offered_or_left_out_for_a_reason(stock: dict[str, int | None]) -> None:
    assert sorted(set(stock) - set(GLUT.__all__) - set(LEFT_OUT)) == []


def test_nothing_is_left_out_that_is_offered(stock: dict[str, int | None]) -> None:
    assert sorted(set(LEFT_OUT) & set(GLUT.__all__)) == []
    assert sorted(name for name in LEFT_OUT if name.startswith("glut")) == []


def test_constants_have_the_stock_numbers(stock: dict[str, int | None]) -> None:
    numbers = {name: value for name, value in stock.items() if name.startswith("GLUT_") and value is not None}
    del numbers["GLUT_GUARD_CALLBACKS"]
    assert len(numbers) > 180
    assert {name: getattr(GLUT, name) for name in numbers} == numbers


def test_all_names_exist_once() -> None:
    assert len(set(GLUT.__all__)) == len(GLUT.__all__)
    assert [name for name in GLUT.__all__ if not hasattr(GLUT, name)] == []


def test_stock_glut_is_not_imported() -> None:
    script = "import sys, domeshim.GLUT; sys.exit('OpenGL.GLUT' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", script], check=False).returncode == 0
