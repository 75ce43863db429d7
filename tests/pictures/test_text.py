"""Text of bitmaps is recorded a line at a time, and stands as GL would have drawn it call by call."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest
from OpenGL.error import GLError

from domeshim.record.bitmaps import Bitmap
from domeshim.state.panel_pixels import PanelPixels
from tests.pictures.beside import GL, SIZE, Beside, Scene, flat, looking
from tests.pictures.test_flat_pixels import WIDE

LETTERS = np.packbits(np.random.default_rng(8).integers(0, 2, (128, 8, 8)), axis=-1).reshape(128, 8)
TEXT = b"dome shim"
BASE = 40
Places = Sequence[tuple[float, float, float]]
"""x, y, size."""


def letter(gl: GL, code: int) -> None:
    gl.glBitmap(8, 8, 0, 1, 9, 0, LETTERS[code])


def at_once(gl: GL, text: bytes) -> None:
    for code in text:
        letter(gl, code)


def with_colours_between(gl: GL, text: bytes) -> None:
    for code in text:
        gl.glColor3f(code / 128, 0, 1)
        letter(gl, code)


def letter_by_letter(gl: GL, text: bytes) -> None:
    """A question comes between, so that each is drawn by itself."""
    for code in text:
        letter(gl, code)
        gl.glGetIntegerv(gl.GL_LIST_BASE)


def from_memory_used_again(gl: GL, text: bytes) -> None:
    memory = np.zeros(8, np.uint8)
    for code in text:
        memory[:] = LETTERS[code]
        gl.glBitmap(8, 8, 0, 1, 9, 0, memory)
    memory[:] = 255


def unpacked_in_turns(gl: GL, text: bytes) -> None:
    """The last bit first, and not, and rows of two bytes, and of one."""
    for number, code in enumerate(text):
        lines = np.unpackbits(LETTERS[code][:, None], axis=1)
        lines = np.pad(lines, ((0, 0), (0, 8 * (number % 2))))
        gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1 + number % 2)
        gl.glPixelStorei(gl.GL_UNPACK_LSB_FIRST, number % 2)
        rows = np.packbits(lines, axis=1, bitorder="little" if number % 2 else "big")
        gl.glBitmap(8, 8, 0, 1, 9, 0, rows)
    gl.glPixelStorei(gl.GL_UNPACK_LSB_FIRST, 0)


def font(gl: GL) -> None:
    """A list for each letter but the space, and none for that."""
    for code in set(TEXT) - {32}:
        gl.glNewList(BASE + code, gl.GL_COMPILE)
        letter(gl, code)
        gl.glEndList()
    gl.glListBase(BASE)


def lists_at_once(gl: GL, text: bytes) -> None:
    font(gl)
    gl.glCallLists(text)


def list_by_list(gl: GL, text: bytes) -> None:
    font(gl)
    for code in text:
        gl.glCallList(BASE + code)


def lists_that_do_more(gl: GL, text: bytes) -> None:
    font(gl)
    gl.glNewList(BASE + text[1], gl.GL_COMPILE)
    letter(gl, text[1])
    gl.glRectf(-0.1, -0.1, 30, 30)
    letter(gl, text[1])
    gl.glEndList()
    gl.glCallLists(text)


def a_line_in_a_list(gl: GL, text: bytes) -> None:
    gl.glNewList(7, gl.GL_COMPILE_AND_EXECUTE)
    at_once(gl, text)
    gl.glEndList()
    gl.glCallList(7)


def coloured_by_hand(gl: GL, text: bytes) -> None:
    letter_by_letter(gl, text)
    gl.glColor3f(text[-1] / 128, 0, 1)


def more_by_hand(gl: GL, text: bytes) -> None:
    letter_by_letter(gl, text[:2])
    gl.glRectf(-0.1, -0.1, 30, 30)
    letter_by_letter(gl, text[1:])


WAYS: dict[Callable[[GL, bytes], None], Callable[[GL, bytes], None]] = {
    at_once: letter_by_letter,
    with_colours_between: coloured_by_hand,
    from_memory_used_again: letter_by_letter,
    unpacked_in_turns: letter_by_letter,
    lists_at_once: letter_by_letter,
    list_by_list: letter_by_letter,
    lists_that_do_more: more_by_hand,
    a_line_in_a_list: lambda gl, text: letter_by_letter(gl, 2 * text),
}
"""Ways to write, and what each must draw."""


def written(way: Callable[[GL, bytes], None], begin: Callable[[GL], None], places: Places) -> Scene:
    """A scene of lines over and under rectangles, and in their colours."""

    def scene(gl: GL) -> Any:
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        begin(gl)
        gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
        answers: list[float] = []
        for number, (x, y, size) in enumerate(places):
            gl.glColor3f(0, 0.5, number % 2)
            gl.glRectf(x, y, x + size, y + size)
            gl.glColor3f(1, number / 4, 0)
            gl.glRasterPos2f(x, y)
            way(gl, TEXT if way in _WITHOUT_SPACE else TEXT.replace(b" ", b""))
            gl.glRectf(x + size, y, x + 1.5 * size, y + size)
            answers += list(gl.glGetFloatv(gl.GL_CURRENT_RASTER_POSITION)[:2])
            answers += list(gl.glGetFloatv(gl.GL_CURRENT_RASTER_COLOR))
        return answers

    return scene


_WITHOUT_SPACE = lists_at_once, list_by_list, lists_that_do_more
"""A name that is no list does nothing."""
IN_THE_SCENE: Places = ((-0.7, -0.5, 0.2), (-0.2, 0.1, 0.1), (-0.4, 0.6, 0.15))
IN_THE_WINDOW: Places = ((30, 60, 30), (100, 130, 12), (70, 200, 20), (SIZE - 30, 100, 12))


@pytest.mark.parametrize("way", WAYS)
def test_text_at_points_of_the_scene(beside: Beside, way: Callable[[GL, bytes], None]) -> None:
    scene = written(way, lambda gl: looking(gl, depth=False), IN_THE_SCENE)
    monitor, dome = beside.monitor(scene), beside.through_dome(scene)
    beside.assert_equal(monitor.picture, dome.picture, name=f"scene {way.__name__}", wrong=0.01)
    np.testing.assert_allclose(dome.answer, monitor.answer, atol=0.02)


@pytest.mark.parametrize(
    ("way", "options"),
    [
        *((way, {}) for way in WAYS),
        *((way, {"stereo": "top-bottom"}) for way in (at_once, a_line_in_a_list)),
        *((way, {"method": "cubemap"}) for way in (lists_at_once, lists_that_do_more)),
    ],
    ids=str,
)
def test_text_on_the_panel(beside: Beside, way: Callable[[GL, bytes], None], options: dict[str, Any]) -> None:
    """Letter for letter it is where rectangles are (test_flat_pixels.py)."""
    wanted = beside.through_dome(written(WAYS[way], flat, IN_THE_WINDOW), **(WIDE | options))
    found = beside.through_dome(written(way, flat, IN_THE_WINDOW), **(WIDE | options))
    assert (wanted.picture > 0).any(-1).mean() > 0.002
    beside.assert_equal(wanted.picture, found.picture, name=f"{way.__name__} {options}", wrong=0.0001)
    np.testing.assert_allclose(found.answer, wanted.answer, atol=1e-3)


def test_a_line_is_drawn_together(beside: Beside, monkeypatch: pytest.MonkeyPatch) -> None:
    lengths: list[int] = []
    original = PanelPixels.write

    def write(panel: PanelPixels, bitmaps: Sequence[Bitmap]) -> None:
        lengths.append(len(bitmaps))
        original(panel, bitmaps)

    monkeypatch.setattr(PanelPixels, "write", write)
    for way in (at_once, with_colours_between, lists_at_once, list_by_list):
        beside.through_dome(written(way, flat, IN_THE_WINDOW[:1]), **WIDE)
    assert lengths == [len(TEXT) - 1] * 4


def test_text_that_is_not_seen_leaves_the_position_invalid(beside: Beside) -> None:
    def scene(gl: GL) -> Any:
        looking(gl)
        gl.glRectf(-0.5, -0.5, 0.5, 0.5)
        gl.glRasterPos3f(7, 0, 0)
        at_once(gl, TEXT)
        return gl.glGetBooleanv(gl.GL_CURRENT_RASTER_POSITION_VALID)

    assert not beside.equal(scene)


def test_feedback_tells_of_each_bitmap(beside: Beside) -> None:
    def scene(gl: GL) -> Any:
        looking(gl)
        gl.glRectf(-0.5, -0.5, 0.5, 0.5)
        gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
        font(gl)
        gl.glFeedbackBuffer(512, gl.GL_2D)
        gl.glRenderMode(gl.GL_FEEDBACK)
        gl.glRasterPos2f(0.1, 0.2)
        at_once(gl, TEXT)
        gl.glCallLists(TEXT)
        return [int(token) for token, *_ in gl.glRenderMode(gl.GL_RENDER)]

    assert len(beside.equal(scene)) == 2 * len(TEXT) - 1


def test_a_bitmap_of_no_size_is_an_error(beside: Beside) -> None:
    def scene(gl: GL) -> Any:
        looking(gl)
        gl.glRectf(-0.5, -0.5, 0.5, 0.5)
        gl.glRasterPos2f(0, 0)
        letter(gl, 65)
        with pytest.raises(GLError) as found:
            gl.glBitmap(-8, 8, 0, 1, 9, 0, LETTERS[65])
        return int(found.value.err)

    beside.equal(scene, wrong=0.01)


def test_letters_take_no_list_of_the_programs(beside: Beside) -> None:
    def scene(gl: GL, *, own: bool) -> None:
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        flat(gl)
        gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
        for number in range(2):
            gl.glRasterPos2f(60, 100 + 20 * number)
            at_once(gl, TEXT)
            for name in range(1, 20 if own else 1):
                gl.glNewList(name, gl.GL_COMPILE)
                gl.glEndList()

    pictures = [beside.through_dome(lambda gl, own=own: scene(gl, own=own), **WIDE).picture for own in (0, 1)]
    assert pictures[0].any()
    np.testing.assert_array_equal(*pictures)
