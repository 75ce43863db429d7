from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterator

import numpy as np
import pytest
from OpenGL import GL

from domeshim.GLUT import solids
from domeshim.GLUT.shapes import platonic, sponge, teapot
from domeshim.GLUT.shapes import round as turned
from domeshim.GLUT.shapes.mesh import Solid, Wire
from domeshim.GLUT.shapes.rhombic import rhombic_dodecahedron_faces
from domeshim.window.contract import SurfaceFormat, WindowEvents
from domeshim.window.offscreen import OffscreenBackend
from tests.GLUT.freeglut_runs import beside_freeglut

SIZE = 128
BODIES = {
    "sphere": (turned.sphere(2.0, 64, 64), 4 / 3 * np.pi * 8),
    "cone": (turned.cone(1.5, 2.0, 128, 3), np.pi * 1.5**2 * 2 / 3),
    "cylinder": (turned.cylinder(1.5, 2.0, 128, 3), np.pi * 1.5**2 * 2),
    "torus": (turned.torus(0.5, 2.0, 64, 128), 2 * np.pi**2 * 2 * 0.25),
    "cube": (platonic.solid(platonic.cube_faces()).scaled(3.0), 27.0),
    "tetrahedron": (platonic.solid(platonic.tetrahedron_faces()), 8 / (9 * np.sqrt(3))),
    "octahedron": (platonic.solid(platonic.octahedron_faces()), 4 / 3),
    "dodecahedron": (platonic.solid(platonic.dodecahedron_faces()), 2 * (5 + np.sqrt(5))),
    "icosahedron": (platonic.solid(platonic.icosahedron_faces()), 2.53615),
    "rhombic": (platonic.solid(rhombic_dodecahedron_faces()), 2.0),
    "sponge": (sponge.sponge(2, (5.0, 6.0, 7.0), 2.0), 64 / (9 * np.sqrt(3)) / 4),
}


def test_pictures_equal_freeglut() -> None:
    found = beside_freeglut("solids")
    assert found["error"] == 0
    pictures = found["pictures"]
    unlike = {case: seen for case, seen in pictures.items() if seen["plain"] > max(2, seen["drawn"] / 1000)}
    assert not unlike
    uneven = {case: seen for case, seen in pictures.items() if seen["any"] > max(3, seen["drawn"] / 200)}
    assert not uneven
    assert sum(seen["drawn"] > 100 for seen in pictures.values()) > 180


@pytest.mark.parametrize("name", BODIES)
def test_triangles_enclose_the_body_and_face_outwards(name: str) -> None:
    solid, volume = BODIES[name]
    corners = solid.vertices.positions.astype(float)[solid.triangles]
    enclosed = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    assert enclosed == pytest.approx(volume, rel=0.005)


@pytest.mark.parametrize("name", BODIES)
def test_normals_point_out_of_the_triangles(name: str) -> None:
    solid = BODIES[name][0]
    corners, normals = solid.vertices.positions[solid.triangles], solid.vertices.normals[solid.triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    wide = np.linalg.norm(across, axis=1) > 1e-7  # the cone's tip is a ring of no width
    across, normals = across[wide], normals[wide]
    assert len(across) > 0
    assert (np.einsum("ij,ikj->ik", across, normals) > 0).all()


@pytest.mark.parametrize("piece", [teapot.teapot, teapot.teacup, teapot.teaspoon])
def test_tea_set_is_whole(piece: Callable[[float], Solid]) -> None:
    solid = piece(1.0)
    assert np.isfinite(solid.vertices.interleaved).all()
    assert np.linalg.norm(solid.vertices.normals, axis=1) == pytest.approx(1, abs=1e-5)
    assert solid.vertices.texcoords is not None
    assert solid.vertices.texcoords.min() == 0
    assert solid.vertices.texcoords.max() == 1
    assert piece(2.0).vertices.positions == pytest.approx(2 * solid.vertices.positions)


def test_meshes_are_made_once_and_cannot_be_changed() -> None:
    assert turned.sphere(1.0, 8, 8) is turned.sphere(1.0, 8, 8)
    with pytest.raises(ValueError, match="read-only"):
        turned.sphere(1.0, 8, 8).vertices.positions[0] = 0


def test_large_meshes_have_wide_indices() -> None:
    solid = turned.sphere(1.0, 300, 300)
    assert solid.triangles.dtype == np.uint32
    assert solid.triangles.max() == len(solid.vertices.positions) - 1 > 65535


@pytest.mark.parametrize("counts", [(0, 5), (-3, 5), (5, 0), (5, -1)])
def test_too_small_counts_give_no_shape(counts: tuple[int, int]) -> None:
    assert turned.sphere(1.0, *counts) is None
    assert turned.wire_sphere(1.0, *counts) is None
    assert turned.cone(1.0, 1.0, *counts) is None
    assert turned.wire_cone(1.0, 1.0, *counts) is None
    assert turned.cylinder(1.0, 1.0, *counts) is None
    assert turned.wire_cylinder(1.0, 1.0, *counts) is None
    assert turned.torus(0.5, 1.0, *counts) is None
    assert turned.wire_torus(0.5, 1.0, *counts) is None


def test_a_wire_shape_is_its_strips_cut_up() -> None:
    wire = platonic.wire(platonic.tetrahedron_faces())
    assert wire.lines.tolist()[:4] == [[0, 1], [1, 2], [2, 0], [3, 4]]
    open_strip = turned.wire_sphere(1.0, 3, 2)
    assert isinstance(open_strip, Wire)
    assert open_strip.lines.tolist()[:3] == [[0, 1], [1, 4], [0, 2]]


@pytest.fixture(scope="module")
def screen() -> Iterator[None]:
    backend = OffscreenBackend()
    window = backend.open_window("solids", (SIZE, SIZE), None, SurfaceFormat(), WindowEvents())
    window.make_current()
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glFrustum(-0.3, 0.3, -0.3, 0.3, 1, 20)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glTranslatef(0, 0, -5)
    GL.glRotatef(30, 1, 1, 0)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glEnable(GL.GL_LIGHT0)
    GL.glEnable(GL.GL_LIGHTING)
    yield
    backend.close()


def picture(draw: Callable[[], object]) -> bytes:
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    draw()
    return bytes(GL.glReadPixels(0, 0, SIZE, SIZE, GL.GL_RGB, GL.GL_UNSIGNED_BYTE))


def given(name: str) -> tuple[object, ...]:
    """Arguments for a function."""
    arguments: dict[str, tuple[object, ...]] = {
        "Sphere": (1.0, 9, 7),
        "Cone": (1.0, 1.0, 9, 7),
        "Cylinder": (1.0, 1.0, 9, 7),
        "Torus": (0.5, 1.0, 9, 7),
        "SierpinskiSponge": (2, (0.1, 0.0, 0.0), 1.0),
        **dict.fromkeys(("Cube", "Teapot", "Teacup", "Teaspoon"), (1.0,)),
    }
    return arguments.get(name.removeprefix("glutSolid").removeprefix("glutWire"), ())


def every_shape() -> None:
    """All functions, each on a place of its own."""
    for number, name in enumerate(solids.__all__):
        GL.glPushMatrix()
        GL.glTranslatef(number % 7 * 0.4 - 1.2, number // 7 * 0.4 - 0.6, 0)
        GL.glScalef(0.2, 0.2, 0.2)
        getattr(solids, name)(*given(name))
        GL.glPopMatrix()


def test_every_shape_draws_something(screen: None) -> None:
    blank = picture(lambda: None)
    for name in solids.__all__:
        assert picture(lambda n=name: getattr(solids, n)(*given(n))) != blank, name


def test_display_lists_hold_the_shapes(screen: None) -> None:
    wanted = picture(every_shape)
    number = GL.glGenLists(1)
    GL.glNewList(number, GL.GL_COMPILE)
    every_shape()
    GL.glEndList()
    assert picture(lambda: GL.glCallList(number)) == wanted


@pytest.mark.parametrize("in_array_object", [False, True])
def test_the_programs_arrays_and_buffers_stay_out_and_stay(screen: None, in_array_object: bool) -> None:
    wanted = picture(every_shape)
    rubbish = np.full(64, 7, np.float32)
    array_object = GL.glGenVertexArrays(1) if in_array_object else 0
    GL.glBindVertexArray(array_object)
    vertices, elements = GL.glGenBuffers(2)
    GL.glBindBuffer(GL.GL_ARRAY_BUFFER, vertices)
    GL.glBufferData(GL.GL_ARRAY_BUFFER, rubbish.nbytes, rubbish, GL.GL_STATIC_DRAW)
    GL.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, elements)
    GL.glBufferData(GL.GL_ELEMENT_ARRAY_BUFFER, rubbish.nbytes, rubbish, GL.GL_STATIC_DRAW)
    switched = (
        *(GL.GL_VERTEX_ARRAY, GL.GL_COLOR_ARRAY, GL.GL_TEXTURE_COORD_ARRAY, GL.GL_EDGE_FLAG_ARRAY),
        *(GL.GL_INDEX_ARRAY, GL.GL_SECONDARY_COLOR_ARRAY, GL.GL_FOG_COORD_ARRAY),
    )
    for array in switched:
        GL.glEnableClientState(array)
    GL.glVertexPointer(2, GL.GL_FLOAT, 8, ctypes.c_void_p(4))
    GL.glColorPointer(3, GL.GL_FLOAT, 0, ctypes.c_void_p(0))
    try:
        assert picture(every_shape) == wanted
        assert GL.glGetIntegerv(GL.GL_VERTEX_ARRAY_BINDING) == array_object
        assert GL.glGetIntegerv(GL.GL_ARRAY_BUFFER_BINDING) == vertices
        assert GL.glGetIntegerv(GL.GL_ELEMENT_ARRAY_BUFFER_BINDING) == elements
        assert GL.glGetIntegerv(GL.GL_VERTEX_ARRAY_BUFFER_BINDING) == vertices
        assert GL.glGetIntegerv(GL.GL_VERTEX_ARRAY_SIZE) == 2
        assert GL.glGetIntegerv(GL.GL_VERTEX_ARRAY_STRIDE) == 8
        assert all(GL.glIsEnabled(array) for array in switched)
        assert not GL.glIsEnabled(GL.GL_NORMAL_ARRAY)
    finally:
        for array in switched:
            GL.glDisableClientState(array)
        GL.glBindVertexArray(0)
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, 0)
        GL.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, 0)


def test_an_overlaid_gl_sees_the_draws(screen: None, monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[tuple[int, int]] = []
    monkeypatch.setattr(GL, "glDrawElements", lambda mode, count, kind, indices: seen.append((mode, count)))
    solids.glutSolidCube(1.0)
    solids.glutWireCube(1.0)
    assert seen == [(GL.GL_TRIANGLES, 36), (GL.GL_LINES, 48)]


def test_an_error_leaves_the_attribute_stack_as_it_was(screen: None, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise RuntimeError("refused")

    monkeypatch.setattr(GL, "glDrawElements", refuse)
    with pytest.raises(RuntimeError):
        solids.glutSolidCube(1.0)
    assert GL.glGetIntegerv(GL.GL_CLIENT_ATTRIB_STACK_DEPTH) == 0
