"""glutBitmap... and glutStroke...: GLUT's text.

Its fonts are those of the installed freeglut; without one, Hershey-Fonts and Pillow stand in (glyph_source
says which). Text is str, bytes, or an array of bytes or a pointer to one, and ends at a NUL; a character is a
code, or a str or bytes of one. Characters that a font has not are left out, as in freeglut.
"""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from OpenGL import GL

from domeshim import session as sessions
from domeshim.GLUT.typefaces.load import typefaces
from domeshim.GLUT.typefaces.names import FONTS, font_of

if TYPE_CHECKING:
    from domeshim.GLUT.typefaces.faces import BitmapFace, StrokeFace
    from domeshim.record.bitmaps import Bitmap

__all__ = [
    "GLUT_BITMAP_8_BY_13",
    "GLUT_BITMAP_9_BY_15",
    "GLUT_BITMAP_HELVETICA_10",
    "GLUT_BITMAP_HELVETICA_12",
    "GLUT_BITMAP_HELVETICA_18",
    "GLUT_BITMAP_TIMES_ROMAN_10",
    "GLUT_BITMAP_TIMES_ROMAN_24",
    "GLUT_STROKE_MONO_ROMAN",
    "GLUT_STROKE_ROMAN",
    "glutBitmapCharacter",
    "glutBitmapHeight",
    "glutBitmapLength",
    "glutBitmapString",
    "glutBitmapWidth",
    "glutStrokeCharacter",
    "glutStrokeHeight",
    "glutStrokeLength",
    "glutStrokeLengthf",
    "glutStrokeString",
    "glutStrokeWidth",
    "glutStrokeWidthf",
]

(
    GLUT_STROKE_ROMAN,
    GLUT_STROKE_MONO_ROMAN,
    GLUT_BITMAP_9_BY_15,
    GLUT_BITMAP_8_BY_13,
    GLUT_BITMAP_TIMES_ROMAN_10,
    GLUT_BITMAP_TIMES_ROMAN_24,
    GLUT_BITMAP_HELVETICA_10,
    GLUT_BITMAP_HELVETICA_12,
    GLUT_BITMAP_HELVETICA_18,
) = FONTS


def glyph_source() -> str:
    """Say where the glyphs in use come from: "freeglut", or "Hershey-Fonts and Pillow"."""
    return typefaces().source


def glutBitmapCharacter(font: object, character: object, *_more: object) -> None:
    """Draw one character at the raster position and move that on by its width."""
    face, code = _bitmap_face(font), _code(character)
    if face is not None and 0 < code < 256:
        _draw_bitmaps(face, [bytes([code])])


def glutBitmapString(font: object, string: object, *_more: object) -> None:
    """Draw text from the raster position on; a newline goes back below the line's start."""
    face, lines = _bitmap_face(font), _lines(string)
    if face is not None:
        _draw_bitmaps(face, lines)


def glutBitmapWidth(font: object, character: object, *_more: object) -> int:
    """How many pixels wide a character is."""
    face, code = _bitmap_face(font), _code(character)
    return face.glyphs[code].width if face is not None and 0 < code < 256 else 0


def glutBitmapLength(font: object, string: object, *_more: object) -> int:
    """How many pixels wide a text's longest line is."""
    face, lines = _bitmap_face(font), _lines(string)
    return 0 if face is None else max(sum(face.glyphs[code].width for code in line) for line in lines)


def glutBitmapHeight(font: object, *_more: object) -> int:
    """How many pixels a line of text is high."""
    face = _bitmap_face(font)
    return 0 if face is None else face.height


def glutStrokeCharacter(font: object, character: object, *_more: object) -> None:
    """Draw one character in lines at the origin, and translate the current matrix by its width."""
    face, code = _stroke_face(font), _code(character)
    if face is not None and 0 <= code < 256:
        _draw_strokes(face, (bytes([code]),))


def glutStrokeString(font: object, string: object, *_more: object) -> None:
    """Draw text in lines from the origin on, and translate the current matrix to its end."""
    face, lines = _stroke_face(font), _lines(string)
    if face is not None:
        _draw_strokes(face, lines)


def glutStrokeWidthf(font: object, character: object, *_more: object) -> float:
    """How wide a character is, in the units of its own space."""
    face, code = _stroke_face(font), _code(character)
    return 0.0 if face is None else face.glyph(code).advance


def glutStrokeWidth(font: object, character: object, *_more: object) -> int:
    """How wide a character is, rounded."""
    return int(glutStrokeWidthf(font, character) + 0.5)


def glutStrokeLengthf(font: object, string: object, *_more: object) -> float:
    """How wide a text's longest line is, in the units of the characters' own space."""
    face, lines = _stroke_face(font), _lines(string)
    return 0.0 if face is None else max(sum(face.glyph(code).advance for code in line) for line in lines)


def glutStrokeLength(font: object, string: object, *_more: object) -> int:
    """How wide a text's longest line is, rounded."""
    return int(glutStrokeLengthf(font, string) + 0.5)


def glutStrokeHeight(font: object, *_more: object) -> float:
    """How high a line of text is, in the units of the characters' own space."""
    face = _stroke_face(font)
    return 0.0 if face is None else face.height


def _draw_bitmaps(face: BitmapFace, lines: Sequence[bytes]) -> None:
    """Draw lines of text, each next one below the start of the one before."""
    dome = sessions.current().dome
    if dome is not None and dome.write(_bitmaps(face, lines)):
        return
    GL.glPushClientAttrib(GL.GL_CLIENT_PIXEL_STORE_BIT)
    try:
        for setting in _UNPACKING:
            GL.glPixelStorei(getattr(GL, setting), 0)
        GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
        for number, line in enumerate(lines):
            if number > 0:
                back = sum(face.glyphs[code].width for code in lines[number - 1])
                # One blank pixel, for inside a display list Mesa reports an error at a bitmap of none.
                GL.glBitmap(1, 1, 0, 0, -back, -face.height, b"\0")
            for code in line:
                glyph = face.glyphs[code]
                GL.glBitmap(glyph.width, face.height, *face.origin, glyph.width, 0, glyph.pixels)
    finally:
        GL.glPopClientAttrib()


def _bitmaps(face: BitmapFace, lines: Sequence[bytes]) -> list[Bitmap]:
    """The same as bitmaps one after the other."""
    from domeshim.record.bitmaps import Bitmap  # noqa: PLC0415 - only a program that writes pays

    found: list[Bitmap] = []
    for number, line in enumerate(lines):
        if number > 0:
            back = sum(face.glyphs[code].width for code in lines[number - 1])
            found.append(Bitmap(0, 0, (0, 0), (-back, -face.height), b""))
        found += [_bitmap(face, code) for code in line]
    return found


@lru_cache(maxsize=2048)
def _bitmap(face: BitmapFace, code: int) -> Bitmap:
    from domeshim.record.bitmaps import Bitmap  # noqa: PLC0415 - as above

    glyph = face.glyphs[code]
    rows = np.frombuffer(glyph.rows, np.uint8).reshape(face.height, -1)
    pixels = np.unpackbits(rows, axis=1)[:, : glyph.width].tobytes()
    return Bitmap(glyph.width, face.height, face.origin, (glyph.width, 0), pixels)


_UNPACKING = (
    "GL_UNPACK_SWAP_BYTES",
    "GL_UNPACK_LSB_FIRST",
    "GL_UNPACK_ROW_LENGTH",
    "GL_UNPACK_SKIP_ROWS",
    "GL_UNPACK_SKIP_PIXELS",
)


def _draw_strokes(face: StrokeFace, lines: tuple[bytes, ...]) -> None:
    from domeshim.GLUT.arrays import draw_lines  # noqa: PLC0415 - only a program that writes pays
    from domeshim.GLUT.typefaces.layout import lettering  # noqa: PLC0415

    text = lettering(face, lines)
    if text.lines.size:
        draw_lines(text.vertices, text.lines, text.strips)
    if any(text.end):
        GL.glTranslatef(*text.end, 0.0)


def _bitmap_face(font: object) -> BitmapFace | None:
    found = font_of(font, "bitmap")
    return None if found is None else typefaces().bitmaps[found.name]


def _stroke_face(font: object) -> StrokeFace | None:
    found = font_of(font, "stroke")
    return None if found is None else typefaces().strokes[found.name]


def _code(character: Any) -> int:
    """A character's code from an int, a ctypes number, or a str or bytes of length 1."""
    if isinstance(character, str | bytes | bytearray):
        return ord(character)
    return int(getattr(character, "value", character))


def _lines(text: Any) -> tuple[bytes, ...]:
    """The lines of a text up to its first NUL, a byte a character; what Latin-1 has not becomes "?"."""
    if isinstance(text, str):
        codes = text.encode("latin-1", "replace")
    elif isinstance(text, ctypes._Pointer):
        codes = ctypes.string_at(text) if text else b""
    else:
        content = getattr(text, "value", text)
        codes = b"" if content is None else bytes(content)
    return tuple(codes.split(b"\0", 1)[0].split(b"\n"))
