"""Programs' pictures through every lens, and on a dome that is turned, sat in and lit from off its centre."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from domeshim.lens.models import lens_of
from domeshim.lens.orientation import Orientation
from domeshim.lens.projection import direction_of, disc_of
from domeshim.options import Options
from tests.lens.lenses import BLENDER_WIDE, OPENCV, measured

SIZE = 512
LINES = [((-50, 3, -2), (50, 3, -2)), ((1, -40, -3), (1, 40, -0.5)), ((-30, -2, -20), (-0.5, -1, 10))]
SEAT = {"seat": (0.0, -2.0, 0.5), "projector": (0.5, 0.0, -1.0), "radius": 5.0}
DOMES = [
    {"heading": 40.0, "roll": 25.0},
    {"fov": 230.0, "tilt": 30.0, "heading": -70.0, "roll": 170.0},
    SEAT,
    {"fov": 210.0, "tilt": 60.0, "heading": 10.0} | SEAT,
    {"method": "geometry", "roll": 30.0} | SEAT,
    {"method": "cpu", "tilt": 40.0} | SEAT,
    {"lens": ("equisolid", ()), "fov": 300.0},
    {"lens": ("stereographic", ()), "fov": 240.0, "tilt": 45.0},
    {"lens": ("orthographic", ())},
    {"lens": ("opencv", OPENCV)},
    {"lens": ("blender", (*BLENDER_WIDE, 44.0))},
    {"lens": ("measured", measured()), "tilt": 20.0},
]


def dome_of(fields):
    options = Options(enabled=True, **({"fov": 180.0} | fields))
    return lens_of(*options.lens, options.fov), Orientation.of(options)


def name_of(fields):
    return ", ".join(f"{name} {value[0] if name == 'lens' else value}" for name, value in fields.items())


def seen_by_pixels(lens, orientation):
    """(SIZE, SIZE, 3) what each pixel shows, the top row first; (SIZE, SIZE) whether it lies on the disc."""
    across = (np.arange(SIZE) + 0.5) / SIZE * 2 - 1
    disc = np.stack(np.meshgrid(across, -across), -1)
    within = np.hypot(disc[..., 0], disc[..., 1]) < 0.99 * lens.rim
    disc[~within] = 0
    return direction_of(disc, lens, orientation), within


def pixels_of(a, b, lens, orientation, short=0.0):
    """(n, 2) columns and rows of the line from a to b where the lens shows it; short of its ends."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    r0, r1 = np.linalg.norm(a), np.linalg.norm(b)
    angle = np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)
    s = np.linspace(short, 1 - short, 20_001)[:, None]
    directions = np.sin((1 - s) * angle) * a / r0 + np.sin(s * angle) * b / r1
    rays = orientation.aimed(directions)
    phi = np.arctan2(np.hypot(rays[:, 0], rays[:, 1]), -rays[:, 2])
    disc = disc_of(directions, lens, orientation)[phi < np.radians(lens.fov / 2)]
    return (np.stack([disc[:, 0], -disc[:, 1]], -1) + 1) * SIZE / 2 - 0.5


@pytest.mark.parametrize("fields", DOMES, ids=name_of)
def test_lines_lie_on_their_true_curves(beside, fields):
    lens, orientation = dome_of(fields)
    curve = np.concatenate([pixels_of(*line, lens, orientation) for line in LINES])
    # GL leaves out a line's last pixel.
    inner = np.concatenate([pixels_of(*line, lens, orientation, short=0.005) for line in LINES])

    def scene(gl):
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.gluPerspective(60, 1, 0.001, 10_000)
        gl.glBegin(gl.GL_LINES)
        for line in LINES:
            for vertex in line:
                gl.glVertex3f(*vertex)
        gl.glEnd()

    picture = beside.through_dome(scene, (SIZE, SIZE), **{"fov": 180.0, "tolerance": 0.1} | fields).picture
    rim = lens.rim * SIZE / 2

    def inside(places, margin):
        return places[np.hypot(*(places - (SIZE - 1) / 2).T) < rim - margin]

    rows, columns = np.nonzero(picture.max(-1) > 128)
    drawn = np.stack([columns, rows], -1).astype(float)
    assert len(drawn) > 300
    assert cKDTree(inside(curve, 1)).query(inside(drawn, 3))[0].max() < 0.1 + 0.75
    assert cKDTree(inside(drawn, 0)).query(inside(inner, 5))[0].max() < 1.5


@pytest.mark.parametrize("fields", DOMES, ids=name_of)
def test_a_large_floor_is_where_it_belongs(beside, fields):
    lens, orientation = dome_of(fields)

    def scene(gl):
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.gluPerspective(60, 1, 0.001, 10_000)
        gl.glBegin(gl.GL_QUADS)
        for x, z in ((-50, -50), (50, -50), (50, 50), (-50, 50)):
            gl.glVertex3f(x, -1, z)
        gl.glEnd()

    picture = beside.through_dome(scene, (SIZE, SIZE), **{"fov": 180.0} | fields).picture[..., 0] > 128
    directions, within = seen_by_pixels(lens, orientation)
    x, y, z = np.moveaxis(directions, -1, 0)
    with np.errstate(divide="ignore", invalid="ignore"):
        floor = (y < 0) & (np.abs(x / y) < 50) & (np.abs(z / y) < 50) & within
    assert ((picture != floor) & within).sum() < 0.004 * floor.sum() + 20


@pytest.mark.parametrize("fields", DOMES[:4], ids=name_of)
def test_clearing_half_of_the_window_clears_half_of_what_is_seen(beside, fields):
    lens, orientation = dome_of(fields)

    def scene(gl):
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.gluPerspective(80, 1, 0.1, 100)
        gl.glBegin(gl.GL_POINTS)
        gl.glVertex3f(0, 0, -50)
        gl.glEnd()
        gl.glEnable(gl.GL_SCISSOR_TEST)
        gl.glScissor(0, 0, SIZE // 2, SIZE)
        gl.glClearColor(1, 1, 1, 1)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)

    picture = beside.through_dome(scene, (SIZE, SIZE), **{"fov": 180.0} | fields).picture[..., 0] > 128
    directions, within = seen_by_pixels(lens, orientation)
    left = (directions[..., 0] < 0) & within
    assert ((picture != left) & within).sum() < 0.004 * left.sum() + 20
