"""The reference picture: numpy's part on painted cubes, the whole with programs of the tests' own."""

from __future__ import annotations

import ctypes.util
import shutil
import subprocess
import sys
import textwrap
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from domeshim.errors import ScreenError
from domeshim.measure import face_program, reference
from domeshim.measure.match import match_discs
from domeshim.measure.reference import NoPictureError, StockRuns, dome_picture, stock_environment

SIZE = 192
HEAD = """
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
import random, sys, time

def display():
    glClear(GL_COLOR_BUFFER_BIT)
    draw()
    glutSwapBuffers()

def perspective():
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(40, 1, 0.1, 100)
    glMatrixMode(GL_MODELVIEW)

def square(x, y, z, side):
    # Faces the viewer at the direction (x, y, z).
    glPushMatrix()
    glTranslatef(x, y, z)
    glBegin(GL_QUADS)
    for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        glVertex3f(u * side, v * side if abs(z) > 1 else 0, 0 if abs(z) > 1 else v * side)
    glEnd()
    glPopMatrix()

def start(mode=GLUT_DOUBLE):
    glutInit()
    glutInitDisplayMode(mode)
    glutInitWindowSize(100, 80)
    glutCreateWindow(b"test")
    glutDisplayFunc(display)
    glutMainLoop()
"""


@pytest.fixture(scope="module")
def display() -> Iterator[str]:
    if shutil.which("Xvfb") is None:
        pytest.skip("Xvfb is not installed: freeglut needs an X server")
    if ctypes.util.find_library("glut") is None:
        pytest.skip("freeglut's library is not installed: there is no stock GLUT to run")
    with reference.virtual_display() as name:
        yield name


@pytest.fixture
def runs(display: str, tmp_path: Path) -> Callable[..., StockRuns]:
    def make(body: str, head: str = HEAD, **wanted: object) -> StockRuns:
        program = tmp_path / "program.py"
        program.write_text(head + textwrap.dedent(body))
        return StockRuns(display, program, **{"size": SIZE, **wanted})

    return make


PAINT = {
    "front": (250, 0, 0),
    "right": (0, 250, 0),
    "back": (0, 0, 250),
    "left": (250, 250, 0),
    "up": (0, 250, 250),
    "down": (250, 0, 250),
}


def painted() -> dict[str, np.ndarray]:
    return {face: np.full((64, 64, 3), colour, np.uint8) for face, colour in PAINT.items()}


@pytest.mark.parametrize("face", face_program.FACES)
def test_a_face_is_a_rotation_of_eye_space(face):
    rotation = np.array(face_program.FACES[face])
    assert (rotation @ rotation.T == np.eye(3)).all()
    assert np.linalg.det(rotation) == pytest.approx(1)


def test_each_face_lies_where_it_looks():
    picture = dome_picture(painted(), 256, fov=360.0)
    at = {"front": (128, 128), "right": (192, 128), "left": (64, 128), "up": (128, 64), "down": (128, 192)}
    for face, (x, y) in at.items():
        assert tuple(picture[y, x]) == PAINT[face], face
    assert tuple(picture[128, 254]) == PAINT["back"]
    assert tuple(picture[2, 2]) == (0, 0, 0)


def test_the_tilt_raises_the_middle():
    assert tuple(dome_picture(painted(), 65, tilt=90.0)[32, 32]) == PAINT["up"]
    assert tuple(dome_picture(painted(), 65, tilt=-90.0)[32, 32]) == PAINT["down"]


def test_faces_meet_without_a_seam_the_right_way_round():
    """A cube painted with each direction's own coordinates gives every pixel its direction."""
    size = 128
    across = (2 * np.arange(size) + 1 - size) / size
    faces = {}
    for face, rows in face_program.FACES.items():
        u, v = np.meshgrid(across, -across)
        directions = np.stack([u, v, -np.ones_like(u)], -1) @ np.array(rows, float)
        directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
        faces[face] = np.rint(directions * 120 + 128).astype(np.uint8)
    picture = dome_picture(faces, 256, fov=300.0, tilt=25.0)
    directions, inside = reference.disc_directions(256, 300.0, 25.0)
    assert np.abs(picture[inside] - (directions[inside] * 120 + 128)).max() < 2.5


def test_directions_are_equidistant():
    directions, inside = reference.disc_directions(101, 180.0, 0.0)
    middle, right = directions[50, 50], directions[50, 75]
    assert np.allclose(middle, (0, 0, -1))
    assert np.degrees(np.arccos(-right[2])) == pytest.approx(90 * 50 / 101)
    assert right[0] > 0
    assert not inside[0, 0]


def test_the_frustum_is_a_right_angle_wide():
    near, far = (
        face_program.frustum(2.0, 50.0) @ [2, 2, -2, 1],
        face_program.frustum(2.0, 50.0) @ [0, 50, -50, 1],
    )
    assert np.allclose(near / near[3], (1, 1, -1, 1))
    assert np.allclose(far / far[3], (0, 1, 1, 1))


def test_what_is_nowhere_is_outside_of_the_view():
    point = face_program.nowhere() @ [0.3, -5, 2, 1]
    assert (np.abs(point[:3]) > point[3]).all()


def test_a_program_on_the_monitor(runs):
    found = runs("""
        def draw():
            glColor3ub(200, 100, 50)
            glRectf(-1, 0, 0, 1)
        start()
    """).monitor()
    assert found.picture.shape == (SIZE, SIZE, 3)
    assert tuple(found.picture[10, 10]) == (200, 100, 50)
    assert not found.picture[SIZE // 2 + 2 :].any()
    assert (found.perspectives, found.fog) == (0, False)
    assert found.renderer
    assert found.version[0].isdecimal()


def test_a_scene_lands_on_the_dome_where_its_directions_do(runs):
    picture = runs("""
        def draw():
            perspective()
            glLoadIdentity()
            glColor3ub(250, 0, 0); square(0, 0, -10, 1)
            glColor3ub(0, 250, 0); square(10, 0, -10, 1)
            glColor3ub(0, 0, 250); square(0, -10, 0, 1)
        start()
    """).dome(tilt=-20.0)
    middle, radius = SIZE / 2, SIZE / 2

    def at(degrees_up: float) -> tuple[int, ...]:
        return tuple(picture[int(middle - (degrees_up + 20) / 90 * radius), int(middle)])

    assert at(0) == (250, 0, 0)
    assert at(-90 + 2) == (0, 0, 250)
    assert at(15) == (0, 0, 0)
    assert at(-45) == (0, 0, 0)
    # Right and up in the picture: (1, 0, -1), seen from an eye that looks 20 degrees down.
    right = (picture == (0, 250, 0)).all(-1)
    y, x = np.argwhere(right).mean(axis=0)
    sine, cosine = np.sin(np.radians(20)), np.cos(np.radians(20))
    forward, up = cosine / np.sqrt(2), sine / np.sqrt(2)
    phi = np.arccos(forward)
    scale = phi / (np.pi / 2) * radius / np.hypot(np.sqrt(0.5), up)
    assert x == pytest.approx(middle + np.sqrt(0.5) * scale, abs=1.5)
    assert y == pytest.approx(middle - up * scale, abs=1.5)


def test_the_hud_is_left_out_and_the_scene_kept(runs):
    body = """
        def draw():
            perspective()
            glLoadIdentity()
            square(0, 0, -10, 1)
            {hud}
        start()
    """
    hud = "glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluOrtho2D(0, 1, 0, 1); glRectf(0, 0, 1, 1)"
    alone = runs(body.format(hud="pass")).dome()
    assert alone.any()
    assert (runs(body.format(hud=hud)).dome() == alone).all()
    assert runs(body.format(hud=hud)).monitor().picture.all()


def test_each_run_sees_the_same_time_and_chance(runs):
    body = """
        import numpy
        def draw():
            perspective()
            glLoadIdentity()
            assert glutGet(GLUT_ELAPSED_TIME) == 0
            glClearColor(random.random(), numpy.random.random(), time.time() % 1000 / 1000, 0)
            glClear(GL_COLOR_BUFFER_BIT)
        start()
    """
    first, second = (runs(body).monitor().picture for _ in range(2))
    assert (first == second).all()
    assert len(np.unique(runs(body).dome()[SIZE // 2, 1:-1], axis=0)) == 1


@pytest.mark.parametrize(
    ("mode", "finish"),
    [("GLUT_DOUBLE", "glutSwapBuffers()"), ("GLUT_SINGLE", "glFlush()"), ("GLUT_SINGLE", "pass")],
)
def test_the_wanted_picture_is_taken(runs, mode, finish):
    body = f"""
        count = 0
        def display():
            global count
            count += 1
            glClearColor(count * 50 / 255, 0, 0, 0)
            glClear(GL_COLOR_BUFFER_BIT)
            {finish}
        start({mode})
    """
    for frame in (1, 3):
        assert (runs(body, frame=frame).monitor().picture == (50 * frame, 0, 0)).all()


def test_a_wait_for_time_to_pass_ends(runs):
    body = """
        def draw():
            until = time.time() + 0.05
            while time.time() < until:
                pass
            glClearColor(1, 1, 1, 0)
            glClear(GL_COLOR_BUFFER_BIT)
        start()
    """
    assert runs(body).monitor().picture.all()


@pytest.mark.parametrize(
    ("body", "reason", "ended"),
    [
        (
            "import there_is_no_such_module",
            "ModuleNotFoundError: No module named 'there_is_no_such_module'",
            False,
        ),
        (
            "print 'two'",
            "SyntaxError: Missing parentheses in call to 'print'. Did you mean print(...)?",
            False,
        ),
        ("print('one'); print('two')", "two", True),
        ("raise ValueError('on\\ntwo lines')", "ValueError: on", False),
        ("x = 1", "it ended with status 0 and without a word", True),
        ("def draw(): unknown\nstart()", "NameError: name 'unknown' is not defined", False),
        ("def draw(): sys.exit()\nstart()", "the program ended before the wanted picture", True),
        ("glutInit(); glutCreateWindow(b'')", "the program ended before the wanted picture", True),
    ],
)
def test_no_picture_has_its_reason(runs, body, reason, ended):
    with pytest.raises(NoPictureError) as raised:
        runs(body).monitor()
    assert (str(raised.value), raised.value.ended) == (reason, ended)
    assert raised.value.silent == reason.endswith("without a word")


def test_a_program_that_shows_nothing_is_given_up(runs):
    with pytest.raises(NoPictureError, match=r"^no picture within 1.5 seconds$"):
        runs("while True: pass", timeout=1.5).monitor()


def test_the_programs_arguments_folder_and_main_are_its_own(runs, tmp_path):
    (tmp_path / "colour.txt").write_text("200")
    body = """
        import os
        def draw():
            glClearColor(int(open("colour.txt").read()) / 255, int(sys.argv[1]) / 255, 0, 0)
            glClear(GL_COLOR_BUFFER_BIT)
        if __name__ == "__main__" and os.path.samefile(sys.argv[0], __file__):
            start()
    """
    assert (runs(body, arguments=("100",)).monitor().picture == (200, 100, 0)).all()


def test_domeshims_dome_matches_the_reference_and_its_monitor_does_not(runs, tmp_path):
    wanted = runs("""
        def draw():
            perspective()
            glLoadIdentity()
            glEnable(GL_DEPTH_TEST)
            glClear(GL_DEPTH_BUFFER_BIT)
            glRotatef(30, 0, 1, 0)
            for k in range(-4, 5):
                glColor3ub(150 - 20 * k, 110 + 15 * k, 128)
                square(2 * k, k / 2, -4, 0.9)
                square(2 * k, -1, 0, 0.9)
        start(GLUT_DOUBLE | GLUT_DEPTH)
    """)
    pictures = []
    for mode in ("dome", "monitor"):
        output = tmp_path / f"{mode}.png"
        command = [sys.executable, "-m", "domeshim", "capture", "--mode", mode, "--size", str(SIZE)]
        subprocess.run(
            [*command, "--output", str(output), str(wanted.program)], env=stock_environment(""), check=True
        )
        pictures.append(np.asarray(Image.open(output)))
    dome = wanted.dome()
    assert match_discs(dome, pictures[0]).content > SIZE**2 / 8
    assert match_discs(dome, pictures[0]).share < 0.02
    assert match_discs(dome, pictures[1]).share > 0.2


def test_a_missing_x_server_is_named(monkeypatch):
    monkeypatch.setenv("PATH", "")
    with pytest.raises(ScreenError, match="Xvfb"), reference.virtual_display():
        pass


def test_stock_runs_know_nothing_of_the_dome():
    given = {"DOME": "1", "DOME_FOV": "200", "PYOPENGL_PLATFORM": "egl", "DISPLAY": ":9", "HOME": "/"}
    made = stock_environment(":1", given)
    assert made["DISPLAY"] == ":1"
    assert made["HOME"] == "/"
    assert not {"DOME", "DOME_FOV", "PYOPENGL_PLATFORM"} & set(made)
