"""The test card: its rings and marks are where the lens puts them."""

import numpy as np
import pytest

from domeshim.lens.card import draw_card
from domeshim.lens.chosen import lens_chosen
from domeshim.lens.models import lens_of
from domeshim.lens.orientation import Orientation
from domeshim.lens.projection import disc_of
from domeshim.options import Options
from domeshim.window.frame import Frame

SIZE = (700, 600)
OPTIONS = [
    Options(),
    Options(fov=160.0, lens=("polynomial", (0.6, 0.02)), tilt=30.0, heading=15.0),
    Options(fov=220.0, lens=("stereographic", ()), roll=40.0),
    Options(tilt=60.0, seat=(0.0, -1.5, -0.3), projector=(0.5, 0.5, 0.0), radius=4.0),
]


def card(options, size=SIZE):
    return np.asarray(draw_card(Frame.of(options, size, size), options)).astype(int)


def pixels(rays, options):
    """(n, 2) rows and columns where rays in the dome's space land, well within the picture."""
    lens = lens_of(*options.lens, options.fov)
    disc = disc_of(rays, lens)
    phi = np.arctan2(np.hypot(rays[:, 0], rays[:, 1]), -rays[:, 2])
    inside = (phi < np.radians(options.fov / 2)) & (np.hypot(*disc.T) < lens.rim - 0.09)
    x0, y0, side, _ = Frame(SIZE, SIZE).square
    x, y = ((disc[inside] + 1) * side / 2 + (x0, y0)).T
    return np.stack([SIZE[1] - y, x], -1).astype(int)


def brightest_near(picture, places):
    """The brightest of each pixel and its neighbours."""
    around = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)]
    return np.max([picture[places[:, 0] + i, places[:, 1] + j].max(-1) for i, j in around], 0)


@pytest.mark.parametrize("options", OPTIONS, ids=str)
def test_each_ring_is_where_its_angle_lands(options):
    picture, orientation = card(options), Orientation.of(options)
    theta = np.linspace(0, 2 * np.pi, 400)
    for ring in range(10, int(options.fov / 2), 10):
        phi = np.full_like(theta, np.radians(ring))
        points = np.stack([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), -np.cos(phi)], -1)
        places = pixels(orientation.thrown(points), options)
        lit = brightest_near(picture, places) > 60
        assert len(places) > 20 or ring > 60
        assert lit.mean() > 0.75 if len(places) else True  # labels stand on their rings


@pytest.mark.parametrize("options", OPTIONS, ids=str)
def test_the_programs_horizon_is_where_it_is_drawn(options):
    turn = np.linspace(-np.pi, np.pi, 800)
    level = np.stack([np.sin(turn), np.zeros_like(turn), -np.cos(turn)], -1)
    places = pixels(Orientation.of(options).aimed(level), options)
    colours = card(options)[places[:, 0], places[:, 1]]
    orange = (colours[:, 0] > 120) & (colours[:, 2] < colours[:, 0] - 60)
    assert len(places) > 100
    assert orange.mean() > 0.7


def test_the_edge_is_the_rim_and_all_outside_it_is_dark():
    picture = card(Options())
    row, column = np.indices(picture.shape[:2]) + 0.5
    radius = np.hypot(row - 300, column - 350)
    edge = (radius > 298.6) & (radius < 299.4)
    assert (picture[edge].max(-1) > 100).mean() > 0.95
    outside = (radius > 301.5) & (column > 2) & (column < 697) & (row > 2) & (row < 400)
    assert picture[outside].max() < 40


def test_each_eye_has_a_card():
    picture = card(Options(stereo="left-right"), (512, 256))
    assert np.abs(picture[:, :256] - picture[:, 256:]).mean() < 3  # the frame's outline is around both
    assert (picture[:, :256].max(-1) > 200).sum() > 500


def test_lines_are_smooth():
    """Between dark and light lie many shades."""
    assert len(np.unique(card(Options())[..., 0])) > 20


def lit_near(picture, places):
    """The share of places, (n, 2) from the bottom left, on or beside something bright."""
    inside = ((places > 2) & (places < np.array(picture.shape[1::-1]) - 2)).all(1)
    rows, columns = picture.shape[0] - 1 - np.floor(places[inside][:, 1]), np.floor(places[inside][:, 0])
    assert len(rows) > 50
    return (brightest_near(picture, np.stack([rows, columns], -1).astype(int)) > 60).mean()


@pytest.mark.parametrize(
    "surface",
    [
        {"surface": ("keystone", (0.1, 0.0, 0.9, 0.1, 1.0, 1.0, 0.0, 0.8))},
        {"disc": (250.0, 320.0, 190.0)},
        {"surface": ("keystone", (0.1, 0.0, 0.9, 0.1, 1.0, 1.0, 0.0, 0.8)), "disc": (250.0, 320.0, 190.0)},
    ],
    ids=str,
)
def test_rings_go_where_corners_and_disc_are_put(surface):
    options = Options(**surface)
    picture, frame = card(options), Frame.of(options, SIZE, SIZE)
    theta = np.linspace(0, 2 * np.pi, 400)
    circle = np.stack([np.cos(theta), np.sin(theta)], -1)
    for ring in (30, 60):
        assert lit_near(picture, frame.place_of(circle * ring / 90)) > 0.9
    assert lit_near(picture, frame.place_of(circle * 0.995)) > 0.9
    assert picture[2:7, 2:7].max() == 0


def test_azimuths_and_elevations_of_a_cylinder():
    options = Options(surface=("cylinder", (150.0, -20.0, 50.0)))
    picture, frame = card(options), Frame.of(options, SIZE, SIZE)
    screen = lens_chosen(options)
    along = np.linspace(-1, 1, 300)
    for azimuth in (-60, -30, 0, 30, 60):
        upright = np.stack([np.full_like(along, azimuth / 75), along], -1)
        assert lit_near(picture, frame.place_of(upright)) > 0.9
    for elevation in (-10, 0, 30, 40):
        height = screen.landed(np.array([0, np.tan(np.radians(elevation)), -1.0]))[1]
        assert lit_near(picture, frame.place_of(np.stack([along, np.full_like(along, height)], -1))) > 0.9
    dark = frame.place_of(np.stack([along, np.full_like(along, 0.3)], -1))
    assert lit_near(picture, dark) < 0.4
