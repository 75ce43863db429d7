"""Which faces of a cube a dome shows, how large they are, and that their tiles lie beside each other."""

from itertools import combinations

import numpy as np
import pytest

from domeshim.draw.resampling import angle_table
from domeshim.draw.tiles import Tile, packed
from domeshim.lens.faces import face_size, faces_of
from domeshim.lens.models import Equidistant, lens_of
from domeshim.lens.orientation import STRAIGHT, Orientation


@pytest.mark.parametrize(("fov", "count"), [(1, 1), (89, 1), (91, 5), (180, 5), (249, 5), (252, 6), (360, 6)])
def test_a_dome_shows_so_many_faces(fov, count):
    assert len(faces_of(fov, STRAIGHT)) == count


def test_tilt_does_not_matter_and_a_seat_does():
    for tilted, straight in zip(
        faces_of(180, Orientation(tilt=50, heading=20)), faces_of(180, STRAIGHT), strict=True
    ):
        assert tilted.axes == straight.axes
        assert tilted.part == pytest.approx(straight.part, abs=0.02)  # a seam goes to either side
    assert faces_of(180, Orientation(seat=(0.0, 0.0, -0.7))) != faces_of(180, STRAIGHT)


def test_the_middle_of_a_face_is_as_fine_as_the_dome():
    faces = faces_of(180, STRAIGHT)
    sizes = [face_size(face, Equidistant(180.0), 180.0, 1024) for face in faces]
    assert sizes == [652, 1024, 1024, 1024, 1024]


@pytest.mark.parametrize("fov", [40, 100, 180, 260, 360])
def test_tiles_hold_all_that_is_seen_and_do_not_overlap(fov):
    tiles = [Tile(face, 200) for face in faces_of(fov, STRAIGHT)]
    views, size = packed(tiles)
    parts = [view.scissor for view in views]
    for x, y, width, height in parts:
        assert min(x, y) >= 0
        assert x + width <= size[0]
        assert y + height <= size[1]
    for (x, y, w, h), (left, bottom, width, height) in combinations(parts, 2):
        assert x + w <= left or left + width <= x or y + h <= bottom or bottom + height <= y
    phi, theta = (
        np.radians(fov / 2) * np.sqrt(np.random.default_rng(3).random(2000)),
        np.linspace(0, 400, 2000),
    )
    rays = np.stack([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), -np.cos(phi)], -1)
    ahead = np.stack([rays @ tile.axes[2] for tile in tiles])
    for number, tile in enumerate(tiles):
        shown = rays[ahead.argmax(0) == number] @ tile.axes.T
        places = (shown[:, :2] / shown[:, 2:] / tile.edge + 1) / 2 * tile.side
        x, y, width, height = tile.part
        assert (places >= (x, y)).all()
        assert (places <= (x + width, y + height)).all()


LENSES = [("equidistant", ()), ("equisolid", ()), ("stereographic", ()), ("polynomial", (0.6, 0.02, -0.01))]


@pytest.mark.parametrize("lens", LENSES, ids=lambda lens: lens[0])
def test_the_table_of_angles_is_right_to_a_hundredth_of_a_pixel(lens):
    """Between its steps as well, on a disc of 8192 pixels; its numbers are float32, as on the GPU."""
    model, radius = lens_of(*lens, 180.0), 4096
    table = angle_table(model)
    place = np.linspace(0, len(table) - 1.001, 50_001)
    below = place.astype(int)
    angles = table[below] + (table[below + 1] - table[below]) * (place - below)
    found = model.radius(np.asarray(angles, float))
    assert np.abs(found - model.rim * place / (len(table) - 1)).max() * radius < 0.01
