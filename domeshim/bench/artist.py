"""Draws the bench's scenes as a program for the monitor does, by whichever GL it is given."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from domeshim.bench.meshes import Floats, Mesh
from domeshim.bench.scenes import FAR, FOVY, NEAR, Scene

GL = Any
"""A namespace of GL's functions and constants, and gluPerspective: stock PyOpenGL's or a dome's."""


def look(gl: GL, aspect: float) -> None:
    """Set the perspective; the eye is at the origin."""
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gl.gluPerspective(FOVY, aspect, NEAR, FAR)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glLoadIdentity()
    gl.glEnable(gl.GL_DEPTH_TEST)


class Artist:
    """One scene in one context, whose GL is given; made while it is current."""

    def __init__(self, gl: GL, scene: Scene, aspect: float = 1.0) -> None:
        self._gl = gl
        look(gl, aspect)
        if scene.lit:
            gl.glEnable(gl.GL_LIGHTING)
            gl.glEnable(gl.GL_LIGHT0)
            gl.glEnable(gl.GL_COLOR_MATERIAL)
        in_buffers = scene.way == "buffers"
        self._parts = [(_Buffered if in_buffers else _Immediate)(gl, mesh) for mesh in scene.meshes]

    def draw(self) -> None:
        """The scene, onto a cleared picture."""
        gl = self._gl
        gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
        for part in self._parts:
            part.draw()


def draw_edge(gl: GL, edge: Floats) -> None:
    """One white line, (2, 3), onto a cleared picture."""
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    gl.glColor3f(1, 1, 1)
    gl.glBegin(gl.GL_LINES)
    for end in edge.tolist():
        gl.glVertex3f(*end)
    gl.glEnd()


def _mode(gl: GL, mesh: Mesh) -> int:
    return int((gl.GL_LINES, gl.GL_TRIANGLES, gl.GL_QUADS)[mesh.corners.shape[1] - 2])


class _Painted:
    """A mesh's colour and texture."""

    def __init__(self, gl: GL, mesh: Mesh) -> None:
        self._gl = gl
        self._colour = mesh.colour
        self._texture = None if mesh.texture is None else _texture(gl, mesh.texture)

    def put_on(self) -> None:
        gl = self._gl
        if self._texture is None:
            gl.glColor3f(*self._colour)
        else:
            gl.glEnable(gl.GL_TEXTURE_2D)
            gl.glBindTexture(gl.GL_TEXTURE_2D, self._texture)


class _Immediate(_Painted):
    """By glBegin, a call for each corner."""

    def __init__(self, gl: GL, mesh: Mesh) -> None:
        super().__init__(gl, mesh)
        order = mesh.corners.ravel()
        self._mode = _mode(gl, mesh)
        self._places = mesh.positions[order].tolist()
        self._texcoords = None if mesh.texcoords is None else mesh.texcoords[order].tolist()

    def draw(self) -> None:
        self.put_on()
        gl, vertex = self._gl, self._gl.glVertex3f
        gl.glBegin(self._mode)
        if self._texcoords is None:
            for x, y, z in self._places:
                vertex(x, y, z)
        else:
            for (s, t), (x, y, z) in zip(self._texcoords, self._places, strict=True):
                gl.glTexCoord2f(s, t)
                vertex(x, y, z)
        gl.glEnd()


class _Buffered(_Painted):
    """From buffers on the GPU, one call for all of it."""

    def __init__(self, gl: GL, mesh: Mesh) -> None:
        super().__init__(gl, mesh)
        self._mode = _mode(gl, mesh)
        self._count = mesh.corners.size
        self._indices = _buffer(gl, gl.GL_ELEMENT_ARRAY_BUFFER, mesh.corners)
        self._arrays: list[tuple[int, Callable[[], object], Any]] = [
            (gl.GL_VERTEX_ARRAY, lambda: gl.glVertexPointer(3, gl.GL_FLOAT, 0, None), mesh.positions)
        ]
        if mesh.normals is not None:
            self._arrays.append(
                (gl.GL_NORMAL_ARRAY, lambda: gl.glNormalPointer(gl.GL_FLOAT, 0, None), mesh.normals)
            )
        if mesh.texcoords is not None:
            self._arrays.append(
                (
                    gl.GL_TEXTURE_COORD_ARRAY,
                    lambda: gl.glTexCoordPointer(2, gl.GL_FLOAT, 0, None),
                    mesh.texcoords,
                )
            )
        self._buffers = [_buffer(gl, gl.GL_ARRAY_BUFFER, values) for _, _, values in self._arrays]

    def draw(self) -> None:
        self.put_on()
        gl = self._gl
        for (array, point, _), buffer in zip(self._arrays, self._buffers, strict=True):
            gl.glBindBuffer(gl.GL_ARRAY_BUFFER, buffer)
            point()
            gl.glEnableClientState(array)
        gl.glBindBuffer(gl.GL_ELEMENT_ARRAY_BUFFER, self._indices)
        gl.glDrawElements(self._mode, self._count, gl.GL_UNSIGNED_INT, None)
        for array, _, _ in self._arrays:
            gl.glDisableClientState(array)


def _buffer(gl: GL, target: int, values: Any) -> int:
    buffer = gl.glGenBuffers(1)
    gl.glBindBuffer(target, buffer)
    gl.glBufferData(target, values.nbytes, np.ascontiguousarray(values), gl.GL_STATIC_DRAW)
    return int(buffer)


def _texture(gl: GL, texels: Any) -> int:
    name = gl.glGenTextures(1)
    gl.glBindTexture(gl.GL_TEXTURE_2D, name)
    for parameter in (gl.GL_TEXTURE_MIN_FILTER, gl.GL_TEXTURE_MAG_FILTER):
        gl.glTexParameteri(gl.GL_TEXTURE_2D, parameter, gl.GL_LINEAR)
    for parameter in (gl.GL_TEXTURE_WRAP_S, gl.GL_TEXTURE_WRAP_T):
        gl.glTexParameteri(gl.GL_TEXTURE_2D, parameter, gl.GL_CLAMP_TO_EDGE)
    gl.glTexEnvi(gl.GL_TEXTURE_ENV, gl.GL_TEXTURE_ENV_MODE, gl.GL_REPLACE)
    rows, columns = texels.shape[:2]
    gl.glTexImage2D(gl.GL_TEXTURE_2D, 0, gl.GL_RGB8, columns, rows, 0, gl.GL_RGB, gl.GL_UNSIGNED_BYTE, texels)
    return int(name)
