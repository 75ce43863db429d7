"""DOME_DEBUG=levels: draws are coloured by the pieces that their edges are subdivided into."""

import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

from domeshim.draw.levels import RAMP, legend_of
from domeshim.lens.detail import pieces_per_radian
from domeshim.lens.models import Equidistant
from domeshim.shading.compose import compose
from domeshim.shading.recipe import Recipe
from tests.pictures.beside import SIZE, checks, looking_around
from tests.waiting import LONGEST

COLOURS = np.reshape(RAMP, (6, 4))[:, :3] * 255
"""Of what is whole, and of 1, 2, 4, 8 and 16 pieces."""
METHODS = ("tessellate", "geometry", "cpu")
MIDDLE = np.s_[SIZE // 2 - 1 : SIZE // 2 + 1, SIZE // 2 - 1 : SIZE // 2 + 1]


def quad(gl, half, centre=(0, 0)):
    gl.glBegin(gl.GL_QUADS)
    for x, y in ((-half, -half), (half, -half), (half, half), (-half, half)):
        gl.glTexCoord2f(x, y)
        gl.glVertex3f(centre[0] + x, centre[1] + y, -2)
    gl.glEnd()


def ramp(pieces):
    """The colour of so many pieces an edge."""
    return np.array([np.interp(np.log2(pieces), range(5), COLOURS[1:, k]) for k in range(3)])


def level_of(colour):
    """The pieces that a colour stands for, and how far it is from theirs."""
    pieces = np.linspace(1, 16, 300)
    off = [np.abs(ramp(n) - colour).max() for n in pieces]
    return pieces[int(np.argmin(off))], min(off)


def shown(beside, scene, **options):
    return beside.through_dome(scene, fov=180.0, debug="levels", **options).picture


@pytest.mark.parametrize("method", METHODS)
def test_a_line_has_the_colour_of_its_pieces(beside, method):
    half = np.radians(15)

    def scene(gl):
        looking_around(gl)
        gl.glColor3f(1, 0, 1)
        gl.glLineWidth(5)
        gl.glBegin(gl.GL_LINES)
        for side in (-1, 1):
            gl.glVertex3f(side * np.sin(half), 0, -np.cos(half))
        gl.glEnd()

    finer = 1.0 if method == "cpu" else 1.3  # glsl/tessellate/pieces
    pieces = np.ceil(finer * 2 * half * pieces_per_radian(Equidistant(180), SIZE / 2, 0.5))
    assert 2 < pieces < 16
    picture = shown(beside, scene, method=method)
    assert np.abs(picture[MIDDLE] - ramp(pieces)).max() <= 2


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("listed", [False, True])
def test_surfaces_have_levels_and_what_is_whole_is_grey(beside, method, listed):
    def scene(gl):
        looking_around(gl)
        if listed:
            gl.glNewList(1, gl.GL_COMPILE)
        quad(gl, 1.0)
        if listed:
            gl.glEndList()
            gl.glCallList(1)
            gl.glCallList(1)
        gl.glLoadIdentity()  # so that the next is judged by itself
        quad(gl, 0.05, (1.5, 0))

    picture = shown(beside, scene, method=method)
    level, off = level_of(picture[SIZE // 2, SIZE // 2])
    assert level > 2
    assert off <= 2
    beyond = picture[SIZE // 2, round(SIZE / 2 * (1 + np.arctan(1.5 / 2) / (np.pi / 2)))].astype(float)
    if method == "cpu":  # the others subdivide whatever they are given
        assert np.ptp(beyond) <= 2
        assert 0.75 * 128 - 2 < beyond.mean() <= 129
    else:
        slant = np.cos(np.arctan(1.5 / 2)) / 4 + 0.75
        assert np.abs(beyond - ramp(1) * slant).max() <= 3


def test_auto_leaves_small_primitives_grey(beside):
    def scene(gl):
        looking_around(gl)
        quad(gl, 0.05)

    for method in ("auto", "vertex", "paper", "cubemap"):
        assert np.abs(shown(beside, scene, method=method)[MIDDLE] - COLOURS[0]).max() <= 2, method


def test_nothing_of_the_programs_own_colours_is_left(beside):
    def plain(gl):
        looking_around(gl)
        quad(gl, 1.0)

    def dressed(gl):
        gl.glEnable(gl.GL_LIGHTING)
        gl.glEnable(gl.GL_LIGHT0)
        gl.glLightModeli(gl.GL_LIGHT_MODEL_COLOR_CONTROL, gl.GL_SEPARATE_SPECULAR_COLOR)
        gl.glLightModeli(gl.GL_LIGHT_MODEL_TWO_SIDE, 1)
        gl.glEnable(gl.GL_FOG)
        gl.glShadeModel(gl.GL_FLAT)
        checks(gl)
        plain(gl)
        return gl.glGetFloatv(gl.GL_CURRENT_COLOR).tolist()

    def own_fragments(gl):
        shader = gl.glCreateShader(gl.GL_FRAGMENT_SHADER)
        gl.glShaderSource(shader, "void main() { gl_FragColor = vec4(1.0, 0.0, 0.0, 1.0); }")
        gl.glCompileShader(shader)
        program = gl.glCreateProgram()
        gl.glAttachShader(program, shader)
        gl.glLinkProgram(program)
        gl.glUseProgram(program)
        plain(gl)

    for method in METHODS:
        bare = shown(beside, plain, method=method).astype(int)
        assert (shown(beside, own_fragments, method=method) == bare).all()
        drawn = beside.through_dome(dressed, fov=180.0, debug="levels", method=method)
        assert drawn.answer == [1, 1, 1, 1]
        if method == "geometry":  # what a vertex carries decides how many pieces there may be
            assert level_of(drawn.picture[SIZE // 2, SIZE // 2])[1] <= 2
        else:
            assert np.abs(drawn.picture - bare).max() <= 1


def test_the_programs_own_vertex_shaders_keep_their_colours(beside, capsys):
    def scene(gl):
        shader = gl.glCreateShader(gl.GL_VERTEX_SHADER)
        gl.glShaderSource(
            shader, "void main() { gl_Position = ftransform(); gl_FrontColor = vec4(1.0, 0.0, 0.0, 1.0); }"
        )
        gl.glCompileShader(shader)
        program = gl.glCreateProgram()
        gl.glAttachShader(program, shader)
        gl.glLinkProgram(program)
        looking_around(gl)
        gl.glUseProgram(program)
        quad(gl, 1.0)

    picture = shown(beside, scene)
    assert picture[SIZE // 2, SIZE // 2].tolist() == [255, 0, 0]
    said = "DOME_DEBUG=levels: what the program's own GLSL draws keeps its colours"
    assert capsys.readouterr().err.count(said) == 1


def test_the_legend_lies_in_the_corner(beside):
    size = (2 * SIZE, SIZE)
    picture = beside.through_dome(looking_around, size, fov=180.0, debug="levels").picture
    legend = legend_of(SIZE)
    assert (picture[: legend.shape[0], : legend.shape[1]] == legend).all()
    assert not beside.through_dome(looking_around, size, fov=180.0).picture.any()
    found = {tuple(colour) for colour in legend.reshape(-1, 3).tolist()}
    assert {tuple(colour) for colour in COLOURS.round().astype(int).tolist()} <= found
    assert legend.shape[1] < 0.3 * SIZE


def test_off_it_is_in_no_text():
    assert "domeRamp" in compose(Recipe(levels="whole")).text
    assert "domeRamp" not in compose(Recipe()).text
    assert "domeSeen" not in compose(Recipe()).text


def test_the_command_writes_such_a_picture(tmp_path):
    program, output = tmp_path / "prog.py", tmp_path / "levels.png"
    program.write_text(
        "from OpenGL.GL import *\nfrom OpenGL.GLU import *\nfrom OpenGL.GLUT import *\n"
        "def display():\n"
        "    glClear(GL_COLOR_BUFFER_BIT)\n"
        "    glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(60, 1, .1, 10)\n"
        "    glBegin(GL_TRIANGLES)\n"
        "    glVertex3f(-2, -1, -2); glVertex3f(2, -1, -2); glVertex3f(0, 2, -2)\n"
        "    glEnd()\n"
        "    glutSwapBuffers()\n"
        "glutInit(); glutInitDisplayMode(GLUT_DOUBLE); glutCreateWindow('levels')\n"
        "glutDisplayFunc(display); glutMainLoop()\n"
    )
    command = [sys.executable, "-m", "domeshim", "capture", "--debug", "levels", "--size", "128"]
    subprocess.run([*command, "--output", str(output), str(program)], check=True, timeout=LONGEST)
    picture = np.asarray(Image.open(output).convert("RGB"))
    assert level_of(picture[64, 64])[0] > 2


@pytest.mark.parametrize("command", ["compare", "explain", "doctor", "render --frames 1:1 --output"])
def test_commands_that_look_at_colours_refuse_it(command, monkeypatch, tmp_path, capsys):
    from domeshim.cli import main

    program = tmp_path / "prog.py"
    program.write_text("")
    monkeypatch.setenv("DOME_DEBUG", "levels")
    words = command.split()
    folder = [str(tmp_path / "out")] if len(words) > 1 else []
    monkeypatch.setattr(sys, "argv", ["domeshim", *words, *folder, str(program)])
    with pytest.raises(SystemExit) as ended:
        main()
    assert ended.value.code == 2
    said = f"DOME_DEBUG=levels: domeshim {words[0]} is for a program's own colours; accepted: off"
    assert said in capsys.readouterr().err
