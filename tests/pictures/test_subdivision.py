"""Long edges bend by themselves: lines lie on their true curves and surfaces close."""

import numpy as np
import pytest
from scipy import ndimage
from scipy.spatial import cKDTree

from domeshim.lens.models import Equidistant
from domeshim.lens.projection import disc_of
from domeshim.state.context import DomeContext

SIZE = 512
EDGES = {
    "long": ((-50, 3, -2), (50, 3, -2)),
    "hair": ((-100, 0.01, -0.01), (100, 0.01, -0.01)),
    "stiff": ((0.01, 0.02, -0.01), (500, 30, -1000)),
    "steep": ((1, -40, -3), (1, 40, -0.5)),
}


def perspective(gl):
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.gluPerspective(60, 1, 0.001, 10_000)
    gl.glMatrixMode(gl.GL_MODELVIEW)


def immediately(gl, mode, vertices):
    gl.glBegin(mode)
    for vertex in vertices:
        gl.glVertex3f(*vertex)
    gl.glEnd()


def listed(gl, mode, vertices):
    gl.glNewList(1, gl.GL_COMPILE)
    immediately(gl, mode, vertices)
    gl.glEndList()
    gl.glCallList(1)


def from_array(gl, mode, vertices):
    gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
    gl.glVertexPointer(3, gl.GL_FLOAT, 0, np.array(vertices, np.float32))
    gl.glDrawArrays(mode, 0, len(vertices))
    gl.glDisableClientState(gl.GL_VERTEX_ARRAY)


def from_buffer(gl, mode, vertices):
    data = np.array(vertices, np.float32)
    buffer = gl.glGenBuffers(1)
    gl.glBindBuffer(gl.GL_ARRAY_BUFFER, buffer)
    gl.glBufferData(gl.GL_ARRAY_BUFFER, data.nbytes, data, gl.GL_STATIC_DRAW)
    gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
    gl.glVertexPointer(3, gl.GL_FLOAT, 0, None)
    gl.glDrawElements(mode, len(data), gl.GL_UNSIGNED_SHORT, np.arange(len(data), dtype=np.uint16))
    gl.glDisableClientState(gl.GL_VERTEX_ARRAY)
    gl.glBindBuffer(gl.GL_ARRAY_BUFFER, 0)


WAYS = [immediately, listed, from_array, from_buffer]
METHODS = ["auto", "geometry", "cpu"]


def true_curve(a, b, fov):
    """(n, 2) pixels of the line from a to b, columns and rows, in float64, evenly in angle."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    r0, r1 = np.linalg.norm(a), np.linalg.norm(b)
    angle = np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)
    s = np.linspace(0, 1, 20_001)[:, None]
    disc = disc_of(np.sin((1 - s) * angle) * a / r0 + np.sin(s * angle) * b / r1, Equidistant(fov))
    return (np.stack([disc[:, 0], -disc[:, 1]], -1) + 1) * SIZE / 2 - 0.5


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("edge", EDGES.values(), ids=EDGES)
def test_long_lines_lie_on_their_true_curves(beside, edge, way, method):
    def scene(gl):
        perspective(gl)
        way(gl, gl.GL_LINES, edge)

    picture = beside.through_dome(scene, (SIZE, SIZE), fov=180.0, tolerance=0.1, method=method).picture
    rows, columns = np.nonzero(picture.max(-1) > 128)
    curve = true_curve(*edge, 180.0)
    curve = curve[np.hypot(*(curve - (SIZE - 1) / 2).T) < SIZE / 2 - 1]
    drawn = np.stack([columns, rows], -1).astype(float)
    drawn = drawn[np.hypot(*(drawn - (SIZE - 1) / 2).T) < SIZE / 2 - 2]
    assert cKDTree(curve).query(drawn)[0].max() < 0.1 + 0.75  # a pixel's centre is up to half a diagonal off
    inner = curve[np.hypot(*(curve - (SIZE - 1) / 2).T) < SIZE / 2 - 4]
    assert cKDTree(drawn).query(inner)[0].max() < 1.5


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("way", WAYS)
def test_a_floor_of_one_quad_reaches_the_horizon(beside, way, method):
    def scene(gl):
        perspective(gl)
        way(gl, gl.GL_QUADS, [(-50, -1, -50), (50, -1, -50), (50, -1, 50), (-50, -1, 50)])

    picture = beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method=method).picture[..., 0] > 128
    column, row = np.meshgrid((np.arange(SIZE) + 0.5) / SIZE * 2 - 1, 1 - (np.arange(SIZE) + 0.5) / SIZE * 2)
    radius = np.hypot(column, row)
    scale = np.sin(radius * np.pi / 2) / radius
    x, y, z = column * scale, row * scale, -np.cos(radius * np.pi / 2)
    with np.errstate(divide="ignore"):
        floor = (y < 0) & (np.abs(x / y) < 50) & (np.abs(z / y) < 50) & (radius < 1)
    wrong = (picture != floor) & (radius < 0.99)
    assert wrong.sum() < 0.002 * floor.sum()


@pytest.mark.parametrize("fov", [180.0, 220.0, 300.0, 360.0])
@pytest.mark.parametrize("method", [*METHODS, "tessellate"])
@pytest.mark.parametrize("turn", [0, 200])
def test_a_closed_room_covers_the_whole_disc(beside, fov, method, turn):
    def scene(gl):
        perspective(gl)
        gl.glRotatef(turn, 1, 2, 3)
        gl.glTranslatef(0.3, -0.2, 0.1)
        a, b = -2, 3
        corners = [(x, y, z) for x in (a, b) for y in (a, b) for z in (a, b)]
        faces = ((0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5))
        immediately(gl, gl.GL_QUADS, [corners[k] for face in faces for k in face])

    picture = beside.through_dome(scene, (SIZE, SIZE), fov=fov, method=method).picture
    column, row = np.meshgrid(*[(np.arange(SIZE) + 0.5) / SIZE * 2 - 1] * 2)
    assert (picture[np.hypot(column, row) < 1 - 1 / SIZE] == 255).all()


def test_wireframe_shows_the_programs_own_edges(beside):
    def scene(gl):
        perspective(gl)
        gl.glPolygonMode(gl.GL_FRONT_AND_BACK, gl.GL_LINE)
        immediately(gl, gl.GL_QUADS, [(-3, -3, -2), (3, -3, -2), (3, 3, -2), (-3, 3, -2)])

    picture = beside.through_dome(scene, (SIZE, SIZE), fov=180.0).picture.max(-1) > 128
    assert picture.any()
    assert not picture[SIZE // 2 - 60 : SIZE // 2 + 60, SIZE // 2 - 60 : SIZE // 2 + 60].any()


def test_short_edges_are_not_subdivided(beside, monkeypatch):
    patches = []
    dress = DomeContext.dress

    def spy(context, patch=None):
        patches.append(patch)
        dress(context, patch)

    def triangle(gl, size):
        perspective(gl)
        immediately(gl, gl.GL_TRIANGLES, [(0, 0, -20), (size, 0, -20), (0, size, -20)])

    monkeypatch.setattr(DomeContext, "dress", spy)
    beside.through_dome(lambda gl: triangle(gl, 1), (SIZE, SIZE), fov=180.0)
    assert patches
    assert set(patches) == {None}
    beside.through_dome(lambda gl: triangle(gl, 10), (SIZE, SIZE), fov=180.0)
    assert "triangles" in [patch.kind for patch in patches if patch]


def test_flat_and_smooth_take_turns(beside):
    def scene(gl):
        perspective(gl)
        for model, x in ((gl.GL_SMOOTH, -4), (gl.GL_FLAT, 0), (gl.GL_SMOOTH, 4)):
            gl.glShadeModel(model)
            gl.glBegin(gl.GL_TRIANGLES)
            for color, (dx, dy) in (((1, 0, 0), (-1, -2)), ((0, 1, 0), (1, -2)), ((0, 0, 1), (0, 2))):
                gl.glColor3f(*color)
                gl.glVertex3f(x + dx, dy, -3)
            gl.glEnd()

    picture = beside.through_dome(scene, (SIZE, SIZE), fov=180.0).picture
    flat = picture[200:312, 236:276].reshape(-1, 3)
    drawn = flat[flat.max(-1) > 0]
    assert len(drawn) > 500
    assert (drawn == [0, 0, 255]).all()
    for columns in (slice(0, 180), slice(332, SIZE)):
        smooth = picture[:, columns].reshape(-1, 3)
        assert len(np.unique(smooth[smooth.max(-1) > 0], axis=0)) > 100


def test_each_draw_is_placed_by_its_own_perspective(beside):
    """Programs shared by draws that lie elsewhere get their uniforms again at each turn."""

    def scene(gl):
        perspective(gl)
        for turn in range(4):
            gl.glMatrixMode(gl.GL_PROJECTION)
            gl.glPushMatrix()
            gl.glRotatef(40 * turn, 0, 1, 0)
            gl.glMatrixMode(gl.GL_MODELVIEW)
            (gl.glEnable if turn % 2 else gl.glDisable)(gl.GL_LIGHTING)
            immediately(gl, gl.GL_QUADS, [(-0.3, -0.3, -3), (0.3, -0.3, -3), (0.3, 0.3, -3), (-0.3, 0.3, -3)])
            gl.glMatrixMode(gl.GL_PROJECTION)
            gl.glPopMatrix()
            gl.glMatrixMode(gl.GL_MODELVIEW)

    picture = beside.through_dome(scene, (SIZE, SIZE), fov=300.0).picture.max(-1) > 0
    _, count = ndimage.label(picture)
    assert count == 4


def test_a_wall_behind_the_viewer_is_not_drawn_inside_out(beside):
    def scene(gl):
        perspective(gl)
        immediately(gl, gl.GL_QUADS, [(-1, -1, 2), (1, -1, 2), (1, 1, 2), (-1, 1, 2)])

    picture = beside.through_dome(scene, (SIZE, SIZE), fov=360.0).picture.max(-1) > 0
    column, row = np.meshgrid(*[(np.arange(SIZE) + 0.5) / SIZE * 2 - 1] * 2)
    nearest = 1 - np.arctan(np.sqrt(2) / 2) / np.pi  # the wall's corners
    assert picture.any()
    assert not picture[np.hypot(column, row) < nearest - 0.01].any()


def test_a_fourth_coordinate_counts(beside):
    """Vertices that look close together, and are far apart once divided by w."""

    def scene(gl):
        perspective(gl)
        gl.glTranslatef(0, 0.5, -3)
        gl.glBegin(gl.GL_LINES)
        gl.glVertex4f(-0.01, 0, 0, 0.002)
        gl.glVertex4f(0.01, 0, 0, 0.002)
        gl.glEnd()

    picture = beside.through_dome(scene, (SIZE, SIZE), fov=180.0, tolerance=0.1).picture
    rows, columns = np.nonzero(picture.max(-1) > 128)
    drawn = np.stack([columns, rows], -1).astype(float)
    assert len(drawn) > 100
    curve = true_curve((-5, 0.5, -3), (5, 0.5, -3), 180.0)
    assert cKDTree(curve).query(drawn)[0].max() < 0.1 + 0.75


@pytest.mark.parametrize("method", ["tessellate", "geometry"])
def test_however_many_pieces_a_surface_needs_it_is_whole(beside, method):
    """Tens of thousands of vertices come out of one draw."""

    def scene(gl):
        perspective(gl)
        immediately(gl, gl.GL_TRIANGLES, [(-9, -7, -1), (8, -6, -1), (0, 9, -1)])

    coarse, fine = (
        beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method=method, tolerance=tolerance).picture
        for tolerance in (0.5, 0.01)
    )
    assert (coarse.max(-1) > 128).mean() > 0.5
    assert (coarse != fine).any(-1).mean() < 0.005
