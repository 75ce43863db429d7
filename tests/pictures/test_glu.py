"""GLU's quadrics, tessellators, NURBS, mipmaps and projections, beside stock GLU."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.pictures.beside import FOV, GL, SIZE, Beside, Scene, checks, looking

STYLES = ("GLU_FILL", "GLU_LINE", "GLU_SILHOUETTE", "GLU_POINT")
NORMALS = ("GLU_SMOOTH", "GLU_FLAT", "GLU_NONE")


def quadric(gl: GL, style: str = "GLU_FILL", normals: str = "GLU_SMOOTH", *, inside: bool = False) -> Any:
    q = gl.gluNewQuadric()
    gl.gluQuadricDrawStyle(q, getattr(gl, style))
    gl.gluQuadricNormals(q, getattr(gl, normals))
    gl.gluQuadricOrientation(q, gl.GLU_INSIDE if inside else gl.GLU_OUTSIDE)
    gl.gluQuadricTexture(q, gl.GL_TRUE)
    return q


def lit(gl: GL) -> None:
    looking(gl)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glEnable(gl.GL_LIGHT0)
    gl.glLightModeli(gl.GL_LIGHT_MODEL_TWO_SIDE, 1)
    gl.glRotatef(-60, 1, 0.2, 0)


SHAPES: dict[str, Any] = {
    "sphere": lambda gl, q: gl.gluSphere(q, 0.7, 16, 12),
    "cylinder": lambda gl, q: gl.gluCylinder(q, 0.5, 0.2, 0.8, 16, 5),
    "disk": lambda gl, q: gl.gluDisk(q, 0.2, 0.7, 16, 3),
    "partial disk": lambda gl, q: gl.gluPartialDisk(q, 0.2, 0.7, 16, 3, 20, 240),
}


@pytest.mark.parametrize("style", STYLES)
@pytest.mark.parametrize("shape", SHAPES)
def test_quadrics_of_every_style(beside: Beside, shape: str, style: str) -> None:
    def scene(gl: GL) -> None:
        lit(gl)
        gl.glPointSize(3)
        SHAPES[shape](gl, quadric(gl, style))

    beside.equal(scene, name=f"{shape} {style}", wrong=0.006)


@pytest.mark.parametrize("inside", [False, True])
@pytest.mark.parametrize("normals", NORMALS)
@pytest.mark.parametrize("shape", SHAPES)
def test_normals_texture_and_orientation(beside: Beside, shape: str, normals: str, inside: bool) -> None:
    def scene(gl: GL) -> None:
        lit(gl)
        checks(gl)
        SHAPES[shape](gl, quadric(gl, "GLU_FILL", normals, inside=inside))

    beside.equal(scene, name=f"{shape} {normals} {inside}", wrong=0.006)


@pytest.mark.parametrize("execute", [False, True])
def test_quadric_in_a_list(beside: Beside, execute: bool) -> None:
    def scene(gl: GL) -> None:
        lit(gl)
        gl.glNewList(1, gl.GL_COMPILE_AND_EXECUTE if execute else gl.GL_COMPILE)
        gl.gluSphere(quadric(gl), 0.3, 12, 8)
        gl.glEndList()
        gl.glTranslatef(0.4, 0, 0)
        gl.glCallList(1)

    beside.equal(scene, wrong=0.004)


def tessellated(gl: GL, rule: str, boundary: bool, callbacks: str) -> list[str]:
    """A star with a square hole that cross; each callback in the way that programs give them."""
    looking(gl)
    calls: list[str] = []
    tess = gl.gluNewTess()

    def vertex(data: Any) -> None:
        gl.glColor3f(*data[3:])
        gl.glVertex3f(*data[:3])

    def combine(place: Any, corners: Any, weights: Any) -> list[float]:
        calls.append("combine")
        total = np.zeros(3)
        for corner, weight in zip(corners, weights, strict=True):
            if corner is not None:
                total += weight * np.array(corner[3:])
        return [*place, *total]

    if callbacks == "gl":
        gl.gluTessCallback(tess, gl.GLU_TESS_BEGIN, gl.glBegin)
        gl.gluTessCallback(tess, gl.GLU_TESS_END, gl.glEnd)
        gl.gluTessCallback(tess, gl.GLU_TESS_VERTEX, vertex)
    else:
        gl.gluTessCallback(
            tess, gl.GLU_TESS_BEGIN, lambda mode: (calls.append(f"begin {mode}"), gl.glBegin(mode))
        )
        gl.gluTessCallback(tess, gl.GLU_TESS_END, lambda: (calls.append("end"), gl.glEnd()))
        gl.gluTessCallback(tess, gl.GLU_TESS_VERTEX, vertex)
        gl.gluTessCallback(tess, gl.GLU_TESS_EDGE_FLAG, gl.glEdgeFlag)
    gl.gluTessCallback(tess, gl.GLU_TESS_COMBINE, combine)
    gl.gluTessProperty(tess, gl.GLU_TESS_WINDING_RULE, getattr(gl, rule))
    gl.gluTessProperty(tess, gl.GLU_TESS_BOUNDARY_ONLY, gl.GL_TRUE if boundary else gl.GL_FALSE)
    gl.gluTessNormal(tess, 0, 0, 1)
    gl.gluTessBeginPolygon(tess, None)
    star = [(0.8 * np.sin(k * 0.8 * np.pi), 0.8 * np.cos(k * 0.8 * np.pi)) for k in range(5)]
    square = [(-0.3, -0.3), (-0.3, 0.35), (0.3, 0.35), (0.3, -0.3)]
    for contour in (star, square):
        gl.gluTessBeginContour(tess)
        for x, y in contour:
            gl.gluTessVertex(tess, (x, y, 0), (x, y, 0, (x + 1) / 2, (y + 1) / 2, 0.8))
        gl.gluTessEndContour(tess)
    gl.gluTessEndPolygon(tess)
    gl.gluDeleteTess(tess)
    return calls


@pytest.mark.parametrize("callbacks", ["gl", "own"])
@pytest.mark.parametrize("boundary", [False, True])
@pytest.mark.parametrize(
    "rule", ["GLU_TESS_WINDING_ODD", "GLU_TESS_WINDING_NONZERO", "GLU_TESS_WINDING_NEGATIVE"]
)
def test_tessellators(beside: Beside, rule: str, boundary: bool, callbacks: str) -> None:
    beside.equal(
        lambda gl: tessellated(gl, rule, boundary, callbacks),
        name=f"{rule} {boundary} {callbacks}",
        wrong=0.004,
    )


def test_tessellated_in_a_list(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        gl.glNewList(4, gl.GL_COMPILE)
        tessellated(gl, "GLU_TESS_WINDING_ODD", False, "gl")
        gl.glEndList()
        gl.glCallList(4)

    beside.equal(scene, wrong=0.004)


def nurbs_surface(gl: GL, *, outline: bool = False) -> None:
    looking(gl)
    for what in (gl.GL_LIGHTING, gl.GL_LIGHT0, gl.GL_AUTO_NORMAL, gl.GL_NORMALIZE):
        gl.glEnable(what)
    nurbs = gl.gluNewNurbsRenderer()
    gl.gluNurbsProperty(nurbs, gl.GLU_SAMPLING_TOLERANCE, 10)
    gl.gluNurbsProperty(nurbs, gl.GLU_DISPLAY_MODE, gl.GLU_OUTLINE_POLYGON if outline else gl.GLU_FILL)
    knots = np.array([0, 0, 0, 0, 1, 1, 1, 1], np.float32)
    points = np.array(
        [
            [[i / 2 - 0.75, j / 2 - 0.75, 0.8 if 0 < i < 3 and 0 < j < 3 else 0] for j in range(4)]
            for i in range(4)
        ],
        np.float32,
    )
    gl.glRotatef(-40, 1, 0, 0)
    gl.gluBeginSurface(nurbs)
    gl.gluNurbsSurface(nurbs, knots, knots, points, gl.GL_MAP2_VERTEX_3)
    gl.gluEndSurface(nurbs)


def nurbs_curve(gl: GL) -> None:
    looking(gl)
    nurbs = gl.gluNewNurbsRenderer()
    knots = np.array([0, 0, 0, 0, 1, 1, 1, 1], np.float32)
    points = np.array([(-0.7, -0.5, 0), (-0.2, 0.9, 0), (0.2, -0.9, 0), (0.7, 0.5, 0)], np.float32)
    gl.glLineWidth(3)
    gl.gluBeginCurve(nurbs)
    gl.gluNurbsCurve(nurbs, knots, points, gl.GL_MAP1_VERTEX_3)
    gl.gluEndCurve(nurbs)


@pytest.mark.parametrize("outline", [False, True])
def test_nurbs_surface(beside: Beside, outline: bool) -> None:
    beside.equal(lambda gl: nurbs_surface(gl, outline=outline), name=f"nurbs {outline}", wrong=0.004)


def test_nurbs_curve(beside: Beside) -> None:
    beside.equal(nurbs_curve, wrong=0.006)


@pytest.mark.parametrize("scene", [nurbs_surface, nurbs_curve])
def test_nurbs_are_in_both_eyes(beside: Beside, scene: Scene) -> None:
    both = beside.through_dome(scene, (2 * SIZE, SIZE), stereo="left-right", eyes=1e-4).picture
    lit = [int((half.max(-1) > 100).sum()) for half in np.split(both, 2, axis=1)]
    assert lit[0] > 500
    assert abs(lit[1] - lit[0]) < 0.02 * lit[0]


def test_projections_answer_as_on_the_monitor(beside: Beside) -> None:
    def scene(gl: GL) -> Any:
        looking(gl)
        gl.glRotatef(20, 0, 1, 0)
        gl.glRectf(-0.5, -0.5, 0.5, 0.5)
        gl.glViewport(0, 0, 250, 240)
        answers = []
        for x, y, z in np.random.default_rng(6).uniform(-0.5, 0.5, (20, 3)).tolist():
            window = gl.gluProject(x, y, z)
            answers += [tuple(window), tuple(gl.gluUnProject(*window))]
            model = gl.glGetDoublev(gl.GL_MODELVIEW_MATRIX)
            projection = gl.glGetDoublev(gl.GL_PROJECTION_MATRIX)
            viewport = gl.glGetIntegerv(gl.GL_VIEWPORT)
            answers.append(tuple(gl.gluProject(x, y, z, model, projection, viewport)))
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glLoadIdentity()
        gl.gluPickMatrix(100, 120, 5, 5, viewport)
        gl.gluPerspective(FOV, 1, 100, 130)
        answers.append(gl.glGetDoublev(gl.GL_PROJECTION_MATRIX))
        gl.glViewport(0, 0, 256, 256)
        return answers

    beside.equal(scene)


def test_scaled_images_and_mipmaps(beside: Beside) -> None:
    def scene(gl: GL) -> Any:
        looking(gl, depth=False)
        image = np.random.default_rng(7).integers(0, 255, (32, 32, 3)).astype(np.uint8)
        gl.glBindTexture(gl.GL_TEXTURE_2D, gl.glGenTextures(1))
        gl.glTexParameteri(gl.GL_TEXTURE_2D, gl.GL_TEXTURE_MIN_FILTER, gl.GL_NEAREST_MIPMAP_NEAREST)
        gl.gluBuild2DMipmaps(gl.GL_TEXTURE_2D, 3, 32, 32, gl.GL_RGB, gl.GL_UNSIGNED_BYTE, image)
        gl.glEnable(gl.GL_TEXTURE_2D)
        for k, size in enumerate((0.5, 0.12, 0.05)):
            gl.glBegin(gl.GL_QUADS)
            for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                gl.glTexCoord2f(x, y)
                gl.glVertex2f(0.5 * k - 0.2 + size * x, size * y)
            gl.glEnd()
        scaled = np.zeros((8, 8, 3), np.uint8)
        gl.gluScaleImage(gl.GL_RGB, 32, 32, gl.GL_UNSIGNED_BYTE, image, 8, 8, gl.GL_UNSIGNED_BYTE, scaled)
        return scaled.tolist()

    beside.equal(scene, wrong=0.006)


def test_arguments_too_many_are_passed_over(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glLoadIdentity()
        gl.gluPerspective(FOV, 1, 0.5, 100, 0)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        q = gl.gluNewQuadric(0)
        gl.gluQuadricTexture(q, gl.GL_TRUE, 0)
        gl.gluSphere(q, 0.7, 16, 12, 0)
        gl.gluDeleteQuadric(q, 0)
        gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
        gl.glVertexPointer(2, gl.GL_FLOAT, 0, np.array([(0.8, 0.8), (0.9, 0.8), (0.9, 0.9)], np.float32))
        gl.glDrawArrays(gl.GL_TRIANGLES, 0, 3, 0)

    beside.equal(scene, wrong=0.004)
