"""All over the dome, what is drawn by a shader lands where the fixed pipeline lands."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.pictures.beside import GL, Beside, sphere
from tests.pictures.own_glsl import COLOUR, COLOURED, both


def room(gl: GL) -> None:
    """Tiles all around the viewer, before and behind."""
    n = 16
    edges = np.linspace(-3, 3, n + 1)
    for axis in range(3):
        for side in (-3.0, 3.0):
            gl.glBegin(gl.GL_QUADS)
            for i in range(n):
                for j in range(n):
                    gl.glColor3f((i + j) % 2, axis / 2, 0.5 + side / 8)
                    for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        gl.glVertex3f(*np.roll((side, edges[i + di], edges[j + dj]), axis))
            gl.glEnd()


def wide(gl: GL, projection: tuple[float, ...] = (60, 1, 0.1, 100)) -> None:
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gl.gluPerspective(*projection)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glLoadIdentity()
    gl.glRotatef(20, 1, 2, 0)


OPTIONS = [
    {"fov": 180},
    {"fov": 180, "tilt": 30},
    {"fov": 230, "tilt": -15},
    {"fov": 180, "lens": ("polynomial", (0.7, -0.05, 0.01, 0.0, 0.0))},
    {"fov": 180, "fill": 120.0},
]


@pytest.mark.parametrize("options", OPTIONS, ids=str)
def test_a_shader_lands_where_the_fixed_pipeline_does(beside: Beside, options: dict[str, Any]) -> None:
    def fixed(gl: GL) -> None:
        wide(gl)
        room(gl)

    def own(gl: GL) -> None:
        wide(gl)
        gl.glUseProgram(both(gl, COLOURED, COLOUR))
        room(gl)

    options = {"method": "vertex", **options}
    one, other = beside.through_dome(fixed, **options), beside.through_dome(own, **options)
    assert one.picture.std() > 10
    beside.assert_equal(one.picture, other.picture, name=f"own-{options}", wrong=0.001)


def test_own_and_fixed_geometry_hide_each_other_by_distance(beside: Beside) -> None:
    def drawn(own: bool) -> Any:
        def scene(gl: GL) -> None:
            wide(gl, (60, 1, 0.01, 1000))
            name = both(gl, COLOURED, COLOUR)
            for i in range(12):
                gl.glUseProgram(name if own and i % 2 else 0)
                gl.glPushMatrix()
                gl.glRotatef(30 * i, 1, 0.3 * i, 0.2)
                gl.glTranslatef(0, 0, -2 - 0.05 * i)
                gl.glColor3f(i / 12, i % 3 / 2, 0.5)
                sphere(gl, 0.9)
                gl.glPopMatrix()

        return scene

    options = {"method": "vertex", "fov": 180}
    one, other = (beside.through_dome(drawn(own), **options) for own in (False, True))
    beside.assert_equal(one.picture, other.picture, name="own-depth", wrong=0.002)


@pytest.mark.parametrize("stretch", [(1, 1, 1), (2, 0.5, 1), (1, -1, 1)], ids=str)
@pytest.mark.parametrize("product", [False, True], ids=["projection alone", "product"])
def test_matrices_of_its_own_in_uniforms(beside: Beside, product: bool, stretch: tuple[float, ...]) -> None:
    def views(gl: GL) -> Any:
        for i in range(2):
            gl.glLoadIdentity()
            gl.glRotatef(20 + 50 * i, 1, 2, 0)
            gl.glScalef(*((0.5 + i) * along for along in stretch))
            yield gl.glGetFloatv(gl.GL_MODELVIEW_MATRIX)

    def fixed(gl: GL) -> None:
        wide(gl)
        for _ in views(gl):
            room(gl)

    def own(gl: GL) -> None:
        wide(gl)
        projection = gl.glGetFloatv(gl.GL_PROJECTION_MATRIX)
        name = both(
            gl,
            """#version 120
            uniform mat4 all, eye;
            void main() { gl_Position = all * eye * gl_Vertex; gl_FrontColor = gl_Color; }""",
            COLOUR,
        )
        gl.glUseProgram(name)
        whole, eye = gl.glGetUniformLocation(name, "all"), gl.glGetUniformLocation(name, "eye")
        for view in views(gl):
            gl.glMatrixMode(gl.GL_PROJECTION)
            gl.glLoadIdentity()
            gl.glMatrixMode(gl.GL_MODELVIEW)
            gl.glUniformMatrix4fv(whole, 1, gl.GL_FALSE, view @ projection if product else projection)
            gl.glUniformMatrix4fv(eye, 1, gl.GL_FALSE, np.eye(4, dtype="f") if product else view)
            room(gl)

    options = {"method": "vertex", "fov": 180}
    one, other = beside.through_dome(fixed, **options), beside.through_dome(own, **options)
    beside.assert_equal(one.picture, other.picture, name=f"own-matrices-{product}", wrong=0.002)


@pytest.mark.parametrize("method", ["cpu", "geometry"])
def test_edges_that_stay_straight_are_said_once(
    beside: Beside, capsys: pytest.CaptureFixture[str], method: str
) -> None:
    def own(gl: GL) -> None:
        wide(gl)
        gl.glUseProgram(both(gl, COLOURED, COLOUR))
        for size in (0.01, 5.0, 6.0):
            gl.glBegin(gl.GL_TRIANGLES)
            for x, y in ((-1, -1), (1, -1), (0, 1)):
                gl.glVertex3f(size * x, size * y, -2)
            gl.glEnd()
            gl.glFlush()
            if size < 1:
                assert capsys.readouterr().err == ""

    beside.through_dome(own, fov=180, method=method)
    said = capsys.readouterr().err.splitlines()
    assert len(said) == 1
    assert "stay straight" in said[0]
