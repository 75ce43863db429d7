"""What the program hears of keys, mouse, windows and menus; the screen's events are put in by hand."""

from __future__ import annotations

import ctypes
from typing import Any

import glfw
import numpy as np
import pytest

from domeshim import GLUT
from domeshim.GLUT.state import GlutWindow
from domeshim.options import Options
from domeshim.session import Session
from domeshim.window.contract import WindowEvents


def hear(log: list[tuple[Any, ...]]) -> list[tuple[Any, ...]]:
    GLUT.glutMainLoopEvent()
    heard = log.copy()
    log.clear()
    return heard


def test_letters_come_as_bytes_by_their_characters(screen: WindowEvents, log: list[Any]) -> None:
    screen.pointer_moved(70.0, 55.0)
    screen.key(glfw.KEY_Q, True, glfw.MOD_SHIFT)
    screen.character(ord("A"))  # as on a French keyboard
    screen.key(glfw.KEY_Q, False, 0)
    screen.character(0xE9)
    screen.character(0x20AC)  # beyond a byte
    assert hear(log) == [
        ("passive", 70, 55),
        ("key", b"A", 70, 55, 1),
        ("key up", b"A", 70, 55, 0),
        ("key", b"\xe9", 70, 55, 0),
    ]


@pytest.mark.parametrize(
    ("key", "modifiers", "typed"),
    [
        (glfw.KEY_ESCAPE, 0, b"\x1b"),
        (glfw.KEY_ENTER, 0, b"\r"),
        (glfw.KEY_KP_ENTER, 0, b"\r"),
        (glfw.KEY_BACKSPACE, 0, b"\b"),
        (glfw.KEY_TAB, 0, b"\t"),
        (glfw.KEY_DELETE, 0, b"\x7f"),
        (glfw.KEY_A, glfw.MOD_CONTROL, b"\x01"),
        (glfw.KEY_Z, glfw.MOD_CONTROL, b"\x1a"),
        (glfw.KEY_1, glfw.MOD_CONTROL, b"1"),
        (glfw.KEY_X, glfw.MOD_ALT, b"x"),
        (glfw.KEY_X, glfw.MOD_ALT | glfw.MOD_SHIFT, b"X"),
    ],
)
def test_keys_without_a_character_type_all_the_same(
    screen: WindowEvents, log: list[Any], key: int, modifiers: int, typed: bytes
) -> None:
    screen.key(key, True, modifiers)
    screen.key(key, False, modifiers)
    assert hear(log) == [("key", typed, 0, 0, modifiers), ("key up", typed, 0, 0, modifiers)]


@pytest.mark.parametrize(
    ("key", "number"),
    [
        (glfw.KEY_F1, GLUT.GLUT_KEY_F1),
        (glfw.KEY_F12, GLUT.GLUT_KEY_F12),
        (glfw.KEY_LEFT, GLUT.GLUT_KEY_LEFT),
        (glfw.KEY_UP, GLUT.GLUT_KEY_UP),
        (glfw.KEY_RIGHT, GLUT.GLUT_KEY_RIGHT),
        (glfw.KEY_DOWN, GLUT.GLUT_KEY_DOWN),
        (glfw.KEY_PAGE_UP, GLUT.GLUT_KEY_PAGE_UP),
        (glfw.KEY_PAGE_DOWN, GLUT.GLUT_KEY_PAGE_DOWN),
        (glfw.KEY_HOME, GLUT.GLUT_KEY_HOME),
        (glfw.KEY_END, GLUT.GLUT_KEY_END),
        (glfw.KEY_INSERT, GLUT.GLUT_KEY_INSERT),
        (glfw.KEY_NUM_LOCK, 109),
        (glfw.KEY_LEFT_SHIFT, 112),
        (glfw.KEY_RIGHT_SHIFT, 113),
        (glfw.KEY_LEFT_CONTROL, 114),
        (glfw.KEY_RIGHT_CONTROL, 115),
        (glfw.KEY_LEFT_ALT, 116),
        (glfw.KEY_RIGHT_ALT, 117),
    ],
)
def test_special_keys_have_their_numbers(screen: WindowEvents, log: list[Any], key: int, number: int) -> None:
    screen.key(key, True, 0)
    screen.key(key, False, 0)
    assert hear(log) == [("special", number, 0, 0, 0), ("special up", number, 0, 0, 0)]


def test_held_keys_repeat_unless_told_not_to(screen: WindowEvents, log: list[Any]) -> None:
    def hold() -> list[Any]:
        for pressed in (True, True, True, False):
            screen.key(glfw.KEY_A, pressed, 0)
            if pressed:
                screen.character(ord("a"))
        return [name for name, *_ in hear(log)]

    assert hold() == ["key", "key", "key", "key up"]
    GLUT.glutIgnoreKeyRepeat(1)
    assert hold() == ["key", "key up"]
    GLUT.glutIgnoreKeyRepeat(0)
    GLUT.glutSetKeyRepeat(GLUT.GLUT_KEY_REPEAT_OFF)
    assert hold() == ["key", "key up"]


def test_mouse_buttons_motion_and_entry(screen: WindowEvents, log: list[Any]) -> None:
    screen.pointer_entered(True)
    screen.pointer_moved(10.7, 20.2)
    for button in (0, 1, 2):
        screen.button(button, True, glfw.MOD_CONTROL)
        screen.pointer_moved(11.0 + button, 20.0)
        screen.button(button, False, 0)
    screen.pointer_entered(False)
    assert hear(log) == [
        ("entry", GLUT.GLUT_ENTERED),
        ("passive", 10, 20),
        ("mouse", GLUT.GLUT_LEFT_BUTTON, GLUT.GLUT_DOWN, 10, 20, 2),
        ("motion", 11, 20),
        ("mouse", GLUT.GLUT_LEFT_BUTTON, GLUT.GLUT_UP, 11, 20, 0),
        ("mouse", GLUT.GLUT_RIGHT_BUTTON, GLUT.GLUT_DOWN, 11, 20, 2),
        ("motion", 12, 20),
        ("mouse", GLUT.GLUT_RIGHT_BUTTON, GLUT.GLUT_UP, 12, 20, 0),
        ("mouse", GLUT.GLUT_MIDDLE_BUTTON, GLUT.GLUT_DOWN, 12, 20, 2),
        ("motion", 13, 20),
        ("mouse", GLUT.GLUT_MIDDLE_BUTTON, GLUT.GLUT_UP, 13, 20, 0),
        ("entry", GLUT.GLUT_LEFT),
    ]


def test_the_wheel_is_buttons_or_a_wheel_callback(screen: WindowEvents, log: list[Any]) -> None:
    screen.wheel(0, 0.5)
    assert hear(log) == []
    screen.wheel(0, 0.5)
    screen.wheel(0, -1)
    assert [(button, state) for _, button, state, *_ in hear(log)] == [(3, 0), (3, 1), (4, 0), (4, 1)]
    GLUT.glutMouseWheelFunc(lambda *args: log.append(args))
    screen.wheel(1, -2)
    assert hear(log) == [(0, -1, 0, 0), (0, -1, 0, 0), (1, 1, 0, 0)]


def test_none_takes_a_callback_back(screen: WindowEvents, log: list[Any]) -> None:
    GLUT.glutMouseFunc(None)
    GLUT.glutPassiveMotionFunc(0)
    screen.button(0, True, 0)
    screen.button(0, False, 0)
    screen.pointer_moved(1, 1)
    assert hear(log) == []


def test_modifiers_are_known_in_input_callbacks_alone(
    window: GlutWindow, capsys: pytest.CaptureFixture[str]
) -> None:
    assert GLUT.glutGetModifiers() == -1
    assert "outside an input callback" in capsys.readouterr().err


def test_resizing_sets_the_viewport_or_calls_reshape_once_a_size(
    window: GlutWindow, glut_session: Session
) -> None:
    from OpenGL import GL

    glut_session.window_size = None
    GLUT.glutReshapeWindow(100, 80)
    GLUT.glutMainLoopEvent()
    assert list(GL.glGetIntegerv(GL.GL_VIEWPORT)) == [0, 0, 100, 80]
    sizes: list[tuple[int, int]] = []
    GLUT.glutReshapeFunc(lambda *size: sizes.append(size))
    GLUT.glutReshapeWindow(120, 90)
    window.surface.events.resized(120, 90)
    GLUT.glutMainLoopEvent()
    assert sizes == [(120, 90)]
    assert (GLUT.glutGet(GLUT.GLUT_WINDOW_WIDTH), GLUT.glutGet(GLUT.GLUT_WINDOW_HEIGHT)) == (120, 90)


def test_a_size_from_outside_overrides_the_program(window: GlutWindow, glut_session: Session) -> None:
    GLUT.glutReshapeWindow(100, 80)
    GLUT.glutFullScreen()
    GLUT.glutMainLoopEvent()
    assert window.size == window.surface.size == (256, 192)


def test_the_program_keeps_its_size_in_a_frame_of_another(glut_session: Session) -> None:
    glut_session.options = Options(enabled=True, frame=(400, 300))
    glut_session.window_size = None
    GLUT.glutInit()
    GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE)
    GLUT.glutInitWindowSize(200, 100)
    GLUT.glutCreateWindow("framed")
    sizes: list[tuple[int, int]] = []
    places: list[tuple[int, int]] = []
    GLUT.glutReshapeFunc(lambda *size: sizes.append(size))
    GLUT.glutPassiveMotionFunc(lambda *place: places.append(place))
    GLUT.glutDisplayFunc(GLUT.glutSwapBuffers)
    assert glut_session.glut is not None
    assert glut_session.glut.current is not None
    surface = glut_session.glut.current.surface
    surface.events.pointer_moved(200, 150)
    GLUT.glutMainLoopEvent()
    GLUT.glutReshapeWindow(100, 100)
    surface.events.pointer_moved(200, 150)
    GLUT.glutMainLoopEvent()
    assert surface.size == (400, 300)
    assert sizes == [(200, 100), (100, 100)]
    assert places == [(100, 50), (50, 50)]


def test_the_user_closing_a_window_ends_the_program(screen: WindowEvents, log: list[Any]) -> None:
    GLUT.glutCloseFunc(lambda: log.append(("close", GLUT.glutGetWindow())))
    screen.close_asked()
    with pytest.raises(SystemExit) as ended:
        GLUT.glutMainLoopEvent()
    assert ended.value.code == 0
    assert log == [("close", 1)]


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: GLUT.glutInitWindowSize(640 / 2, 240), "Size: width must be an integer, not float 320.0"),
        (lambda: GLUT.glutTimerFunc(16.7, print, 0), "milliseconds must be an integer"),
        (lambda: GLUT.glutCreateWindow(3), "title must be str or bytes, not int 3"),
        (lambda: GLUT.glutKeyboardFunc("f"), "a function or None is needed, not str 'f'"),
    ],
)
def test_wrong_arguments_are_refused_as_by_stock(window: GlutWindow, call: Any, words: str) -> None:
    with pytest.raises(ctypes.ArgumentError, match=words):
        call()


def test_arguments_too_many_are_passed_over_as_by_stock(glut_session: Session) -> None:
    GLUT.glutInit()
    GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE, GLUT.GLUT_DEPTH)
    GLUT.glutInitWindowSize(300, 200, 1)
    window = GLUT.glutCreateWindow("title", 300, 200)
    GLUT.glutSolidCube(1, 1, 1)
    GLUT.glutSolidIcosahedron(1)
    GLUT.glutBitmapCharacter(GLUT.GLUT_BITMAP_9_BY_15, 65, 0)
    GLUT.glutSetWindow(window, 0)
    assert GLUT.glutGet(GLUT.GLUT_INIT_WINDOW_WIDTH, 0) == 300


def test_integers_of_all_kinds_are_taken(window: GlutWindow) -> None:
    GLUT.glutInitWindowSize(np.int32(300), ctypes.c_int(200))
    assert GLUT.glutGet(GLUT.GLUT_INIT_WINDOW_WIDTH) == 300
    assert GLUT.glutGet(GLUT.GLUT_INIT_WINDOW_HEIGHT) == 200


def test_glut_init_takes_its_arguments_out(glut_session: Session) -> None:
    left = GLUT.glutInit(["prog", "-geometry", "320x240+5+6", "mine", "-iconic", b"-sync"])
    assert left == [b"prog", b"mine"]
    assert GLUT.glutGet(GLUT.GLUT_INIT_WINDOW_WIDTH) == 320
    assert GLUT.glutGet(GLUT.GLUT_INIT_WINDOW_Y) == 6
    assert GLUT.glutInit("again") == ("again",)


def test_glut_init_without_arguments(glut_session: Session) -> None:
    assert GLUT.glutInit() == [b"foo"]


@pytest.mark.parametrize(
    ("words", "mode"),
    [
        ("rgb double depth>=16 samples~8", GLUT.GLUT_DOUBLE | GLUT.GLUT_DEPTH | GLUT.GLUT_MULTISAMPLE),
        (b"rgba single stencil", GLUT.GLUT_ALPHA | GLUT.GLUT_STENCIL),
        ("double samples=0", GLUT.GLUT_DOUBLE),
    ],
)
def test_display_strings(glut_session: Session, words: Any, mode: int) -> None:
    GLUT.glutInit()
    GLUT.glutInitDisplayString(words)
    assert GLUT.glutGet(GLUT.GLUT_INIT_DISPLAY_MODE) == mode


def test_the_window_answers_for_what_it_holds(window: GlutWindow) -> None:
    assert GLUT.glutGet(GLUT.GLUT_WINDOW_DEPTH_SIZE) >= 16
    assert GLUT.glutGet(GLUT.GLUT_WINDOW_NUM_SAMPLES) == 0
    assert GLUT.glutGet(GLUT.GLUT_WINDOW_DOUBLEBUFFER) == 1
    assert GLUT.glutGet(GLUT.GLUT_WINDOW_RED_SIZE) == 8
    assert GLUT.glutGet(GLUT.GLUT_WINDOW_PARENT) == 0
    assert GLUT.glutGet(12345) == -1
    assert GLUT.glutExtensionSupported("GL_ARB_multisample") == 1
    assert GLUT.glutExtensionSupported(b"GL_NO_such") == 0
    assert GLUT.glutGetProcAddress("glClear")
    assert GLUT.glutDeviceGet(GLUT.GLUT_HAS_MOUSE) == 1
    assert GLUT.glutLayerGet(GLUT.GLUT_OVERLAY_POSSIBLE) == 0


def test_game_mode_is_a_window_and_back(window: GlutWindow) -> None:
    GLUT.glutGameModeString("640x480:32@60")
    assert GLUT.glutGameModeGet(GLUT.GLUT_GAME_MODE_WIDTH) == 640
    number = GLUT.glutEnterGameMode()
    assert GLUT.glutGetWindow() == number != window.number
    assert GLUT.glutGameModeGet(GLUT.GLUT_GAME_MODE_ACTIVE) == 1
    GLUT.glutLeaveGameMode()
    assert GLUT.glutGetWindow() == window.number
    assert GLUT.glutGameModeGet(GLUT.GLUT_GAME_MODE_ACTIVE) == 0
