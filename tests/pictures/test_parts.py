"""Large meshes: long edges cost only where they are, and what was split for a view is kept for it."""

import numpy as np
import pytest

from domeshim.draw import subdivide
from domeshim.state.context import DomeContext
from tests.pictures.test_subdivision import from_array, from_buffer, immediately, listed, perspective

SIZE = 256
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
