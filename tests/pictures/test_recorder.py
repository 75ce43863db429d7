"""Everything by which a program gives vertices draws what it draws on the monitor."""

from __future__ import annotations

import ctypes
import struct
from typing import Any

import numpy as np
import pytest

from tests.pictures.beside import GL, Beside, checks, looking

MODES = (
    "POINTS", "LINES", "LINE_STRIP", "LINE_LOOP", "TRIANGLES", "TRIANGLE_STRIP", "TRIANGLE_FAN", "QUADS",
    "QUAD_STRIP", "POLYGON",
)  # fmt: skip


def ring(count: int, strip: bool) -> list[tuple[float, float]]:
    """Points on a ring; in a zigzag for strips."""
    points = []
    for k in range(count):
        turn = 2 * np.pi * k / count
        size = 0.8 if not strip or k % 2 else 0.4
        points.append((size * np.cos(turn), size * np.sin(turn)))
    return points


@pytest.mark.parametrize("count", [2, 3, 7, 12, 13, 61, 200])
@pytest.mark.parametrize("mode", MODES)
def test_every_mode(beside: Beside, mode: str, count: int) -> None:
    def scene(gl: GL) -> None:
        looking(gl, depth=False)
        gl.glPointSize(3)
        gl.glBegin(getattr(gl, f"GL_{mode}"))
        for x, y in ring(count, "STRIP" in mode):
            gl.glColor3f(0.5 + x / 2, 0.5 + y / 2, 1)
            gl.glVertex2f(x, y)
        gl.glEnd()
        gl.glRectf(-0.1, -0.1, 0.1, 0.1)

    beside.equal(scene, name=f"{mode} {count}", wrong=0.004)


VERTICES = {
    "glVertex2f": (0.5, -0.3), "glVertex2d": (0.5, -0.3), "glVertex2i": (1, -1), "glVertex2s": (1, -1),
    "glVertex3f": (0.5, 0.3, 0.2), "glVertex3d": (0.5, 0.3, 0.2), "glVertex3i": (1, 0, 1),
    "glVertex3s": (1, 0, 1),
    "glVertex4f": (1, 0.6, 0.2, 2), "glVertex4d": (1, 0.6, 0.2, 2), "glVertex4i": (1, 1, 0, 2),
    "glVertex4s": (1, 1, 0, 2), "glVertex": (0.6, 0.4, 0),
}  # fmt: skip
COLORS = {
    "glColor3f": (1, 0.5, 0), "glColor3d": (1, 0.5, 0), "glColor3ub": (255, 128, 0),
    "glColor3b": (127, 50, -3),
    "glColor3us": (65535, 30000, 0), "glColor3s": (32767, 10000, 0), "glColor3ui": (2**32 - 1, 2**31, 0),
    "glColor3i": (2**31 - 1, 2**30, 0), "glColor4f": (1, 0.5, 0, 0.4), "glColor4d": (1, 0.5, 0, 0.4),
    "glColor4ub": (255, 128, 0, 100), "glColor4b": (127, 50, 0, 60), "glColor4us": (65535, 30000, 0, 20000),
    "glColor4s": (32767, 10000, 0, 9000), "glColor4ui": (2**32 - 1, 2**31, 0, 2**30),
    "glColor4i": (2**31 - 1, 2**30, 0, 2**30), "glColor": (1, 0.5, 0),
}  # fmt: skip
OTHERS = {
    "glTexCoord1f": (0.7,), "glTexCoord2f": (0.7, 0.2), "glTexCoord3f": (0.7, 0.2, 0.1),
    "glTexCoord4f": (0.7, 0.2, 0.1, 2), "glTexCoord2d": (0.7, 0.2), "glTexCoord2i": (1, 3),
    "glTexCoord2s": (1, 3),
    "glTexCoord3i": (1, 2, 1), "glTexCoord4s": (1, 2, 1, 3), "glTexCoord1d": (0.4,),
    "glNormal3f": (0.6, 0.1, 0.7), "glNormal3d": (0.6, 0.1, 0.7), "glNormal3b": (80, 20, 90),
    "glNormal3s": (20000, 900, 25000), "glNormal3i": (2**30, 2**28, 2**30), "glNormal": (0.6, 0.1, 0.7),
    "glSecondaryColor3f": (0.2, 0.5, 0), "glSecondaryColor3d": (0.2, 0.5, 0),
    "glSecondaryColor3ub": (60, 128, 0),
    "glSecondaryColor3b": (30, 60, 1), "glSecondaryColor3us": (9000, 30000, 0),
    "glSecondaryColor3s": (9000, 10000, 0), "glSecondaryColor3ui": (2**30, 2**31, 0),
    "glSecondaryColor3i": (2**30, 2**30, 0), "glFogCoordf": (0.6,), "glFogCoordd": (0.6,),
    "glMultiTexCoord1f": (0.7,), "glMultiTexCoord2f": (0.7, 0.2), "glMultiTexCoord3d": (0.7, 0.2, 0.1),
    "glMultiTexCoord4i": (3, 1, 0, 4), "glMultiTexCoord2s": (3, 1),
}  # fmt: skip


def everything_on(gl: GL) -> None:
    """Lighting (with colours as material), a texture, fog coordinates and the colour sum all show."""
    looking(gl, depth=False)
    checks(gl)
    for what in (gl.GL_BLEND, gl.GL_COLOR_SUM, gl.GL_FOG):
        gl.glEnable(what)
    gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
    gl.glFogi(gl.GL_FOG_MODE, gl.GL_LINEAR)
    gl.glFogf(gl.GL_FOG_START, 0)
    gl.glFogf(gl.GL_FOG_END, 1)
    gl.glFogi(gl.GL_FOG_COORD_SRC, gl.GL_FOG_COORD)
    gl.glFogfv(gl.GL_FOG_COLOR, (1, 0, 1, 1))
    gl.glTexCoord2f(0.3, 0.3)
    gl.glNormal3f(0, 0, 1)


@pytest.mark.parametrize("vector", [False, True])
@pytest.mark.parametrize("name", [*VERTICES, *COLORS, *OTHERS])
def test_every_attribute_type(beside: Beside, name: str, vector: bool) -> None:
    if vector and name == "glNormal":
        pytest.skip("PyOpenGL's own takes no vector")

    def scene(gl: GL) -> Any:
        everything_on(gl)
        if "Normal" in name:
            gl.glDisable(gl.GL_COLOR_SUM)
            gl.glDisable(gl.GL_TEXTURE_2D)
            for what in (gl.GL_LIGHTING, gl.GL_LIGHT0, gl.GL_NORMALIZE):
                gl.glEnable(what)
        values = {**VERTICES, **COLORS, **OTHERS}[name]
        bare = name in ("glVertex", "glColor", "glNormal")
        call = getattr(gl, name if bare or not vector else name + "v")
        unit = (gl.GL_TEXTURE0,) if "Multi" in name else ()
        if "Coord1" in name:
            gl.glTexCoord2f(0.3, 0)  # Mesa itself would leave the first t where t is given no more
        gl.glBegin(gl.GL_TRIANGLE_FAN)
        gl.glVertex2f(-0.7, -0.7)
        if vector:
            call(*unit, values)
        else:
            call(*unit, *values)
        gl.glVertex2f(0.8, -0.6)
        gl.glVertex2f(0, 0.8)
        gl.glEnd()
        return [
            gl.glGetFloatv(what).tolist()
            for what in (gl.GL_CURRENT_COLOR, gl.GL_CURRENT_NORMAL, gl.GL_CURRENT_TEXTURE_COORDS)
        ]

    beside.equal(scene, name=f"{name} {vector}", wrong=0.004)


def test_current_attributes_last(beside: Beside) -> None:
    def scene(gl: GL) -> Any:
        looking(gl, depth=False)
        answers = []
        for count in (3, 60):
            gl.glBegin(gl.GL_TRIANGLES)
            for k in range(count):
                gl.glColor4f(1, k / count, 0, 1)
                gl.glNormal3f(0, k, 1)
                gl.glVertex2f(0.8 * np.cos(k), 0.8 * np.sin(k))
            gl.glSecondaryColor3f(0.1, 0.2, 0.3)
            gl.glFogCoordf(7)
            gl.glMultiTexCoord2f(gl.GL_TEXTURE1, 5, 6)
            gl.glEnd()
            gl.glPushAttrib(gl.GL_CURRENT_BIT)
            gl.glColor3ub(1, 2, 3)
            answers.append(gl.glGetFloatv(gl.GL_CURRENT_COLOR).tolist())
            gl.glPopAttrib()
            gl.glActiveTexture(gl.GL_TEXTURE1)
            whats = ("COLOR", "NORMAL", "SECONDARY_COLOR", "FOG_COORD", "TEXTURE_COORDS")
            answers += [
                np.ravel(gl.glGetFloatv(getattr(gl, f"GL_CURRENT_{what}"))).tolist() for what in whats
            ]
            gl.glActiveTexture(gl.GL_TEXTURE0)
        gl.glRectf(-0.2, -0.2, 0.2, 0.2)
        return answers

    beside.equal(scene)


@pytest.mark.parametrize(
    "mode", ["TRIANGLES", "QUADS", "TRIANGLE_STRIP", "TRIANGLE_FAN", "POLYGON", "LINE_STRIP"]
)
@pytest.mark.parametrize("in_list", [False, True])
@pytest.mark.parametrize("two_sided", [False, True])
def test_material_at_each_vertex(beside: Beside, mode: str, in_list: bool, two_sided: bool) -> None:
    def scene(gl: GL) -> Any:
        looking(gl, depth=False)
        for what in (gl.GL_LIGHTING, gl.GL_LIGHT0):
            gl.glEnable(what)
        gl.glLineWidth(5)
        gl.glLightModeli(gl.GL_LIGHT_MODEL_TWO_SIDE, two_sided)
        gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, (1, 1, 2, 0))
        gl.glMaterialfv(gl.GL_FRONT_AND_BACK, gl.GL_SPECULAR, (0.6, 0.6, 0.6, 1))
        gl.glNormal3f(0, 0, 1)
        face = gl.GL_FRONT_AND_BACK if two_sided else gl.GL_FRONT
        if in_list:
            gl.glNewList(1, gl.GL_COMPILE)
        gl.glBegin(getattr(gl, f"GL_{mode}"))
        for k, (x, y) in enumerate(ring(12, "STRIP" in mode)):
            if k % 2:
                gl.glMaterialfv(face, gl.GL_AMBIENT_AND_DIFFUSE, (k / 12, 1 - k / 12, 0.3, 1))
            if k % 5 == 1:
                gl.glMaterialf(face, gl.GL_SHININESS, 3 * k)
            if k == 7:
                gl.glMaterialiv(face, gl.GL_EMISSION, (0, 2**29, 2**30, 2**31 - 1))
            gl.glVertex2f(x, y)
        gl.glEnd()
        if in_list:
            gl.glEndList()
            gl.glCallList(1)
        gl.glLoadIdentity()
        gl.glTranslatef(0, 0, -114)
        gl.glRectf(-0.1, -0.1, 0.1, 0.1)
        return [
            gl.glGetMaterialfv(gl.GL_FRONT, what).tolist()
            for what in (gl.GL_AMBIENT, gl.GL_DIFFUSE, gl.GL_EMISSION, gl.GL_SHININESS)
        ]

    name = f"material {mode} {in_list} {two_sided}"
    if in_list and mode == "TRIANGLE_STRIP":  # there Mesa's own lists lose a triangle
        dome, in_list = beside.through_dome(scene), False
        beside.assert_equal(beside.monitor(scene).picture, dome.picture, name=name)
    else:
        beside.equal(scene, name=name, wrong=0.004)


def test_material_of_three_values(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl, depth=False)
        for what in (gl.GL_LIGHTING, gl.GL_LIGHT0):
            gl.glEnable(what)
        gl.glNormal3f(0, 0, 1)
        gl.glBegin(gl.GL_TRIANGLES)
        for x, y in ring(12, False):
            gl.glMaterial(gl.GL_FRONT_AND_BACK, gl.GL_DIFFUSE, (0.5 + x / 2, 0.5 + y / 2, 1))
            gl.glVertex2f(x, y)
        gl.glEnd()

    beside.equal(scene, name="material of three values", wrong=0.004)


def test_array_elements(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl, depth=False)
        points = np.array([(x, y, 0) for x, y in ring(24, False)], np.float32)
        colors = (points * 127 + 128).astype(np.uint8)
        gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
        gl.glEnableClientState(gl.GL_COLOR_ARRAY)
        gl.glVertexPointer(3, gl.GL_FLOAT, 0, points)
        gl.glColorPointer(3, gl.GL_UNSIGNED_BYTE, 0, colors)
        gl.glBegin(gl.GL_TRIANGLES)
        for k in range(24):
            gl.glArrayElement(k * 5 % 24)
            if k % 3 == 2:
                gl.glColor3f(1, 1, 1)
        gl.glEnd()

    beside.equal(scene)


def test_evaluated_vertices(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl, depth=False)
        gl.glMap1f(
            gl.GL_MAP1_VERTEX_3, 0, 1, [[-0.8, -0.5, 0], [-0.3, 0.9, 0], [0.3, -0.9, 0], [0.8, 0.5, 0]]
        )
        gl.glEnable(gl.GL_MAP1_VERTEX_3)
        gl.glBegin(gl.GL_LINE_STRIP)
        for k in range(31):
            gl.glColor3f(1, k / 30, 0)
            gl.glEvalCoord1f(k / 30)
        gl.glEnd()
        gl.glMapGrid1f(10, 0, 1)
        gl.glPointSize(5)
        gl.glEvalMesh1(gl.GL_POINT, 0, 10)
        gl.glBegin(gl.GL_POINTS)
        for k in range(0, 10, 3):
            gl.glColor3f(0, 1, 1)
            gl.glEvalPoint1(k)
        gl.glEnd()

    beside.equal(scene, wrong=0.004)


def test_evaluated_surface(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl, depth=False)
        for what in (gl.GL_LIGHTING, gl.GL_LIGHT0, gl.GL_AUTO_NORMAL, gl.GL_MAP2_VERTEX_3, gl.GL_NORMALIZE):
            gl.glEnable(what)
        grid = [[[i / 2 - 0.75, j / 2 - 0.75, (i * j) % 3 / 2] for i in range(4)] for j in range(4)]
        gl.glMap2f(gl.GL_MAP2_VERTEX_3, 0, 1, 0, 1, grid)
        gl.glMapGrid2f(12, 0, 1, 12, 0, 1)
        gl.glRotatef(30, 1, 0, 0)
        gl.glEvalMesh2(gl.GL_FILL, 0, 12, 0, 12)
        gl.glDisable(gl.GL_LIGHTING)
        gl.glBegin(gl.GL_QUADS)
        for u, v in ((0, 0), (0.2, 0), (0.2, 0.2), (0, 0.2)):
            gl.glEvalCoord2f(u, v)
        gl.glEnd()

    beside.equal(scene, wrong=0.004)


def arrays(gl: GL, buffers: bool) -> tuple[Any, Any, Any]:
    """A lit ring in arrays; gives what the draws index."""
    looking(gl, depth=False)
    data = np.zeros((48, 9), np.float32)
    data[:, :2] = ring(48, True)
    data[:, 3:6] = (0.1, 0.2, 1)
    data[:, 6:] = np.random.default_rng(1).random((48, 3))
    gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
    gl.glEnableClientState(gl.GL_NORMAL_ARRAY)
    gl.glEnableClientState(gl.GL_COLOR_ARRAY)
    gl.glEnable(gl.GL_COLOR_MATERIAL)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glEnable(gl.GL_LIGHT0)
    indices = np.arange(48, dtype=np.uint16)
    if buffers:
        vertices, elements = gl.glGenBuffers(2)
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, vertices)
        gl.glBufferData(gl.GL_ARRAY_BUFFER, data.nbytes, data, gl.GL_STATIC_DRAW)
        gl.glBindBuffer(gl.GL_ELEMENT_ARRAY_BUFFER, elements)
        gl.glBufferData(gl.GL_ELEMENT_ARRAY_BUFFER, indices.nbytes, indices, gl.GL_STATIC_DRAW)
        at: Any = ctypes.c_void_p
    else:
        at = lambda offset: ctypes.c_void_p(data.ctypes.data + offset)  # noqa: E731
    gl.glVertexPointer(3, gl.GL_FLOAT, 36, at(0))
    gl.glNormalPointer(gl.GL_FLOAT, 36, at(12))
    gl.glColorPointer(3, gl.GL_FLOAT, 36, at(24))
    return data, indices, at


@pytest.mark.parametrize("buffers", [False, True])
@pytest.mark.parametrize("call", ["Arrays", "Elements", "RangeElements", "MultiArrays", "MultiElements"])
def test_array_draws(beside: Beside, call: str, buffers: bool) -> None:
    def scene(gl: GL) -> Any:
        data, indices, _ = arrays(gl, buffers)
        first = ctypes.c_void_p(0) if buffers else indices
        if call == "Arrays":
            gl.glDrawArrays(gl.GL_TRIANGLE_STRIP, 3, 40)
        elif call == "Elements":
            gl.glDrawElements(gl.GL_TRIANGLES, 48, gl.GL_UNSIGNED_SHORT, first)
        elif call == "RangeElements":
            gl.glDrawRangeElements(gl.GL_QUADS, 0, 47, 48, gl.GL_UNSIGNED_SHORT, first)
        elif call == "MultiArrays":
            gl.glMultiDrawArrays(gl.GL_TRIANGLE_FAN, np.int32([0, 20, 31]), np.int32([9, 10, 17]), 3)
        else:
            start = 0 if buffers else indices.ctypes.data
            pointers = (ctypes.c_void_p * 2)(start, start + 40)
            gl.glMultiDrawElements(gl.GL_POLYGON, np.int32([12, 20]), gl.GL_UNSIGNED_SHORT, pointers, 2)
        gl.glDisableClientState(gl.GL_COLOR_ARRAY)
        gl.glBegin(gl.GL_TRIANGLES)
        for k in range(30):
            gl.glColor3f(k / 30, 0, 1)
            gl.glVertex2f(0.2 * np.cos(k), 0.2 * np.sin(k))
        gl.glEnd()
        gl.glScalef(0.5, 0.5, 0.5)
        gl.glColor3f(1, 1, 0)
        gl.glDrawArrays(gl.GL_LINE_LOOP, 0, 48)
        return gl.glIsEnabled(gl.GL_VERTEX_ARRAY), gl.glIsEnabled(gl.GL_COLOR_ARRAY), len(data)

    beside.equal(scene, name=f"{call} {buffers}", wrong=0.004)


def test_interleaved_arrays_and_client_attributes(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl, depth=False)
        data = np.zeros((36, 6), np.float32)
        data[:, :3] = np.random.default_rng(2).random((36, 3))
        data[:, 3:5] = ring(36, True)
        gl.glPushClientAttrib(gl.GL_CLIENT_ALL_ATTRIB_BITS)
        gl.glInterleavedArrays(gl.GL_C3F_V3F, 0, data)
        gl.glDrawArrays(gl.GL_QUADS, 0, 36)
        gl.glPopClientAttrib()
        assert not gl.glIsEnabled(gl.GL_VERTEX_ARRAY)
        gl.glRectf(-0.1, -0.1, 0.1, 0.1)

    beside.equal(scene)


def test_arrays_compiled_into_a_list(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        data, indices, _ = arrays(gl, buffers=False)
        gl.glNewList(5, gl.GL_COMPILE)
        gl.glDrawElements(gl.GL_TRIANGLES, 48, gl.GL_UNSIGNED_SHORT, indices)
        gl.glEndList()
        data[:] = 0
        gl.glCallList(5)

    beside.equal(scene)


@pytest.mark.parametrize(
    "name", ["glRectf", "glRectd", "glRecti", "glRects", "glRectfv", "glRectdv", "glRectiv"]
)
def test_rectangles(beside: Beside, name: str) -> None:
    def scene(gl: GL) -> None:
        looking(gl, depth=False)
        gl.glScalef(0.2, 0.2, 0.2)
        for k in range(3):
            gl.glColor3f(1, k / 3, 0)
            one, other = (2 * k - 3, -2), (2 * k - 2, 3)
            if name.endswith("v"):
                kind = {"f": np.float32, "d": np.float64, "i": np.int32}[name[-2]]
                getattr(gl, name)(np.array(one, kind), np.array(other, kind))
            else:
                getattr(gl, name)(*one, *other)

    beside.equal(scene, name=name)


def test_calls_that_gl_refuses_inside_a_block(beside: Beside) -> None:
    """The error comes, at glEnd or at the call after it, and the call has no effect."""

    def scene(gl: GL) -> Any:
        looking(gl, depth=False)
        gl.glBegin(gl.GL_TRIANGLES)
        gl.glVertex2f(-0.5, -0.5)
        try:
            gl.glTranslatef(5, 0, 0)
            gl.glEnable(gl.GL_LIGHTING)
            gl.glBegin(gl.GL_LINES)
            gl.glRectf(0, 0, 1, 1)
            gl.glVertex2f(0.5, -0.5)
            gl.glVertex2f(0, 0.5)
            gl.glEnd()
            gl.glColor3f(1, 0, 0)
            gl.glMatrixMode(gl.GL_MODELVIEW)
        except gl.GLError as error:
            return error.err
        return None

    assert beside.equal(scene) == beside.stock.GL_INVALID_OPERATION


@pytest.mark.parametrize(
    "wrong",
    [
        lambda gl: gl.glEnd(),
        lambda gl: gl.glEnable(0x1234),
        lambda gl: gl.glMatrixMode(7),
        lambda gl: gl.glPopMatrix(),
        lambda gl: gl.glPopAttrib(),
        lambda gl: gl.glLightf(gl.GL_LIGHT0, gl.GL_SPOT_CUTOFF, 200),
        lambda gl: gl.glDrawArrays(77, 0, 3),
        lambda gl: gl.glFrustum(0, 0, 0, 1, 1, 2),
        lambda gl: gl.glEndList(),
        lambda gl: gl.glNewList(0, gl.GL_COMPILE),
        lambda gl: gl.glViewport(0, 0, -1, 5),
    ],
    ids=range(11),
)
def test_a_programs_mistakes_are_raised(beside: Beside, wrong: Any) -> None:
    def scene(gl: GL) -> Any:
        looking(gl, depth=False)
        gl.glRectf(-0.5, -0.5, 0.5, 0.5)
        with pytest.raises(gl.GLError) as raised:
            wrong(gl)
        return raised.value.err

    beside.equal(scene, name="mistake")


@pytest.mark.parametrize(
    "call",
    [
        lambda gl: gl.glColor3f(1, 0.5, 0, 1),
        lambda gl: gl.glColor3ub(300, 128, -1, 7),
        lambda gl: gl.glColor3b(255, 127, 60),
        lambda gl: gl.glColor3ubv([300, 128, 256]),
        lambda gl: gl.glColor4f(1, 0.5, 0, 1, 1),
        lambda gl: gl.glColor3fv([[0.2, 0.5, 1]]),
        lambda gl: gl.glColor3fv(np.array([[0.2, 0.5, 1]])),
        lambda gl: gl.glColor4fv(np.array([[0.2, 0.5, 1, 0.5]], np.float32)),
        lambda gl: gl.glColor3fv(np.array([[0.2], [0.5], [1]])),
        lambda gl: gl.glColor(np.array([[0.2, 0.5, 1]])),
        lambda gl: gl.glColor(np.array([[0.2], [0.5], [1]])),
        lambda gl: gl.glColor3ubv(np.array([200.7, 100, 255])),
        lambda gl: gl.glColor3fv((0.2, 0.5, 1), 1),
        lambda gl: gl.glColor(struct.pack("3f", 0.2, 0.5, 1)),
    ],
    ids=range(14),
)
def test_arguments_are_taken_as_pyopengl_takes_them(beside: Beside, call: Any) -> None:
    """Arguments too many are passed over, bytes wrap, and a matrix of one row or one column is a vector."""

    def scene(gl: GL) -> Any:
        looking(gl, depth=False)
        call(gl)
        gl.glBegin(gl.GL_TRIANGLES)
        gl.glVertex2f(-0.5, -0.5, 3)
        gl.glNormal3f(0, 0, 1, 1)
        gl.glTexCoord2f(0, 0, 1)
        gl.glVertex3f(0.5, -0.5, 0, 2)
        gl.glVertex2fv([[0, 0.5]])
        gl.glEnd()
        gl.glBegin(gl.GL_QUADS)
        for corner in np.array([(-0.9, 0.6), (-0.6, 0.6), (-0.6, 0.9), (-0.9, 0.9)]):
            gl.glVertex2fv(corner.reshape(2, 1), 2)
        gl.glEnd()
        gl.glRectf(0.6, 0.6, 0.9, 0.9, 4)
        return gl.glGetFloatv(gl.GL_CURRENT_COLOR).tolist()

    beside.equal(scene, wrong=0.004)


def test_a_vector_of_the_wrong_length_is_refused(beside: Beside) -> None:
    def scene(gl: GL) -> str:
        looking(gl, depth=False)
        gl.glRectf(-0.5, -0.5, 0.5, 0.5)
        with pytest.raises(ValueError, match="Expected 12 byte"):
            gl.glVertex3fv((1, 2))
        return ""

    beside.equal(scene, wrong=0.004)


REFUSALS = (TypeError, ValueError, AttributeError, NotImplementedError, ctypes.ArgumentError)
"""PyOpenGL's, and ours."""


@pytest.mark.parametrize("count", [3, 300])
@pytest.mark.parametrize(
    "wrong",
    [
        lambda gl: gl.glVertex3f(object(), 1, 2),
        lambda gl: gl.glColor3f("1", 0, 0),
        lambda gl: gl.glColor3ub(1.5, 0, 0),
        lambda gl: gl.glColor3ubv(ctypes.pointer(ctypes.c_float(1))),
        lambda gl: gl.glColor(ctypes.pointer(ctypes.c_float(1))),
        lambda gl: gl.glVertex2fv(None),
    ],
    ids=range(6),
)
def test_what_is_no_number_is_refused_once(beside: Beside, wrong: Any, count: int) -> None:
    """GL goes on as if that had not been given, and so does what was recorded."""

    def misdrawn(gl: GL) -> None:
        gl.glBegin(gl.GL_TRIANGLES)
        try:
            for _ in range(count):
                gl.glVertex3f(5, 5, 0)
            wrong(gl)
        finally:
            gl.glEnd()
        gl.glFlush()  # before which nothing was looked at

    def scene(gl: GL) -> int:
        looking(gl, depth=False)
        with pytest.raises(REFUSALS):
            misdrawn(gl)
        gl.glColor3f(0, 1, 0.5)
        gl.glRectf(-0.5, -0.5, 0.5, 0.5)
        gl.glFlush()
        return int(gl.glGetError())

    beside.equal(scene, wrong=0.004)


def test_a_value_that_is_left_out_is_told_of_by_the_calls_own_name(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        with pytest.raises(TypeError, match="glVertex3f"):
            gl.glVertex3f(1, 2)

    beside.through_dome(scene)
