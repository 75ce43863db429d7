"""The virtual dome shows a picture where the dome would."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import glfw
import numpy as np
import pytest
from PIL import Image

from domeshim.live.shared import Board
from domeshim.options import Options
from domeshim.preview.dome import VirtualDome, dome_of
from domeshim.preview.pictures import Live
from domeshim.preview.viewer import Viewer
from domeshim.preview.window import Hands
from tests.waiting import LONGEST

ROOT = Path(__file__).parents[2]


def preview(*args: str, **environment: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "domeshim", "preview", *args]
    env = {"PATH": "/usr/bin:/bin", "PYTHONPATH": str(ROOT), **environment}
    return subprocess.run(command, capture_output=True, text=True, timeout=LONGEST, env=env)


def seen(dome: VirtualDome, viewer: Viewer, phi: float, theta: float) -> np.ndarray:
    """Where a place of the dome is seen, -1 to 1."""
    x, y, _, w = viewer.matrix(1.0) @ (*dome.place(np.radians(phi), np.radians(theta)), 1)
    assert w > 0
    return np.array([x, y]) / w


def test_place_in_the_room():
    dome = VirtualDome(radius=5, rim=1)
    np.testing.assert_allclose(dome.place(0.0, 0.0), (0, 6, 0), atol=1e-12)
    np.testing.assert_allclose(dome.place(np.pi / 2, 0.0), (5, 1, 0), atol=1e-12)
    np.testing.assert_allclose(
        dome.place(np.pi / 2, -np.pi / 2), (0, 1, -5), atol=1e-12
    )  # the lower edge: front
    leaning = VirtualDome(radius=5, rim=1, tilt=90)
    np.testing.assert_allclose(leaning.place(0.0, 0.0), (0, 1, -5), atol=1e-12)
    np.testing.assert_allclose(leaning.place(np.pi / 2, np.pi / 2), (0, 6, 0), atol=1e-12)  # the upper edge


def test_dome_leans_so_that_ahead_is_at_the_front():
    for tilt in (0.0, 30.0, 90.0):
        dome = dome_of(Options(tilt=tilt), rim=0.0)
        ahead = dome.place(np.radians(tilt), -np.pi / 2)  # tilt under the disc's centre
        np.testing.assert_allclose(ahead, (0, 0, -dome.radius), atol=1e-12)


def test_viewer_looks_turns_and_flies():
    dome = VirtualDome(radius=5, rim=0)
    viewer = Viewer((0, 0, 0), 0, 0, 90)
    np.testing.assert_allclose(seen(dome, viewer, 90, -90), (0, 0), atol=1e-12)
    np.testing.assert_allclose(seen(dome, viewer, 90, -45), (1, 0), atol=1e-12)
    np.testing.assert_allclose(seen(dome, viewer, 45, -90), (0, 1), atol=1e-12)
    viewer.turn(90, 0)
    np.testing.assert_allclose(seen(dome, viewer, 90, 0), (0, 0), atol=1e-12)
    viewer.turn(0, 45)
    np.testing.assert_allclose(seen(dome, viewer, 45, 0), (0, 0), atol=1e-12)
    viewer.fly(0, 2, 0)
    np.testing.assert_allclose(viewer.place, (2**0.5, 2**0.5, 0), atol=1e-12)
    assert Viewer.from_json(viewer.to_json()).place == pytest.approx(viewer.place)
    assert VirtualDome.from_json(dome.to_json()) == dome


def test_a_key_touched_between_two_pictures_moves_the_viewer_once():
    viewer = Viewer((0, 1, 0), 0, 0, 90)
    hands = Hands(viewer)
    for pressed in (True, False):
        hands.key(glfw.KEY_D, pressed, 0)
    for _ in range(2):
        hands.move(0.1)
    np.testing.assert_allclose(viewer.place, (0.3, 1, 0), atol=1e-12)
    for key in (glfw.KEY_D, glfw.KEY_R):
        for pressed in (True, False):
            hands.key(key, pressed, 0)
    hands.move(0.1)
    assert viewer.place == (0, 1, 0)


def test_the_dome_beside_a_program_ends_with_it():
    board = Board()
    try:
        assert not Live(board.name, os.getppid()).ended
        assert Live(board.name, 2**22 + 1).ended  # a number that no process has
    finally:
        board.close()
    command = [sys.executable, "-m", "domeshim.preview.beside", board.name, "1", "{}", "{}"]
    env = {"PATH": "/usr/bin:/bin", "PYTHONPATH": str(ROOT)}
    done = subprocess.run(command, capture_output=True, text=True, timeout=LONGEST, env=env)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.parametrize(
    ("look", "colour"),
    [("0,20", (255, 0, 0)), ("90,20", (0, 255, 0)), ("180,20", (0, 0, 255)), ("0,89", (255, 255, 255))],
    ids=["front", "right", "back", "zenith"],
)
def test_view_from_the_middle(master: Path, tmp_path: Path, look: str, colour: tuple[int, ...]):
    view = tmp_path / "view.png"
    what = master if look != "0,20" else master.parent
    done = preview("--output", str(view), "--at", "0,2,0", "--look", look, "--size", "60x40", str(what))
    assert done.returncode == 0, done.stderr
    pixels = np.asarray(Image.open(view))
    assert pixels.shape == (40, 60, 3)
    np.testing.assert_allclose(pixels[20, 30], colour, atol=2)


def test_view_of_a_program(tmp_path: Path):
    program = tmp_path / "prog.py"
    program.write_text(
        "from OpenGL.GL import *\nfrom OpenGL.GLU import *\nfrom OpenGL.GLUT import *\n"
        "def display():\n glClearColor(0, 1, 0, 1); glClear(GL_COLOR_BUFFER_BIT); glutSwapBuffers()\n"
        "glutInit(); glutInitDisplayMode(GLUT_DOUBLE); glutCreateWindow('p')\n"
        "glutDisplayFunc(display); glutMainLoop()\n"
    )
    view = tmp_path / "view.png"
    done = preview("--output", str(view), "--size", "60x40", str(program), DOME_TILT="30")
    assert done.returncode == 0, done.stderr
    np.testing.assert_allclose(np.asarray(Image.open(view))[5, 30], (0, 255, 0), atol=2)


@pytest.mark.parametrize(
    ("args", "said"),
    [
        (["--output", "v.png", "missing.png"], "cannot show missing.png"),
        (["--output", "v.png", "."], "no pictures in it"),
        (["--output", "v.png", "missing.py"], "no such file"),
        (["--at", "1,2", "x.png"], "3 numbers"),
    ],
)
def test_what_cannot_be_shown_is_one_line(tmp_path: Path, args: list[str], said: str):
    command = [sys.executable, "-m", "domeshim", "preview", *args]
    env = {"PATH": "/usr/bin:/bin", "PYTHONPATH": str(ROOT)}
    done = subprocess.run(command, capture_output=True, text=True, timeout=LONGEST, env=env, cwd=tmp_path)
    assert done.returncode == 2
    assert said in done.stderr
    assert done.stderr.count("\n") == 1
