"""A picture pays only for what it needs: GL's calls are counted, and the shaders' texts read as compiled."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from collections import Counter
from contextlib import closing
from pathlib import Path

import pytest

from domeshim.bench.stage import Stage
from domeshim.driver import Driver
from domeshim.options import Options

PATCHES = 0x000E


class Counted(Counter):
    """How often the dome has called each entry point of GL, and the texts it compiled."""

    def __init__(self):
        super().__init__()
        self.texts = []
        self.modes = []

    def uniforms(self):
        return sum(count for name, count in self.items() if name.startswith("glUniform"))


@pytest.fixture
def calls(monkeypatch):
    """Counts from now on."""
    found = Counted()
    look_up = Driver.__getattr__

    def counted(driver, name):
        function = look_up(driver, name)

        def call(*arguments):
            found[name] += 1
            if name == "glShaderSource":
                found.texts.append(arguments[2].value.decode())
            if name in ("glDrawArrays", "glMultiDrawArrays"):
                found.modes.append(arguments[0])
            return function(*arguments)

        setattr(driver, name, call)
        return call

    monkeypatch.setattr(Driver, "__getattr__", counted)
    return found


def look(gl):
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.gluPerspective(60, 1, 0.1, 100)
    gl.glMatrixMode(gl.GL_MODELVIEW)


def triangle(gl, width=0.05):
    gl.glBegin(gl.GL_TRIANGLES)
    for x, y in ((-width, -width), (width, -width), (0, width)):
        gl.glVertex3f(x, y, -2)
    gl.glEnd()


def draw(scene, pictures=1, **options):
    with closing(Stage(64)) as stage:
        player = stage.dome(Options(enabled=True, **options))
        look(player.gl)

        def picture():
            player.gl.glClear(player.gl.GL_COLOR_BUFFER_BIT)
            scene(player.gl)

        for _ in range(pictures):
            player.show(picture)


@pytest.mark.parametrize(
    ("capability", "word"),
    [
        ("GL_LIGHTING", "gl_LightSource"),
        ("GL_TEXTURE_2D", "gl_MultiTexCoord0"),
        ("GL_FOG", "gl_FogFragCoord"),
        ("GL_CLIP_PLANE0", "gl_ClipPlane"),
    ],
)
def test_the_code_of_a_capability_is_compiled_when_it_is_on(calls, capability, word):
    def scene(gl):
        gl.glEnable(gl.GL_LIGHT0)
        triangle(gl)

    draw(scene)
    assert calls.texts
    assert not any(word in text for text in calls.texts)

    def scene_with(gl):
        gl.glEnable(getattr(gl, capability))
        scene(gl)

    draw(scene_with)
    assert any(word in text for text in calls.texts)


def test_short_edges_see_no_tessellation(calls):
    draw(triangle)
    assert PATCHES not in calls.modes
    assert not calls["glPatchParameteri"]
    assert not any("gl_TessLevelOuter" in text for text in calls.texts)
    draw(lambda gl: triangle(gl, width=2.0))
    assert PATCHES in calls.modes
    assert any("gl_TessLevelOuter" in text for text in calls.texts)


def test_uniforms_that_stay_are_sent_once(calls):
    counts = []

    def scene(gl):
        counts.append(calls.uniforms())
        triangle(gl)

    draw(scene, pictures=4)
    assert 0 == counts[0] < counts[1]
    assert counts[1] == counts[2] == counts[3]


def test_a_second_picture_compiles_nothing(calls):
    compiled = []

    def scene(gl):
        compiled.append(calls["glCompileShader"])
        triangle(gl)
        triangle(gl, width=2.0)

    draw(scene, pictures=4)
    assert compiled[0] < compiled[1]
    assert compiled[1] == compiled[2] == compiled[3]


def test_draws_that_follow_each_other_ask_for_nothing(calls):
    counts = []

    def scene(gl):
        for _ in range(4):
            triangle(gl)
            gl.glFlush()
            counts.append(sum(count for name, count in calls.items() if name.startswith("glGet")))

    draw(scene)
    assert counts[3] - counts[2] == counts[2] - counts[1] <= 4


def test_faces_that_are_not_seen_are_not_drawn(calls):
    drawn = {}
    for fov in (80.0, 180.0, 360.0):

        def scene(gl):
            before = calls["glDrawArrays"] + calls["glBegin"]
            triangle(gl)
            gl.glFlush()
            drawn[fov] = calls["glDrawArrays"] + calls["glBegin"] - before  # noqa: B023 - called in this turn

        draw(scene, fov=fov, method="cubemap:32")
    assert drawn == {80.0: 1, 180.0: 5, 360.0: 6}


def test_nothing_is_resolved_unless_the_window_is_multisampled(calls):
    draw(triangle)
    assert not calls["glBlitFramebuffer"]
    assert not calls["glGenFramebuffers"]
    assert not calls["glGenTextures"]


@pytest.mark.parametrize(
    ("surface", "rings", "corners"),
    [
        (("dome", ()), 2, 0),
        (("keystone", (0.0, 0.0, 1.0, 0.1, 1.0, 0.9, 0.0, 1.0)), 0, 1),
        (("cylinder", (220.0, -30.0, 40.0)), 0, 0),
    ],
)
def test_the_rim_is_compiled_as_far_as_it_is_drawn(calls, surface, rings, corners):
    draw(triangle, surface=surface)
    assert sum("const int PIECES" in text for text in calls.texts) == rings
    assert sum("domeToSquare" in text for text in calls.texts) == corners


LEFT_OUT = (
    *("click", "glfw", "moderngl", "HersheyFonts", "PIL", "tqdm"),
    *("domeshim.bench", "domeshim.cli", "domeshim.diagnosis", "domeshim.measure", "domeshim.preview"),
    *("domeshim.render", "domeshim.live", "domeshim.window.show", "domeshim.window.virtual_time"),
    *("domeshim.GLUT.composition", "domeshim.GLUT.typefaces.freeglut", "domeshim.GLUT.typefaces.faces"),
    *("domeshim.GLUT.typefaces.layout", "domeshim.GLUT.typefaces.substitute"),
    *("domeshim.draw.arrays", "domeshim.draw.atlas", "domeshim.draw.clear", "domeshim.draw.cubemap"),
    *("domeshim.draw.finish", "domeshim.draw.finishing", "domeshim.draw.resampling", "domeshim.draw.tiles"),
    *("domeshim.draw.flat_pixels", "domeshim.draw.levels", "domeshim.state.panel_pixels"),
    *("domeshim.intercept.quadrics.calls", "domeshim.intercept.quadrics.shapes"),
    *("domeshim.intercept.toolkits.pygame", "domeshim.intercept.toolkits.qt"),
    *("domeshim.lens.card", "domeshim.lens.cylinder", "domeshim.lens.fit", "domeshim.lens.measured"),
    *("domeshim.lens.mesh", "domeshim.lens.polynomials", "domeshim.lens.table"),
    *("domeshim.record.arrays", "domeshim.shading.exchange", "domeshim.shading.fragments"),
    *("domeshim.shading.geometry", "domeshim.shading.own", "domeshim.shading.pieces"),
    *("domeshim.shading.tessellation", "domeshim.state.comfort", "domeshim.state.monitor_raster"),
    *("domeshim.state.pointer", "domeshim.state.region", "domeshim.state.shown"),
)
"""What a program of a few small triangles does not need; glfw without a display."""
GLUT_PROGRAM = """
import sys
from domeshim import startup
from domeshim.options import Options
from domeshim.session import Session
from domeshim.window.offscreen import OffscreenBackend

startup.run_under(Session(Options(enabled=True), backend=OffscreenBackend))
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *

def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glBegin(GL_TRIANGLES)
    for x, y in ((-0.05, -0.05), (0.05, -0.05), (0, 0.05)):
        glVertex3f(x, y, -2)
    glEnd()
    {more}
    glutSwapBuffers()
    sys.stdout.write(" ".join(sys.modules))
    sys.exit()

glutInit()
glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH)
glutInitWindowSize(64, 64)
glutCreateWindow("small")
glMatrixMode(GL_PROJECTION)
gluPerspective(60, 1, 0.1, 100)
glMatrixMode(GL_MODELVIEW)
glutDisplayFunc(display)
glutMainLoop()
"""


def modules_of_a_program(more):
    """What a GLUT program has loaded after its first picture; more: what else it draws."""
    command = [sys.executable, "-c", GLUT_PROGRAM.format(more=more)]
    root = Path(__file__).parents[2]
    return set(subprocess.run(command, cwd=root, capture_output=True, text=True, check=True).stdout.split())


def test_a_simple_program_loads_no_module_that_it_does_not_need():
    assert [name for name in LEFT_OUT if importlib.util.find_spec(name) is None] == []
    loaded = modules_of_a_program("import gc; assert gc.isenabled(), 'left off after the imports'")
    assert "domeshim.draw.rim" in loaded
    assert sorted(loaded.intersection(LEFT_OUT)) == []


def test_what_a_program_uses_is_loaded_then():
    more = 'glutStrokeString(GLUT_STROKE_ROMAN, b"a"); glScissor(8, 8, 16, 16); glEnable(GL_SCISSOR_TEST)'
    more += "; glClear(GL_COLOR_BUFFER_BIT); glGetFloatv(GL_CURRENT_RASTER_POSITION)"
    more += "; gluSphere(gluNewQuadric(), 0.1, 8, 8)"
    used = {"domeshim.GLUT.typefaces.layout", "domeshim.draw.clear", "domeshim.state.monitor_raster"}
    more += "; glBitmap(8, 1, 0, 0, 8, 0, b'a')"
    used |= {"domeshim.intercept.quadrics.shapes", "domeshim.state.panel_pixels"}
    assert modules_of_a_program(more) >= used
