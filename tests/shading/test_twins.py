"""The shaders' lens, aim and bend against their numpy twins, at random and extreme directions."""

import numpy as np
import pytest

from domeshim.lens.cylinder import Cylinder
from domeshim.lens.models import Equidistant
from domeshim.lens.orientation import STRAIGHT, Orientation
from domeshim.lens.projection import disc_of
from domeshim.shading.compose import compose
from domeshim.shading.recipe import Mapping, Recipe
from tests.lens.lenses import every_lens
from tests.shading.feedback import caught

RNG = np.random.default_rng(2006)
ORIENTATIONS = [
    STRAIGHT,
    Orientation(tilt=30),
    Orientation(tilt=-75, heading=40, roll=-100),
    Orientation(seat=(0.3, -0.4, 0.2)),
    Orientation(tilt=60, roll=15, seat=(0.0, 0.6, 0.1), projector=(-0.2, 0.1, 0.5)),
]


def positions_on_gpu(driver, recipe, vertices, uniforms):
    """gl_Position of each vertex. vertices: (n, 4) float32 -> (n, 4)."""
    return caught(driver, compose(recipe).text, vertices, uniforms)


def directions(count, reach=np.pi):
    """(n, 3): random ones within reach of the axis, and those on and near axis, rim and planes."""
    phi, theta = RNG.uniform(0, reach, count), RNG.uniform(-np.pi, np.pi, count)
    random = np.stack([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), -np.cos(phi)], -1)
    tiny = 10.0 ** -np.arange(1, 12)
    near_axis = np.stack([tiny, -tiny, -np.ones_like(tiny)], -1)
    near_rim = np.stack([np.ones_like(tiny), tiny, -tiny], -1)
    planes = np.array([[0, 0, -1], [1, 0, 0], [0, 1, 0], [-1, 0, -1], [0, -1, -1], [1, 1, 0.0]])
    return np.concatenate([random, near_axis, near_rim, planes])


def check(driver, lens, orientation, d):
    """The shader and numpy agree about directions, (n, 3), to 1e-5 of the disc's radius."""
    d = d.astype(np.float32)
    uniforms = {"domeLens": lens.uniform, "domeDepth": (1.0, 0.0), **dict(orientation.uniforms)}
    recipe = Recipe(Mapping(lens=lens.snippets, aim=orientation.aim))
    got = positions_on_gpu(driver, recipe, np.column_stack([d, np.ones(len(d), np.float32)]), uniforms)
    want = disc_of(d.astype(float), lens, orientation)
    rays = orientation.aimed(d.astype(float))
    phi = np.arctan2(np.hypot(rays[:, 0], rays[:, 1]), -rays[:, 2])
    seen = phi <= min(np.radians(lens.fov) / 2, np.pi * 0.999)  # straight behind there is no direction
    assert seen.sum() > len(d) / 3
    error = np.hypot(*(got[seen, :2] / got[seen, 3:] - want[seen]).T)
    assert (error / np.maximum(1, np.hypot(*want[seen].T))).max() < 1e-5
    distance = np.linalg.norm(d.astype(float), axis=1)
    assert np.abs(got[:, 3] / distance - 1).max() < 1e-5


@pytest.mark.parametrize("lens", every_lens(), ids=str)
def test_every_lens_agrees_with_numpy(driver, lens):
    check(driver, lens, STRAIGHT, directions(100_000, np.radians(lens.fov) / 2))


@pytest.mark.parametrize("screen", [Cylinder(120, -30, 30), Cylinder(340, -75, 75)], ids=str)
def test_a_cylinder_agrees_with_numpy(driver, screen):
    d = directions(100_000).astype(np.float32)
    rays = d.astype(float)
    steep = np.hypot(rays[:, 0], rays[:, 2]) < np.linalg.norm(rays, axis=1) * np.cos(np.radians(80))
    d = d[~steep & (np.abs(np.arctan2(rays[:, 0], -rays[:, 2])) < np.radians(175))]
    uniforms = {"domeLens": screen.uniform, "domeDepth": (1.0, 0.0)}
    recipe = Recipe(Mapping(lens=screen.snippets, clip="wedge"))
    got = positions_on_gpu(driver, recipe, np.column_stack([d, np.ones(len(d), np.float32)]), uniforms)
    want = screen.landed(d.astype(float))
    assert len(d) > 80_000
    assert (np.hypot(*(got[:, :2] / got[:, 3:] - want).T) / np.maximum(1, np.hypot(*want.T))).max() < 1e-5


@pytest.mark.parametrize("orientation", ORIENTATIONS, ids=str)
@pytest.mark.parametrize("scale", [1.0, 1e-18, 1e18])
def test_every_orientation_agrees_with_numpy(driver, orientation, scale):
    check(driver, Equidistant(220), orientation, directions(10_000) * scale)


def test_negative_w_flips_the_direction_and_zero_w_is_one(driver):
    d = np.array([[0.3, -0.2, -1.0]])
    uniforms = {"domeLens": Equidistant(180).uniform, "domeDepth": (1.0, 0.0)}
    for w, sign in ((-2.0, -1), (0.0, 1), (2.0, 1)):
        vertex = np.column_stack([d * sign, [w]]).astype(np.float32)
        got = positions_on_gpu(driver, Recipe(), vertex, uniforms)[0]
        assert got[:2] / got[3] == pytest.approx(disc_of(d, Equidistant(180))[0], abs=1e-6)


def test_paper_is_as_published(driver):
    """Disc at the vertex's own z, seen through glOrtho(-1, 1, -1, 1, 0, 1000); w stays 1."""
    vertices = np.array([[1, 2, -3, 1], [0, 0, -5, 1], [4, 0, 2, 1]], np.float32)
    got = positions_on_gpu(
        driver, Recipe(Mapping(method="paper")), vertices, {"domeLens": Equidistant(180).uniform}
    )
    assert got[:, 3] == pytest.approx([1, 1, 1])
    assert got[:, :2] == pytest.approx(disc_of(vertices[:, :3].astype(float), Equidistant(180)), abs=1e-5)
    assert got[:, 2] == pytest.approx(-vertices[:, 2] / 500 - 1, abs=1e-6)
