"""Names of GL's extensions reach the dome; what cannot be bent is said."""

from __future__ import annotations

from typing import Any

import numpy as np
import OpenGL.GL.ARB.multitexture
import OpenGL.GL.ARB.shader_objects
import OpenGL.GL.ARB.vertex_program
import pytest

from tests.pictures.beside import GL, Beside, looking
from tests.pictures.own_glsl import both, program, tiles


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
