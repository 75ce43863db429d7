"""A program's own GLSL beside stock GL."""

from __future__ import annotations

import ctypes
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from tests.pictures.beside import GL, Beside, checks, looking, sphere
from tests.pictures.own_glsl import COLOUR, COLOURED, both, program, tiles

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


def test_planes_without_a_clip_vertex_are_said_once(
    beside: Beside, capsys: pytest.CaptureFixture[str]
) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        gl.glUseProgram(both(gl, COLOURED, COLOUR))
        tiles(gl)
        assert "CLIP_PLANE" not in capsys.readouterr().err
        gl.glEnable(gl.GL_CLIP_PLANE0)
        tiles(gl)
        tiles(gl)

    beside.through_dome(scene)
    assert capsys.readouterr().err.count("only GL_CLIP_PLANE0 to 2 cut") == 1


def within_a_scissor(gl: GL) -> None:
    looking(gl)
    gl.glEnable(gl.GL_SCISSOR_TEST)
    gl.glScissor(60, 90, 100, 70)
    gl.glUseProgram(both(gl, COLOURED, COLOUR))
    tiles(gl)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glLoadIdentity()
    gl.glDisable(gl.GL_DEPTH_TEST)
    gl.glScissor(150, 120, 30, 70)
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
        within_a_scissor,
        positions_straight_in_the_window,
        selected,
        geometry_shader,
        refused_text,
    ],
    ids=lambda scene: scene.__name__,
)
def test_beside_stock_gl(beside: Beside, scene: Any) -> None:
    beside.equal(scene)


PLACES = """#version %s
void main() { gl_FragColor = vec4(gl_FragCoord.xy / 256.0, 10.0 * (1.0 - gl_FragCoord.z), gl_FragCoord.w); }
"""


@pytest.mark.parametrize("version", ["120", "150 compatibility"])
@pytest.mark.parametrize("flat", [False, True])
def test_a_fragment_is_told_its_place_in_the_window(beside: Beside, flat: bool, version: str) -> None:
    """Through a wide lens, where its place in the frame is another."""

    def read(gl: GL) -> list[int]:
        gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glLoadIdentity()
        gl.glOrtho(-1, 1, -1, 1, 0, 5) if flat else gl.gluPerspective(60, 1, 1, 10)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glLoadIdentity()
        gl.glUseProgram(both(gl, f"#version {version}\n{COLOURED}", PLACES % version))
        steps = np.linspace(-3, 3, 25)  # the program's own GLSL is not subdivided
        gl.glBegin(gl.GL_QUADS)
        for left, right in pairwise(steps):
            for low, high in pairwise(steps):
                for x, y in ((left, low), (right, low), (right, high), (left, high)):
                    gl.glVertex3f(x, y, -3)
        gl.glEnd()
        gl.glUseProgram(0)
        gl.glPixelStorei(gl.GL_PACK_ALIGNMENT, 1)
        at = [(128, 128), (40, 200), (230, 30), (90, 60)]
        return [v for place in at for v in gl.glReadPixels(*place, 1, 1, gl.GL_RGB, gl.GL_UNSIGNED_BYTE)]

    monitor = beside.monitor(read).answer
    assert monitor[:2] == [128, 128]
    dome = beside.through_dome(read, fov=180.0, panel=60.0).answer
    assert dome == pytest.approx(monitor, abs=3)  # a pixel of the dome is 3 of the window's
