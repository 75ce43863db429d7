"""domeshim capture, as a user calls it, on small GLUT programs."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.waiting import LONGEST

ROOT = Path(__file__).resolve().parent.parent.parent
Capture = Callable[..., subprocess.CompletedProcess[str]]

# Frame n has the colour (n, 10, 20) all over, and a white bottom row.
PROGRAM = """
from OpenGL.GL import *
from OpenGL.GLUT import *
import atexit, sys, threading, time
n = 0
def display():
    global n
    n += 1
    before(n)
    glDisable(GL_SCISSOR_TEST)
    glClearColor(n / 255, 10 / 255, 20 / 255, 0)
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_SCISSOR_TEST)
    glScissor(0, 0, 1000, 1)
    glClearColor(1, 1, 1, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    swap()
    glutPostRedisplay()
def before(n): pass
def swap(): glutSwapBuffers()
def start():
    glutInit()
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB)
    glutInitWindowSize(300, 200)
    glutCreateWindow("program")
    glutDisplayFunc(display)
{}
start()
glutMainLoop()
"""


@pytest.fixture
def capture(tmp_path: Path) -> Capture:
    """Captures the program with these lines added; the picture goes to folder/picture.png."""

    def capture(added: str = "", *options: str, whole: str | None = None, **variables: str):
        (tmp_path / "prog.py").write_text(PROGRAM.replace("{}", added) if whole is None else whole)
        environ = {**os.environ, "PYTHONPATH": str(ROOT), **variables}
        del environ["PYOPENGL_PLATFORM"]
        defaults = ["--mode", "monitor", "--size", "40x30", "--output", "folder/picture.png"]
        command = [sys.executable, "-m", "domeshim", "capture", *defaults, *options, "prog.py"]
        return subprocess.run(
            command, cwd=tmp_path, env=environ, capture_output=True, text=True, timeout=LONGEST
        )

    return capture


@pytest.fixture
def picture(tmp_path: Path) -> Callable[[], np.ndarray]:
    def picture() -> np.ndarray:
        assert [path.name for path in (tmp_path / "folder").iterdir()] == ["picture.png"]
        image = Image.open(tmp_path / "folder" / "picture.png")
        assert (image.format, image.mode) == ("PNG", "RGB")
        return np.asarray(image)

    return picture


@pytest.mark.parametrize("frame", [1, 2, 7])
def test_the_wanted_frame_is_written_the_right_way_up(capture, picture, frame):
    result = capture("", "--frame", str(frame))
    assert (result.returncode, result.stdout, result.stderr) == (0, "", "")
    pixels = picture()
    assert pixels.shape == (30, 40, 3)
    assert (pixels[:-1] == (frame, 10, 20)).all()
    assert (pixels[-1] == 255).all()


def test_one_number_is_a_square_and_an_old_picture_is_replaced(capture, picture):
    capture("", "--frame", "3")
    capture("", "--size", "16")
    assert picture().shape == (16, 16, 3)
    assert picture()[0, 0].tolist() == [1, 10, 20]


def test_the_program_prints_ends_and_cleans_up_as_itself(capture, picture):
    result = capture(
        "print('out'); print('err', file=sys.stderr); atexit.register(print, 'at exit')\n"
        "import os; os.chdir('/')\n"
    )
    assert (result.returncode, result.stdout, result.stderr) == (0, "out\nat exit\n", "err\n")
    assert picture().size


def test_a_single_buffered_program_that_only_flushes(capture, picture):
    single = "def swap(): glFlush()\nGLUT_DOUBLE = GLUT_SINGLE\n"
    assert capture(single, "--frame", "2").returncode == 0
    assert picture()[0, 0].tolist() == [2, 10, 20]


def test_time_is_counted_in_frames(capture):
    times = "t0 = time.time()\ndef before(n): print(n, f'{time.time() - t0:.3f}', glutGet(700))\n"
    lines = capture(times, "--frame", "3", "--fps", "10").stdout.splitlines()
    assert lines == ["1 0.000 0", "2 0.100 100", "3 0.200 200"]


def test_the_programs_odd_reading_state_does_not_reach_the_picture(capture, picture):
    odd = "def before(n): glPixelStorei(GL_PACK_ALIGNMENT, 8); glPixelTransferf(GL_RED_SCALE, 0)\n"
    assert capture(odd, "--size", "41x30").returncode == 0
    assert (picture()[:-1] == (1, 10, 20)).all()


@pytest.mark.parametrize(
    "swallowing",
    [
        "def swap():\n    try: glutSwapBuffers()\n    except: print('swallowed')\n",
        "def swap():\n    try: glutSwapBuffers()\n    except BaseException as e: print('swallowed')\n",
    ],
)
def test_a_program_that_stops_every_exception_ends_at_its_next_picture(capture, picture, swallowing):
    result = capture(swallowing)
    assert (result.returncode, result.stdout, result.stderr) == (0, "swallowed\n", "")
    assert picture()[0, 0].tolist() == [1, 10, 20]


def test_a_thread_that_never_ends_does_not_hold_the_finished_capture(capture, picture):
    result = capture("e = threading.Event(); threading.Thread(target=e.wait).start()\n")
    assert (result.returncode, result.stderr) == (0, "")
    assert picture().size


@pytest.mark.parametrize(
    ("whole", "frame", "stderr"),
    [
        (
            "print('hello')\n",
            1,
            "domeshim: the program ended after 0 pictures; picture 1 was wanted: "
            "it opened no GL window, or never swapped its buffers nor flushed\n",
        ),
        (
            "import sys; sys.exit('no such texture')\n",
            1,
            "no such texture\ndomeshim: the program ended after 0 pictures; picture 1 was wanted\n",
        ),
        (
            PROGRAM.replace("{}", "def before(n):\n    if n == 3: sys.exit(0)\n"),
            5,
            "domeshim: the program ended after 2 pictures; picture 5 was wanted\n",
        ),
    ],
)
def test_a_program_that_ends_too_early(capture, tmp_path, whole, frame, stderr):
    result = capture("", "--frame", str(frame), whole=whole)
    assert (result.returncode, result.stderr) == (1, stderr)
    assert not list((tmp_path / "folder").iterdir())


@pytest.mark.parametrize("place", ["1 / 0\n", "def before(n): 1 / 0\n"])
def test_the_programs_exception_is_its_own(capture, place):
    result = capture(place)
    assert result.returncode == 1
    trace, _, after = result.stderr.partition("ZeroDivisionError: division by zero\n")
    assert trace.startswith("Traceback (most recent call last):")
    assert "prog.py" in trace
    assert "domeshim" not in trace
    assert len(after.splitlines()) <= 1


@pytest.mark.parametrize(
    "hang",
    [
        "while True: time.sleep(1)\n",
        "threading.Event().wait()\n",
        "def swap(): threading.Event().wait()\n",
    ],
)
def test_a_program_without_pictures_is_given_up_by_real_time(capture, hang):
    began = time.monotonic()
    whole = "print('before')\n" + PROGRAM.replace("{}", hang)
    result = capture("", "--timeout", "3", whole=whole)
    assert time.monotonic() - began > 3
    assert (result.returncode, result.stdout) == (1, "before\n")
    assert result.stderr.startswith("domeshim: nothing came for 3 seconds after 0 pictures; ")
    assert result.stderr.count("\n") == 1


@pytest.mark.parametrize(
    ("options", "line"),
    [
        (["--size", "axb"], "--size=axb: not a size; accepted: S or WxH in pixels, each 1 to 16384"),
        (["--size", "0"], "--size=0: out of range"),
        (["--frame", "0"], "Invalid value for '--frame'"),
        (["--mode", "cave"], "Invalid value for '--mode'"),
        (["--fps", "0"], "Invalid value for '--fps'"),
        (["--tilt", "x"], "--tilt=x: not a number; accepted: degrees from -180 to 180"),
        (["--output", "prog.py/picture.png"], "--output=prog.py/picture.png: "),
    ],
)
def test_bad_options_are_one_line_and_status_2(capture, options, line):
    result = capture("", *options)
    assert (result.returncode, result.stdout) == (2, "")
    assert line in result.stderr
    assert result.stderr.startswith("domeshim: ")
    assert result.stderr.count("\n") == 1


def test_a_picture_that_cannot_be_written_is_one_line(capture, tmp_path):
    (tmp_path / "folder" / "picture.png").mkdir(parents=True)
    result = capture("", "--output", "folder/picture.png/../picture.png")
    assert result.returncode in (1, 2)
    assert result.stderr.count("\n") == 1
    assert result.stderr.startswith("domeshim: ")


def test_the_dome_is_a_disc_and_the_monitor_a_full_frame(capture, picture):
    wide = """
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
def display():
    glClearColor(0, 0, 1, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(90, 1, .1, 100)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glBegin(GL_QUADS)
    for x, y in ((-1, 0), (0, -1), (1, 0), (0, 1)): glVertex3f(x, y, -2)
    glEnd()
    glutSwapBuffers()
glutInit()
glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB)
glutCreateWindow("wide")
glutDisplayFunc(display)
glutMainLoop()
"""
    sides = {}
    for mode in ("monitor", "dome"):
        result = capture("", "--mode", mode, "--size", "200", whole=wide, DOME_HUD="off")
        assert (result.returncode, result.stderr) == (0, "")
        pixels = picture()
        assert (pixels[100, 100] == 255).all()
        sides[mode] = np.count_nonzero((pixels[100] == 255).all(axis=1))
        assert (pixels[2, 2] == (0, 0, 255 if mode == "monitor" else 0)).all()
    assert sides["monitor"] == pytest.approx(100, abs=2)
    # A corner stands atan(1/2) = 26.57 degrees from the axis, of the 90 that reach the rim.
    assert sides["dome"] == pytest.approx(2 * 100 * 26.57 / 90, abs=2)


@pytest.mark.parametrize("dome", ["0", "1"])
def test_the_mode_counts_not_the_variable(capture, picture, dome):
    assert capture("", DOME=dome).returncode == 0
    assert (picture()[:-1] == (1, 10, 20)).all()


@pytest.mark.parametrize("mode", ["monitor", "dome"])
@pytest.mark.parametrize(
    ("drawing", "ending"),
    [
        ("glRectf(-1, -1, 1, 1)", "glFlush()"),
        ("glutSolidCube(1)", "glutSwapBuffers()"),
        ("gluSphere(gluNewQuadric(), 1, 4, 4)", "glFlush()"),
    ],
)
def test_a_single_buffered_program_that_never_clears(capture, picture, mode, drawing, ending):
    program = f"""
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
def display():
    {drawing}
    {ending}
glutInit()
glutInitDisplayMode(GLUT_SINGLE)
glutCreateWindow("never clears")
glutDisplayFunc(display)
glutMainLoop()
"""
    result = capture("", "--mode", mode, "--size", "32", "--frame", "1", whole=program)
    assert (result.returncode, result.stderr) == (0, "")
    assert picture()[16, 16].tolist() == [255, 255, 255]


def test_a_swap_finishes_the_picture_of_a_single_buffered_program_that_has_drawn_nothing(capture, picture):
    single = "def before(n): glutSwapBuffers()\nGLUT_DOUBLE = GLUT_SINGLE\n"
    assert capture(single, "--frame", "2").returncode == 0
    assert picture()[0, 0].tolist() == [1, 10, 20]


@pytest.mark.parametrize("mode", ["monitor", "dome"])
def test_glx_can_be_imported_and_has_no_function(capture, mode):
    whole = (
        "from OpenGL.GLX import *\nfrom OpenGL.GLX.MESA.swap_control import glXSwapIntervalMESA\n" + PROGRAM
    )
    checked = "\nassert not glXGetCurrentContext and not glXSwapIntervalMESA\nprint('no function')\n"
    ended = capture("", "--mode", mode, whole=whole.replace("{}", checked))
    assert ended.returncode == 0, ended.stderr
    assert "no function" in ended.stdout


FIXED_VIEW = """
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
def display():
    glViewport(0, 0, 120, 100)
    glClear(GL_COLOR_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    {}
    glMatrixMode(GL_MODELVIEW)
    glColor3f(1, 1, 1)
    glBegin(GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        glVertex3f(x, y, -2)
    glEnd()
    glutSwapBuffers()
glutInit()
glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB)
glutInitWindowSize(120, 100)
glutCreateWindow("program")
glutDisplayFunc(display)
glutMainLoop()
"""


@pytest.mark.parametrize("view", ["gluPerspective(60, 1.2, 0.1, 10)", "glOrtho(-1.8, 1.8, -1.5, 1.5, -3, 3)"])
def test_a_view_as_large_as_the_program_asked_for_fills_the_dome_at_any_size(capture, picture, view):
    seen = {}
    for width, height in ((120, 100), (480, 400)):
        ended = capture(
            "", "--mode", "dome", "--size", f"{width}x{height}", whole=FIXED_VIEW.replace("{}", view)
        )
        assert ended.returncode == 0, ended.stderr
        rows, columns = np.nonzero(picture()[..., 0] > 128)
        seen[width] = np.array([rows.mean() / height, columns.mean() / width, len(rows) / (height * width)])
    assert seen[120][2] > 0.03
    np.testing.assert_allclose(seen[480], seen[120], atol=0.01)


def test_a_view_of_another_size_stays_an_inset(capture, picture):
    smaller = FIXED_VIEW.replace("{}", "gluPerspective(60, 1.2, 0.1, 10)").replace(
        "120, 100)", "110, 100)", 1
    )
    ended = capture("", "--mode", "dome", "--size", "480x400", whole=smaller)
    assert ended.returncode == 0, ended.stderr
    rows, columns = np.nonzero(picture()[..., 0] > 128)
    assert columns.mean() < 200
    assert rows.mean() > 220
