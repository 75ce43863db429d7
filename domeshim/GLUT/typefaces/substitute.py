"""Faces for machines without freeglut: Hershey's Roman simplex, from which GLUT's strokes were made, for the
strokes, and Pillow's own typeface for the bitmaps.
"""

from __future__ import annotations

import numpy as np
from HersheyFonts import HersheyFonts
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from domeshim.GLUT.typefaces.faces import BitmapFace, BitmapGlyph, StrokeFace, StrokeGlyph, Typefaces

_CODES = range(32, 127)
_STROKE_HEIGHT = 152.381
_UNIT = 100 / 21
"""GLUT's capitals are 100 high, Hershey's 21; so parentheses reach from -33.33 to 119.05."""
_BASE_LINE = 9.0
"""Hershey's y of the baseline, y down."""
_MONO_ADVANCE = 104.762
_LEAST_INK = 96
"""A pixel is set where a letter covers more than this of it, of 255."""

# The advances of GLUT's proportional strokes, characters 32 to 126 (measured with glutStrokeWidthf).
_ROMAN_ADVANCES = (
    *(104.762, 26.624, 51.435, 79.489, 76.207, 96.574, 101.758, 13.62, 47.173, 47.533, 59.439, 97.254),
    *(26.064, 100.754, 26.484, 82.107, 77.067, 66.53, 77.647, 77.047, 80.169, 77.687, 73.805, 77.227),
    *(77.667, 74.065, 26.224, 26.304, 81.61, 97.254, 81.61, 73.903, 74.365, 80.491, 83.627, 84.489),
    *(85.287, 78.185, 78.745, 89.769, 89.087, 21.3, 59.999, 79.327, 71.323, 97.211, 88.807, 88.83),
    *(85.667, 88.09, 82.367, 80.827, 71.947, 89.487, 81.61, 100.518, 72.367, 79.65, 73.747, 46.113),
    *(78.207, 46.393, 90.23, 104.062, 83.571, 66.603, 70.463, 68.923, 70.263, 68.523, 38.655, 70.983),
    *(71.021, 28.864, 36.231, 62.521, 19.34, 123.962, 70.881, 71.745, 70.803, 70.743, 49.495, 62.321),
    *(39.315, 71.161, 60.603, 80.491, 56.401, 66.065, 61.821, 41.63, 23.78, 41.47, 91.274),
)

# Pixels: the letters' size, their cell's width or None where each has its own, the line's height, its depth.
_BITMAPS = {
    "8_BY_13": (13, 8, 14, 3),
    "9_BY_15": (15, 9, 16, 4),
    "TIMES_ROMAN_10": (10, None, 14, 4),
    "TIMES_ROMAN_24": (24, None, 29, 7),
    "HELVETICA_10": (10, None, 14, 3),
    "HELVETICA_12": (12, None, 16, 4),
    "HELVETICA_18": (18, None, 23, 5),
}


def substitute_typefaces() -> Typefaces:
    """All nine faces from Hershey-Fonts and Pillow, in GLUT's sizes; the strokes' advances are GLUT's."""
    bitmaps = {font: _bitmap_face(*measures) for font, measures in _BITMAPS.items()}
    return Typefaces("Hershey-Fonts and Pillow", bitmaps, _stroke_faces())


def _stroke_faces() -> dict[str, StrokeFace]:
    hershey = HersheyFonts()
    hershey.load_default_font("rowmans")
    letters = hershey.glyphs_for_text("".join(map(chr, _CODES)))
    shapes = [[np.array(strip, float) for strip in letter.strokes] for letter in letters]
    roman = [_roman_glyph(strips, advance) for strips, advance in zip(shapes, _ROMAN_ADVANCES, strict=True)]
    mono = [_stroke_glyph(strips, _MONO_ADVANCE, 0.0) for strips in shapes]
    return {name: _stroke_face(glyphs) for name, glyphs in (("ROMAN", roman), ("MONO_ROMAN", mono))}


def _roman_glyph(strips: list[NDArray[np.float64]], advance: float) -> StrokeGlyph:
    """The drawn part in the middle of its advance."""
    x = np.concatenate([strip[:, 0] for strip in strips]) if strips else np.zeros(1)
    return _stroke_glyph(strips, advance, float(x.min() + x.max()) / 2)


def _stroke_glyph(strips: list[NDArray[np.float64]], advance: float, middle: float) -> StrokeGlyph:
    """Put Hershey's x = middle in the middle of the advance, and his baseline on y = 0."""
    scaled = [(strip - (middle, _BASE_LINE)) * (_UNIT, -_UNIT) + (advance / 2, 0) for strip in strips]
    return StrokeGlyph(advance, tuple(strip.astype(np.float32) for strip in scaled))


def _stroke_face(glyphs: list[StrokeGlyph]) -> StrokeFace:
    return StrokeFace(_STROKE_HEIGHT, (*(None for _ in range(_CODES.start)), *glyphs, None))


def _bitmap_face(size: int, cell: int | None, height: int, depth: int) -> BitmapFace:
    font = ImageFont.load_default(size)
    drawn = {*_CODES, *range(160, 256)}
    letters = [chr(code) if code in drawn else " " for code in range(256)]
    glyphs = [_bitmap_glyph(font, letter, cell, height, depth) for letter in letters]
    return BitmapFace(height, (0.0, float(depth)), tuple(glyphs))


def _bitmap_glyph(
    font: ImageFont.FreeTypeFont | ImageFont.ImageFont, letter: str, cell: int | None, height: int, depth: int
) -> BitmapGlyph:
    """Draw one letter in black and white; narrow one that is too wide for its cell."""
    length = font.getlength(letter)
    width = cell or round(length)
    natural = max(width, round(length))
    image = Image.new("L", (natural, height))
    draw = ImageDraw.Draw(image)
    draw.text(((natural - length) / 2, height - depth), letter, fill=255, font=font, anchor="ls")
    ink = np.asarray(image.resize((width, height), Image.Resampling.BOX)) > _LEAST_INK
    return BitmapGlyph(width, np.packbits(ink[::-1], axis=1).tobytes())
