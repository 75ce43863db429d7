"""Which method subdivides: the user's, or the next that the driver has, which is said."""

import os
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

from domeshim.driver import Driver
from domeshim.state.context import DomeContext

SIZE = 256
WALL = [(-9, -1, -2), (9, -1, -2), (9, 3, -2), (-9, 3, -2)]


def wall(gl):
    gl.glClear(gl.GL_COLOR_BUFFER_BIT)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.gluPerspective(60, 1, 0.1, 100)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glBegin(gl.GL_QUADS)
    for vertex in WALL:
        gl.glVertex3f(*vertex)
    gl.glEnd()


@pytest.mark.parametrize("method", ["tessellate", "geometry", "cpu"])
def test_what_is_switched_off_between_two_draws_is_off(beside, method):
    def scene(gl):
        gl.glEnable(gl.GL_LIGHTING)
        wall(gl)
        gl.glDisable(gl.GL_LIGHTING)
        gl.glColor3f(1, 0, 0)
        gl.glBegin(gl.GL_QUADS)
        for vertex in WALL:
            gl.glVertex3f(*vertex)
        gl.glEnd()

    picture = beside.through_dome(scene, fov=180.0, method=method).picture
    assert picture[SIZE // 2, SIZE // 2].tolist() == [255, 0, 0]


@pytest.fixture
def dressed(monkeypatch):
    """What the dome handed over to be subdivided, draw by draw."""
    patches = []
    dress = DomeContext.dress

    def spy(context, patch=None, *, raster=False):
        patches.append(patch)
        dress(context, patch, raster=raster)

    monkeypatch.setattr(DomeContext, "dress", spy)
    return patches


def methods(patches):
    return {patch.method if patch else None for patch in patches}


@pytest.mark.parametrize(
    ("version", "wanted", "used"),
    [
        ((4, 5), "auto", "tessellate"),
        ((4, 5), "geometry", "geometry"),
        ((3, 3), "auto", "geometry"),
        ((3, 3), "tessellate", "geometry"),
        ((3, 0), "auto", "cpu"),
        ((3, 1), "geometry", "cpu"),
        ((3, 1), "cpu", "cpu"),
    ],
)
def test_the_next_method_that_the_driver_has(beside, dressed, monkeypatch, capsys, version, wanted, used):
    monkeypatch.setattr(Driver, "version", version)
    picture = beside.through_dome(wall, (SIZE, SIZE), fov=180.0, method=wanted).picture
    assert picture.any()
    assert methods(dressed) == {None if used == "cpu" else used}
    said = capsys.readouterr().err
    expected = wanted == used or (wanted == "auto" and version >= (4, 0))
    assert said.count(f"method {used}") == said.count("domeshim:") == (0 if expected else 1)


@pytest.mark.parametrize("method", ["vertex", "paper"])
def test_what_does_not_subdivide(beside, dressed, method):
    beside.through_dome(wall, (SIZE, SIZE), fov=180.0, method=method)
    assert methods(dressed) == {None}


@pytest.mark.parametrize("method", ["tessellate", "geometry", "cpu", "auto"])
def test_the_methods_agree(beside, method):
    """The same wall within a pixel of its outline, and far from what its four corners alone would show."""
    best = beside.through_dome(wall, (SIZE, SIZE), fov=180.0, tolerance=0.05).picture[..., 0] > 128
    plain = beside.through_dome(wall, (SIZE, SIZE), fov=180.0, method="vertex").picture[..., 0] > 128
    picture = beside.through_dome(wall, (SIZE, SIZE), fov=180.0, method=method).picture[..., 0] > 128
    assert (picture != best).sum() < 0.01 * best.sum() < (plain != best).sum()


@pytest.fixture
def capture(tmp_path):
    """Captures the wall with Mesa as an older driver; gives the process and the path of the picture."""
    program, output = tmp_path / "wall.py", tmp_path / "wall.png"
    program.write_text(
        "from OpenGL.GL import *\nfrom OpenGL.GLU import *\nfrom OpenGL.GLUT import *\n"
        "def display():\n"
        "    glClear(GL_COLOR_BUFFER_BIT)\n"
        "    glMatrixMode(GL_PROJECTION)\n    gluPerspective(60, 1, 0.1, 100)\n"
        "    glMatrixMode(GL_MODELVIEW)\n    glBegin(GL_QUADS)\n"
        f"    for v in {WALL}:\n        glVertex3f(*v)\n"
        "    glEnd()\n    glutSwapBuffers()\n"
        "glutInit()\nglutCreateWindow('wall')\nglutDisplayFunc(display)\nglutMainLoop()\n"
    )

    def run(version, glsl):
        environment = {**os.environ, "MESA_GL_VERSION_OVERRIDE": version, "MESA_GLSL_VERSION_OVERRIDE": glsl}
        words = ["capture", "--size", str(SIZE), "--output", output, program]
        return subprocess.run(
            [sys.executable, "-m", "domeshim", *words], env=environment, capture_output=True, text=True
        ), output

    return run


@pytest.mark.parametrize(("version", "glsl"), [("3.0", "130"), ("3.2COMPAT", "150")])
def test_older_gl(capture, version, glsl):
    ran, output = capture(version, glsl)
    assert ran.returncode == 0, ran.stderr
    assert "no tessellation shaders" in ran.stderr
    assert (np.asarray(Image.open(output).convert("L")) > 128).sum() > 1000


def test_gl_that_is_too_old_is_named_in_one_line(capture):
    ran, _ = capture("2.0", "110")
    assert ran.returncode == 1
    assert ran.stderr == "domeshim: this machine's OpenGL is 2.0; the dome needs 2.1 or later\n"
