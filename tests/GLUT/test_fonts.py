from __future__ import annotations

import ctypes
import ctypes.util
from collections.abc import Iterator
from types import SimpleNamespace

import numpy as np
import pytest
from OpenGL import GL

from domeshim.GLUT import fonts
from domeshim.GLUT.typefaces import freeglut, load
from domeshim.GLUT.typefaces.faces import BitmapFace, Typefaces
from domeshim.GLUT.typefaces.freeglut import UnreadableFontError, read_typefaces
from domeshim.GLUT.typefaces.substitute import substitute_typefaces
from domeshim.record.bitmaps import Bitmap
from domeshim.window.contract import SurfaceFormat, WindowEvents
from domeshim.window.offscreen import OffscreenBackend
from tests.GLUT.freeglut_runs import beside_freeglut

STROKES = (fonts.GLUT_STROKE_ROMAN, fonts.GLUT_STROKE_MONO_ROMAN)
BITMAPS = tuple(font for font in fonts.FONTS if font not in STROKES)
PRINTABLE = range(33, 127)


@pytest.fixture
def installed() -> Typefaces:
    library = load.glut_library()
    if library is None:
        pytest.skip("freeglut's library is not installed: there are no fonts of its own to read")
    return read_typefaces(library)


@pytest.mark.parametrize("font", fonts.FONTS, ids=str)
def test_text_equals_freeglut(font: fonts.Font) -> None:
    found = beside_freeglut("fonts")
    assert found["source"] == "freeglut"
    seen = found["fonts"][str(font)]
    theirs, ours = seen["widths"]
    assert ours == theirs
    assert sum(theirs) > 256
    assert seen["lengths"]["ours"] == seen["lengths"]["theirs"] > 100
    assert seen["heights"][0] == seen["heights"][1] > 10
    assert seen["error"] == 0
    assert seen["moved"] < 0.001
    for picture in seen["pictures"].values():
        assert picture["drawn"] > 30
        assert picture["any"] <= (0 if font in BITMAPS else picture["drawn"] / 500)


def test_another_library_is_refused() -> None:
    with pytest.raises(UnreadableFontError, match="fgFontFixed8x13"):
        read_typefaces(ctypes.CDLL(ctypes.util.find_library("m")))


def test_other_content_is_refused(installed: Typefaces, monkeypatch: pytest.MonkeyPatch) -> None:
    shared = load.glut_library()
    monkeypatch.setitem(freeglut._BITMAPS, "8_BY_13", ("fgFontFixed9x15", "-misc-fixed-medium-r-normal--13-"))
    with pytest.raises(UnreadableFontError, match="not named"):
        read_typefaces(shared)
    monkeypatch.setitem(freeglut._BITMAPS, "8_BY_13", ("glutBitmapCharacter", "-misc"))
    with pytest.raises(UnreadableFontError):
        read_typefaces(shared)


def test_a_wrong_address_is_an_error_and_no_crash() -> None:
    with freeglut._own_memory() as memory:
        for address in (0, 8, 2**47 - 1, 2**64 - 1):
            with pytest.raises(UnreadableFontError):
                memory.read(address, 64)


def test_without_the_library_substitutes_draw(monkeypatch: pytest.MonkeyPatch, fresh: None) -> None:
    monkeypatch.setattr(load, "PLATFORM", SimpleNamespace(GLUT=None))
    assert fonts.glyph_source() == "Hershey-Fonts and Pillow"
    assert fonts.glutBitmapLength(fonts.GLUT_BITMAP_8_BY_13, "dome") == 32
    assert fonts.glutStrokeLength(fonts.GLUT_STROKE_MONO_ROMAN, "dome") == 419


def test_an_unknown_library_is_warned_about(monkeypatch: pytest.MonkeyPatch, fresh: None) -> None:
    monkeypatch.setattr(load, "PLATFORM", SimpleNamespace(GLUT=ctypes.CDLL(ctypes.util.find_library("m"))))
    with pytest.warns(RuntimeWarning, match="not as expected"):
        assert fonts.glyph_source() == "Hershey-Fonts and Pillow"


@pytest.fixture
def fresh() -> Iterator[None]:
    load.typefaces.cache_clear()
    yield
    load.typefaces.cache_clear()


def test_substitutes_have_glut_s_measures(installed: Typefaces) -> None:
    substitutes = substitute_typefaces()
    for font in BITMAPS:
        ours, theirs = substitutes.bitmaps[font.name], installed.bitmaps[font.name]
        assert (ours.height, ours.origin) == (theirs.height, theirs.origin)
        total = [sum(face.glyphs[code].width for code in PRINTABLE) for face in (ours, theirs)]
        assert total[0] == pytest.approx(total[1], rel=0.06)
    for font in STROKES:
        ours, theirs = substitutes.strokes[font.name], installed.strokes[font.name]
        assert ours.height == pytest.approx(theirs.height)
        for code in range(128):
            advances = ours.glyph(code).advance, theirs.glyph(code).advance
            assert advances[0] == pytest.approx(advances[1], abs=0.001) or code == 127


def test_substitute_strokes_are_nearly_glut_s(installed: Typefaces) -> None:
    substitutes = substitute_typefaces()
    for font in STROKES:
        near = 0
        for code in PRINTABLE:
            ours = np.concatenate(substitutes.strokes[font.name].glyph(code).strips)
            theirs = np.concatenate(installed.strokes[font.name].glyph(code).strips)
            boxes = [np.array([points.min(axis=0), points.max(axis=0)]) for points in (ours, theirs)]
            near += bool((abs(boxes[0] - boxes[1]) < 7).all())
        assert near >= 0.9 * len(PRINTABLE)


@pytest.mark.parametrize("font", BITMAPS, ids=str)
def test_substitute_bitmaps_can_be_read(font: fonts.Font) -> None:
    face = substitute_typefaces().bitmaps[font.name]
    assert len(face.glyphs) == 256
    assert all(len(glyph.rows) == face.height * ((glyph.width + 7) // 8) for glyph in face.glyphs)
    letters = [face.glyphs[code].rows for code in PRINTABLE]
    assert all(any(rows) for rows in letters)
    assert len(set(letters)) >= 90
    assert not any(face.glyphs[ord(" ")].rows)
    above, below = ink_rows(face, "A"), ink_rows(face, "g")
    assert above.min() == face.origin[1] > below.min()
    assert above.max() < face.height


def ink_rows(face: BitmapFace, letter: str) -> np.ndarray:
    """The rows, from the bottom, in which a letter has ink."""
    rows = np.frombuffer(face.glyphs[ord(letter)].rows, np.uint8).reshape(face.height, -1)
    return np.flatnonzero(rows.any(axis=1))


def test_text_may_come_in_any_form() -> None:
    font = fonts.GLUT_BITMAP_HELVETICA_18
    wanted = fonts.glutBitmapLength(font, b"Dome")
    assert wanted > 0
    array = (ctypes.c_ubyte * 5)(*b"Dome\0")
    pointer = ctypes.cast(array, ctypes.POINTER(ctypes.c_ubyte))
    forms = ["Dome", bytearray(b"Dome"), array, pointer, list(b"Dome")]
    forms += [ctypes.c_char_p(b"Dome"), np.frombuffer(b"Dome", np.uint8), b"Dome\0and more", "Dome\n"]
    assert [fonts.glutBitmapLength(font, form) for form in forms] == [wanted] * len(forms)
    assert fonts.glutBitmapLength(font, None) == fonts.glutBitmapLength(font, "") == 0
    widths = {fonts.glutBitmapWidth(font, form) for form in (68, "D", b"D", ctypes.c_int(68), np.int32(68))}
    assert len(widths) == 1
    assert fonts.glutBitmapLength(font, "\u4e2d") == fonts.glutBitmapLength(font, "?")


def test_freeglut_s_pointers_and_numbers_are_fonts_too(installed: Typefaces) -> None:
    for number, font in enumerate(fonts.FONTS):
        pointer = load.PLATFORM.getGLUTFontPointer(str(font))
        measure = fonts.glutStrokeWidth if font in STROKES else fonts.glutBitmapWidth
        widths = [measure(form, "W") for form in (font, pointer, pointer.value, number)]
        assert widths == [widths[0]] * 4
        assert widths[0] > 0


@pytest.mark.parametrize("wrong", [None, 99, "Helvetica", fonts.GLUT_STROKE_ROMAN])
def test_a_wrong_font_is_warned_about_and_draws_nothing(wrong: object) -> None:
    with pytest.warns(RuntimeWarning, match="no bitmap font"):
        assert fonts.glutBitmapWidth(wrong, "A") == 0
    with pytest.warns(RuntimeWarning, match="no bitmap font"):
        fonts.glutBitmapString(wrong, "A")


def test_fonts_print_their_names() -> None:
    assert str(fonts.GLUT_BITMAP_8_BY_13) == "GLUT_BITMAP_8_BY_13"
    assert fonts.GLUT_STROKE_ROMAN != fonts.GLUT_STROKE_MONO_ROMAN


@pytest.fixture(scope="module")
def screen() -> Iterator[None]:
    backend = OffscreenBackend()
    window = backend.open_window("fonts", (200, 100), None, SurfaceFormat(), WindowEvents())
    window.make_current()
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glOrtho(0, 200, 0, 100, -1, 1)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    yield
    backend.close()


def letters_on_screen() -> bytes:
    GL.glClear(GL.GL_COLOR_BUFFER_BIT)
    GL.glLoadIdentity()
    GL.glRasterPos2f(5, 80)
    fonts.glutBitmapString(fonts.GLUT_BITMAP_TIMES_ROMAN_24, "Dome\nshim")
    GL.glTranslatef(100, 20, 0)
    GL.glScalef(0.2, 0.2, 1)
    fonts.glutStrokeString(fonts.GLUT_STROKE_ROMAN, "ab\nc")
    return bytes(GL.glReadPixels(0, 0, 200, 100, GL.GL_RGB, GL.GL_UNSIGNED_BYTE))


def test_pixel_storage_is_the_programs_own(screen: None) -> None:
    wanted = letters_on_screen()
    assert any(wanted)
    odd = {GL.GL_UNPACK_LSB_FIRST: 1, GL.GL_UNPACK_ALIGNMENT: 8}
    odd |= {GL.GL_UNPACK_SKIP_ROWS: 3, GL.GL_UNPACK_ROW_LENGTH: 50}
    for setting, value in odd.items():
        GL.glPixelStorei(setting, value)
    try:
        assert letters_on_screen() == wanted
        assert {setting: GL.glGetIntegerv(setting) for setting in odd} == odd
    finally:
        for setting in odd:
            GL.glPixelStorei(setting, 4 if setting == GL.GL_UNPACK_ALIGNMENT else 0)


def test_text_in_a_display_list(screen: None) -> None:
    wanted = letters_on_screen()
    number = GL.glGenLists(1)
    GL.glNewList(number, GL.GL_COMPILE)
    fonts.glutBitmapString(fonts.GLUT_BITMAP_TIMES_ROMAN_24, "Dome\nshim")
    GL.glTranslatef(100, 20, 0)
    GL.glScalef(0.2, 0.2, 1)
    fonts.glutStrokeString(fonts.GLUT_STROKE_ROMAN, "ab\nc")
    GL.glEndList()
    GL.glClear(GL.GL_COLOR_BUFFER_BIT)
    GL.glLoadIdentity()
    GL.glRasterPos2f(5, 80)
    GL.glCallList(number)
    assert bytes(GL.glReadPixels(0, 0, 200, 100, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)) == wanted


def test_on_the_dome_text_is_its_bitmaps_one_after_the_other(monkeypatch: pytest.MonkeyPatch) -> None:
    written: list[Bitmap] = []
    dome = SimpleNamespace(write=lambda bitmaps: bool(written.extend(bitmaps)) or True)
    monkeypatch.setattr(fonts.sessions, "current", lambda: SimpleNamespace(dome=dome))
    fonts.glutBitmapString(fonts.GLUT_BITMAP_HELVETICA_18, b"Hi\nj")
    face = load.typefaces().bitmaps[fonts.GLUT_BITMAP_HELVETICA_18.name]
    widths = [face.glyphs[ord(letter)].width for letter in "Hij"]
    moves = [(widths[0], 0), (widths[1], 0), (-widths[0] - widths[1], -face.height), (widths[2], 0)]
    assert [bitmap.move for bitmap in written] == moves
    tall = np.frombuffer(written[0].pixels, np.uint8).reshape(face.height, widths[0])
    rows = np.frombuffer(face.glyphs[ord("H")].rows, np.uint8).reshape(face.height, -1)
    assert (tall == np.unpackbits(rows, axis=1)[:, : widths[0]]).all()
    assert tall.any()
    assert written[0].origin == face.origin
