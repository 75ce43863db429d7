"""A program's own GLSL: building it, and what is drawn by it."""

from __future__ import annotations

import numpy as np

from tests.pictures.beside import GL

COLOURED = "void main() { gl_Position = ftransform(); gl_FrontColor = gl_Color; }"
COLOUR = "void main() { gl_FragColor = gl_Color; }"


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
