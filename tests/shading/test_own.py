"""A program's own shader is rewritten as text, and the driver takes what comes out."""

from __future__ import annotations

from ctypes import c_char_p, c_int, create_string_buffer
from dataclasses import replace

import pytest

from domeshim.shading import exchange
from domeshim.shading.own import Landing, rewritten
from domeshim.shading.own_text import has_main, leaves_fixed_place, uses_projection
from tests.shading.test_compose import LENSES

PLAIN = "void main() { gl_Position = ftransform(); }"
VERSIONED = """\
/* #version 999 in a comment
   is none */
#version 120
#extension GL_ARB_draw_buffers : enable
#ifdef GL_EXT_gpu_shader4
#extension GL_EXT_gpu_shader4 : enable
#endif
#define r 3
#define place gl_Vertex
varying vec3 n; // not main( here
void main(void) { n = gl_NormalMatrix * gl_Normal; gl_Position = gl_ModelViewProjectionMatrix * place; }
"""
CLIPPED = "void main() { gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex; gl_Position = ftransform(); }"
CORE = """\
#version 330 core
layout(location = 0) in vec3 at;
uniform mat4 mvp;
void main() { gl_Position = mvp * vec4(at, 1.0); }
"""
NAMED_LIKE_OURS = """\
#version 120
vec4 bent(vec4 p) { return p; }
float lensRadius(float phi) { return phi; }
void main() { if (lensRadius(1.0) > 2.0) return; gl_Position = bent(ftransform()); }
"""
TOO_OLD_FOR_CLIPPING = (
    "#version 120\nattribute float smooth; void main() { gl_Position = smooth * ftransform(); }"
)
GEOMETRY = """\
#version 150 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
void main() {
    for (int i = 0; i < 3; ++i) { gl_Position = gl_in[i].gl_Position; EmitVertex(); }
    EndPrimitive();
}
"""
LANDINGS = [
    *(Landing((f"lens/{lens}", "bend/radial")) for lens in LENSES),
    Landing(("bend/cylinder",), clip="wedge"),
    *(Landing(aim=aim, clip=clip) for aim in ("straight", "turned", "seated") for clip in ("behind", "cone")),
]


def compiles(driver, text: str, stage: int = 0x8B31) -> str:
    """The driver's complaint; empty where it has none."""
    shader = driver.glCreateShader(stage)
    driver.glShaderSource(shader, 1, c_char_p(text.encode()), None)
    driver.glCompileShader(shader)
    compiled, log = c_int(), create_string_buffer(4096)
    driver.glGetShaderiv(shader, 0x8B81, compiled)
    driver.glGetShaderInfoLog(shader, len(log), None, log)
    driver.glDeleteShader(shader)
    return "" if compiled else log.value.decode()


@pytest.mark.parametrize("landing", LANDINGS, ids=str)
@pytest.mark.parametrize("text", [PLAIN, VERSIONED, CLIPPED, CORE, NAMED_LIKE_OURS])
def test_the_driver_takes_every_form(driver, text: str, landing: Landing):
    for candidate in rewritten(text, "vertex", landing):
        assert compiles(driver, candidate.text) == ""


@pytest.mark.parametrize("landing", LANDINGS, ids=str)
def test_a_geometry_shader_bends_what_it_emits(driver, landing: Landing):
    for candidate in rewritten(GEOMETRY, "geometry", landing):
        assert compiles(driver, candidate.text, 0x8DD9) == ""
        assert "domeProgramMain" not in candidate.text


def test_the_best_form_cuts_and_the_last_keeps_the_programs_version():
    first, last = rewritten(VERSIONED, "vertex", Landing())
    assert first.cut
    assert first.text.startswith("#version 150 compatibility\n")
    assert not last.cut
    assert last.text.startswith("#version 120\n")
    assert "gl_ClipDistance" not in last.text


def test_a_text_without_a_version_is_of_glsl_110():
    assert rewritten(PLAIN, "vertex", Landing())[-1].text.startswith("#version 110\n")


def test_a_later_version_is_not_lowered():
    assert rewritten(CORE, "vertex", Landing())[0].text.startswith("#version 330 core\n")


@pytest.mark.parametrize("landing", LANDINGS, ids=str)
@pytest.mark.parametrize("text", [PLAIN, VERSIONED, CLIPPED, NAMED_LIKE_OURS])
def test_on_opengl_2_a_shader_cuts_by_its_clip_vertex(driver, text: str, landing: Landing):
    first, last = rewritten(text, "vertex", replace(landing, legacy=True))
    assert first.cut
    assert not first.by_planes
    assert "gl_ClipVertex.x = domeInFront(place);" in first.text
    assert first.text.startswith("#version 120\n")
    for candidate in (first, last):
        assert "gl_ClipDistance" not in candidate.text
        assert compiles(driver, candidate.text) == ""


def test_glsl_es_keeps_its_version():
    es = "#version 300 es\nin vec4 at; void main() { gl_Position = at; }"
    (only,) = rewritten(es, "vertex", Landing())
    assert only.text.startswith("#version 300 es\n")
    assert not only.cut


def test_every_line_of_the_program_stands_below_the_dome_s_but_the_directives_that_must_be_above():
    text = rewritten(VERSIONED, "vertex", Landing())[0].text
    ours = text.index("uniform float domeMode")
    assert text.index("#extension GL_EXT_gpu_shader4") < ours < text.index("#define r 3")
    assert text.index("varying vec3 n") > ours


def test_what_the_recipe_leaves_out_is_not_in_the_text():
    text = rewritten(PLAIN, "vertex", Landing())[0].text
    assert "domeTilt" not in text
    assert "domeRim" not in text


def test_clip_planes_go_by_the_programs_own_clip_vertex():
    assert "domePlanesOf(domeClipVertex)" in rewritten(CLIPPED, "vertex", Landing())[0].text
    assert "gl_ClipDistance[2] = 1.0" in rewritten(PLAIN, "vertex", Landing())[0].text
    written = PLAIN.replace("{", "{ gl_ClipDistance[0] = 2.0;")
    assert rewritten(written, "vertex", Landing())[0].text.count("gl_ClipDistance[0]") == 1


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        (PLAIN, True),
        (VERSIONED, True),
        ("void main() { gl_Position = gl_ProjectionMatrix * gl_Vertex; }", True),
        (CORE, False),
        ("void main() { gl_Position = gl_Vertex; } // not ftransform()", False),
        ("/* gl_ModelViewProjectionMatrix\n*/ void main() { gl_Position = gl_Vertex; }", False),
    ],
)
def test_where_the_projection_comes_from(text: str, answer: bool):
    assert uses_projection(text) is answer


def test_a_shader_with_functions_alone_has_no_main():
    assert has_main(PLAIN)
    assert not has_main("float domain(float x) { return x; } // main()")


def linked(driver, *texts: tuple[int, str]) -> tuple[int, list[int], exchange.Linked]:
    program = driver.glCreateProgram()
    shaders = []
    for stage, text in texts:
        shader = driver.glCreateShader(stage)
        driver.glShaderSource(shader, 1, c_char_p(text.encode()), None)
        driver.glCompileShader(shader)
        driver.glAttachShader(program, shader)
        shaders.append(shader)
    outcome = exchange.link(driver, program, Landing(), lambda: driver.glLinkProgram(program))
    return program, shaders, outcome


def status(driver, program: int) -> bool:
    value = c_int()
    driver.glGetProgramiv(program, 0x8B82, value)
    return bool(value)


FRAGMENTS = (0x8B30, "#version 120\nvarying vec3 n; void main() { gl_FragColor = vec4(n, 1.0); }")


def test_an_exchanged_shader_keeps_its_text(driver):
    program, (vertex, _), outcome = linked(driver, (0x8B31, VERSIONED), FRAGMENTS)
    assert status(driver, program)
    assert outcome.program is not None
    assert outcome.program.cut
    text = create_string_buffer(4096)
    driver.glGetShaderSource(vertex, len(text), None, text)
    assert text.value.decode() == VERSIONED


def test_what_does_not_compile_with_clip_distances_goes_without(driver):
    _, _, outcome = linked(driver, (0x8B31, TOO_OLD_FOR_CLIPPING))
    assert outcome.program is not None
    assert not outcome.program.cut


def test_what_cannot_be_bent_is_linked_as_it_is(driver):
    taken = "#version 120\nuniform vec3 domeMode; void main() { gl_Position = domeMode.x * ftransform(); }"
    program, _, outcome = linked(driver, (0x8B31, taken))
    assert status(driver, program)
    assert outcome.program is None
    assert outcome.complaint


ASKING = "#version 130\nout vec4 c; void main() { c = vec4(gl_FragCoord.xy, 0.0, 1.0); }"


def test_a_fragment_shader_that_asks_for_its_place_keeps_its_text(driver):
    program, (_, fragment), outcome = linked(driver, (0x8B31, PLAIN), (0x8B30, ASKING))
    assert status(driver, program)
    assert driver.glGetUniformLocation(program, b"domeWindow") >= 0
    assert outcome.program is not None
    text = create_string_buffer(4096)
    driver.glGetShaderSource(fragment, len(text), None, text)
    assert text.value.decode() == ASKING


@pytest.mark.parametrize(
    "text",
    [
        "#version 150\nlayout(origin_upper_left) in vec4 gl_FragCoord;\n"
        "out vec4 c; void main() { c = gl_FragCoord; }",
        "void main() { gl_FragColor = vec4(1.0); } // gl_FragCoord",
    ],
    ids=["redeclared", "in a comment"],
)
def test_others_are_left_as_they_are(driver, text: str):
    program, _, outcome = linked(driver, (0x8B31, PLAIN), (0x8B30, text))
    assert status(driver, program)
    assert outcome.program is not None
    assert driver.glGetUniformLocation(program, b"domeWindow") < 0


def test_a_program_that_does_not_link_leaves_its_own_errors(driver):
    broken = "void main() { gl_Position = missing(); }"
    program, (vertex,), outcome = linked(driver, (0x8B31, broken))
    assert not status(driver, program)
    assert outcome == exchange.Linked(None)
    log = create_string_buffer(4096)
    driver.glGetShaderInfoLog(vertex, len(log), None, log)
    assert b"missing" in log.value
    assert b"dome" not in log.value


def test_only_the_programs_own_uniforms_are_visible(driver):
    _, _, outcome = linked(
        driver, (0x8B31, CORE.replace("330 core", "150 compatibility").replace("layout(location = 0) ", ""))
    )
    assert outcome.program is not None
    assert len(outcome.program.visible) == 1
    assert outcome.program.hidden >= 4


@pytest.mark.parametrize(
    ("statements", "fixed"),
    [
        ("gl_Position = ftransform ( ) ;", True),
        ("gl_Position = gl_ProjectionMatrix * (gl_ModelViewMatrix * gl_Vertex);", True),
        ("vec4 eye = gl_ModelViewMatrix * gl_Vertex; gl_Position = gl_ProjectionMatrix * eye;", True),
        (
            "vec4 v = gl_Vertex; vec4 eye = gl_ModelViewMatrix * v; gl_Position = gl_ProjectionMatrix * eye;",
            True,
        ),
        ("vec4 v = gl_Vertex; v.y += 1.0; gl_Position = gl_ModelViewProjectionMatrix * v;", False),
        ("vec4 v = gl_Vertex; v = 2.0 * v; gl_Position = gl_ModelViewProjectionMatrix * v;", False),
        ("vec4 v = gl_Vertex + vec4(1.0); gl_Position = gl_ModelViewProjectionMatrix * v;", False),
        ("gl_Position = ftransform(); gl_Position.x += 1.0;", False),
        ("gl_Position = gl_ModelViewProjectionMatrix * bent(gl_Vertex);", False),
        ("gl_Position = projection * gl_ModelViewMatrix * gl_Vertex;", False),
        ("// gl_Position = ftransform();", False),
    ],
)
def test_which_shaders_leave_the_fixed_pipelines_place(statements: str, fixed: bool):
    assert leaves_fixed_place(f"void main() {{ {statements}\n}}") is fixed


def test_a_function_may_change_what_a_name_stands_for():
    moved = "void f(inout vec4 p) { p.x += 1.0; } "
    main = "void main() { vec4 v = gl_Vertex; f(v); gl_Position = gl_ModelViewProjectionMatrix * v; }"
    assert not leaves_fixed_place(moved + main)
