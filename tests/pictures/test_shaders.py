"""A program's own GLSL beside stock GL under a narrow lens, and beside the fixed pipeline under wide ones."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
import OpenGL.GL.ARB.multitexture
import OpenGL.GL.ARB.shader_objects
import OpenGL.GL.ARB.vertex_program
import pytest

from tests.pictures.beside import GL, Beside, checks, looking, sphere

LIT = """\
#version 120
varying vec3 normal;
varying vec4 place;
void main() {
    normal = gl_NormalMatrix * gl_Normal;
    place = gl_ModelViewMatrix * gl_Vertex;
    gl_FrontColor = gl_Color;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
"""
LIGHT = """\
#version 120
varying vec3 normal;
varying vec4 place;
uniform vec3 lamp;
uniform float gain[2];
void main() {
    float lit = max(dot(normalize(normal), normalize(lamp)), 0.0);
    gl_FragColor = vec4(gl_Color.rgb * (gain[0] + gain[1] * lit) + 0.1 * fract(4.0 * place.xyz), 1.0);
}
"""
COLOURED = "void main() { gl_Position = ftransform(); gl_FrontColor = gl_Color; }"
COLOUR = "void main() { gl_FragColor = gl_Color; }"
TEXTURED = """\
uniform sampler2D image;
uniform vec2 shift;
uniform mat3 mix;
uniform bool dark;
uniform ivec2 repeat;
void main() {
    vec4 texel = texture2D(image, gl_TexCoord[1].st * vec2(repeat) + shift);
    gl_FragColor = vec4(mix * texel.rgb * gl_Color.rgb * (dark ? 0.5 : 1.0), 1.0);
}
"""


def program(gl: GL, *stages: tuple[int, str]) -> int:
    name = gl.glCreateProgram()
    for stage, text in stages:
        shader = gl.glCreateShader(stage)
        gl.glShaderSource(shader, text)
        gl.glCompileShader(shader)
        assert gl.glGetShaderiv(shader, gl.GL_COMPILE_STATUS), gl.glGetShaderInfoLog(shader)
        gl.glAttachShader(name, shader)
        gl.glDeleteShader(shader)
    gl.glLinkProgram(name)
    assert gl.glGetProgramiv(name, gl.GL_LINK_STATUS), gl.glGetProgramInfoLog(name)
    return int(name)


def both(gl: GL, vertex: str, fragment: str) -> int:
    return program(gl, (gl.GL_VERTEX_SHADER, vertex), (gl.GL_FRAGMENT_SHADER, fragment))


def tiles(gl: GL, *, size: float = 0.7, pieces: int = 6) -> None:
    """A square of coloured tiles."""
    edges = np.linspace(-size, size, pieces + 1)
    gl.glBegin(gl.GL_QUADS)
    for i in range(pieces):
        for j in range(pieces):
            gl.glColor3f(i / pieces, j / pieces, (i + j) % 2)
            for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                gl.glTexCoord2f((i + di) / pieces, (j + dj) / pieces)
                gl.glMultiTexCoord2f(gl.GL_TEXTURE1, (i + di) / pieces, (j + dj) / pieces)
                gl.glVertex2f(edges[i + di], edges[j + dj])
    gl.glEnd()


def lighting_of_its_own(gl: GL) -> Any:
    looking(gl)
    name = both(gl, LIT, LIGHT)
    gl.glUseProgram(name)
    lamp, gain = gl.glGetUniformLocation(name, "lamp"), gl.glGetUniformLocation(name, "gain")
    gl.glUniform3f(lamp, 1, 2, 3)
    gl.glUniform1fv(gain, 2, [0.3, 0.6])
    gl.glColor3f(1, 0.8, 0.4)
    sphere(gl)
    gl.glUniform3f(lamp, -1, 0, 1)
    gl.glTranslatef(0.5, 0.5, 0.5)
    sphere(gl, 0.3)
    active = gl.glGetProgramiv(name, gl.GL_ACTIVE_UNIFORMS)
    names = sorted(str(gl.glGetActiveUniform(name, i)[0]) for i in range(active))
    current = gl.glGetIntegerv(gl.GL_CURRENT_PROGRAM) == name
    return int(active), names, bool(current), tuple(gl.glGetIntegerv(gl.GL_VIEWPORT))


def own_and_fixed_in_turn(gl: GL) -> None:
    looking(gl)
    name = both(gl, COLOURED, "void main() { gl_FragColor = gl_Color.brga; }")
    for i in range(4):
        gl.glUseProgram(name if i % 2 else 0)
        gl.glPushMatrix()
        gl.glTranslatef(0.4 * i - 0.6, 0.1 * i, 0.1 * i)
        tiles(gl, size=0.3, pieces=3)
        gl.glPopMatrix()


def generic_attributes_in_buffers(gl: GL) -> None:
    looking(gl, depth=False)
    name = both(
        gl,
        """#version 120
        attribute vec2 at; attribute vec3 tint; uniform mat4 model; varying vec3 c;
        void main() { c = tint; gl_Position = gl_ModelViewProjectionMatrix * model * vec4(at, 0.0, 1.0); }""",
        "#version 120\nvarying vec3 c; void main() { gl_FragColor = vec4(c, 1.0); }",
    )
    corners = np.random.default_rng(5).uniform(-0.7, 0.7, (30, 2))
    data = np.hstack([corners, np.random.default_rng(6).uniform(0, 1, (30, 3))]).astype(np.float32)
    gl.glUseProgram(name)
    gl.glUniformMatrix4fv(gl.glGetUniformLocation(name, "model"), 1, gl.GL_TRUE, np.diag([1, 0.8, 1, 1]))
    gl.glBindBuffer(gl.GL_ARRAY_BUFFER, gl.glGenBuffers(1))
    gl.glBufferData(gl.GL_ARRAY_BUFFER, data.nbytes, data, gl.GL_STATIC_DRAW)
    for attribute, size, offset in (("at", 2, 0), ("tint", 3, 8)):
        location = gl.glGetAttribLocation(name, attribute)
        gl.glEnableVertexAttribArray(location)
        gl.glVertexAttribPointer(location, size, gl.GL_FLOAT, gl.GL_FALSE, 20, ctypes.c_void_p(offset))
    gl.glDrawArrays(gl.GL_TRIANGLES, 0, 30)


def in_a_display_list(gl: GL) -> None:
    looking(gl)
    name = both(gl, COLOURED, "void main() { gl_FragColor = gl_Color.brga; }")
    gl.glNewList(1, gl.GL_COMPILE)
    tiles(gl, size=0.4)
    gl.glUseProgram(name)
    gl.glTranslatef(0.3, 0.3, 0.2)
    tiles(gl, size=0.3)
    gl.glUseProgram(0)
    gl.glEndList()
    gl.glCallList(1)


def fragments_alone(gl: GL) -> Any:
    looking(gl)
    gl.glActiveTexture(gl.GL_TEXTURE1)
    checks(gl)
    gl.glDisable(gl.GL_TEXTURE_2D)
    gl.glMatrixMode(gl.GL_TEXTURE)
    gl.glScalef(0.7, 1.3, 1)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glEnable(gl.GL_LIGHT0)
    gl.glEnable(gl.GL_COLOR_MATERIAL)
    gl.glNormal3f(0.2, 0, 1)
    name = program(gl, (gl.GL_FRAGMENT_SHADER, TEXTURED))
    gl.glUseProgram(name)
    place = {u: gl.glGetUniformLocation(name, u) for u in ("image", "shift", "mix", "dark", "repeat")}
    gl.glUniform1i(place["image"], 1)
    gl.glUniform2f(place["shift"], 0.1, 0.2)
    gl.glUniform2i(place["repeat"], 1, 2)
    gl.glUniformMatrix3fv(
        place["mix"], 1, gl.GL_FALSE, np.array([[1, 0, 0.2], [0, 1, 0], [0.3, 0, 0.7]], "f")
    )
    tiles(gl, size=0.5)
    gl.glUniform1i(place["dark"], 1)
    gl.glTranslatef(0.3, 0.4, 0.2)
    tiles(gl, size=0.3)
    return int(gl.glGetIntegerv(gl.GL_CURRENT_PROGRAM)) == name


def planes_by_its_own_clip_vertex(gl: GL) -> None:
    looking(gl)
    clip = COLOURED.replace("main() {", "main() { gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;")
    gl.glUseProgram(both(gl, clip, COLOUR))
    gl.glClipPlane(gl.GL_CLIP_PLANE1, (1, 0.3, 0, 0.2))
    gl.glEnable(gl.GL_CLIP_PLANE1)
    tiles(gl)


def positions_straight_in_the_window(gl: GL) -> None:
    looking(gl)
    gl.glUseProgram(both(gl, "void main() { gl_Position = gl_Vertex; gl_FrontColor = gl_Color; }", COLOUR))
    tiles(gl, size=0.9)


def selected(gl: GL) -> Any:
    looking(gl)
    gl.glUseProgram(both(gl, COLOURED, COLOUR))
    tiles(gl)
    gl.glSelectBuffer(64)
    gl.glRenderMode(gl.GL_SELECT)
    gl.glInitNames()
    gl.glPushName(0)
    for i in range(3):
        gl.glLoadName(i + 7)
        gl.glPushMatrix()
        gl.glTranslatef(2.0 * i - 2, 0, 0)
        tiles(gl)
        gl.glPopMatrix()
    return [(list(hit.names), hit.near, hit.far) for hit in gl.glRenderMode(gl.GL_RENDER)]


def geometry_shader(gl: GL) -> None:
    looking(gl, depth=False)
    gl.glUseProgram(
        program(
            gl,
            (
                gl.GL_VERTEX_SHADER,
                """#version 150 compatibility
                out vec4 tint;
                void main() { tint = gl_Color; gl_Position = gl_ModelViewMatrix * gl_Vertex; }""",
            ),
            (
                gl.GL_GEOMETRY_SHADER,
                """#version 150 compatibility
                layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;
                in vec4 tint[]; out vec4 c;
                void main() {
                    for (int i = 0; i < 3; ++i) {
                        c = tint[i];
                        vec4 p = gl_in[i].gl_Position;
                        gl_Position = gl_ProjectionMatrix * (p + vec4(0.1 * p.y, 0.0, 0.0, 0.0));
                        EmitVertex();
                    }
                    EndPrimitive();
                }""",
            ),
            (gl.GL_FRAGMENT_SHADER, "#version 150\nin vec4 c; out vec4 o; void main() { o = c; }"),
        )
    )
    gl.glBegin(gl.GL_TRIANGLES)
    for i in range(30):
        gl.glColor3f(i % 3 / 2, i % 5 / 4, 0.5)
        gl.glVertex2f(np.sin(2.0 * i) * 0.6, np.cos(3.0 * i) * 0.6)
    gl.glEnd()


def refused_text(gl: GL) -> Any:
    looking(gl)
    tiles(gl)
    shader = gl.glCreateShader(gl.GL_VERTEX_SHADER)
    gl.glShaderSource(shader, "void main() {\n gl_Position = nothing(); }")
    gl.glCompileShader(shader)
    name = gl.glCreateProgram()
    gl.glAttachShader(name, shader)
    gl.glLinkProgram(name)
    compiled, logged = gl.glGetShaderiv(shader, gl.GL_COMPILE_STATUS), gl.glGetShaderInfoLog(shader)
    linked = gl.glGetProgramiv(name, gl.GL_LINK_STATUS)
    return int(compiled), bytes(logged), int(linked), bytes(gl.glGetProgramInfoLog(name))


@pytest.mark.parametrize(
    "scene",
    [
        lighting_of_its_own,
        own_and_fixed_in_turn,
        generic_attributes_in_buffers,
        in_a_display_list,
        fragments_alone,
        planes_by_its_own_clip_vertex,
        positions_straight_in_the_window,
        selected,
        geometry_shader,
        refused_text,
    ],
    ids=lambda scene: scene.__name__,
)
def test_beside_stock_gl(beside: Beside, scene: Any) -> None:
    beside.equal(scene)


# All over the dome: whatever reaches GL by the fixed pipeline and by a shader must land on the same pixels.


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


@pytest.mark.parametrize("product", [False, True], ids=["projection alone", "product"])
def test_matrices_of_its_own_in_uniforms(beside: Beside, product: bool) -> None:
    def views(gl: GL) -> Any:
        for i in range(2):
            gl.glLoadIdentity()
            gl.glRotatef(20 + 50 * i, 1, 2, 0)
            gl.glScalef(0.5 + i, 0.5 + i, 0.5 + i)
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


def test_the_names_of_the_extensions_reach_the_dome(beside: Beside) -> None:
    text = "void main() { gl_Position = ftransform(); gl_FrontColor = gl_MultiTexCoord1; }"
    arb = {**vars(OpenGL.GL.ARB.shader_objects), **vars(OpenGL.GL.ARB.multitexture)}

    def core(gl: GL) -> None:
        looking(gl, depth=False)
        gl.glUseProgram(program(gl, (gl.GL_VERTEX_SHADER, text)))
        triangles(gl, gl.glMultiTexCoord4f)

    def extensions(gl: GL) -> None:
        looking(gl, depth=False)
        name = arb["glCreateProgramObjectARB"]()
        shader = arb["glCreateShaderObjectARB"](gl.GL_VERTEX_SHADER)
        arb["glShaderSourceARB"](shader, [text])
        arb["glCompileShaderARB"](shader)
        arb["glAttachObjectARB"](name, shader)
        arb["glLinkProgramARB"](name)
        arb["glUseProgramObjectARB"](name)
        assert arb["glGetHandleARB"](arb["GL_PROGRAM_OBJECT_ARB"]) == name
        triangles(gl, arb["glMultiTexCoord4fARB"])

    def triangles(gl: GL, coordinate: Any) -> None:
        gl.glBegin(gl.GL_TRIANGLES)
        for i in range(60):
            coordinate(gl.GL_TEXTURE1, i % 3 / 2, i % 5 / 4, 0.5, 1)
            gl.glVertex2f(np.sin(2.0 * i) * 0.6, np.cos(3.0 * i) * 0.6)
        gl.glEnd()

    monitor, dome = beside.monitor(core), beside.through_dome(extensions)
    assert monitor.picture.std() > 10
    beside.assert_equal(monitor.picture, dome.picture, name="extensions")


def test_edges_that_stay_straight_are_said_once(beside: Beside, capsys: pytest.CaptureFixture[str]) -> None:
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

    beside.through_dome(own, fov=180)
    said = capsys.readouterr().err.splitlines()
    assert len(said) == 1
    assert "stay straight" in said[0]


def test_vertex_programs_in_assembly_draw_as_on_the_monitor(
    beside: Beside, capsys: pytest.CaptureFixture[str]
) -> None:
    arb = {**vars(OpenGL.GL.ARB.vertex_program)}
    text = b"""!!ARBvp1.0
        ADD result.position, vertex.position, {0.1, 0.1, 0.0, 0.0};
        MOV result.color, {1.0, 0.5, 0.2, 1.0};
        END"""
    enables: list[bool] = []

    def scene(gl: GL) -> None:
        looking(gl)
        load = arb["glProgramStringARB"]
        target, form = arb["GL_VERTEX_PROGRAM_ARB"], arb["GL_PROGRAM_FORMAT_ASCII_ARB"]
        arb["glBindProgramARB"](target, 1)
        load(target, form, len(text), text)
        gl.glEnable(target)
        gl.glRectf(-0.5, -0.5, 0.3, 0.3)
        gl.glDisable(target)
        enables.append(bool(gl.glIsEnabled(target)))

    beside.equal(scene)
    assert enables == [False, False]
    assert "assembly" in capsys.readouterr().err


def test_what_cannot_be_bent_is_said_once(beside: Beside, capsys: pytest.CaptureFixture[str]) -> None:
    def own(gl: GL) -> None:
        looking(gl)
        taken = "uniform vec3 domeMode; void main() { gl_Position = ftransform() + vec4(domeMode, 0.0); }"
        name = both(gl, taken, "void main() { gl_FragColor = vec4(1.0); }")
        for _ in range(3):
            gl.glUseProgram(name)
            tiles(gl)
            gl.glUseProgram(0)

    beside.through_dome(own)
    said = [line for line in capsys.readouterr().err.splitlines() if "GLSL" in line]
    assert len(said) == 1
