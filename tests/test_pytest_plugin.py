"""The fixture dome, in tests of a test suite of its own."""

from __future__ import annotations

import importlib.metadata
import subprocess
import sys
from pathlib import Path

import pytest

from tests.waiting import LONGEST

pytest_plugins = ["pytester"]

ROOT = Path(__file__).resolve().parent.parent
PROGRAM = """
import sys
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
def display():
    glClear(GL_COLOR_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(60, 1, .1, 10)
    glMatrixMode(GL_MODELVIEW); glLoadIdentity(); glTranslatef(0, 0, -3)
    glColor3f(*map(float, sys.argv[1:] or (1, .5, 0)))
    glRectf(-.7, -.5, .6, .8)
    glutSwapBuffers()
glutInit(sys.argv[:1]); glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB); glutCreateWindow("program")
glutDisplayFunc(display); glutMainLoop()
"""


@pytest.fixture
def suite(pytester, monkeypatch):
    """Runs pytest in a folder with prog.py and these tests, in a process of its own."""
    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    monkeypatch.delenv("PYOPENGL_PLATFORM", raising=False)
    pytester.makepyfile(prog=PROGRAM)

    def run(tests: str, *options: str) -> pytest.RunResult:
        pytester.makepyfile(test_it="from pathlib import Path\nPROG = Path('prog.py')\n" + tests)
        registered = any(
            entry.value == "domeshim.pytest_plugin"
            for entry in importlib.metadata.entry_points(group="pytest11")
        )
        loaded = () if registered else ("-p", "domeshim.pytest_plugin")
        return pytester.runpytest_subprocess(*loaded, *options, timeout=LONGEST)

    return run


def test_a_right_dome_passes_and_a_wrong_one_fails_with_a_picture(suite, pytester):
    result = suite(
        "def test_right(dome): dome.compare(PROG, size=128)\n"
        "def test_blank(dome): dome.compare(PROG, '0', '0', '0', size=64)\n",
        "--dome-output=kept",
    )
    result.assert_outcomes(passed=1, failed=1)
    result.stdout.fnmatch_lines(
        ["prog, picture 1, 64x64: could not tell: both pictures are blank", "  picture *"]
    )
    assert [path.name for path in (pytester.path / "kept").iterdir()] == ["prog-1-64x64.png"]


def test_snapshots_are_stored_held_and_shown(suite, pytester):
    tests = "def test_it(dome): dome.snapshot(PROG, size=96, fov=120)\n"
    missing = suite(tests)
    missing.assert_outcomes(failed=1)
    missing.stdout.fnmatch_lines(["*no stored picture */dome_pictures/prog-1-96x96.png; store it with*"])
    suite(tests, "--dome-update").assert_outcomes(passed=1)
    assert (pytester.path / "dome_pictures" / "prog-1-96x96.png").exists()
    suite(tests).assert_outcomes(passed=1)
    changed = suite(tests.replace("PROG,", "PROG, '0', '.5', '1',"), "--dome-output=kept")
    changed.assert_outcomes(failed=1)
    changed.stdout.fnmatch_lines(["*of the pixels show what the other picture does not*", "*--dome-update*"])
    assert (pytester.path / "kept" / "prog-1-96x96.png").exists()


def test_a_picture_is_had_as_an_array_and_failures_are_the_programs(suite, pytester):
    result = suite(
        "def test_it(dome):\n"
        "    picture = dome.picture(PROG, size=64)\n"
        "    assert picture.shape == (64, 64, 3)\n"
        "    assert (picture[32, 32] == (255, 128, 0)).all()\n"
        "def test_failing(dome): dome.picture(PROG, 'x', size=64)\n"
    )
    result.assert_outcomes(passed=1, failed=1)
    result.stdout.fnmatch_lines(["prog.py: no picture on the dome: ValueError: could not convert string*"])
    result.stdout.no_fnmatch_line("*During handling*")


def test_loading_it_loads_nothing_heavy():
    script = (
        "import sys, domeshim.pytest_plugin as p\n"
        "print([m for m in ('numpy', 'PIL', 'scipy', 'OpenGL', 'click') if m in sys.modules])"
    )
    loaded = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True)
    assert loaded.stdout == "[]\n"


def test_it_is_registered():
    assert 'domeshim = "domeshim.pytest_plugin"' in (ROOT / "pyproject.toml").read_text()
