"""Read the glyphs inside an installed freeglut library, so that text is the same as on the monitor.

The layouts are those of fg_internal.h's SFG_Font and SFG_StrokeFont. Nothing is dereferenced: each address is
read through /proc/self/mem, where a wrong one is an error and not a crash, and every value is checked.
"""

from __future__ import annotations

import ctypes
import math
import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from domeshim.GLUT.typefaces.faces import BitmapFace, BitmapGlyph, StrokeFace, StrokeGlyph, Typefaces

_BITMAPS = {
    "8_BY_13": ("fgFontFixed8x13", "-misc-fixed-medium-r-normal--13-"),
    "9_BY_15": ("fgFontFixed9x15", "-misc-fixed-medium-r-normal--15-"),
    "TIMES_ROMAN_10": ("fgFontTimesRoman10", "-adobe-times-medium-r-normal--10-"),
    "TIMES_ROMAN_24": ("fgFontTimesRoman24", "-adobe-times-medium-r-normal--24-"),
    "HELVETICA_10": ("fgFontHelvetica10", "-adobe-helvetica-medium-r-normal--10-"),
    "HELVETICA_12": ("fgFontHelvetica12", "-adobe-helvetica-medium-r-normal--12-"),
    "HELVETICA_18": ("fgFontHelvetica18", "-adobe-helvetica-medium-r-normal--18-"),
}
_STROKES = {"ROMAN": ("fgStrokeRoman", "Roman"), "MONO_ROMAN": ("fgStrokeMonoRoman", "MonoRoman")}


class UnreadableFontError(Exception):
    """The library holds no fonts in the form that we know; says what was odd."""


class _BitmapFont(ctypes.Structure):
    _fields_ = (
        ("name", ctypes.c_void_p),
        ("quantity", ctypes.c_int),
        ("height", ctypes.c_int),
        ("characters", ctypes.c_void_p),
        ("x_origin", ctypes.c_float),
        ("y_origin", ctypes.c_float),
    )


class _StrokeFont(ctypes.Structure):
    _fields_ = (
        ("name", ctypes.c_void_p),
        ("quantity", ctypes.c_int),
        ("height", ctypes.c_float),
        ("characters", ctypes.c_void_p),
    )


class _StrokeChar(ctypes.Structure):
    _fields_ = (("right", ctypes.c_float), ("number", ctypes.c_int), ("strips", ctypes.c_void_p))


class _StrokeStrip(ctypes.Structure):
    _fields_ = (("number", ctypes.c_int), ("vertices", ctypes.c_void_p))


_Layout = TypeVar("_Layout", bound=ctypes.Structure)


def read_typefaces(library: ctypes.CDLL) -> Typefaces:
    """All nine faces of a loaded freeglut.

    Raises UnreadableFontError where the library is of another kind, or this system has no /proc/self/mem.
    """
    with _own_memory() as memory:
        bitmaps = {font: _bitmap_face(memory, library, *place) for font, place in _BITMAPS.items()}
        strokes = {font: _stroke_face(memory, library, *place) for font, place in _STROKES.items()}
    return Typefaces("freeglut", bitmaps, strokes)


class _Memory:
    """This process's memory as a file."""

    def __init__(self, descriptor: int) -> None:
        self._descriptor = descriptor

    def read(self, address: int | None, size: int) -> bytes:
        try:
            content = os.pread(self._descriptor, size, address or 0)
        except (OSError, OverflowError) as error:
            raise UnreadableFontError(f"an address cannot be read ({error})") from error
        _check(len(content) == size, "an address at the end of the memory")
        return content

    def structures(self, layout: type[_Layout], address: int | None, count: int) -> list[_Layout]:
        size = ctypes.sizeof(layout)
        content = self.read(address, size * count)
        return [layout.from_buffer_copy(content, size * i) for i in range(count)]

    def pointers(self, address: int | None, count: int) -> list[int]:
        content = self.read(address, ctypes.sizeof(ctypes.c_void_p) * count)
        return [int(pointer) for pointer in np.frombuffer(content, np.uintp)]


@contextmanager
def _own_memory() -> Iterator[_Memory]:
    try:
        descriptor = os.open("/proc/self/mem", os.O_RDONLY)
    except OSError as error:
        raise UnreadableFontError(f"no /proc/self/mem ({error})") from error
    try:
        yield _Memory(descriptor)
    finally:
        os.close(descriptor)


def _bitmap_face(memory: _Memory, library: ctypes.CDLL, symbol: str, name: str) -> BitmapFace:
    (font,) = memory.structures(_BitmapFont, _address(library, symbol), 1)
    _check(memory.read(font.name, len(name)) == name.encode(), f"{symbol} is not named {name}...")
    _check(font.quantity == 256 and 1 <= font.height <= 64, f"{symbol} has an odd size")
    _check(abs(font.x_origin) <= 64 and abs(font.y_origin) <= 64, f"{symbol} has an odd origin")
    places = memory.pointers(font.characters, font.quantity)
    glyphs = tuple(_bitmap_glyph(memory, place, font.height) for place in places)
    return BitmapFace(font.height, (font.x_origin, font.y_origin), glyphs)


def _bitmap_glyph(memory: _Memory, address: int, height: int) -> BitmapGlyph:
    width = memory.read(address, 1)[0]
    _check(width <= 64, f"a bitmap {width} pixels wide")
    return BitmapGlyph(width, memory.read(address + 1, height * ((width + 7) // 8)))


def _stroke_face(memory: _Memory, library: ctypes.CDLL, symbol: str, name: str) -> StrokeFace:
    (font,) = memory.structures(_StrokeFont, _address(library, symbol), 1)
    _check(memory.read(font.name, len(name) + 1) == name.encode() + b"\0", f"{symbol} is not named {name}")
    _check(font.quantity == 128 and 0 < font.height < 1000, f"{symbol} has an odd size")
    places = memory.pointers(font.characters, font.quantity)
    return StrokeFace(font.height, tuple(_stroke_glyph(memory, place) if place else None for place in places))


def _stroke_glyph(memory: _Memory, address: int) -> StrokeGlyph:
    (glyph,) = memory.structures(_StrokeChar, address, 1)
    _check(math.isfinite(glyph.right) and abs(glyph.right) < 1000, "a stroke character of odd width")
    _check(0 <= glyph.number <= 64, "a stroke character of odd length")
    strips = memory.structures(_StrokeStrip, glyph.strips, glyph.number) if glyph.number else []
    return StrokeGlyph(glyph.right, tuple(_strip(memory, strip) for strip in strips))


def _strip(memory: _Memory, strip: _StrokeStrip) -> NDArray[np.float32]:
    _check(0 < strip.number <= 1024, "a stroke of odd length")
    points = np.frombuffer(memory.read(strip.vertices, 8 * strip.number), np.float32).reshape(-1, 2)
    _check(bool((abs(points) < 1000).all()), "a stroke of odd size")
    return points


def _address(library: ctypes.CDLL, symbol: str) -> int:
    try:
        return ctypes.addressof(ctypes.c_char.in_dll(library, symbol))
    except ValueError as error:
        raise UnreadableFontError(f"no {symbol}") from error


def _check(sound: bool, complaint: str) -> None:
    if not sound:
        raise UnreadableFontError(complaint)
