"""What GL and GLU evaluate bends between its vertices like everything else."""

from functools import partial

import numpy as np
import pytest
from scipy import ndimage

from domeshim.driver import Driver
from tests.pictures.beside import checks
from tests.pictures.test_subdivision import SIZE, perspective

COARSE, FINE = 4, 96
CORNERS = [(-3, -1, -4), (3, -1, -4), (-3, -1, 1), (3, -1, 1)]
"""A floor close under the viewer, wider than the view."""


def lit_and_textured(gl):
    """Whatever evaluators can make of a vertex shows."""
    perspective(gl)
    checks(gl, size=16)
    for what in (gl.GL_LIGHTING, gl.GL_LIGHT0, gl.GL_NORMALIZE, gl.GL_COLOR_MATERIAL):
        gl.glEnable(what)
    gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, (0, 1, 0.5, 0))
    gl.glColor3f(1, 0.9, 0.8)


def maps(gl):
    """A flat patch: however coarse its grid is, the surface is the same."""
    u, v = np.meshgrid([0, 1], [0, 1], indexing="ij")
    square = np.stack([u, v], -1).astype(np.float32)
    colors = np.stack([1 - 0.5 * u, 1 - 0.5 * v, np.full_like(u, 0.9, float), np.ones_like(u)], -1)
    for name, values in (
        (gl.GL_MAP2_VERTEX_3, np.reshape(CORNERS, (2, 2, 3)).transpose(1, 0, 2)),
        (gl.GL_MAP2_TEXTURE_COORD_2, square),
        (gl.GL_MAP2_COLOR_4, colors),
        (gl.GL_MAP2_NORMAL, np.stack([u - 0.5, np.ones_like(u), v - 0.5], -1)),
    ):
        gl.glMap2f(name, 0, 1, 0, 1, np.ascontiguousarray(values, np.float32))
        gl.glEnable(name)


def mesh(gl, pieces, mode="GL_FILL"):
    maps(gl)
    gl.glMapGrid2f(pieces, 0, 1, pieces, 0, 1)
    gl.glEvalMesh2(getattr(gl, mode), 0, pieces, 0, pieces)


def points_in_blocks(gl, pieces):
    maps(gl)
    for row in range(pieces):
        gl.glBegin(gl.GL_QUAD_STRIP)
        for column in range(pieces + 1):
            gl.glEvalCoord2f(row / pieces, column / pieces)
            gl.glEvalCoord2fv([(row + 1) / pieces, column / pieces])
        gl.glEnd()


def nurbs(gl, pieces, display="GLU_FILL", hole=False):
    """The floor as a NURBS surface of the first degree, which GLU samples at so many places each way."""
    surface = gl.gluNewNurbsRenderer()
    gl.gluNurbsProperty(surface, gl.GLU_SAMPLING_METHOD, gl.GLU_DOMAIN_DISTANCE)
    gl.gluNurbsProperty(surface, gl.GLU_U_STEP, pieces)
    gl.gluNurbsProperty(surface, gl.GLU_V_STEP, pieces)
    gl.gluNurbsProperty(surface, gl.GLU_DISPLAY_MODE, getattr(gl, display))
    knots = np.array([0, 0, 1, 1], np.float32)
    gl.glEnable(gl.GL_AUTO_NORMAL)
    gl.gluBeginSurface(surface)
    for values, name in (
        (np.stack(np.meshgrid([0, 1], [0, 1], indexing="ij"), -1), gl.GL_MAP2_TEXTURE_COORD_2),
        (np.reshape(CORNERS, (2, 2, 3)), gl.GL_MAP2_VERTEX_3),
    ):
        gl.gluNurbsSurface(surface, knots, knots, np.ascontiguousarray(values, np.float32), name)
    if hole:
        steps = np.linspace(0, 4, 4 * pieces + 1)
        for corners in (
            [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)],
            [(0.3, 0.2), (0.3, 0.6), (0.7, 0.6), (0.7, 0.2), (0.3, 0.2)],
        ):
            outline = np.stack([np.interp(steps, range(5), axis) for axis in np.transpose(corners)], -1)
            gl.gluBeginTrim(surface)
            gl.gluPwlCurve(surface, outline.astype(np.float32), gl.GLU_MAP1_TRIM_2)
            gl.gluEndTrim(surface)
    gl.gluEndSurface(surface)


def trimmed(gl, pieces):
    nurbs(gl, pieces, hole=True)


def in_a_list(gl, draw, pieces):
    gl.glNewList(1, gl.GL_COMPILE)
    draw(gl, pieces)
    gl.glEndList()
    gl.glCallList(1)


def drawn(beside, draw, pieces, in_list=False, **options):
    def scene(gl):
        lit_and_textured(gl)
        if in_list:
            in_a_list(gl, draw, pieces)
        else:
            draw(gl, pieces)

    return beside.through_dome(scene, (SIZE, SIZE), fov=180.0, **options).picture.astype(int)


def unlike(one, other):
    """The share of what is drawn that differs by more than a bent texture's filtering."""
    differs = (np.abs(one - other) > 40).any(-1)
    return differs.sum() / (other.max(-1) > 0).sum()


@pytest.mark.parametrize("in_list", [False, True])
@pytest.mark.parametrize("draw", [mesh, points_in_blocks, nurbs, trimmed])
def test_a_coarse_surface_is_the_fine_one(beside, draw, in_list):
    fine = drawn(beside, draw, FINE, method="vertex")
    assert (fine.max(-1) > 0).mean() > 0.2
    assert unlike(drawn(beside, draw, COARSE, in_list), fine) < 0.02
    assert unlike(drawn(beside, draw, COARSE, in_list, method="vertex"), fine) > 0.1


def lines(gl, pieces):
    """Five lines each way, of so many pieces."""
    if pieces == COARSE:
        mesh(gl, COARSE, "GL_LINE")
        return
    maps(gl)
    for line in np.linspace(0, 1, COARSE + 1):
        for u, v in ((1, 0), (0, 1)):
            gl.glBegin(gl.GL_LINE_STRIP)
            for step in np.linspace(0, 1, pieces + 1):
                gl.glEvalCoord2f(*(line + u * (step - line), line + v * (step - line)))
            gl.glEnd()


def lit(beside, draw, pieces, method):
    def scene(gl):
        perspective(gl)
        draw(gl, pieces)

    return beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method=method).picture.max(-1) > 0


AROUND = np.ones((3, 3))


def test_coarse_lines_are_the_fine_ones(beside):
    near = ndimage.binary_dilation(lit(beside, lines, FINE, "vertex"), AROUND)
    assert not (lit(beside, lines, COARSE, "auto") & ~near).any()
    assert (lit(beside, lines, COARSE, "vertex") & ~near).sum() > 100


def test_a_coarse_outline_is_the_fine_one(beside):
    """GLU outlines a surface by lines and by triangles, at the places where it samples it."""
    grid = lit(beside, lines, FINE, "vertex")

    def missed(method):
        outlined = lit(beside, partial(nurbs, display="GLU_OUTLINE_POLYGON"), COARSE, method)
        return (grid & ~ndimage.binary_dilation(outlined, AROUND)).sum() / grid.sum()

    assert missed("auto") < 0.01
    assert missed("vertex") > 0.1


def test_a_list_evaluates_by_the_maps_and_colours_of_its_call(beside):
    def scene(gl, in_list):
        perspective(gl)
        maps(gl)
        for name in (gl.GL_MAP2_COLOR_4, gl.GL_MAP2_VERTEX_3):
            gl.glDisable(name)
        if in_list:
            gl.glNewList(1, gl.GL_COMPILE)
            mesh_of_vertices(gl)
            gl.glEndList()
        for color in ((1, 0, 0), (0, 1, 0)):
            gl.glColor3f(*color)
            gl.glCallList(1) if in_list else mesh_of_vertices(gl)
            gl.glTranslatef(0, -0.5, 0)
            assert gl.glGetFloatv(gl.GL_CURRENT_COLOR)[:3].tolist() == list(color)

    def mesh_of_vertices(gl):
        gl.glEnable(gl.GL_MAP2_VERTEX_3)
        gl.glMapGrid2f(2, 0, 1, 2, 0, 1)
        gl.glEvalMesh2(gl.GL_FILL, 0, 2, 0, 2)
        gl.glBegin(gl.GL_TRIANGLES)
        for place in (0, 0), (0, 2), (2, 0):
            gl.glEvalPoint2(*place)
        gl.glEnd()

    options = {"fov": 180.0, "size": (SIZE, SIZE)}
    once, listed = (beside.through_dome(lambda gl, k=k: scene(gl, k), **options).picture for k in (0, 1))
    assert (once[..., 0] > 200).any()
    assert (once[..., 1] > 200).any()
    assert np.array_equal(once, listed)


def test_coordinates_may_be_overwritten_before_the_end_of_a_block(beside):
    def scene(gl):
        perspective(gl)
        maps(gl)
        place = np.zeros(2, np.float32)
        gl.glBegin(gl.GL_TRIANGLES)
        for corner in ((0, 0), (0, 1), (1, 0)):
            place[:] = corner
            gl.glEvalCoord2fv(place)
        gl.glEnd()

    assert (beside.through_dome(scene, (SIZE, SIZE), fov=180.0).picture.max(-1) > 0).mean() > 0.05


def test_tessellating_nurbs_call_the_program(beside):
    """What GLU hands to callbacks is drawn by the program, and GLU draws nothing."""

    def scene(gl):
        perspective(gl)
        gl.glColor3f(0, 1, 0)
        surface = gl.gluNewNurbsRenderer()
        gl.gluNurbsProperty(surface, gl.GLU_NURBS_MODE, gl.GLU_NURBS_TESSELLATOR)
        gl.gluNurbsCallback(surface, gl.GLU_NURBS_BEGIN, gl.glBegin)
        gl.gluNurbsCallback(surface, gl.GLU_NURBS_VERTEX, lambda place: gl.glVertex3f(*place[:3]))
        gl.gluNurbsCallback(surface, gl.GLU_NURBS_END, gl.glEnd)
        knots = np.array([0, 0, 1, 1], np.float32)
        gl.gluBeginSurface(surface)
        gl.gluNurbsSurface(
            surface, knots, knots, np.reshape(CORNERS, (2, 2, 3)).astype(np.float32), gl.GL_MAP2_VERTEX_3
        )
        gl.gluEndSurface(surface)

    picture = beside.through_dome(scene, (SIZE, SIZE), fov=180.0).picture
    assert (picture[..., 1] > 200).mean() > 0.1
    assert picture[..., 0].max() == 0


def test_nurbs_without_a_beginning_are_drawn_at_once(beside):
    def scene(gl, begun):
        perspective(gl)
        surface = gl.gluNewNurbsRenderer()
        knots = np.array([0, 0, 1, 1], np.float32)
        if begun:
            gl.gluBeginSurface(surface)
        gl.gluNurbsSurface(
            surface, knots, knots, np.reshape(CORNERS, (2, 2, 3)).astype(np.float32), gl.GL_MAP2_VERTEX_3
        )
        if begun:
            gl.gluEndSurface(surface)

    options = {"fov": 180.0, "size": (SIZE, SIZE)}
    at_once, begun = (beside.through_dome(lambda gl, k=k: scene(gl, k), **options).picture for k in (0, 1))
    assert (begun.max(-1) > 0).mean() > 0.1
    assert np.array_equal(at_once, begun)


def test_opengl_2_says_that_it_cannot(beside, monkeypatch, capsys):
    monkeypatch.setattr(Driver, "version", (2, 1))
    monkeypatch.setitem(vars(beside.session.dome._driver), "legacy", True)
    drawn(beside, mesh, COARSE)
    assert capsys.readouterr().err.count("this OpenGL cannot say what it evaluates") == 1
