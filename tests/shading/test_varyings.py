"""What a vertex shader hands on is found in its text, and its declarations become blocks."""

from __future__ import annotations

import pytest

from domeshim.errors import ShaderError
from domeshim.shading.own_text import bare
from domeshim.shading.varyings import Handed, handed_on


def handed(text: str) -> Handed:
    return handed_on(text, bare(text))


def test_varyings_become_blocks_on_their_own_lines():
    text = "varying vec3 a, b[2]; // varying vec3 no;\n/* out */ centroid varying\n  float c;\nvoid main() {}"
    found = handed(text)
    assert found.text.split("\n")[0] == "out DomeOut_a_b { vec3 a; vec3 b[2]; }; // varying vec3 no;"
    assert found.text.split("\n")[1] == "/* out */ out DomeOut_c { centroid float c; };"
    assert found.text.count("\n") == text.count("\n")
    assert found.text.endswith("void main() {}")
    assert [member.name for block in found.blocks for member in block.members] == ["a", "b", "c"]


def test_integers_and_flat_values_come_from_one_corner():
    found = handed("flat out ivec2 n; out float x; flat out vec3 y; layout(location = 2) out uint m;")
    assert [block.members[0].flat for block in found.blocks] == [True, False, True, True]
    assert "layout" not in found.text


def test_blocks_stay_as_they_are():
    text = "out Surface { vec3 normal; flat int part; } leaving;"
    found = handed(text)
    assert found.text == text
    [block] = found.blocks
    assert (block.name, block.instance, block.given) == ("Surface", "leaving", True)
    assert [(m.name, m.flat) for m in block.members] == [("normal", False), ("part", True)]


def test_parameters_and_locals_are_none():
    text = "void f(in vec3 a, out vec3 b) { b = a; }\nvoid main() { vec3 out_ = vec3(1.0); f(out_, out_); }"
    assert handed(text) == Handed(text, (), ())


def test_what_of_gl_is_written():
    text = "gl_FrontColor = gl_Color; gl_TexCoord[2] = gl_TexCoord[0] = gl_Vertex; gl_ClipDistance[1] = 1.0;"
    assert handed(text).built_in == (
        "gl_FrontColor",
        "gl_TexCoord[0]",
        "gl_TexCoord[2]",
        "gl_ClipDistance[1]",
    )


def test_coordinates_that_a_loop_writes_are_as_many_as_declared():
    loop = "void main() { for (int i = 0; i < 2; ++i) gl_TexCoord[i] = gl_Vertex; }"
    assert handed("varying vec4 gl_TexCoord[2];" + loop).built_in == ("gl_TexCoord[0]", "gl_TexCoord[1]")
    with pytest.raises(ShaderError, match="gl_TexCoord"):
        handed(loop)


@pytest.mark.parametrize("text", ["struct S { vec3 n; }; out S s;", "out Many { vec3 n; } many[2];"])
def test_what_cannot_be_blended_is_refused(text: str):
    with pytest.raises(ShaderError, match="hands on"):
        handed(text)
