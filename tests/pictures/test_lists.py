"""Display lists of every build draw, and leave GL, as they do on the monitor."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.pictures.beside import FOV, GL, Beside, checks, looking, sphere


def square(gl: GL, x: float, y: float, size: float = 0.15) -> None:
    gl.glRectf(x - size, y - size, x + size, y + size)


def compiled_and_executed(gl: GL) -> None:
    looking(gl)
    gl.glNewList(1, gl.GL_COMPILE_AND_EXECUTE)
    gl.glColor3f(1, 0, 0)
    square(gl, -0.5, 0)
    gl.glTranslatef(0.5, 0, 0)
    gl.glEndList()
    square(gl, 0, 0.3)
    gl.glCallList(1)


def color_from_the_caller(gl: GL) -> None:
    looking(gl, depth=False)
    gl.glNewList(1, gl.GL_COMPILE)
    gl.glBegin(gl.GL_TRIANGLES)
    for k in range(60):
        if k == 30:
            gl.glColor3f(0, 0, 1)
        gl.glVertex2f(0.3 * np.cos(k), 0.3 * np.sin(k))
    gl.glEnd()
    gl.glEndList()
    for k in range(3):
        gl.glColor3f(1, k / 3, 0)
        gl.glPushMatrix()
        gl.glTranslatef(k / 2 - 0.5, k / 2 - 0.5, k / 10)
        gl.glCallList(1)
        gl.glPopMatrix()


def nested_and_redefined(gl: GL) -> None:
    looking(gl)
    gl.glNewList(1, gl.GL_COMPILE)
    square(gl, -0.5, 0)
    gl.glEndList()
    gl.glNewList(2, gl.GL_COMPILE)
    gl.glColor3f(0, 1, 0)
    gl.glCallList(1)
    gl.glColor3f(0, 1, 1)
    gl.glCallList(3)
    gl.glEndList()
    gl.glNewList(3, gl.GL_COMPILE)
    square(gl, 0.5, 0)
    gl.glEndList()
    gl.glCallList(2)
    gl.glNewList(1, gl.GL_COMPILE)
    sphere(gl, 0.2)
    gl.glEndList()
    gl.glCallList(2)
    gl.glDeleteLists(3, 1)
    gl.glTranslatef(0, 0.5, 0)
    gl.glCallList(2)


def calls_itself(gl: GL) -> None:
    looking(gl)
    gl.glNewList(1, gl.GL_COMPILE)
    square(gl, -0.7, -0.7, 0.05)
    gl.glTranslatef(0.02, 0.02, 0)
    gl.glCallList(1)
    gl.glEndList()
    gl.glCallList(1)


def lighting_inside(gl: GL) -> None:
    looking(gl)
    gl.glNewList(1, gl.GL_COMPILE)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glEnable(gl.GL_LIGHT0)
    gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, (1, 1, 1, 0))
    gl.glMaterialfv(gl.GL_FRONT, gl.GL_DIFFUSE, (1, 0.3, 0, 1))
    sphere(gl, 0.3)
    gl.glEndList()
    sphere(gl, 0.2)
    gl.glTranslatef(0.4, 0.4, 0)
    gl.glCallList(1)
    gl.glTranslatef(-0.8, 0, 0)
    sphere(gl, 0.3)


def textures_inside(gl: GL) -> None:
    looking(gl)
    checks(gl)
    gl.glDisable(gl.GL_TEXTURE_2D)
    gl.glNewList(1, gl.GL_COMPILE)
    gl.glEnable(gl.GL_TEXTURE_2D)
    gl.glTexGeni(gl.GL_S, gl.GL_TEXTURE_GEN_MODE, gl.GL_OBJECT_LINEAR)
    gl.glEnable(gl.GL_TEXTURE_GEN_S)
    gl.glMatrixMode(gl.GL_TEXTURE)
    gl.glScalef(3, 1, 1)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    sphere(gl, 0.4)
    gl.glDisable(gl.GL_TEXTURE_2D)
    gl.glEndList()
    square(gl, -0.6, 0.6)
    gl.glCallList(1)
    square(gl, 0.6, 0.6)


def matrices_and_perspective_inside(gl: GL) -> None:
    looking(gl)
    gl.glNewList(7, gl.GL_COMPILE)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gl.gluPerspective(FOV / 2, 1, 100, 130)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glRotatef(30, 0, 0, 1)
    gl.glEndList()
    gl.glColor3f(1, 0, 0)
    square(gl, 0, 0, 0.6)
    gl.glClear(gl.GL_DEPTH_BUFFER_BIT)


def orthographic_inside(gl: GL) -> None:
    looking(gl)
    gl.glNewList(7, gl.GL_COMPILE)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glPushMatrix()
    gl.glLoadIdentity()
    gl.gluOrtho2D(0, 256, 0, 256)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glPushMatrix()
    gl.glLoadIdentity()
    gl.glRectf(100, 60, 160, 80)
    gl.glPopMatrix()
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glPopMatrix()
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glEndList()
    sphere(gl, 0.3)
    gl.glColor3f(1, 1, 0)
    gl.glCallList(7)
    square(gl, 0.5, 0.5)


def viewport_inside(gl: GL) -> None:
    looking(gl)
    gl.glNewList(7, gl.GL_COMPILE)
    gl.glViewport(30, 90, 80, 90)
    gl.glColor3f(1, 0, 0)
    square(gl, 0, 0, 0.8)
    gl.glEndList()
    gl.glCallList(7)
    gl.glViewport(0, 0, 256, 256)
    square(gl, 0.4, 0.4)


def attribute_stack_inside(gl: GL) -> None:
    looking(gl)
    gl.glNewList(7, gl.GL_COMPILE)
    gl.glPushAttrib(gl.GL_LIGHTING_BIT | gl.GL_CURRENT_BIT | gl.GL_ENABLE_BIT)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glEnable(gl.GL_LIGHT0)
    gl.glColor3f(1, 0, 1)
    sphere(gl, 0.3)
    gl.glPopAttrib()
    gl.glEndList()
    gl.glColor3f(1, 1, 0)
    gl.glCallList(7)
    square(gl, 0.5, 0.5)


def vertices_for_the_callers_block(gl: GL) -> None:
    looking(gl)
    for name, dx in ((1, -0.5), (2, 0.3)):
        gl.glNewList(name, gl.GL_COMPILE)
        for x, y in ((0, 0), (0.3, 0), (0.1, 0.4)):
            gl.glColor3f(x * 3, y * 2, 1)
            gl.glVertex2f(x + dx, y)
        gl.glEndList()
    gl.glBegin(gl.GL_TRIANGLES)
    gl.glCallList(1)
    for x, y in ((0, -0.4), (0.3, -0.4), (0.1, -0.1)):
        gl.glVertex2f(x, y)
    gl.glCallLists(np.array([2, 1], np.uint32))
    gl.glEnd()


def material_list_inside_a_block(gl: GL) -> None:
    looking(gl)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glEnable(gl.GL_LIGHT0)
    gl.glNewList(1, gl.GL_COMPILE)
    gl.glNormal3f(0, 0, 1)
    gl.glEndList()
    gl.glBegin(gl.GL_QUADS)
    gl.glCallList(1)
    for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
        gl.glVertex2f(x, y)
    gl.glEnd()


def generated_names_beside_long_lists(gl: GL) -> None:
    """A list of several parts must not take a name that the program is given later."""
    looking(gl)
    gl.glNewList(gl.glGenLists(1), gl.GL_COMPILE)
    gl.glEnable(gl.GL_LIGHTING)
    square(gl, 0, 0)
    gl.glDisable(gl.GL_LIGHTING)
    square(gl, 0.4, 0)
    gl.glEndList()
    later = gl.glGenLists(3)
    for k in range(3):
        gl.glNewList(later + k, gl.GL_COMPILE)
        gl.glColor3f(1, k / 2, 0)
        gl.glEnable(gl.GL_FOG)
        gl.glDisable(gl.GL_FOG)
        square(gl, k / 2 - 0.5, 0.5)
        gl.glEndList()
    for k in range(3):
        gl.glCallList(later + k)
    gl.glCallList(1)


SCENES = (
    compiled_and_executed,
    color_from_the_caller,
    nested_and_redefined,
    calls_itself,
    lighting_inside,
    textures_inside,
    matrices_and_perspective_inside,
    orthographic_inside,
    viewport_inside,
    attribute_stack_inside,
    vertices_for_the_callers_block,
    material_list_inside_a_block,
    generated_names_beside_long_lists,
)


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.__name__)
def test_lists_draw_as_on_the_monitor(beside: Beside, scene: object) -> None:
    beside.equal(scene)


@pytest.mark.parametrize("plain", [True, False])
@pytest.mark.parametrize(
    "names",
    [
        b"\x00\x02\x01",
        np.array([2, 0], np.uint8),
        [1, 2],
        np.array([2, 1], np.int64),
        ("GL_BYTE", np.array([0, -1, 2], np.int8)),
        ("GL_UNSIGNED_BYTE", np.array([0, 2], np.uint8)),
        ("GL_SHORT", np.array([2, -1], np.int16)),
        ("GL_UNSIGNED_SHORT", np.array([2, 1], np.uint16)),
        ("GL_INT", np.array([1, -1], np.int32)),
        ("GL_UNSIGNED_INT", np.array([1, 0], np.uint32)),
        ("GL_FLOAT", np.array([1.6, 2.2], np.float32)),
        ("GL_2_BYTES", np.array([0, 1, 0, 2], np.uint8)),
        ("GL_3_BYTES", np.array([0, 0, 1, 0, 0, 2], np.uint8)),
        ("GL_4_BYTES", np.array([0, 0, 0, 1, 0, 0, 0, 2], np.uint8)),
    ],
    ids=str,
)
def test_lists_called_together(beside: Beside, names: Any, plain: bool) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        for k in range(-1, 3):
            gl.glNewList(100 + k, gl.GL_COMPILE)
            if not plain:
                gl.glEnable(gl.GL_LIGHT0)
            gl.glColor3f(1, (k + 1) / 3, 0)
            square(gl, k / 3, k / 3)
            gl.glEndList()
        gl.glPushAttrib(gl.GL_LIST_BIT)
        gl.glListBase(100)
        if isinstance(names, tuple):
            kind, values = names
            count = len(values) // (int(kind[3]) if kind.endswith("BYTES") else 1)
            gl.glCallLists(count, getattr(gl, kind), values)
        else:
            gl.glCallLists(names)
        gl.glPopAttrib()
        assert gl.glGetIntegerv(gl.GL_LIST_BASE) == 0

    beside.equal(scene, name=f"lists {names}")


def test_no_list_is_left_behind(beside: Beside) -> None:
    """All names that a list's parts took are free again once it is deleted or defined anew."""

    def build(gl: GL) -> None:
        gl.glNewList(1, gl.GL_COMPILE)
        for k in range(5):
            (gl.glEnable if k % 2 else gl.glDisable)(gl.GL_LIGHTING)
            square(gl, 0, 0)
        gl.glEndList()

    def in_use() -> int:
        return sum(
            bool(beside.stock.glIsList(name)) for name in (*range(1, 100), *range(2**30 - 10, 2**30 + 100))
        )

    with beside.window():
        gl = beside.dome
        before = in_use()
        build(gl)
        once = in_use()
        assert once > before + 1, "the list is not one of several parts"
        for _ in range(3):
            build(gl)
        assert in_use() == once
        gl.glDeleteLists(1, 1)
        assert in_use() == before
