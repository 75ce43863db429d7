"""A GLUT program in a real window: keys and mouse by xdotool on a display of its own, closing, resizing."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.displays import needs_xvfb
from tests.GLUT.program_runs import run_on_screen, run_without_display

LISTENING = """
import subprocess
import sys
from OpenGL.GL import *
from domeshim.GLUT import *
from tests.waiting import Steps

said, shown = [], []

def say(*words):
    said.append(words)
    print(*words, flush=True)

def listen(name, modifiers=False):
    return lambda *args: say(name, *args, *([glutGetModifiers()] if modifiers else []))

def xdotool(commands):
    subprocess.run(["xdotool", *commands.split()], check=True)

def play(steps):
    steps = Steps(steps)
    def look(_):
        if steps.ended():
            glutLeaveMainLoop()
        else:
            glutTimerFunc(5, look, 0)
    glutTimerFunc(0, look, 0)
    glutMainLoop()

glutInit(sys.argv)
glutInitDisplayMode({mode})
glutInitWindowSize(200, 100)
glutInitWindowPosition(0, 0)
glutCreateWindow("listening")

def display():
    glClearColor(1, 0.5, 0, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    {show}()
    shown.append(1)

glutDisplayFunc(display)
"""


def listening(mode: str = "GLUT_DOUBLE", show: str = "glutSwapBuffers") -> str:
    return LISTENING.format(mode=mode, show=show)


def answers(out: str) -> dict[str, list[str]]:
    """Return what was said after each step."""
    said: dict[str, list[str]] = {"": []}
    step = ""
    for line in out.splitlines():
        if line.startswith("-- "):
            step = line[3:]
            said[step] = []
        else:
            said[step].append(line)
    return said


@needs_xvfb
def test_keys_and_mouse_arrive(tmp_path: Path) -> None:
    expected = {
        "mousemove 60 50": ["entry 1", "passive 60 50"],
        "key a": ["key b'a' 60 50 0", "key up b'a' 60 50 0"],
        "keydown shift key a keyup shift": [
            "special 112 60 50 0",
            "key b'A' 60 50 1",
            "key up b'A' 60 50 1",
            "special up 112 60 50 1",
        ],
        "keydown ctrl key c keyup ctrl": [
            "special 114 60 50 0",
            r"key b'\x03' 60 50 2",
            r"key up b'\x03' 60 50 2",
            "special up 114 60 50 2",
        ],
        "key Escape": [r"key b'\x1b' 60 50 0", r"key up b'\x1b' 60 50 0"],
        "key Return": [r"key b'\r' 60 50 0", r"key up b'\r' 60 50 0"],
        "key F1": ["special 1 60 50 0", "special up 1 60 50 0"],
        "key Left": ["special 100 60 50 0", "special up 100 60 50 0"],
        "click 3": ["mouse 2 0 60 50 0", "mouse 2 1 60 50 0"],
        "click 2": ["mouse 1 0 60 50 0", "mouse 1 1 60 50 0"],
        "click 4": ["mouse 3 0 60 50 0", "mouse 3 1 60 50 0"],
        "mousedown 1 mousemove 80 60 mouseup 1": ["mouse 0 0 60 50 0", "motion 80 60", "mouse 0 1 80 60 0"],
        "mousemove 600 500": ["entry 0"],
    }
    source = (
        listening()
        + """
glutKeyboardFunc(listen("key", True)); glutKeyboardUpFunc(listen("key up", True))
glutSpecialFunc(listen("special", True)); glutSpecialUpFunc(listen("special up", True))
glutMouseFunc(listen("mouse", True)); glutMotionFunc(listen("motion"))
glutPassiveMotionFunc(listen("passive")); glutEntryFunc(listen("entry"))
def steps():
    yield lambda: shown
    for commands, answers in EXPECTED.items():
        say("--", commands)
        awaited = len(said) + len(answers)
        xdotool(commands)
        yield lambda: len(said) >= awaited
play(steps())
""".replace("EXPECTED", repr(expected))
    )
    done = run_on_screen(tmp_path, source)
    assert (done.returncode, done.stderr) == (0, "")
    said = answers(done.stdout)
    del said[""]
    assert said == expected


@needs_xvfb
def test_resizing_hiding_and_full_screen_are_told_and_drawn(tmp_path: Path) -> None:
    source = (
        listening()
        + """
glutReshapeFunc(listen("reshape"))
glutVisibilityFunc(listen("visibility"))
def steps():
    yield lambda: len(said) == 2
    for number, move in enumerate([lambda: glutReshapeWindow(300, 200), glutHideWindow, glutShowWindow,
                                   glutFullScreen, glutFullScreenToggle]):
        move()
        yield lambda: len(said) == 3 + number
    glutPositionWindow(40, 30)
    yield lambda: (glutGet(GLUT_WINDOW_X), glutGet(GLUT_WINDOW_Y)) == (40, 30)
    say("screen", glutGet(GLUT_SCREEN_WIDTH))
play(steps())
"""
    )
    done = run_on_screen(tmp_path, source)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == [
        "reshape 200 100",
        "visibility 1",
        "reshape 300 200",
        "visibility 0",
        "visibility 1",
        "reshape 800 600",
        "reshape 300 200",
        "screen 800",
    ]


@needs_xvfb
@pytest.mark.parametrize("platform", ["glx", "egl"])
@pytest.mark.parametrize(("mode", "show"), [("GLUT_DOUBLE", "glutSwapBuffers"), ("GLUT_SINGLE", "glFlush")])
def test_what_is_drawn_is_on_the_screen_and_can_be_read(
    tmp_path: Path, platform: str, mode: str, show: str
) -> None:
    source = (
        listening(mode=mode, show=show)
        + """
import ctypes
x11 = ctypes.CDLL("libX11.so.6")
for name in ("XOpenDisplay", "XDefaultRootWindow", "XGetImage", "XGetPixel"):
    getattr(x11, name).restype = ctypes.c_void_p if "Pixel" not in name else ctypes.c_ulong
screen = ctypes.c_void_p(x11.XOpenDisplay(None))
root = ctypes.c_void_p(x11.XDefaultRootWindow(screen))
def seen():
    image = x11.XGetImage(screen, root, 100, 50, 1, 1, ctypes.c_ulong(0xFFFFFF), 2)
    return x11.XGetPixel(ctypes.c_void_p(image), 0, 0)
def steps():
    yield lambda: seen() in (0xff7f00, 0xff8000)
    if glutGet(GLUT_WINDOW_DOUBLEBUFFER) == 0:
        say(list(glReadPixels(5, 5, 1, 1, GL_RGB, GL_UNSIGNED_BYTE)))
play(steps())
"""
    )
    done = run_on_screen(tmp_path, source, platform)
    assert (done.returncode, done.stderr) == (0, "")
    read = [] if mode == "GLUT_DOUBLE" else ["[255, 127, 0]", "[255, 128, 0]"]
    assert done.stdout.splitlines() in ([[line] for line in read] or [[]])


@needs_xvfb
@pytest.mark.parametrize(
    ("action", "out"),
    [("GLUT_ACTION_EXIT", "closed\n"), ("GLUT_ACTION_GLUTMAINLOOP_RETURNS", "closed\nafter\n")],
)
def test_closing_the_window_by_its_frame(tmp_path: Path, action: str, out: str) -> None:
    source = (
        listening()
        + f"""
import glfw
glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, {action})
glutCloseFunc(lambda: say("closed"))
def close(_):
    # What a window manager does: WM_DELETE_WINDOW to the window. Xvfb has none.
    import ctypes
    from domeshim.session import current
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XInternAtom.restype = ctypes.c_ulong
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = ctypes.c_void_p(x11.XOpenDisplay(None))
    window = glfw.get_x11_window(current().glut.current.surface.handle)
    atoms = [x11.XInternAtom(display, name, 0) for name in (b"WM_PROTOCOLS", b"WM_DELETE_WINDOW")]
    message = (ctypes.c_long * 24)(33, 0, 0, 0, window, atoms[0], 32, atoms[1])
    x11.XSendEvent(display, ctypes.c_ulong(window), 0, ctypes.c_long(0), message)
    x11.XFlush(display)
glutTimerFunc(0, close, 0)
glutMainLoop()
say("after")
"""
    )
    done = run_on_screen(tmp_path, source)
    assert (done.returncode, done.stdout, done.stderr) == (0, out, "")


@needs_xvfb
def test_real_timers_take_real_time(tmp_path: Path) -> None:
    source = (
        listening()
        + """
import time
began = time.perf_counter()
def late(_):
    say(0.15 <= time.perf_counter() - began, 150 <= glutGet(GLUT_ELAPSED_TIME) < 150000)
    glutLeaveMainLoop()
glutTimerFunc(150, late, 0)
glutMainLoop()
"""
    )
    done = run_on_screen(tmp_path, source)
    assert (done.returncode, done.stdout, done.stderr) == (0, "True True\n", "")


def test_without_a_display_one_line_says_what_to_do(tmp_path: Path) -> None:
    done = run_without_display(tmp_path, "from domeshim.GLUT import *\nglutInit()\nglutCreateWindow('x')\n")
    assert done.returncode == 1
    assert done.stderr.count("\n") == 1
    for word in ("DISPLAY", "WAYLAND_DISPLAY", "domeshim capture"):
        assert word in done.stderr


FULL = """
from domeshim import session
from domeshim.options import Options
session.begin(session.Session(Options(enabled=True, display={display})))
import sys
from domeshim.GLUT import *
glutInit()
glutInitDisplayMode(GLUT_DOUBLE)
glutInitWindowSize(200, 100)
glutCreateWindow("full")
def display():
    glutSwapBuffers()
    print(session.current().glut.current.surface.size, glutGet(GLUT_WINDOW_WIDTH), flush=True)
    glutLeaveMainLoop()
glutDisplayFunc(display)
glutReshapeFunc(print)
glutTimerFunc(100000, sys.exit, 9)
glutMainLoop()
"""


@needs_xvfb
def test_the_dome_display_is_covered_and_the_program_keeps_its_size(tmp_path: Path) -> None:
    done = run_on_screen(tmp_path, FULL.format(display=0))
    assert (done.returncode, done.stdout, done.stderr) == (0, "200 100\n(800, 600) 200\n", "")


@needs_xvfb
def test_a_display_that_is_not_there_is_one_line(tmp_path: Path) -> None:
    done = run_on_screen(tmp_path, FULL.format(display=5))
    assert done.returncode == 1
    assert done.stderr == "domeshim (foo): ERROR: there is no display 5: 1 found, counted from 0\n"


@needs_xvfb
def test_a_window_is_put_under_others_and_over_them(tmp_path: Path) -> None:
    source = """
    import ctypes
    from domeshim.GLUT import *
    from domeshim.session import current
    import glfw

    def order():
        x11 = ctypes.CDLL("libX11.so.6")
        display = ctypes.c_void_p(glfw.get_x11_display())
        x11.XDefaultRootWindow.restype = ctypes.c_ulong
        root, parent, count = ctypes.c_ulong(), ctypes.c_ulong(), ctypes.c_uint()
        children = ctypes.POINTER(ctypes.c_ulong)()
        top = ctypes.c_ulong(x11.XDefaultRootWindow(display))
        found = (ctypes.byref(value) for value in (root, parent, children, count))
        x11.XQueryTree(display, top, *found)
        numbers = {glfw.get_x11_window(w.surface.handle): n for n, w in current().glut.windows.items()}
        return [numbers[children[k]] for k in range(count.value) if children[k] in numbers]

    glutInit()
    for title in "abc":
        glutCreateWindow(title)
        glutDisplayFunc(lambda: None)
    glutMainLoopEvent()
    glutSetWindow(3)
    glutPushWindow()
    print(order())
    glutSetWindow(1)
    glutPopWindow()
    print(order())
    """
    done = run_on_screen(tmp_path, source)
    assert done.stdout.splitlines() == ["[3, 1, 2]", "[3, 2, 1]"], done.stderr
