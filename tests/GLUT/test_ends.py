"""How programs end: exceptions, exits, closed windows, misuse."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.GLUT.program_runs import run_off_screen

PREFACE = """
import sys
from domeshim.GLUT import *
glutInit()
glutInitDisplayMode(GLUT_DOUBLE)
glutCreateWindow("x")
"""


def test_an_exception_ends_the_program_with_its_own_traceback(tmp_path: Path) -> None:
    done = run_off_screen(
        tmp_path,
        PREFACE
        + """
def inner():
    return 1 / 0
def display():
    glutSwapBuffers()
    inner()
glutDisplayFunc(display)
glutMainLoop()
print("never here")
""",
    )
    assert done.returncode == 1
    assert done.stdout == ""
    lines = done.stderr.splitlines()
    assert lines[0] == "Traceback (most recent call last):"
    assert [line.split(", ", 1)[1] for line in lines if line.startswith("  File")] == [
        "line 13, in display",
        "line 10, in inner",
    ]
    assert lines[-1] == "ZeroDivisionError: division by zero"


def test_an_exception_from_a_glut_call_shows_the_program_alone(tmp_path: Path) -> None:
    done = run_off_screen(
        tmp_path, PREFACE + "glutDisplayFunc(lambda: glutReshapeWindow(1.5, 2))\nglutMainLoop()\n"
    )
    assert done.returncode == 1
    assert "domeshim" + "/" not in done.stderr
    assert "glutReshapeWindow: width must be an integer, not float 1.5" in done.stderr


def test_keeping_going_prints_and_goes_on(tmp_path: Path) -> None:
    source = """
count = 0
def display():
    global count
    count += 1
    if count == 3:
        print("third")
        sys.exit(7)
    glutPostRedisplay()
    raise ValueError(count)
glutDisplayFunc(display)
glutMainLoop()
"""
    done = run_off_screen(tmp_path, PREFACE + source, "keep_going=True")
    assert (done.returncode, done.stdout) == (7, "third\n")
    assert done.stderr.count("ValueError: ") == 2


@pytest.mark.parametrize(
    ("last", "status"),
    [("sys.exit(0)", 0), ("sys.exit(3)", 3), ("raise SystemExit", 0), ("os._exit(5)", 5)],
)
def test_a_program_may_exit_from_a_callback(tmp_path: Path, last: str, status: int) -> None:
    source = f"def display(): {last}\nglutDisplayFunc(display)\nglutMainLoop()\n"
    done = run_off_screen(tmp_path, PREFACE + source)
    assert (done.returncode, done.stderr) == (status, "")


def test_a_keyboard_interrupt_passes_through(tmp_path: Path) -> None:
    source = """
def display(): raise KeyboardInterrupt
glutDisplayFunc(display)
try: glutMainLoop()
except KeyboardInterrupt: print("interrupted")
"""
    assert run_off_screen(tmp_path, PREFACE + source).stdout == "interrupted\n"


@pytest.mark.parametrize(
    ("option", "out"),
    [("", ""), ("glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_CONTINUE_EXECUTION)", "after\n")],
)
def test_closing_the_last_window_ends_loop_or_program(tmp_path: Path, option: str, out: str) -> None:
    source = f"""
{option}
def display():
    glutSwapBuffers()
    glutDestroyWindow(glutGetWindow())
glutDisplayFunc(display)
glutMainLoop()
print("after")
"""
    done = run_off_screen(tmp_path, PREFACE + source)
    assert (done.returncode, done.stdout, done.stderr) == (0, out, "")


NO_WINDOW = "Function <{}> called with no current window defined."


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ("glutCreateWindow('x')", "Function <glutCreateWindow> called without first calling 'glutInit'."),
        ("glutInit(); glutMainLoop()", "glutMainLoop called with no windows created."),
        ("glutInit(); glutPostRedisplay()", NO_WINDOW.format("glutPostRedisplay")),
        ("glutInit(); glutSwapBuffers()", NO_WINDOW.format("glutSwapBuffers")),
        (
            "glutInit(['a/b.py']); glutCreateWindow('x'); glutMainLoop()",
            "No display callback registered for window 1",
        ),
    ],
)
def test_misuse_is_one_line_and_status_one(tmp_path: Path, source: str, words: str) -> None:
    done = run_off_screen(tmp_path, f"from domeshim.GLUT import *\n{source}\nprint('never here')\n")
    program = "b.py" if "b.py" in source else "foo"
    assert (done.returncode, done.stdout, done.stderr) == (1, "", f"domeshim ({program}): ERROR: {words}\n")
