"""GLU's quadrics from Python: the very vertices of GLU's own, and bent on the dome."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterator
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from OpenGL.platform import PLATFORM

from tests.pictures.beside import GL, SIZE, Beside, checks, looking

Shape = Callable[[GL, Any], Any]

STYLES = ("GLU_FILL", "GLU_LINE", "GLU_SILHOUETTE", "GLU_POINT")
NORMALS = ("GLU_SMOOTH", "GLU_FLAT", "GLU_NONE")
SHAPES: dict[str, Shape] = {
    "sphere": lambda gl, q: gl.gluSphere(q, 0.7, 9, 6),
    "sphere of one stack": lambda gl, q: gl.gluSphere(q, 0.7, 5, 1),
    "sphere of two": lambda gl, q: gl.gluSphere(q, 0.7, 2, 2),
    "sphere of too many slices": lambda gl, q: gl.gluSphere(q, 0.7, 300, 3),
    "sphere of too many stacks": lambda gl, q: gl.gluSphere(q, 0.7, 3, 300),
    "cylinder": lambda gl, q: gl.gluCylinder(q, 0.5, 0.2, 0.8, 9, 4),
    "cone": lambda gl, q: gl.gluCylinder(q, 0.5, 0, 0.8, 7, 1),
    "ring": lambda gl, q: gl.gluCylinder(q, 0.2, 0.6, 0, 7, 2),
    "disk": lambda gl, q: gl.gluDisk(q, 0.2, 0.7, 9, 3),
    "whole disk": lambda gl, q: gl.gluDisk(q, 0, 0.7, 6, 3),
    "fan": lambda gl, q: gl.gluDisk(q, 0, 0.7, 6, 1),
    "circle": lambda gl, q: gl.gluDisk(q, 0.7, 0.7, 6, 3),
    "part": lambda gl, q: gl.gluPartialDisk(q, 0.2, 0.7, 7, 3, 20, 240),
    "part backwards": lambda gl, q: gl.gluPartialDisk(q, 0, 0.7, 7, 2, 20, -140),
    "part of a circle": lambda gl, q: gl.gluPartialDisk(q, 0.7, 0.7, 7, 2, 20, 140),
    "part and more": lambda gl, q: gl.gluPartialDisk(q, 0, 0.7, 7, 2, 20, 500),
    "part all round": lambda gl, q: gl.gluPartialDisk(q, 0.2, 0.7, 7, 2, 20, -360),
}


@pytest.fixture(scope="module")
def beside(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Beside]:
    pair = Beside(Path(tmp_path_factory.getbasetemp()) / "differences")
    yield pair
    pair.close()


def quadric(
    gl: GL, style: str = "GLU_FILL", normals: str = "GLU_SMOOTH", side: str = "GLU_OUTSIDE", texture: int = 1
) -> Any:
    q = gl.gluNewQuadric()
    gl.gluQuadricDrawStyle(q, getattr(gl, style))
    gl.gluQuadricNormals(q, getattr(gl, normals))
    gl.gluQuadricOrientation(q, getattr(gl, side))
    gl.gluQuadricTexture(q, texture)
    return q


def lit(gl: GL) -> None:
    """Light whose colour tells where a normal points."""
    looking(gl)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glLightModelfv(gl.GL_LIGHT_MODEL_AMBIENT, (0.3, 0.3, 0.3, 1))
    for k, colour in enumerate(((1, 0, 0, 1), (0, 1, 0, 1), (0, 0, 1, 1))):
        light = gl.GL_LIGHT0 + k
        gl.glEnable(light)
        gl.glLightfv(light, gl.GL_DIFFUSE, colour)
        gl.glLightfv(light, gl.GL_SPECULAR, (0, 0, 0, 1))
        gl.glLightfv(light, gl.GL_POSITION, (*np.eye(3)[k], 0))
    gl.glRotatef(-50, 1, 0.2, 0)


def fed_back(gl: GL, draw: Callable[[], Any]) -> Any:
    """What GL makes of the vertices: kinds of primitives, places, lit colours, texture coordinates."""
    buffer = gl.glFeedbackBuffer(400_000, gl.GL_4D_COLOR_TEXTURE)
    gl.glRenderMode(gl.GL_FEEDBACK)
    draw()
    size = PLATFORM.GL.glRenderMode(int(gl.GL_RENDER))
    gl.glRenderMode(gl.GL_RENDER)  # past PyOpenGL first, which would make thousands of objects of it
    assert size >= 0
    return np.array(buffer[:size])


def undefined(shape: str, style: str, normals: str) -> bool:
    """GLU takes these normals from memory that it never wrote."""
    if style == "GLU_FILL":
        return normals == "GLU_SMOOTH" and shape == "sphere of too many stacks"
    round_shape = shape.startswith(("sphere", "cylinder", "cone", "ring"))
    return round_shape and normals == "GLU_FLAT" and style in {"GLU_SILHOUETTE", "GLU_POINT"}


CASES = (
    ("GLU_SMOOTH", "GLU_OUTSIDE", 0),
    ("GLU_SMOOTH", "GLU_INSIDE", 1),
    ("GLU_FLAT", "GLU_OUTSIDE", 0),
    ("GLU_FLAT", "GLU_OUTSIDE", 1),
    ("GLU_FLAT", "GLU_INSIDE", 0),
    ("GLU_NONE", "GLU_INSIDE", 0),
    ("GLU_NONE", "GLU_OUTSIDE", 1),
)


@pytest.mark.parametrize("style", STYLES)
@pytest.mark.parametrize("shape", SHAPES)
def test_the_vertices_are_those_of_glu(beside: Beside, shape: str, style: str) -> None:
    def scene(gl: GL) -> Any:
        lit(gl)
        checks(gl)
        answers = []
        for normals, side, texture in CASES:
            if undefined(shape, style, normals):
                continue
            gl.glNormal3f(0.3, 0.4, 0.5)
            gl.glTexCoord2f(0.1, 0.9)
            q = quadric(gl, style, normals, side, texture)
            answers.append(fed_back(gl, lambda q=q: SHAPES[shape](gl, q)))
            answers += [gl.glGetFloatv(gl.GL_CURRENT_NORMAL), gl.glGetFloatv(gl.GL_CURRENT_TEXTURE_COORDS)]
            gl.gluDeleteQuadric(q)
        return answers

    monitor, dome = beside.monitor(scene).answer, beside.through_dome(scene).answer
    assert all(answer.size > 50 for answer in monitor[::3])
    for one, other in zip(dome, monitor, strict=True):
        np.testing.assert_allclose(one, other, atol=2e-3)


@pytest.mark.parametrize("culled", ["GL_FRONT", "GL_BACK"])
@pytest.mark.parametrize("side", ["GLU_OUTSIDE", "GLU_INSIDE"])
@pytest.mark.parametrize("shape", ["sphere", "cylinder", "disk", "part backwards"])
def test_culled_and_flat_shaded_pictures(beside: Beside, shape: str, side: str, culled: str) -> None:
    def scene(gl: GL) -> None:
        lit(gl)
        checks(gl)
        gl.glEnable(gl.GL_CULL_FACE)
        gl.glCullFace(getattr(gl, culled))
        gl.glShadeModel(gl.GL_FLAT)
        for k, normals in enumerate(NORMALS):
            gl.glPushMatrix()
            gl.glScalef(0.5, 0.5, 0.5)
            gl.glTranslatef(k - 1, 0.3 - k, 0)
            SHAPES[shape](gl, quadric(gl, "GLU_FILL", normals, side))
            gl.glPopMatrix()
        gl.glDisable(gl.GL_CULL_FACE)
        gl.glBegin(gl.GL_QUADS)  # lit by the normal that the quadric leaves behind
        for x, y in ((-0.9, 0.5), (-0.5, 0.5), (-0.5, 0.9), (-0.9, 0.9)):
            gl.glVertex2f(x, y)
        gl.glEnd()

    beside.equal(scene, name=f"{shape} {side} {culled}", wrong=0.006)


@pytest.mark.parametrize("outline", ["GLU_LINE", "GL_LINE"])
def test_stippled_lines_run_on(beside: Beside, outline: str) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        gl.glEnable(gl.GL_LINE_STIPPLE)
        gl.glLineStipple(3, 0x0FF3)
        gl.glLineWidth(3)
        if outline == "GL_LINE":
            gl.glPolygonMode(gl.GL_FRONT_AND_BACK, gl.GL_LINE)
        gl.gluDisk(quadric(gl, outline if outline == "GLU_LINE" else "GLU_FILL"), 0.1, 0.8, 7, 3)

    beside.equal(scene, name=outline, wrong=0.006)


@pytest.mark.parametrize("normals", NORMALS)
def test_in_a_display_list(beside: Beside, normals: str) -> None:
    def scene(gl: GL) -> None:
        lit(gl)
        checks(gl)
        q = quadric(gl, normals=normals)
        gl.glNewList(1, gl.GL_COMPILE)
        gl.gluSphere(q, 0.3, 9, 6)
        gl.glTranslatef(0.4, 0, 0)
        gl.gluCylinder(q, 0.3, 0.1, 0.3, 9, 2)
        gl.glEndList()
        gl.gluQuadricDrawStyle(q, gl.GLU_LINE)
        gl.glTranslatef(-0.5, 0.3, 0)
        gl.glCallList(1)
        gl.glTranslatef(-0.2, -0.6, 0)
        gl.glCallList(1)

    beside.equal(scene, name=f"list {normals}", wrong=0.006)


def test_selected_as_on_the_monitor(beside: Beside) -> None:
    def scene(gl: GL) -> Any:
        looking(gl)
        gl.glSelectBuffer(64)
        gl.glRenderMode(gl.GL_SELECT)
        gl.glInitNames()
        gl.glPushName(0)
        for name, x in ((5, 0.0), (6, 30.0), (7, 0.4)):
            gl.glLoadName(name)
            gl.glPushMatrix()
            gl.glTranslatef(x, 0, 0)
            gl.gluSphere(quadric(gl), 0.3, 8, 8)
            gl.glPopMatrix()
        return [(hit.near, hit.far, *hit.names) for hit in gl.glRenderMode(gl.GL_RENDER)]

    monitor, dome = beside.monitor(scene).answer, beside.through_dome(scene).answer
    assert [hit[2:] for hit in monitor] == [(5,), (7,)]
    np.testing.assert_allclose(dome, monitor, rtol=1e-6)


def test_leaves_the_programs_arrays_alone(beside: Beside) -> None:
    def scene(gl: GL) -> Any:
        looking(gl)
        corners = np.array([(-0.9, -0.9), (-0.6, -0.9), (-0.6, -0.6)], np.float32)
        for unit in (1, 0):
            gl.glClientActiveTexture(gl.GL_TEXTURE0 + unit)
            gl.glEnableClientState(gl.GL_TEXTURE_COORD_ARRAY)
            gl.glTexCoordPointer(2, gl.GL_FLOAT, 0, corners)
        gl.glClientActiveTexture(gl.GL_TEXTURE1)
        gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
        gl.glVertexPointer(2, gl.GL_FLOAT, 0, corners)
        gl.gluSphere(quadric(gl), 0.5, 30, 30)
        gl.glDrawArrays(gl.GL_TRIANGLES, 0, 3)
        return [
            int(gl.glGetIntegerv(name)) for name in (gl.GL_CLIENT_ACTIVE_TEXTURE, gl.GL_ARRAY_BUFFER_BINDING)
        ]

    beside.equal(scene)


WRONG: dict[str, Shape] = {
    "one slice": lambda gl, q: gl.gluSphere(q, 1, 1, 3),
    "no stack": lambda gl, q: gl.gluCylinder(q, 1, 1, 1, 3, 0),
    "negative": lambda gl, q: gl.gluSphere(q, -1, 3, 3),
    "no extent": lambda gl, q: gl.gluCylinder(q, 1, 1, 0, 3, 3),
    "inner beyond outer": lambda gl, q: gl.gluDisk(q, 2, 1, 3, 3),
    "no radius": lambda gl, q: gl.gluPartialDisk(q, 0, 0, 3, 3, 0, 90),
    "no such style": lambda gl, q: gl.gluQuadricDrawStyle(q, 7),
}


@pytest.mark.parametrize("wrong", WRONG)
def test_what_glu_refuses_is_told_to_the_programs_callback(beside: Beside, wrong: str) -> None:
    def scene(gl: GL) -> Any:
        looking(gl)
        q = quadric(gl)
        codes: list[int] = []
        told = PLATFORM.functionTypeFor(PLATFORM.GLU)(None, ctypes.c_uint)(codes.append)
        PLATFORM.GLU.gluQuadricCallback(q, int(gl.GLU_ERROR), told)
        WRONG[wrong](gl, q)
        gl.gluSphere(q, 0.3, 8, 8)  # the refused call has changed nothing
        return codes

    assert beside.equal(scene, name=wrong, wrong=0.006) == [100900 if wrong == "no such style" else 100901]


@pytest.mark.parametrize("arguments", [(1.0, 8.0, 8), (1.0, 8), ("wide", 8, 8), (1.0, None, 8)])
def test_wrong_kinds_of_arguments_raise_as_on_the_monitor(beside: Beside, arguments: tuple[Any, ...]) -> None:
    def scene(gl: GL) -> Any:
        with pytest.raises((TypeError, ctypes.ArgumentError)) as raised:
            gl.gluSphere(quadric(gl), *arguments)
        return type(raised.value)

    assert beside.monitor(scene).answer == beside.through_dome(scene).answer


def test_numbers_of_numpy(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        gl.gluSphere(quadric(gl), np.float32(0.5), np.int64(9), np.int32(8))
        gl.gluDisk(quadric(gl).contents, 0.1, 0.9, True + 2, 1)

    beside.equal(scene, wrong=0.006)


def test_a_new_object_has_no_settings_of_a_deleted_one(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        for _ in range(20):  # addresses come again
            old = quadric(gl, "GLU_LINE", "GLU_NONE")
            gl.gluDeleteQuadric(old)
        gl.gluSphere(gl.gluNewQuadric(), 0.5, 9, 8)

    beside.equal(scene, wrong=0.006)


def test_an_object_made_before_is_drawn_as_it_is_set(beside: Beside) -> None:
    early = quadric(beside.stock, "GLU_LINE")

    def scene(gl: GL) -> None:
        looking(gl)
        gl.gluSphere(early, 0.5, 9, 8)

    beside.equal(scene, wrong=0.006)


# On the dome.

DEEP = 3.0
"""How far the viewer stands from a disk's plane, or from a tube's axis."""


def standing(gl: GL) -> Any:
    """On a chequered floor, amid what follows; gives a quadric."""
    gl.glClearColor(0.1, 0.1, 0.2, 1)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gl.gluPerspective(60, 1, 0.1, 200)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glLoadIdentity()
    gl.glEnable(gl.GL_DEPTH_TEST)
    checks(gl)
    for coordinate, generator, plane in (
        (gl.GL_S, gl.GL_TEXTURE_GEN_S, (0.05, 0.01, 0.03, 0)),
        (gl.GL_T, gl.GL_TEXTURE_GEN_T, (-0.01, 0.05, 0.01, 0)),
    ):
        gl.glTexGeni(coordinate, gl.GL_TEXTURE_GEN_MODE, gl.GL_OBJECT_LINEAR)
        gl.glTexGenfv(coordinate, gl.GL_OBJECT_PLANE, plane)
        gl.glEnable(generator)
    gl.glTexEnvi(gl.GL_TEXTURE_ENV, gl.GL_TEXTURE_ENV_MODE, gl.GL_REPLACE)
    return gl.gluNewQuadric()


def floor_ahead(gl: GL) -> None:
    gl.glRotatef(-60, 1, 0, 0)
    gl.glTranslatef(0, 10, -DEEP)


def around_the_viewer(gl: GL) -> None:
    gl.glRotatef(10, 0, 1, 0)
    gl.glTranslatef(0, DEEP, -60)


def ring(count: int, radius: float, z: float) -> np.ndarray:
    angles = 2 * np.pi * np.arange(count + 1) / count
    return np.stack([radius * np.sin(angles), radius * np.cos(angles), np.full(count + 1, z)], -1)


def finely(gl: GL, low: np.ndarray, high: np.ndarray, pieces: int = 40) -> None:
    """The band between two polygons, each of its flat faces in many small quads."""
    fractions = np.linspace(0, 1, pieces + 1)
    even = fractions[:, None, None]
    gl.glBegin(gl.GL_QUADS)
    for k in range(len(low) - 1):
        start, end = low[k] + (high[k] - low[k]) * even, low[k + 1] + (high[k + 1] - low[k + 1]) * even
        grid = start + (end - start) * fractions[None, :, None]
        quads = np.stack([grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]], 2)
        for corner in quads.reshape(-1, 3).tolist():
            gl.glVertex3f(*corner)
    gl.glEnd()


LARGE: dict[str, tuple[Callable[[GL], None], Shape, Callable[[GL], None]]] = {
    "disk": (
        floor_ahead,
        lambda gl, q: gl.gluDisk(q, 0, 50, 6, 1),
        lambda gl: finely(gl, ring(6, 50, 0), ring(6, 0, 0)),
    ),
    "ring": (
        floor_ahead,
        lambda gl, q: gl.gluDisk(q, 6, 50, 5, 1),
        lambda gl: finely(gl, ring(5, 50, 0), ring(5, 6, 0)),
    ),
    "cylinder": (
        around_the_viewer,
        lambda gl, q: gl.gluCylinder(q, 8, 8, 120, 5, 1),
        lambda gl: finely(gl, ring(5, 8, 0), ring(5, 8, 120), 80),
    ),
}


@pytest.mark.parametrize("listed", [False, True])
@pytest.mark.parametrize("name", LARGE)
def test_long_edges_bend(beside: Beside, name: str, listed: bool) -> None:
    place, shape, fine = LARGE[name]

    def coarse_scene(gl: GL) -> None:
        q = standing(gl)
        place(gl)
        if listed:
            gl.glNewList(1, gl.GL_COMPILE)
        shape(gl, q)
        if listed:
            gl.glEndList()
            gl.glCallList(1)

    def fine_scene(gl: GL) -> None:
        standing(gl)
        place(gl)
        fine(gl)

    bent = beside.through_dome(coarse_scene, fov=180).picture
    right = beside.through_dome(fine_scene, fov=180).picture
    straight = beside.through_dome(coarse_scene, fov=180, method="vertex").picture
    assert covered(right).mean() > 0.04, "too little to see"
    assert wrong_share(bent, right) < 0.01
    assert wrong_share(straight, right) > 0.03


def covered(picture: np.ndarray) -> np.ndarray:
    """Pixels that are neither background nor outside the disc."""
    background, outside = (np.abs(picture.astype(int) - c).max(-1) < 3 for c in ((26, 26, 51), (0, 0, 0)))
    return ~(background | outside)


def wrong_share(one: np.ndarray, other: np.ndarray) -> float:
    """The share of pixels that differ clearly."""
    return float((np.abs(one.astype(int) - other) > 24).any(-1).sum() / SIZE**2)


@pytest.mark.parametrize("name", LARGE)
def test_long_lines_bend(beside: Beside, name: str) -> None:
    """The lines of GLU_LINE lie on the faces that they belong to, drawn finely."""
    place, shape, _ = LARGE[name]

    def scene(gl: GL) -> None:
        q = standing(gl)
        gl.glDisable(gl.GL_TEXTURE_2D)
        gl.gluQuadricDrawStyle(q, gl.GLU_LINE)
        place(gl)
        shape(gl, q)

    bent = beside.through_dome(scene, fov=180).picture
    filled = beside.through_dome(lambda gl: (standing(gl), place(gl), LARGE[name][2](gl)), fov=180).picture
    lines = (bent > 200).all(-1)
    ground = covered(filled)
    assert lines.sum() > 100
    near = np.zeros_like(ground)
    for dy, dx in product((-2, -1, 0, 1, 2), repeat=2):
        near |= np.roll(ground, (dy, dx), (0, 1))
    assert not (lines & ~near).any(), "lines lie beside the surface that they belong to"
