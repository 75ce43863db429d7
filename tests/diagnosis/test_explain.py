"""domeshim explain, on a program whose draws are known."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.waiting import LONGEST

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAM = """
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
def fan(n):
    glBegin(GL_TRIANGLE_FAN)
    for i in range(n): glVertex3f(.01 * (i % 7), .01 * (i % 5), 0)
    glEnd()
def display():
    glClear(GL_COLOR_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(60, 1, .1, 100)
    glMatrixMode(GL_MODELVIEW); glLoadIdentity(); glTranslatef(0, 0, -5)
    for _ in range(3): fan(40); glFlush()
    glEnable(GL_LIGHTING); glEnable(GL_LIGHT0); glEnable(GL_FOG)
    glCallList(made)
    glDisable(GL_LIGHTING); glDisable(GL_FOG)
    glPushMatrix(); glScalef(900, 900, 1); fan(4); glPopMatrix(); glScalef(.001, .001, .001)
    glVertexPointerf([[0, 0, 0], [1, 0, 0], [0, 1, 0]]); glEnableClientState(GL_VERTEX_ARRAY)
    glDrawArrays(GL_TRIANGLES, 0, 3)
    glutSolidTetrahedron()
    glutSwapBuffers(); glutPostRedisplay()
glutInit(); glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB); glutCreateWindow("program")
made = glGenLists(1)
glNewList(made, GL_COMPILE); fan(30); glEndList()
glutDisplayFunc(display); glutMainLoop()
"""


FEW = """
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
def display():
    glClear(GL_COLOR_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(60, 1, .1, 100)
    glMatrixMode(GL_MODELVIEW); glLoadIdentity()
    glBegin(GL_LINES)
    for k in range(6): glVertex3f(-1 + .1 * k, 1, -2); glVertex3f(1, -1, -2)
    glEnd()
    glRotatef(10, 0, 1, 0)
    glBegin(GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)): glVertex3f(x, y, -3)
    glEnd()
    glutSwapBuffers()
glutInit(); glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB); glutCreateWindow("few")
glutDisplayFunc(display); glutMainLoop()
"""


EVALUATED = """
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
def display():
    glClear(GL_COLOR_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(60, 1, .1, 100)
    glMatrixMode(GL_MODELVIEW); glLoadIdentity()
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 0, 1, [[[-9, -1, -9], [-9, -1, 9]], [[9, -1, -9], [9, -1, 9]]])
    glEnable(GL_MAP2_VERTEX_3); glMapGrid2f(4, 0, 1, 4, 0, 1)
    glEvalMesh2(GL_LINE, 0, 4, 0, 4)
    glTranslatef(0, 0, -500); glScalef(.1, .1, .1)
    glEvalMesh2(GL_FILL, 0, 4, 0, 4)
    glutSwapBuffers()
glutInit(); glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB); glutCreateWindow("evaluated")
glutDisplayFunc(display); glutMainLoop()
"""


SHADED = """
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
def display():
    glClear(GL_COLOR_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION); glLoadIdentity(); gluPerspective(60, 1, .1, 100)
    glUseProgram(name)
    glBegin(GL_QUADS)
    for x, z in ((-40, 40), (40, 40), (40, -40), (-40, -40)):
        glVertex3f(x, -1.5, z)
    glEnd()
    glMatrixMode(GL_MODELVIEW); glTranslatef(0, 0, -1)
    glBegin(GL_TRIANGLES)
    for x, y in ((0, 0), (.1, 0), (0, .1)):
        glVertex3f(x, y, -20)
    glEnd()
    glutSwapBuffers()
glutInit(); glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB); glutCreateWindow("shaded")
name, shader = glCreateProgram(), glCreateShader(GL_VERTEX_SHADER)
glShaderSource(shader, "void main() { gl_Position = ftransform(); gl_FrontColor = vec4(1.0); }")
glCompileShader(shader); glAttachShader(name, shader); glLinkProgram(name)
glutDisplayFunc(display); glutMainLoop()
"""


@pytest.fixture
def explain(tmp_path):
    def explain(*options: str) -> subprocess.CompletedProcess[str]:
        (tmp_path / "prog.py").write_text(PROGRAM)
        command = [sys.executable, "-m", "domeshim", "explain", "--size", "128", *options, "prog.py"]
        environ = {**os.environ, "PYTHONPATH": str(ROOT)}
        return subprocess.run(
            command, cwd=tmp_path, env=environ, capture_output=True, text=True, timeout=LONGEST
        )

    return explain


def test_each_way_to_draw_with_what_it_needs_and_leaves_out(explain):
    result = explain("--json", "--frame", "2")
    assert (result.returncode, result.stderr) == (0, "")
    seen = json.loads(result.stdout)
    ways = {("lighting (1 directional)" in way["needs"], "subdivision" in way["left_out"]): way
            for way in seen["draws"] if way["kind"] == "draw"}  # fmt: skip
    assert len(ways) == 3
    plain, lit, long = ways[False, True], ways[True, True], ways[False, False]
    # Three fans of 40 in this picture, whatever was drawn before, its own array, and a solid of GLUT's.
    primitives = 3 * 38 + 1 + 4
    assert plain["vertices"] == 3 * 40 + 3 + 12
    assert (plain["primitives"], plain["generated"]) == (primitives, primitives)
    assert {"lighting", "fog", "textures", "clip planes"} <= set(plain["left_out"])
    assert (lit["draws"], lit["vertices"], lit["primitives"]) == (1, 30, 28)
    assert "fog by distance" in lit["needs"]
    assert not {"lighting", "fog"} & set(lit["left_out"])
    assert long["primitives"] == 2  # as the program gave them, before they are halved on the CPU
    assert long["generated"] > 10
    assert any(word.startswith("triangles subdivided") for word in long["needs"])
    assert lit["characters"] > plain["characters"] > 500
    assert all(way["seconds"] > 0 for way in ways.values())
    assert (plain["passes"], plain["shaders"], long["shaders"]) == (1, 1, 3)
    assert plain["approximated"] == ["each edge is one straight piece, within 0.5 pixels of its curve"]
    assert long["approximated"] == ["each edge is made of straight pieces, within 0.5 pixels of its curve"]
    assert {way["kind"] for way in seen["draws"]} == {"draw", "rim"}
    names = [each["name"] for each in seen["passes"]]
    assert names == ["scene", "rim", "multisample resolve"]
    assert {"resampling", "finish", "second eye", "6 faces of a cube"} <= set(seen["spared"])


def test_the_passes_of_a_picture(explain):
    seen = json.loads(explain("--json", "--method", "cubemap", "--mirror", "both").stdout)
    assert seen["passes"][0] == {"name": "scene", "times": 5, "into": "5 faces of a cube"}
    names = {each["name"]: each["times"] for each in seen["passes"][1:]}
    assert names == dict.fromkeys(
        ("multisample resolve of the faces", "resampling", "rim", "finish", "multisample resolve"), 1
    )
    assert "1 face of a cube" in seen["spared"]
    ways = {way["kind"]: way for way in seen["draws"]}
    assert ways["resampling"]["primitives"] == 1
    assert ways["finish"]["primitives"] == ways["finish"]["generated"] > 0
    assert all(ways[kind]["characters"] > 200 for kind in ("resampling", "finish"))
    plain = next(way for way in seen["draws"] if "fog" in way["left_out"] and way["kind"] == "draw")
    assert (plain["draws"], plain["passes"]) == (6, 5)
    assert plain["generated"] == 5 * plain["primitives"]
    assert "the faces are resampled, which softens" in plain["approximated"]


def test_what_the_cpu_cuts_and_what_two_eyes_take(explain):
    result = explain("--method", "cpu", "--stereo", "left-right", "--size", "256x128")
    assert "passes        the scene into a disc for each eye; rim" in result.stdout
    assert "draws in 2 passes, " in result.stdout
    assert "cut on the CPU" in result.stdout
    assert "each edge is made of straight pieces, within 0.5 pixels of its curve" in result.stdout


def drawn_by(program, folder):
    (folder / "few.py").write_text(program)
    command = [sys.executable, "-m", "domeshim", "explain", "--json", "--size", "128", "few.py"]
    result = subprocess.run(
        command,
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        timeout=LONGEST,
    )
    return [way for way in json.loads(result.stdout)["draws"] if way["kind"] != "rim"]


def test_a_few_lines_and_quads_are_counted_as_the_program_gave_them(tmp_path):
    ways = drawn_by(FEW, tmp_path)
    assert {way["primitives"] for way in ways} == {6, 1}
    assert all(way["generated"] > 20 for way in ways)


def test_what_own_shaders_draw_is_counted_as_the_program_gave_it(tmp_path):
    pieces, whole = sorted(drawn_by(SHADED, tmp_path), key=lambda way: way["kind"], reverse=True)
    assert (pieces["kind"], whole["kind"]) == ("own pieces", "own")
    assert (pieces["primitives"], whole["primitives"]) == (2, 1)
    assert pieces["generated"] > 20


def test_what_gl_evaluates_is_counted_once(tmp_path):
    triangles, lines = sorted(drawn_by(EVALUATED, tmp_path), key=lambda way: way["primitives"])
    assert lines["primitives"] == 2 * 5 * 4
    assert lines["generated"] > 2 * lines["primitives"]
    assert triangles["primitives"] == triangles["generated"] == 2 * 4 * 4


def test_the_text_and_failures(explain, tmp_path):
    result = explain()
    assert (result.returncode, result.stderr) == (0, "")
    assert "needs         on the dome, method vertex" in result.stdout
    assert "   left out      " in result.stdout
    result = explain("--fov", "x")
    assert (result.returncode, result.stdout) == (2, "")
    assert result.stderr.startswith("domeshim: --fov=x: not a number")


def test_nothing_of_it_is_there_unless_asked():
    script = "import sys, domeshim.measure.capture; print([m for m in sys.modules if 'diagnosis' in m])"
    loaded = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True)
    assert loaded.stdout == "[]\n"
