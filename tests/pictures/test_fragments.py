"""Modes, stipples, tests, clip planes, logic, offsets and attribute stacks work as on the monitor."""

from __future__ import annotations

import numpy as np
import pytest

from tests.pictures.beside import GL, SIZE, Beside, checks, flat, looking, sphere


def polygon_lines(gl: GL) -> None:
    looking(gl)
    gl.glPolygonMode(gl.GL_FRONT_AND_BACK, gl.GL_LINE)
    gl.glBegin(gl.GL_QUADS)
    for x in range(6):
        for dx, dy in ((0, 0), (0.2, 0), (0.2, 0.2), (0, 0.2)):
            gl.glVertex2f(x / 4 - 0.7 + dx, 0.2 + dy)
    gl.glEnd()
    gl.glBegin(gl.GL_POLYGON)
    for turn in np.linspace(0, 2 * np.pi, 7, endpoint=False):
        gl.glVertex2f(0.4 * np.cos(turn), 0.4 * np.sin(turn) - 0.4)
    gl.glEnd()
    gl.glBegin(gl.GL_QUAD_STRIP)
    for i in range(12):
        gl.glVertex2f(i / 8 - 0.7, -0.1 if i % 2 else 0.05)
    gl.glEnd()


def front_and_back_modes(gl: GL) -> None:
    looking(gl)
    gl.glPolygonMode(gl.GL_FRONT, gl.GL_LINE)
    gl.glPolygonMode(gl.GL_BACK, gl.GL_POINT)
    gl.glPointSize(4)
    sphere(gl, slices=12, stacks=8)


def hidden_edges(gl: GL) -> None:
    looking(gl)
    gl.glPolygonMode(gl.GL_FRONT_AND_BACK, gl.GL_LINE)
    gl.glBegin(gl.GL_TRIANGLES)
    for k in range(40):
        x, y = k % 8 / 5 - 0.8, k // 8 / 5 - 0.5
        for i, (dx, dy) in enumerate(((0, 0), (0.15, 0), (0.1, 0.15))):
            gl.glEdgeFlag((i + k) % 3 != 0)
            gl.glVertex2f(x + dx, y + dy)
    gl.glEnd()
    gl.glEdgeFlag(gl.GL_TRUE)
    gl.glBegin(gl.GL_POLYGON)
    for i, turn in enumerate(np.linspace(0, 2 * np.pi, 6, endpoint=False)):
        gl.glEdgeFlagv([i % 2])
        gl.glVertex2f(0.3 * np.cos(turn), 0.3 * np.sin(turn) - 0.65)
    gl.glEnd()


def line_widths_and_stipples(gl: GL) -> None:
    looking(gl)
    gl.glEnable(gl.GL_LINE_STIPPLE)
    for i in range(8):
        gl.glLineWidth(1 + i / 2)
        gl.glLineStipple(1 + i // 3, (0x00FF, 0x0C0F, 0x1C47, 0xAAAA)[i % 4])
        gl.glBegin((gl.GL_LINES, gl.GL_LINE_STRIP, gl.GL_LINE_LOOP)[i % 3])
        for k in range(6):
            gl.glVertex2f(k / 4 - 0.6, i / 5 - 0.7 + 0.1 * (k % 2))
        gl.glEnd()


def many_stippled_strips(gl: GL) -> None:
    looking(gl)
    gl.glEnable(gl.GL_LINE_STIPPLE)
    gl.glLineStipple(2, 0x0F1F)
    for i in range(20):
        gl.glBegin(gl.GL_LINE_STRIP)
        for k in range(9):
            gl.glVertex2f(k / 6 - 0.7, i / 14 - 0.7)
        gl.glEnd()


def polygon_stipple(gl: GL) -> None:
    looking(gl)
    gl.glEnable(gl.GL_POLYGON_STIPPLE)
    gl.glPolygonStipple(np.tile(np.array([0xF0, 0x3C, 0x0F, 0xC3], np.uint8), 32))
    sphere(gl)


def flat_provoking_vertices(gl: GL) -> None:
    looking(gl)
    gl.glShadeModel(gl.GL_FLAT)
    rng = np.random.default_rng(5)
    modes = (
        gl.GL_TRIANGLES, gl.GL_TRIANGLE_STRIP, gl.GL_TRIANGLE_FAN, gl.GL_QUADS, gl.GL_QUAD_STRIP,
        gl.GL_POLYGON, gl.GL_LINES, gl.GL_LINE_STRIP, gl.GL_LINE_LOOP,
    )  # fmt: skip
    gl.glLineWidth(3)
    for row, count in enumerate((6, 36)):
        for column, mode in enumerate(modes):
            middle = column / 5 - 0.8, 0.35 - row * 0.7
            strip = mode in (gl.GL_TRIANGLE_STRIP, gl.GL_QUAD_STRIP)
            gl.glBegin(mode)
            for k in range(count):
                turn = 2 * np.pi * (k // 2 if strip else k) / count * (1.9 if strip else 1)
                size = 0.09 * (1 + k % 2) / 2 if strip else 0.09
                gl.glColor3f(*rng.random(3))
                gl.glVertex2f(middle[0] + size * np.cos(turn), middle[1] + 3 * size * np.sin(turn))
            gl.glEnd()


def alpha_test(gl: GL) -> None:
    looking(gl)
    gl.glEnable(gl.GL_ALPHA_TEST)
    gl.glAlphaFunc(gl.GL_GREATER, 0.45)
    gl.glBegin(gl.GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        gl.glColor4f(1, 1, 0, (x + y + 2) / 4)
        gl.glVertex2f(0.7 * x, 0.7 * y)
    gl.glEnd()


def stencil(gl: GL) -> None:
    looking(gl, depth=False)
    gl.glEnable(gl.GL_STENCIL_TEST)
    gl.glStencilFunc(gl.GL_ALWAYS, 1, 1)
    gl.glStencilOp(gl.GL_REPLACE, gl.GL_REPLACE, gl.GL_INVERT)
    gl.glColorMask(0, 0, 0, 0)
    sphere(gl, 0.4)
    gl.glRectf(0, 0, 0.8, 0.6)
    gl.glColorMask(1, 1, 1, 1)
    gl.glStencilFunc(gl.GL_EQUAL, 1, 1)
    gl.glStencilOp(gl.GL_KEEP, gl.GL_KEEP, gl.GL_KEEP)
    gl.glColor3f(0.2, 1, 0.4)
    gl.glRectf(-0.9, -0.9, 0.9, 0.9)


def depth_test(gl: GL) -> None:
    looking(gl)
    for i in range(5):
        gl.glColor3f(i / 5, 1 - i / 5, 0.5)
        gl.glPushMatrix()
        gl.glRotatef(36 * i, 1, 1, 1)
        gl.glRectf(-0.6, -0.4, 0.6, 0.4)
        gl.glPopMatrix()
    gl.glDepthMask(0)
    gl.glTranslatef(0, 0, -0.2)
    gl.glDepthFunc(gl.GL_GREATER)
    gl.glColor3f(1, 1, 1)
    gl.glRectf(-0.2, -0.9, 0.2, 0.9)


def depth_range(gl: GL) -> None:
    looking(gl)
    gl.glDepthRange(0.5, 1)
    gl.glColor3f(1, 0, 0)
    gl.glRectf(-0.5, -0.5, 0.5, 0.5)
    gl.glDepthRange(0, 0.5)
    gl.glTranslatef(0, 0, -1)
    gl.glColor3f(0, 1, 0)
    gl.glRectf(-0.2, -0.8, 0.2, 0.8)


def logic(gl: GL) -> None:
    looking(gl, depth=False)
    gl.glEnable(gl.GL_COLOR_LOGIC_OP)
    for i, operation in enumerate((gl.GL_XOR, gl.GL_INVERT, gl.GL_OR_REVERSE, gl.GL_AND_INVERTED)):
        gl.glLogicOp(operation)
        gl.glColor3f(0.8, 0.4, 0.2)
        gl.glRectf(i / 3 - 0.8, -0.6, i / 3 - 0.2, 0.2 * i)


def blend(gl: GL) -> None:
    looking(gl, depth=False)
    gl.glEnable(gl.GL_BLEND)
    gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE)
    for i in range(6):
        gl.glColor4f(1, i / 6, 0.3, 0.4)
        gl.glRectf(i / 5 - 0.8, -0.6, i / 5 - 0.2, 0.1 * i)


def polygon_offset(gl: GL) -> None:
    looking(gl)
    for i, units in enumerate((-4, 4)):
        gl.glPushMatrix()
        gl.glTranslatef(i - 0.5, 0, 0)
        gl.glRotatef(20, 1, 1, 0)
        gl.glColor3f(1, 0, 0)
        gl.glRectf(-0.3, -0.3, 0.3, 0.3)
        gl.glEnable(gl.GL_POLYGON_OFFSET_FILL)
        gl.glPolygonOffset(units / 4, units)
        gl.glColor3f(0, 1, i)
        gl.glRectf(-0.3, -0.3, 0.3, 0.3)
        gl.glDisable(gl.GL_POLYGON_OFFSET_FILL)
        gl.glPopMatrix()


def clip_planes(gl: GL) -> None:
    looking(gl)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glEnable(gl.GL_LIGHT0)
    gl.glRotatef(30, 1, 0, 0)
    gl.glClipPlane(gl.GL_CLIP_PLANE0, (0, 1, 0, 0.1))
    gl.glClipPlane(gl.GL_CLIP_PLANE3, (-1, 0, 0, 0.3))
    gl.glEnable(gl.GL_CLIP_PLANE0)
    gl.glEnable(gl.GL_CLIP_PLANE3)
    sphere(gl)
    gl.glDisable(gl.GL_CLIP_PLANE0)
    gl.glTranslatef(0, -0.5, 0)
    sphere(gl, 0.3)


def attribute_stack(gl: GL) -> None:
    looking(gl)
    gl.glColor3f(1, 1, 0)
    gl.glPushAttrib(gl.GL_ALL_ATTRIB_BITS)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glEnable(gl.GL_LIGHT0)
    gl.glEnable(gl.GL_CLIP_PLANE1)
    gl.glClipPlane(gl.GL_CLIP_PLANE1, (1, 0, 0, 0))
    gl.glViewport(0, 0, 128, 256)
    gl.glColor3f(0, 1, 1)
    gl.glPopAttrib()
    sphere(gl, 0.3)
    gl.glPushAttrib(gl.GL_CURRENT_BIT | gl.GL_ENABLE_BIT)
    gl.glColor3f(1, 0, 0)
    checks(gl)
    gl.glPopAttrib()
    gl.glRectf(0.4, 0.4, 0.6, 0.6)
    gl.glPushAttrib(gl.GL_LIGHTING_BIT)
    gl.glShadeModel(gl.GL_FLAT)
    gl.glPopAttrib()
    gl.glBegin(gl.GL_TRIANGLES)
    for x, y in ((-0.6, -0.7), (0.6, -0.7), (0, -0.4)):
        gl.glColor3f(x + 0.6, 0.5, y + 1)
        gl.glVertex2f(x, y)
    gl.glEnd()


SCENES = (
    polygon_lines,
    front_and_back_modes,
    hidden_edges,
    line_widths_and_stipples,
    many_stippled_strips,
    polygon_stipple,
    flat_provoking_vertices,
    alpha_test,
    stencil,
    depth_test,
    depth_range,
    logic,
    blend,
    polygon_offset,
    clip_planes,
    attribute_stack,
)


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.__name__)
def test_fragments_fare_as_on_the_monitor(beside: Beside, scene: object) -> None:
    beside.equal(scene, wrong=0.01 if scene is line_widths_and_stipples else 0.004)


@pytest.mark.parametrize("panel", [50, 110])
def test_lines_and_points_of_the_panel_keep_their_width(beside: Beside, panel: int) -> None:
    def scene(gl: GL) -> None:
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        flat(gl)
        gl.glPointSize(12)
        gl.glLineWidth(8)
        gl.glColor3f(1, 0, 0)
        gl.glBegin(gl.GL_POINTS)
        gl.glVertex2f(SIZE / 2, SIZE / 2)
        gl.glEnd()
        gl.glColor3f(0, 1, 0)
        gl.glBegin(gl.GL_LINES)
        gl.glVertex2f(20, 180)
        gl.glVertex2f(SIZE - 20, 180)
        gl.glEnd()

    seen = beside.through_dome(scene, fov=180.0, panel=panel).picture > 128
    assert (seen[..., 0].sum(), seen[:, SIZE // 2, 1].sum()) == (12 * 12, 8)
    assert seen[..., 1].any(0).sum() < 0.75 * (SIZE - 40)  # shown smaller
