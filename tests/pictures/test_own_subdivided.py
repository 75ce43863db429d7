"""What a program's own shader draws large is bent between its vertices, as the fixed pipeline's is."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
import pytest

from tests.pictures.beside import GL, Beside
from tests.pictures.own_glsl import COLOUR, COLOURED, both
from tests.pictures.test_shaders_wide import wide

CORNERS = ((-1, -1), (1, -1), (1, 1), (-1, 1))
GENERIC = """\
#version 120
attribute vec3 at, tint;
varying vec3 c;
void main() { c = tint; gl_Position = gl_ModelViewProjectionMatrix * vec4(at, 1.0); }
"""
GENERIC_COLOUR = "#version 120\nvarying vec3 c; void main() { gl_FragColor = vec4(c, 1.0); }"


def floor(gl: GL, height: float = -1.5) -> None:
    """One quad under the viewer."""
    gl.glBegin(gl.GL_QUADS)
    for i, (x, z) in enumerate(CORNERS):
        gl.glColor3f(i / 4, i % 2, 0.5)
        gl.glVertex3f(40 * x, height, -40 * z)
    gl.glEnd()


def box(gl: GL) -> None:
    """Six quads close by."""
    gl.glPushMatrix()
    gl.glTranslatef(0.4, 0.3, -1.6)
    gl.glRotatef(30, 1, 1, 0)
    gl.glBegin(gl.GL_QUADS)
    for axis in range(3):
        for side in (-0.8, 0.8):
            for u, v in CORNERS:
                gl.glColor3f(u / 2 + 0.5, v / 2 + 0.5, axis / 2)
                gl.glVertex3f(*np.roll((side, 0.8 * u, 0.8 * v), axis))
    gl.glEnd()
    gl.glPopMatrix()


def beams(gl: GL) -> None:
    """Long lines, wide enough to be compared."""
    gl.glLineWidth(5)
    gl.glBegin(gl.GL_LINES)
    for height in (-1, 2, 4):
        for end in (-50, 50):
            gl.glColor3f(1, height / 4, end / 100 + 0.5)
            gl.glVertex3f(end, height, -3)
    gl.glEnd()


def beside_fixed(
    beside: Beside,
    things: Callable[[GL], None],
    vertex: str = COLOURED,
    fragment: str = COLOUR,
    *,
    wrong: float = 0.003,
    **options: Any,
) -> None:
    """Assert that a shader's picture is the fixed pipeline's, and not what the vertices alone give."""

    def scene(gl: GL, own: bool) -> None:
        wide(gl)
        if own:
            gl.glUseProgram(both(gl, vertex, fragment))
        things(gl)

    own, fixed = (
        beside.through_dome(partial(scene, own=o), fov=180, **options).picture for o in (True, False)
    )
    straight = beside.through_dome(partial(scene, own=True), fov=180, method="vertex").picture
    assert fixed.std() > 10
    beside.assert_equal(fixed, own, name=f"own-{getattr(things, '__name__', 'drawn')}", wrong=wrong)
    assert (np.abs(straight.astype(int) - fixed) > 8).any(-1).mean() > 3 * wrong


@pytest.mark.parametrize("things", [floor, box, beams], ids=lambda things: things.__name__)
def test_large_primitives_bend(beside: Beside, things: Callable[[GL], None]) -> None:
    beside_fixed(beside, things)


@pytest.mark.parametrize(
    "options",
    [{"tilt": 40}, {"seat": (0.2, 0.1, 0.0)}, {"lens": ("equisolid", ())}, {"stereo": "top-bottom"}],
    ids=str,
)
def test_they_bend_on_every_kind_of_dome(beside: Beside, options: dict[str, Any]) -> None:
    beside_fixed(beside, box, **options)


def test_a_wide_field_of_view_cuts_none_away(beside: Beside) -> None:
    def scene(gl: GL, own: bool) -> None:
        wide(gl)
        if own:
            gl.glUseProgram(both(gl, COLOURED, COLOUR))
        for height in (-1.5, 1.5):
            floor(gl, height)

    own, fixed = (beside.through_dome(partial(scene, own=o), fov=300).picture for o in (True, False))
    beside.assert_equal(fixed, own, name="own-300", wrong=0.01)


def generic(gl: GL, name: int, draw: Callable[[GL], None], *, array_object: bool = False) -> None:
    """Two quads under and over the viewer from generic attributes in one buffer."""
    data = np.array(
        [
            (30 * x, height, -30 * z, z / 2 + 0.5, x / 2 + 0.5, 1)
            for height in (-1.5, 2.5)
            for x, z in CORNERS
        ],
        "f",
    )
    if array_object:
        gl.glBindVertexArray(gl.glGenVertexArrays(1))
    gl.glBindBuffer(gl.GL_ARRAY_BUFFER, gl.glGenBuffers(1))
    gl.glBufferData(gl.GL_ARRAY_BUFFER, data.nbytes, data, gl.GL_STATIC_DRAW)
    for attribute, offset in (("at", 0), ("tint", 12)):
        location = gl.glGetAttribLocation(name, attribute)
        gl.glEnableVertexAttribArray(location)
        gl.glVertexAttribPointer(location, 3, gl.GL_FLOAT, gl.GL_FALSE, 24, ctypes.c_void_p(offset))
    draw(gl)


def by_arrays(gl: GL) -> None:
    gl.glDrawArrays(gl.GL_QUADS, 0, 8)


def by_elements(gl: GL) -> None:
    numbers = np.array([0, 1, 3, 2, 4, 5, 7, 6], np.uint16)
    gl.glDrawElements(gl.GL_TRIANGLE_STRIP, 4, gl.GL_UNSIGNED_SHORT, numbers)
    gl.glDrawRangeElements(gl.GL_TRIANGLE_STRIP, 4, 7, 4, gl.GL_UNSIGNED_SHORT, numbers[4:].copy())


def by_elements_in_a_buffer(gl: GL) -> None:
    numbers = np.array([0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7], np.uint32)
    buffer = gl.glGenBuffers(1)
    gl.glBindBuffer(gl.GL_ELEMENT_ARRAY_BUFFER, buffer)
    gl.glBufferData(gl.GL_ELEMENT_ARRAY_BUFFER, numbers.nbytes, numbers, gl.GL_STATIC_DRAW)
    gl.glDrawElements(gl.GL_TRIANGLES, 12, gl.GL_UNSIGNED_INT, ctypes.c_void_p(0))
    assert gl.glGetIntegerv(gl.GL_ELEMENT_ARRAY_BUFFER_BINDING) == buffer


@pytest.mark.parametrize("array_object", [False, True], ids=["", "vertex array object"])
@pytest.mark.parametrize("draw", [by_arrays, by_elements, by_elements_in_a_buffer], ids=lambda d: d.__name__)
def test_generic_attributes(beside: Beside, draw: Callable[[GL], None], array_object: bool) -> None:
    def own(gl: GL) -> None:
        wide(gl)
        name = both(gl, GENERIC, GENERIC_COLOUR)
        gl.glUseProgram(name)
        generic(gl, name, draw, array_object=array_object)

    def fixed(gl: GL) -> None:
        wide(gl)
        gl.glBegin(gl.GL_QUADS)
        for height in (-1.5, 2.5):
            for x, z in CORNERS:
                gl.glColor3f(z / 2 + 0.5, x / 2 + 0.5, 1)
                gl.glVertex3f(30 * x, height, -30 * z)
        gl.glEnd()

    one, other = (beside.through_dome(scene, fov=180).picture for scene in (own, fixed))
    beside.assert_equal(other, one, name=f"own-{draw.__name__}", wrong=0.003)


EACH_KIND = """\
#version 150 compatibility
uniform float gain;
out vec2 many[2];
out mat3 turn;
flat out ivec3 number;
out Surface { vec3 normal; float share; } place;
void main() {
    many[0] = many[1] = gl_Vertex.xz / 80.0;
    turn = mat3(gain * gl_Color.rgb, vec3(0.0), vec3(0.0));
    number = ivec3(gl_Color.rgb * 255.5);
    place.normal = gl_Color.rgb;
    place.share = gl_Vertex.x / 80.0;
    gl_FrontColor = gl_Color;
    gl_TexCoord[1] = gl_Color;
    gl_Position = ftransform();
}
"""
READ = """\
#version 150 compatibility
in vec2 many[2];
in mat3 turn;
flat in ivec3 number;
in Surface {{ vec3 normal; float share; }} place;
void main() {{ gl_FragColor = vec4({}, 1.0); }}
"""
SMOOTH = (
    "turn[0]",
    "place.normal",
    "gl_Color.rgb",
    "gl_TexCoord[1].rgb",
    "gl_Color.rgb + 2.0 * (many[1].x - place.share)",
)


@pytest.mark.parametrize("value", SMOOTH)
def test_each_kind_of_varying_is_blended(beside: Beside, value: str) -> None:
    def own(gl: GL) -> None:
        wide(gl)
        name = both(gl, EACH_KIND, READ.format(value))
        gl.glUseProgram(name)
        gl.glUniform1f(gl.glGetUniformLocation(name, "gain"), 1)
        floor(gl)

    def fixed(gl: GL) -> None:
        wide(gl)
        floor(gl)

    one, other = (beside.through_dome(scene, fov=180).picture for scene in (own, fixed))
    beside.assert_equal(other, one, name="own-varying", wrong=0.004)


def test_integers_and_flat_colours_are_those_of_one_corner(beside: Beside) -> None:
    def scene(gl: GL, fragment: str | None) -> None:
        wide(gl)
        gl.glShadeModel(gl.GL_FLAT)
        if fragment is not None:
            gl.glUseProgram(both(gl, EACH_KIND, READ.format(fragment)))
        gl.glBegin(gl.GL_TRIANGLE_STRIP)
        for i, (x, z) in enumerate(((-1, -1), (1, -1), (-1, 1), (1, 1))):
            gl.glColor3ub(50 * i + 20, 90 * (i % 2), 128)
            gl.glVertex3f(40 * x, -1.5, -40 * z)
        gl.glEnd()

    fixed, number, colour = (
        beside.through_dome(partial(scene, fragment=f), fov=180).picture
        for f in (None, "vec3(number) / 255.0", "gl_Color.rgb")
    )
    beside.assert_equal(fixed, number, name="own-number", wrong=0.003)
    beside.assert_equal(fixed, colour, name="own-flat", wrong=0.003)


def test_uniforms_are_those_of_each_draw(beside: Beside) -> None:
    vertex = """uniform vec3 shift;
    void main() { gl_Position = gl_ModelViewProjectionMatrix * (gl_Vertex + vec4(shift, 0)); }"""
    fragment = (
        "uniform vec3 tint[2]; uniform int which; void main() { gl_FragColor = vec4(tint[which], 1.0); }"
    )

    def own(gl: GL) -> Any:
        wide(gl)
        name = both(gl, vertex, fragment)
        places = [gl.glGetUniformLocation(name, u) for u in ("shift", "tint", "which")]
        gl.glUseProgram(name)
        gl.glUniform3fv(places[1], 2, [[1, 0.5, 0], [0, 0.5, 1]])
        for which, height in enumerate((-1.5, 2.0)):
            gl.glUniform3f(places[0], 0, height, 0)
            gl.glUniform1i(places[2], which)
            floor(gl, 0)
        return [
            int(gl.glGetIntegerv(gl.GL_CURRENT_PROGRAM)) == name,
            int(gl.glGetProgramiv(name, gl.GL_ACTIVE_UNIFORMS)),
            int(gl.glGetError()),
        ]

    def fixed(gl: GL) -> None:
        wide(gl)
        for colour, height in (((1, 0.5, 0), -1.5), ((0, 0.5, 1), 2.0)):
            gl.glBegin(gl.GL_QUADS)
            gl.glColor3f(*colour)
            for x, z in CORNERS:
                gl.glVertex3f(40 * x, height, -40 * z)
            gl.glEnd()

    one, other = (beside.through_dome(scene, fov=180) for scene in (own, fixed))
    beside.assert_equal(other.picture, one.picture, name="own-uniforms", wrong=0.003)
    assert one.answer == beside.monitor(own).answer


def test_display_lists(beside: Beside) -> None:
    def listed(gl: GL) -> None:
        gl.glNewList(1, gl.GL_COMPILE)
        floor(gl)
        box(gl)
        gl.glEndList()
        gl.glCallList(1)

    beside_fixed(beside, listed)


def test_clip_planes_cut_what_is_subdivided(beside: Beside) -> None:
    vertex = COLOURED.replace("main() {", "main() { gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;")

    def cut(gl: GL) -> None:
        gl.glClipPlane(gl.GL_CLIP_PLANE1, (1, 0.3, 0, 0.2))
        gl.glEnable(gl.GL_CLIP_PLANE1)
        floor(gl)

    beside_fixed(beside, cut, vertex)


def test_a_program_with_stages_of_its_own_stays_and_says_why(
    beside: Beside, capsys: pytest.CaptureFixture[str]
) -> None:
    vertex = (
        "struct S { vec3 c; }; varying S s; void main() { s.c = gl_Color.rgb; gl_Position = ftransform(); }"
    )
    fragment = "struct S { vec3 c; }; varying S s; void main() { gl_FragColor = vec4(s.c, 1.0); }"

    def own(gl: GL) -> None:
        wide(gl)
        gl.glUseProgram(
            both(
                gl,
                "#version 150 compatibility\n" + vertex.replace("varying", "out"),
                "#version 150 compatibility\n" + fragment.replace("varying", "in"),
            )
        )
        floor(gl)
        floor(gl)

    assert beside.through_dome(own, fov=180).picture.std() > 0
    said = [line for line in capsys.readouterr().err.splitlines() if "stay straight" in line]
    assert said == [
        "domeshim: long edges drawn by the program's own GLSL stay straight: it hands on a value of type S"
    ]


@pytest.mark.parametrize(
    "vertex",
    [
        "gl_Position = ftransform();",
        "vec4 eye = gl_ModelViewMatrix * gl_Vertex; gl_Position = gl_ProjectionMatrix * eye;",
    ],
)
def test_a_mesh_without_long_edges_stays_with_the_plain_program(beside: Beside, vertex: str) -> None:
    def scene(gl: GL) -> None:
        wide(gl)
        gl.glUseProgram(both(gl, f"void main() {{ {vertex} gl_FrontColor = gl_Color; }}", COLOUR))
        for size, made in ((0.01, False), (5.0, True)):
            gl.glBegin(gl.GL_TRIANGLES)
            for x, y in ((-1, -1), (1, -1), (0, 1)):
                gl.glVertex3f(size * x, size * y, -2)
            gl.glEnd()
            gl.glFlush()
            own = beside.session.dome.context.own.current
            assert own.subdivided.made is made

    beside.through_dome(scene, fov=180)


def test_a_shader_that_moves_its_vertices_is_looked_at_where_they_go(beside: Beside) -> None:
    vertex = """void main() {
        gl_FrontColor = gl_Color;
        gl_Position = gl_ModelViewProjectionMatrix * vec4(400.0 * gl_Vertex.xyz, 1.0);
    }"""

    def scene(gl: GL, own: bool) -> None:
        wide(gl)
        if own:
            gl.glUseProgram(both(gl, vertex, COLOUR))
        scale = 1 / 400 if own else 1
        gl.glBegin(gl.GL_QUADS)
        for i, (x, z) in enumerate(CORNERS):
            gl.glColor3f(i / 4, i % 2, 0.5)
            gl.glVertex3f(40 * scale * x, -1.5 * scale, -40 * scale * z)
        gl.glEnd()

    one, other = (beside.through_dome(partial(scene, own=o), fov=180).picture for o in (True, False))
    beside.assert_equal(other, one, name="own-moved", wrong=0.003)


def test_the_panel_stays_as_it_is(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glUseProgram(both(gl, COLOURED, COLOUR))
        gl.glBegin(gl.GL_QUADS)
        for i, corner in enumerate(CORNERS):
            gl.glColor3f(i / 4, i % 2, 0.5)
            gl.glVertex2f(*corner)
        gl.glEnd()

    one, other = (
        beside.through_dome(scene, fov=180, panel=60, method=method).picture for method in ("auto", "vertex")
    )
    assert (one == other).all()
