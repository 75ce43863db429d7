"""Large meshes: long edges cost only where they are, and what was split for a view is kept for it."""

import ctypes
import gc

import numpy as np
import pytest

from domeshim.draw import subdivide
from domeshim.draw.upload import Upload
from domeshim.record.runs import Run
from domeshim.state import subdividing
from domeshim.state.context import DomeContext
from tests.pictures.test_subdivision import from_array, from_buffer, immediately, listed, perspective

SIZE = 256
PATCHES = 14
CORNERS = ((-0.3, -0.3), (-0.3, 0.3), (0.3, 0.3), (0.3, -0.3))
CELLS = 40


def terrain():
    """(n, 3) corners of the triangles of a floor of 40 x 40 cells a unit wide, row after row."""
    steps = np.arange(CELLS + 1) - CELLS / 2
    z, x = np.meshgrid(steps, steps, indexing="ij")
    grid = np.stack([x, np.full_like(x, -0.4), z], -1)
    a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]
    return np.stack([a, d, b, b, d, c], 2).reshape(-1, 3).astype(np.float32)


@pytest.mark.parametrize("way", [immediately, listed, from_array, from_buffer])
def test_only_the_parts_that_need_it_are_subdivided(beside, monkeypatch, way):
    patches = []
    dress = DomeContext.dress

    def spy(context, patch=None, *, raster=False):
        patches.append(patch)
        dress(context, patch, raster=raster)

    def scene(gl):
        perspective(gl)
        way(gl, gl.GL_TRIANGLES, terrain())

    monkeypatch.setattr(DomeContext, "dress", spy)
    picture = beside.through_dome(scene, (SIZE, SIZE), fov=180.0).picture
    assert {patch is None for patch in patches} == {True, False}
    patches.clear()
    everywhere = beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method="tessellate").picture
    assert None not in patches
    assert (picture != everywhere).any(-1).sum() < 0.001 * SIZE**2
    assert (picture[SIZE // 2 + 20 : SIZE - 20, SIZE // 2] == 255).all()


def tower():
    """(n, 3) corners of the triangles of a wall around the viewer, 24 x 8 quads: an edge needs two pieces."""
    turn, height = np.meshgrid(np.linspace(0, 2 * np.pi, 25), np.linspace(-1, 1, 9))
    grid = np.stack([2 * np.cos(turn), height, 2 * np.sin(turn)], -1)
    a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]
    return np.stack([a, d, b, b, d, c], 2).reshape(-1, 3).astype(np.float32)


@pytest.mark.parametrize("way", [immediately, from_buffer])
def test_few_pieces_are_made_by_what_makes_them_for_less(beside, monkeypatch, way):
    methods = set()
    dress = DomeContext.dress

    def spy(context, patch=None, *, raster=False):
        methods.add(patch and patch.method)
        dress(context, patch, raster=raster)

    def scene(gl):
        perspective(gl)
        way(gl, gl.GL_TRIANGLES, tower())

    def picture(*, by_processor):
        methods.clear()
        monkeypatch.setattr(subdividing, "processor_draws", lambda _: by_processor)
        return beside.through_dome(scene, (SIZE, SIZE), fov=180.0).picture

    monkeypatch.setattr(DomeContext, "dress", spy)
    by_tessellator = picture(by_processor=False)
    assert "tessellate" in methods
    assert "geometry" not in methods
    by_geometry = picture(by_processor=True)
    assert "geometry" in methods
    assert "tessellate" not in methods
    assert (by_geometry != by_tessellator).any(-1).sum() < 0.001 * SIZE**2
    assert by_geometry.any(-1).mean() > 0.1


def test_a_listed_mesh_is_split_once_for_a_view_that_stands_still(beside, monkeypatch):
    splits = []
    split_wide = subdivide.split_wide

    def spy(*args):
        splits.append(args)
        return split_wide(*args)

    monkeypatch.setattr(subdivide, "split_wide", spy)
    floor = [(-50, -1, -50), (-50, -1, 50), (50, -1, 50), (50, -1, -50)]
    pictures = []

    def scene(gl):
        perspective(gl)
        listed(gl, gl.GL_QUADS, floor)
        for _ in range(5):
            gl.glClear(gl.GL_COLOR_BUFFER_BIT)
            gl.glCallList(1)
            pictures.append(gl.glReadPixels(0, 0, SIZE, SIZE, gl.GL_RGB, gl.GL_UNSIGNED_BYTE))
        assert len(splits) == 2  # as it was seen first, and to be kept
        gl.glTranslatef(0, 0.5, 0)
        gl.glCallList(1)
        assert len(splits) == 3
        gl.glShadeModel(gl.GL_FLAT)
        gl.glCallList(1)
        assert len(splits) == 4
        gl.glDeleteLists(1, 1)

    beside.through_dome(scene, (SIZE, SIZE), fov=180.0)
    assert any(pictures[0])
    assert all(picture == pictures[0] for picture in pictures)


def soup(long):
    """(n, 3) ends of 600 short lines around the viewer, and a few as long as that."""
    chance = np.random.default_rng(5)
    ways = chance.normal(size=(600, 3))
    tails = 8 * ways / np.linalg.norm(ways, axis=1, keepdims=True)
    ends = np.stack([tails, tails + 0.2 * chance.normal(size=(600, 3))], 1)
    ends[long, 1] = [[5.0, 5, -5], [-5, 4, -6], [4, -5, -3]]
    return ends.reshape(-1, 3).astype(np.float32)


@pytest.mark.parametrize("blended", [False, True])
@pytest.mark.parametrize("way", [immediately, listed, from_array, from_buffer])
def test_of_many_lines_only_the_long_ones_are_subdivided(beside, monkeypatch, way, blended):
    points = soup([40, 45, 400])
    patches = []
    draw_all = Upload.draw_all

    def spy(upload, mode, count):
        patches.append(count // 2 if mode == PATCHES else 0)
        draw_all(upload, mode, count)

    def scene(gl):
        perspective(gl)
        if blended:
            gl.glEnable(gl.GL_BLEND)
            gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
            gl.glColor4f(0.4, 1, 0.2, 0.5)
        way(gl, gl.GL_LINES, points)

    monkeypatch.setattr(Upload, "draw_all", spy)
    picture = beside.through_dome(scene, (SIZE, SIZE), fov=180.0).picture
    assert 0 < sum(patches) < 30
    everywhere = beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method="tessellate").picture
    assert sum(patches) > 600
    assert (picture != everywhere).any(-1).sum() < 0.001 * SIZE**2


def coloured(gl, points, colours):
    gl.glBegin(gl.GL_QUADS)
    for point, colour in zip(points.tolist(), colours.tolist(), strict=True):
        gl.glColor4f(*colour)
        gl.glVertex3f(*point)
    gl.glEnd()


def coloured_in_list(gl, points, colours):
    gl.glNewList(1, gl.GL_COMPILE)
    coloured(gl, points, colours)
    gl.glEndList()
    gl.glCallList(1)


def coloured_from_array(gl, points, colours):
    gl.glEnableClientState(gl.GL_COLOR_ARRAY)
    gl.glColorPointer(4, gl.GL_FLOAT, 0, colours)
    from_array(gl, gl.GL_QUADS, points)
    gl.glDisableClientState(gl.GL_COLOR_ARRAY)


@pytest.mark.parametrize("way", [coloured, coloured_in_list, coloured_from_array])
def test_what_is_blended_keeps_its_order(beside, way):
    """Small green quads, a red floor that must bend, and small blue quads, in one draw."""
    steps = np.linspace(-6, 6, 11)
    small = np.array([(x + a, -0.9, z + b) for x in steps for z in steps - 7 for a, b in CORNERS], np.float32)
    floor = np.array([(60 * a, -0.9, 60 * b) for a, b in CORNERS], np.float32)
    points = np.concatenate([small, floor, small + np.float32(0.1)])
    colours = np.repeat(np.float32([[0, 1, 0, 0.5], [1, 0, 0, 0.5], [0, 0, 1, 0.5]]), [484, 4, 484], axis=0)

    def scene(gl):
        perspective(gl)
        gl.glDisable(gl.GL_DEPTH_TEST)
        gl.glEnable(gl.GL_BLEND)
        gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
        way(gl, points, colours)

    picture, everywhere = (
        beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method=method).picture
        for method in ("auto", "tessellate")
    )
    seen = {tuple(colour) for colour in picture.reshape(-1, 3).tolist()}
    assert {(128, 64, 0), (64, 0, 128)} <= {tuple(round(v / 64) * 64 for v in colour) for colour in seen}
    off = (np.abs(picture.astype(int) - everywhere).max(-1) > 2).sum()
    assert off < 0.01 * SIZE**2  # single pixels on the edges of 968 quads


def test_of_a_far_mesh_in_buffers_only_its_size_is_kept(beside):
    near = np.array([(0, 0, -5), (0.1, 0, -5), (0, 0.1, -5)], np.float32)
    kept = []

    def scene(gl):
        perspective(gl)
        data = np.tile(near, (1000, 1))
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, gl.glGenBuffers(1))
        gl.glBufferData(gl.GL_ARRAY_BUFFER, data.nbytes, data, gl.GL_STATIC_DRAW)
        gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
        gl.glVertexPointer(3, gl.GL_FLOAT, 0, None)
        for z in (0, 4.9):
            gl.glLoadIdentity()
            gl.glTranslatef(0, 0, z)
            gl.glDrawArrays(gl.GL_TRIANGLES, 0, len(data))
            gc.collect()
            kept.append(sum(len(each.positions) for each in gc.get_objects() if isinstance(each, Run)))
        gl.glDisableClientState(gl.GL_VERTEX_ARRAY)
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, 0)

    beside.through_dome(scene, (SIZE, SIZE), fov=180.0)
    assert kept[1] - kept[0] == 3000


def test_indices_in_the_programs_own_array_object(beside):
    """16-bit indices from the middle of a buffer, of vertices shared and coloured; all bindings stay."""
    steps = np.linspace(-20, 20, 31)
    z, x = np.meshgrid(steps, steps, indexing="ij")
    places = np.stack([x, np.full_like(x, -0.4), z], -1).reshape(-1, 3).astype(np.float32)
    colours = np.random.default_rng(3).integers(100, 256, (len(places), 4), np.uint8)
    first = (np.arange(30)[:, None] * 31 + np.arange(30)).reshape(-1, 1)
    corners = (first + np.array([0, 31, 32, 1])).astype(np.uint16)

    def scene(gl):
        perspective(gl)
        gl.glBindVertexArray(gl.glGenVertexArrays(1))
        buffers = gl.glGenBuffers(3)
        for buffer, data in zip(buffers, (places, colours, corners), strict=True):
            gl.glBindBuffer(gl.GL_ARRAY_BUFFER, buffer)
            gl.glBufferData(gl.GL_ARRAY_BUFFER, data.nbytes, data, gl.GL_STATIC_DRAW)
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, buffers[0])
        gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
        gl.glVertexPointer(3, gl.GL_FLOAT, 0, None)
        gl.glBindBuffer(gl.GL_ARRAY_BUFFER, buffers[1])
        gl.glEnableClientState(gl.GL_COLOR_ARRAY)
        gl.glColorPointer(4, gl.GL_UNSIGNED_BYTE, 0, None)
        gl.glBindBuffer(gl.GL_ELEMENT_ARRAY_BUFFER, buffers[2])
        for _ in range(3):  # seen anew, to be kept, and as kept
            gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
            gl.glDrawElements(gl.GL_QUADS, corners.size - 40, gl.GL_UNSIGNED_SHORT, ctypes.c_void_p(80))
            assert gl.glGetIntegerv(gl.GL_ELEMENT_ARRAY_BUFFER_BINDING) == buffers[2]
            assert gl.glGetIntegerv(gl.GL_ARRAY_BUFFER_BINDING) == buffers[1]
        gl.glBindVertexArray(0)

    picture, everywhere = (
        beside.through_dome(scene, (SIZE, SIZE), fov=180.0, method=method).picture
        for method in ("auto", "tessellate")
    )
    assert picture.any(-1).mean() > 0.2
    off = (np.abs(picture.astype(int) - everywhere).max(-1) > 8).sum()
    assert off < 0.005 * SIZE**2


@pytest.mark.parametrize(("width", "looks"), [(0.014, False), (0.2, True)])
def test_quads_are_looked_for_where_there_are_pieces_to_save(beside, monkeypatch, width, looks):
    """Two triangles for each of 100 panels around the viewer."""
    found = []
    as_quads = subdivide.as_quads

    def spy(*args, **named):
        found.append(args)
        return as_quads(*args, **named)

    monkeypatch.setattr(subdivide, "as_quads", spy)
    turns = np.linspace(-0.8, 0.8, 100)
    panel = [(-1, -1), (1, -1), (1, 1), (-1, -1), (1, 1), (-1, 1)]
    points = [(np.sin(t) + 5 * width * x, 5 * width * y, -np.cos(t)) for t in turns for x, y in panel]

    def scene(gl):
        perspective(gl)
        immediately(gl, gl.GL_TRIANGLES, points)

    assert beside.through_dome(scene, (SIZE, SIZE), fov=180.0, tolerance=0.1).picture.any()
    assert bool(found) == looks
