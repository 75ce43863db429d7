"""The stages that subdivide what a program's own vertex shader draws: as text, and by the driver."""

from __future__ import annotations

import pytest

from domeshim.errors import ShaderError
from domeshim.shading.own import Landing
from domeshim.shading.own_pieces import Judging, subdivided
from tests.shading.test_own import CLIPPED, CORE, LANDINGS, NAMED_LIKE_OURS, PLAIN, VERSIONED, compiles

HANDING = """\
#version 150 compatibility
out vec3 weights, reach;
out vec2 many[3];
out mat3 turn;
flat out ivec2 number;
out Surface { vec3 normal; float share; } place;
void main() {
    weights = reach = gl_Normal;
    many[0] = many[1] = many[2] = gl_MultiTexCoord0.st;
    turn = mat3(1.0);
    number = ivec2(gl_Vertex.xy);
    place.normal = gl_Normal;
    place.share = 1.0;
    gl_FrontColor = gl_BackColor = gl_Color;
    gl_TexCoord[1] = gl_MultiTexCoord1;
    gl_Position = ftransform();
}
"""


@pytest.mark.parametrize("kind", ["lines", "triangles"])
@pytest.mark.parametrize("landing", LANDINGS, ids=str)
@pytest.mark.parametrize("text", [PLAIN, VERSIONED, CLIPPED, CORE, NAMED_LIKE_OURS, HANDING])
def test_the_driver_takes_every_form(driver, text: str, landing: Landing, kind):
    for near_behind in (False, True):
        pieces = subdivided(text, kind, landing, Judging(near_behind))
        for stage, source in zip((0x8B31, 0x8E88, 0x8E87), pieces, strict=True):
            assert compiles(driver, source, stage) == ""


def test_the_programs_own_shader_stays_straight_and_the_new_vertices_land():
    pieces = subdivided(PLAIN, "triangles", Landing(), Judging())
    assert "domeLand" not in pieces.vertex
    assert "domeLand();" in pieces.evaluation
    assert pieces.evaluation.startswith("#version 400 compatibility\n")


def test_a_shader_of_core_gl_stays_there():
    pieces = subdivided(CORE, "lines", Landing(), Judging())
    assert pieces.vertex.startswith("#version 330 core\n")
    assert pieces.control.startswith("#version 400 core\n")


def test_whole_values_come_from_the_last_corner():
    evaluation = subdivided(HANDING, "lines", Landing(), Judging()).evaluation
    assert "number = domeIn3[1].number;" in evaluation
    assert "flat out ivec2 number;" in evaluation


def test_shaders_of_opengl_es_are_refused():
    with pytest.raises(ShaderError, match="OpenGL ES"):
        subdivided("#version 300 es\nvoid main() {}", "lines", Landing(), Judging())
