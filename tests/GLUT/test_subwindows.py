"""Windows inside others, off screen: their pictures, their places, who hears of the mouse and the keys."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from OpenGL import GL

from domeshim import GLUT
from domeshim.GLUT.state import GlutWindow
from domeshim.measure.pixels import read_pixels
from domeshim.session import Session
from domeshim.window.contract import Window, WindowEvents

WIDTH, HEIGHT = 256, 192
GREY, RED, GREEN, BLUE = (51, 51, 51), (255, 0, 0), (0, 255, 0), (0, 0, 255)


class Pictures:
    """Keeps what the session shows; each is (height, width, 3), the top row first."""

    def __init__(self) -> None:
        self.seen: list[np.ndarray] = []

    def frame_finished(self, window: Window, number: int) -> None:
        assert number == len(self.seen) + self.before + 1
        width, height = window.size
        self.seen.append(np.frombuffer(read_pixels(width, height), np.uint8).reshape(height, width, 3))

    before = 0


@pytest.fixture
def pictures(glut_session: Session, window: GlutWindow) -> Pictures:
    shown = Pictures()
    shown.before = glut_session.frames
    glut_session.listeners.append(shown)
    show(GREY)
    return shown


def show(colour: tuple[int, int, int], swap: bool = True) -> None:
    """Have the current window drawn in one colour, which stays set in its context."""
    GL.glClearColor(*np.divide(colour, 255), 1)

    def display() -> None:
        GL.glClear(GL.GL_COLOR_BUFFER_BIT)
        GLUT.glutSwapBuffers() if swap else GL.glFlush()

    GLUT.glutDisplayFunc(display)


def inside(parent: int, x: int, y: int, width: int, height: int, colour: tuple[int, int, int]) -> int:
    number = GLUT.glutCreateSubWindow(parent, x, y, width, height)
    show(colour)
    return number


def expected(*rectangles: tuple[int, int, int, int, tuple[int, int, int]]) -> np.ndarray:
    picture = np.full((HEIGHT, WIDTH, 3), GREY, np.uint8)
    for x, y, width, height, colour in rectangles:
        picture[y : y + height, x : x + width] = colour
    return picture


def shown_next(pictures: Pictures) -> np.ndarray:
    before = len(pictures.seen)
    GLUT.glutMainLoopEvent()
    assert len(pictures.seen) == before + 1, "one picture of all windows a round"
    return pictures.seen[-1]


def test_each_subwindow_lies_in_its_rectangle_in_one_picture(window: GlutWindow, pictures: Pictures) -> None:
    inside(window.number, 10, 20, 100, 50, RED)
    inside(window.number, 60, 40, 80, 90, GREEN)
    found = shown_next(pictures)
    np.testing.assert_array_equal(found, expected((10, 20, 100, 50, RED), (60, 40, 80, 90, GREEN)))


def test_what_leaves_the_window_around_it_is_cut(window: GlutWindow, pictures: Pictures) -> None:
    outer = inside(window.number, 200, 100, 100, 200, RED)
    inside(outer, 20, 0, 500, 30, GREEN)
    GLUT.glutPositionWindow(20, -10)
    expectation = expected((200, 100, 56, 92, RED), (220, 100, 36, 20, GREEN))
    np.testing.assert_array_equal(shown_next(pictures), expectation)


def test_one_that_is_drawn_alone_changes_its_part_alone(window: GlutWindow, pictures: Pictures) -> None:
    inside(window.number, 10, 20, 30, 40, RED)
    number = inside(window.number, 100, 20, 30, 40, GREEN)
    shown_next(pictures)
    GLUT.glutSetWindow(number)
    GL.glClearColor(0, 0, 1, 1)
    GLUT.glutPostRedisplay()
    expectation = expected((10, 20, 30, 40, RED), (100, 20, 30, 40, BLUE))
    np.testing.assert_array_equal(shown_next(pictures), expectation)


def test_a_window_drawn_twice_in_a_round_gives_two_pictures(window: GlutWindow, pictures: Pictures) -> None:
    number = inside(window.number, 10, 20, 30, 40, RED)
    shown_next(pictures)
    GLUT.glutSetWindow(number)
    for colour in (GREEN, BLUE):
        GL.glClearColor(*np.divide(colour, 255), 1)
        GL.glClear(GL.GL_COLOR_BUFFER_BIT)
        GLUT.glutSwapBuffers()
    GLUT.glutMainLoopEvent()
    assert [tuple(picture[30, 20].tolist()) for picture in pictures.seen] == [RED, GREEN, BLUE]


def test_a_single_buffered_one_is_finished_with_its_display(window: GlutWindow, pictures: Pictures) -> None:
    GLUT.glutInitDisplayMode(GLUT.GLUT_SINGLE)
    GLUT.glutCreateSubWindow(window.number, 10, 20, 30, 40)
    show(RED, swap=False)
    np.testing.assert_array_equal(shown_next(pictures), expected((10, 20, 30, 40, RED)))


def test_a_window_that_draws_nothing_itself_shows_those_inside(
    window: GlutWindow, pictures: Pictures
) -> None:
    GLUT.glutDisplayFunc(lambda: None)
    inside(window.number, 10, 20, 30, 40, RED)
    GLUT.glutMainLoopEvent()
    assert tuple(pictures.seen[-1][30, 20]) == RED
    assert not pictures.seen[-1][100:].any()


def test_position_size_order_and_visibility(window: GlutWindow, pictures: Pictures) -> None:
    red = inside(window.number, 10, 20, 50, 50, RED)
    green = inside(window.number, 30, 40, 50, 50, GREEN)
    over = expected((10, 20, 50, 50, RED), (30, 40, 50, 50, GREEN))
    np.testing.assert_array_equal(shown_next(pictures), over)
    GLUT.glutSetWindow(red)
    GLUT.glutPopWindow()
    under = expected((30, 40, 50, 50, GREEN), (10, 20, 50, 50, RED))
    np.testing.assert_array_equal(shown_next(pictures), under)
    GLUT.glutPushWindow()
    np.testing.assert_array_equal(shown_next(pictures), over)
    GLUT.glutPositionWindow(100, 5)
    GLUT.glutReshapeWindow(20, 30)
    apart = expected((100, 5, 20, 30, RED), (30, 40, 50, 50, GREEN))
    np.testing.assert_array_equal(shown_next(pictures), apart)
    assert [GLUT.glutGet(q) for q in (GLUT.GLUT_WINDOW_X, GLUT.GLUT_WINDOW_Y)] == [100, 5]
    assert [GLUT.glutGet(q) for q in (GLUT.GLUT_WINDOW_WIDTH, GLUT.GLUT_WINDOW_HEIGHT)] == [20, 30]
    GLUT.glutHideWindow()
    np.testing.assert_array_equal(shown_next(pictures), expected((30, 40, 50, 50, GREEN)))
    GLUT.glutShowWindow()
    np.testing.assert_array_equal(shown_next(pictures), apart)
    GLUT.glutDestroyWindow(green)
    np.testing.assert_array_equal(shown_next(pictures), expected((100, 5, 20, 30, RED)))


def test_they_are_counted_and_go_with_the_window_around_them(
    window: GlutWindow, capsys: pytest.CaptureFixture[str]
) -> None:
    outer = inside(window.number, 5, 6, 50, 40, RED)
    inner = inside(outer, 5, 6, 50, 40, RED)
    assert GLUT.glutGet(GLUT.GLUT_WINDOW_PARENT) == outer
    GLUT.glutSetWindow(window.number)
    assert GLUT.glutGet(GLUT.GLUT_WINDOW_NUM_CHILDREN) == 1
    GLUT.glutDestroyWindow(outer)
    assert GLUT.glutGet(GLUT.GLUT_WINDOW_NUM_CHILDREN) == 0
    GLUT.glutSetWindow(inner)
    assert "not found" in capsys.readouterr().err
    assert GLUT.glutCreateSubWindow(99, 1, 1, 1, 1) == 0


def test_negative_places_count_from_the_other_side(window: GlutWindow) -> None:
    GLUT.glutCreateSubWindow(window.number, -10, 20, 100, -30)
    queries = GLUT.GLUT_WINDOW_X, GLUT.GLUT_WINDOW_Y, GLUT.GLUT_WINDOW_WIDTH, GLUT.GLUT_WINDOW_HEIGHT
    assert [GLUT.glutGet(q) for q in queries] == [WIDTH - 110, 20, 100, HEIGHT - 50]


def test_lists_and_state_are_each_windows_own(window: GlutWindow) -> None:
    GL.glNewList(7, GL.GL_COMPILE)
    GL.glEndList()
    GL.glEnable(GL.GL_FOG)
    inside(window.number, 5, 6, 50, 40, RED)
    assert not GL.glIsList(7)
    assert not GL.glIsEnabled(GL.GL_FOG)
    GLUT.glutSetWindow(window.number)
    assert GL.glIsList(7)
    assert GL.glIsEnabled(GL.GL_FOG)


def test_a_glut_begun_anew_makes_one_picture_as_well(window: GlutWindow, pictures: Pictures) -> None:
    inside(window.number, 10, 20, 30, 40, RED)
    shown_next(pictures)
    GLUT.glutExit()
    GLUT.glutInit()
    GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE)
    outer = GLUT.glutCreateWindow("again")
    show(GREY)
    inside(outer, 50, 60, 30, 40, GREEN)
    np.testing.assert_array_equal(shown_next(pictures), expected((50, 60, 30, 40, GREEN)))


# The mouse and the keys.


@pytest.fixture
def family(window: GlutWindow) -> list[tuple[Any, ...]]:
    """A window, one in it at (20, 30), and one in that at (10, 10): what each hears."""
    heard: list[tuple[Any, ...]] = []

    def listen(name: str) -> None:
        def note(what: str) -> Any:
            return lambda *args: heard.append((name, what, *args))

        GLUT.glutMouseFunc(note("mouse"))
        GLUT.glutMotionFunc(note("motion"))
        GLUT.glutPassiveMotionFunc(note("passive"))
        GLUT.glutKeyboardFunc(note("key"))
        GLUT.glutKeyboardUpFunc(note("key up"))
        GLUT.glutEntryFunc(note("entry"))

    listen("top")
    outer = inside(window.number, 20, 30, 100, 80, RED)
    listen("outer")
    inside(outer, 10, 10, 50, 40, GREEN)
    listen("inner")
    GLUT.glutMainLoopEvent()
    return heard


def hear(heard: list[tuple[Any, ...]]) -> list[tuple[Any, ...]]:
    GLUT.glutMainLoopEvent()
    found = heard.copy()
    heard.clear()
    return found


def test_the_window_under_the_pointer_hears_in_its_own_coordinates(
    screen: WindowEvents, family: list[tuple[Any, ...]]
) -> None:
    screen.pointer_entered(True)
    screen.pointer_moved(200, 150)
    assert hear(family) == [("top", "entry", 1), ("top", "passive", 200, 150)]
    screen.pointer_moved(35, 47)
    assert hear(family) == [
        ("top", "entry", 0),
        ("outer", "entry", 1),
        ("inner", "entry", 1),
        ("inner", "passive", 5, 7),
    ]
    screen.key(ord("X"), True, 0)
    screen.character(ord("x"))
    assert hear(family) == [("inner", "key", b"x", 5, 7)]
    screen.button(0, True, 0)
    screen.pointer_moved(25, 35)
    assert hear(family) == [("inner", "mouse", 0, 0, 5, 7), ("inner", "motion", -5, -5)]
    screen.button(0, False, 0)
    assert hear(family) == [
        ("inner", "mouse", 0, 1, -5, -5),
        ("inner", "entry", 0),
        ("outer", "entry", 1),
    ]
    screen.key(ord("X"), False, 0)
    assert hear(family) == [("outer", "key up", b"x", 5, 5)]
    screen.pointer_entered(False)
    assert hear(family) == [("outer", "entry", 0), ("top", "entry", 0)]


def test_a_hidden_window_hears_nothing(screen: WindowEvents, family: list[tuple[Any, ...]]) -> None:
    GLUT.glutSetWindow(2)
    GLUT.glutHideWindow()
    GLUT.glutMainLoopEvent()
    screen.pointer_moved(35, 47)
    assert hear(family)[-1] == ("top", "passive", 35, 47)


def test_a_menu_of_a_small_one_lies_over_all(
    window: GlutWindow, screen: WindowEvents, pictures: Pictures
) -> None:
    chosen: list[tuple[int, int]] = []
    small = inside(window.number, 20, 30, 12, 12, RED)
    GLUT.glutCreateMenu(lambda value: chosen.append((value, GLUT.glutGetWindow())))
    for value in range(4):
        GLUT.glutAddMenuEntry("an entry of some length", value)
    GLUT.glutAttachMenu(GLUT.GLUT_RIGHT_BUTTON)
    shown_next(pictures)
    screen.pointer_moved(22, 32)
    screen.button(1, True, 0)
    screen.button(1, False, 0)
    assert (shown_next(pictures)[80, 24] == 191).all(), "a row of the menu, far outside of the small window"
    screen.pointer_moved(60, 32 + 2.5 * 18)
    screen.button(0, True, 0)
    screen.button(0, False, 0)
    np.testing.assert_array_equal(shown_next(pictures), expected((20, 30, 12, 12, RED)))
    assert chosen == [(2, small)]
