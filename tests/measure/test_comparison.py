"""domeshim compare, as a user calls it: alike, with a fault, and where nothing can be told."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from domeshim.errors import OptionError
from domeshim.measure.apart import Program
from domeshim.measure.baseline import Baseline
from domeshim.measure.comparison import Compared, Comparison, even_side
from domeshim.measure.difference import difference, unwarped
from tests.waiting import LONGEST

ROOT = Path(__file__).resolve().parent.parent.parent
SCENE = ROOT / "benchmarks" / "faulty_scene.py"
SIZE = (224, 224)

PROGRAM = """
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
import os
def display():
    glClear(GL_COLOR_BUFFER_BIT)
    {}
    glutSwapBuffers()
    glutPostRedisplay()
glutInit()
glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB)
glutCreateWindow("program")
glutDisplayFunc(display)
glutMainLoop()
"""


@pytest.fixture
def compare(tmp_path):
    def compare(program: str | Path, *options: str) -> subprocess.CompletedProcess[str]:
        if isinstance(program, str):
            (tmp_path / "prog.py").write_text(PROGRAM.replace("{}", program))
            program = Path("prog.py")
        environ = {**os.environ, "PYTHONPATH": str(ROOT)}
        command = [sys.executable, "-m", "domeshim", "compare", "--size", "160", *options, str(program)]
        return subprocess.run(
            command, cwd=tmp_path, env=environ, capture_output=True, text=True, timeout=LONGEST
        )

    return compare


def test_a_sound_dome_is_alike_and_can_be_stored(compare, tmp_path):
    result = compare(SCENE, "--baseline", "stored", "--update", "--output", "shown", "--json")
    assert (result.returncode, result.stderr) == (0, "")
    [report] = json.loads(result.stdout)
    assert report["verdict"] == "alike"
    assert report["perspective"]
    assert report["monitor"]["wrong"] < 0.004
    assert report["monitor"]["moved"]["largest"] < 0.5
    assert report["renderer"]
    shown = Image.open(tmp_path / report["picture"])
    assert shown.width > 3 * 160
    stored = tmp_path / "stored" / "faulty_scene-1-160x160.png"
    assert Image.open(stored).size == tuple(report["dome"])


def test_a_dome_is_held_against_the_stored_picture(tmp_path):
    drawn = np.asarray(Image.effect_mandelbrot((160, 160), (-2, -1.5, 1, 1.5), 30).convert("RGB"))
    result = Compared(1, (80, 80), difference(drawn, drawn, np.ones((160, 160), bool)), drawn, drawn)
    (tmp_path / "file").write_text("")
    with pytest.raises(OptionError, match="accepted: a folder"):
        Baseline(tmp_path / "file", update=True).held("name", result)
    stored = Baseline(tmp_path / "stored")
    assert stored.held("name", result).verdict == "undecided"
    assert Baseline(tmp_path / "stored", update=True).held("name", result) is None
    assert stored.held("name", result).verdict == "alike"
    turned = replace(result, dome=drawn[:, ::-1])
    assert stored.held("name", turned).verdict == "different"
    assert "another size" in stored.held("name", replace(result, dome=drawn[:100])).reason
    stored.path("name", result).write_text("no picture")
    with pytest.raises(OptionError, match="is no picture"):
        stored.held("name", result)


def test_a_dome_wrong_by_a_degree_or_without_an_object_is_different():
    right = Comparison(Program(str(SCENE)), size=SIZE)
    monitor = right.take(dome=False).exposures[1].picture
    side = even_side(right.take(dome=True, side=SIZE[0]).exposures[1], 4096)
    sound = right.take(dome=True, side=side).exposures[1]

    def verdict(**wrong) -> str:
        drawn = (
            replace(right, **wrong).take(dome=True, side=side).exposures[1].picture
            if wrong
            else sound.picture
        )
        return difference(monitor, unwarped(drawn, sound.places, sound.seen), sound.seen).verdict

    assert verdict() == "alike"
    assert verdict(settings={"tilt": "1"}) == "different"
    assert verdict(settings={"fov": "182"}) == "different"
    assert verdict(program=Program(str(SCENE), ("missing",))) == "different"


EYE = """
def eye(side):
    glMatrixMode(GL_PROJECTION); glLoadIdentity()
    glFrustum(-.06 + .01 * side, .06 + .01 * side, -.06, .06, .1, 100)
    glMatrixMode(GL_MODELVIEW); glLoadIdentity(); glTranslatef(.8 * side, 0, -8)
    glClear(GL_DEPTH_BUFFER_BIT)
    glRotatef(20, 1, 1, 0); glutSolidTeapot(2)
"""
ANAGLYPH = """glEnable(GL_DEPTH_TEST); glEnable(GL_LIGHTING); glEnable(GL_LIGHT0)
    glColorMask(1, 0, 0, 1); eye(1); glColorMask(0, 1, 1, 1); eye(-1); glColorMask(1, 1, 1, 1)"""


def test_each_channel_is_seen_through_the_perspective_that_it_was_drawn_in(tmp_path):
    program = tmp_path / "anaglyph.py"
    program.write_text(EYE + PROGRAM.replace("{}", ANAGLYPH).replace("GLUT_RGB", "GLUT_RGB | GLUT_DEPTH"))
    right = Comparison(Program(str(program)), size=SIZE)
    [result] = right.results()
    assert (result.verdict, result.difference.reason) == ("alike", "")
    assert result.difference.moved.largest < 0.3
    monitor = result.monitor
    sound = right.take(dome=True, side=448).exposures[1]
    assert not sound.overlaid
    turned = replace(right, settings={"heading": "1"}).take(dome=True, side=448).exposures[1]
    for drawn, verdict in ((sound, "alike"), (turned, "different")):
        assert (
            difference(monitor, unwarped(drawn.picture, sound.channels, sound.seen), sound.seen).verdict
            == verdict
        )
    through_one = unwarped(sound.picture, sound.places, sound.seen)
    assert difference(monitor, through_one, sound.seen).verdict == "different"


def test_perspectives_over_each_other_in_the_same_colours_cannot_be_told(compare, tmp_path):
    lit = "glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); "
    scene = lit + "eye(1); glEnable(GL_BLEND); glBlendFunc(GL_ONE, GL_ONE); eye(-1)"
    program = tmp_path / "over.py"
    program.write_text(EYE + PROGRAM.replace("{}", scene))
    result = compare(program)
    assert (result.returncode, result.stderr) == (2, "")
    assert (
        "could not tell: the program draws over each other what it sees in several perspectives"
        in result.stdout
    )


@pytest.mark.parametrize(
    ("program", "reason"),
    [
        ("pass", "both pictures are blank"),
        ("glColor3ubv(list(os.urandom(3)))\n    glRectf(-.5, -.5, .5, .5)", "another picture at each run"),
        ("1 / 0", "no picture as on the monitor: ZeroDivisionError"),
    ],
)  # fmt: skip
def test_what_cannot_be_told_is_status_2_with_the_reason(compare, program, reason):
    result = compare(program)
    assert (result.returncode, result.stderr) == (2, "")
    assert "could not tell: " in result.stdout
    assert reason in result.stdout


def test_several_frames_of_a_panel(compare):
    square = "glRectf(-.5, -.5, .1 * (1 + int(glutGet(GLUT_ELAPSED_TIME) / 1000 * 60 + .5)), .5)"
    result = compare(square, "--frames", "3,1", "--size", "120x80")
    assert (result.returncode, result.stderr) == (0, "")
    heads = [line for line in result.stdout.splitlines() if line.startswith("prog, ")]
    assert heads == [f"prog, picture {frame}, 120x80: alike" for frame in (1, 3)]
    assert result.stdout.count("through the panel") == 2


def test_a_toolkits_own_window_is_compared_as_finely(compare, tmp_path):
    pytest.importorskip("pygame")
    (tmp_path / "game.py").write_text(
        "import pygame\nfrom OpenGL.GL import *\nfrom OpenGL.GLU import *\n"
        "pygame.init(); pygame.display.set_mode((300, 200), pygame.OPENGL | pygame.DOUBLEBUF)\n"
        "while True:\n    glClear(GL_COLOR_BUFFER_BIT)\n"
        "    glLoadIdentity(); gluPerspective(50, 1, 1, 9)\n"
        "    glTranslatef(0, 0, -5); glColor3f(1, .5, 0)\n"
        "    glRectf(-1.5, -1, 1, 1.7)\n    pygame.display.flip()\n"
    )
    result = compare(Path("game.py"), "--json")
    [report] = json.loads(result.stdout)
    assert (result.returncode, report["verdict"], report["notes"]) == (0, "alike", [])
    assert min(report["dome"]) > 2 * 160


@pytest.mark.parametrize(
    ("options", "line"),
    [
        (["--frames", "1,x"], "--frames=1,x: accepted: numbers from 1 on, as in 1,10,60"),
        (["--frames", "0"], "--frames=0: accepted"),
        (["--size", "3,axb"], "--size=axb: not a size"),
        (["--update"], "--update: stores pictures in the folder of --baseline"),
        (["--fov", "x"], "--fov=x: not a number"),
    ],
)
def test_bad_options_are_one_line_and_status_2(compare, options, line):
    result = compare("pass", *options)
    assert (result.returncode, result.stdout) == (2, "")
    assert result.stderr.startswith(f"domeshim: {line}")
    assert result.stderr.count("\n") == 1


def test_without_scipy_it_says_what_to_install(compare, tmp_path):
    (tmp_path / "sitecustomize.py").write_text(
        "import sys\nclass Without:\n    def find_spec(self, name, path=None, target=None):\n"
        "        if name.partition('.')[0] == 'scipy': raise ModuleNotFoundError(name)\n"
        "import importlib.util as u\nfind = u.find_spec\n"
        "u.find_spec = lambda name, package=None: None if name == 'scipy' else find(name, package)\n"
    )
    environ = {**os.environ, "PYTHONPATH": f"{tmp_path}{os.pathsep}{ROOT}"}
    command = [sys.executable, "-m", "domeshim", "compare", "prog.py"]
    result = subprocess.run(
        command, cwd=tmp_path, env=environ, capture_output=True, text=True, timeout=LONGEST
    )
    assert (result.returncode, result.stdout) == (2, "")
    assert result.stderr == "domeshim: domeshim compare needs scipy: pip install 'domeshim[measure]'\n"
