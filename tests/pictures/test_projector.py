"""What the projector gets: keystone and meshes against numpy, the disc's place, mirrors, light, the HUD."""

from itertools import pairwise

import numpy as np
import pytest
from scipy import ndimage

from domeshim.lens.keystone import Keystone
from domeshim.lens.models import Equidistant
from domeshim.lens.projection import disc_of
from domeshim.measure.pixels import read_pixels
from domeshim.window.contract import SurfaceFormat
from tests.lens.test_surfaces import bourke
from tests.pictures.beside import looking_around, points_at

SIZE = 384
CORNERS = (0.2, 0.0, 0.9, 0.1, 1.0, 1.0, 0.0, 0.8)
RNG = np.random.default_rng(5)
POINTS = RNG.normal(size=(40, 3)) * (1, 1, 0.6) - (0, 0, 0.8)
POINTS = (POINTS / np.linalg.norm(POINTS, axis=1, keepdims=True))[POINTS[:, 2] < -0.15]


def assert_spots(picture, places):
    """A point is drawn with its middle within half a pixel of each place, and nothing elsewhere."""
    lit = picture.max(-1) > 128
    labels, count = ndimage.label(lit)
    middles = np.array(ndimage.center_of_mass(lit, labels, range(1, count + 1)))
    found = np.stack([middles[:, 1] + 0.5, picture.shape[0] - middles[:, 0] - 0.5], -1)
    apart = np.abs(found[:, None] - places).max(-1)  # the rasteriser puts a point on the nearest pixel
    assert count == len(places)
    assert apart.min(0).max() < 0.51
    assert apart.min(1).max() < 0.51


def points(gl):
    points_at(5 * SEPARATE)(gl)


def _separate():
    disc = disc_of(POINTS, Equidistant(180))
    kept = []
    for i, place in enumerate(disc):
        if all(np.linalg.norm(place - disc[j]) > 0.1 for j in kept) and np.hypot(*place) < 0.9:
            kept.append(i)
    return POINTS[kept]


SEPARATE = _separate()


def test_keystone_is_the_homography(beside):
    picture = beside.through_dome(points, (SIZE, SIZE), fov=180.0, surface=("keystone", CORNERS)).picture
    goal = Keystone(CORNERS).to_frame(disc_of(SEPARATE, Equidistant(180)))
    assert len(goal) > 8
    assert_spots(picture, (goal + 1) * SIZE / 2)


@pytest.mark.parametrize("method", ["auto", "geometry", "cpu"])
def test_line_bends_through_the_keystone(beside, method):
    def scene(gl):
        looking_around(gl)
        gl.glBegin(gl.GL_LINES)
        gl.glVertex3f(-30, 2, -3)
        gl.glVertex3f(30, 2, -3)
        gl.glEnd()

    options = {"fov": 180.0, "method": method, "tolerance": 0.1, "surface": ("keystone", CORNERS)}
    picture = beside.through_dome(scene, (SIZE, SIZE), **options).picture
    a, b = np.array([-30, 2, -3.0]), np.array([30, 2, -3.0])
    t = np.linspace(0, 1, 100_001)[:, None]
    true = (Keystone(CORNERS).to_frame(disc_of(a + t * (b - a), Equidistant(180))) + 1) * SIZE / 2
    rows, columns = np.nonzero(picture.max(-1))
    places = np.stack([columns + 0.5, SIZE - rows - 0.5], -1)
    assert len(places) > 200
    assert max(np.linalg.norm(true - place, axis=1).min() for place in places) < 0.9


def test_keystone_cuts_at_the_bent_rim(beside):
    def scene(gl):
        gl.glClearColor(1, 1, 1, 1)
        looking_around(gl)

    picture = beside.through_dome(scene, (SIZE, SIZE), fov=180.0, surface=("keystone", CORNERS)).picture
    rows, columns = np.mgrid[:SIZE, :SIZE] + 0.5
    places = np.stack([columns, SIZE - rows], -1) / SIZE * 2 - 1
    radius = np.hypot(*np.moveaxis(Keystone(CORNERS).to_disc(places), -1, 0))
    lit = picture.max(-1) > 0
    assert not (lit & (radius > 1.01)).any()
    assert lit[radius < 0.99].all()


def checks(gl):
    """A disc with something to see all over, smooth enough to be resampled."""
    looking_around(gl)
    gl.glBegin(gl.GL_TRIANGLES)
    around = np.linspace(0, 2 * np.pi, 37)
    for a, b in pairwise(around):
        for place, color in (
            ((0, 0, -1), (1, 1, 1)),
            ((a,), (0.5 + 0.5 * np.sin(a), 0, 0.4)),
            ((b,), (0.5 + 0.5 * np.sin(b), 0, 0.4)),
        ):
            gl.glColor3f(*color)
            gl.glVertex3f(*(place if len(place) == 3 else (20 * np.cos(place[0]), 20 * np.sin(place[0]), -1)))
    gl.glEnd()


@pytest.mark.parametrize("kind", ["data", "obj"])
def test_mesh_against_numpy(beside, tmp_path, kind):
    plain = beside.through_dome(checks, (SIZE, SIZE), fov=180.0).picture
    path = tmp_path / f"mesh.{kind}"
    if kind == "data":
        path.write_text(bourke(30, 30, place=lambda u, v: ((2 * u - 1) * (0.6 + 0.4 * v), 2 * v - 1)))
    else:
        path.write_text(
            "v -0.6 -1 0\nv 0.6 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
            "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"
        )
    warped = beside.through_dome(checks, (SIZE, SIZE), fov=180.0, surface=("mesh", str(path))).picture
    rows, columns = np.mgrid[:SIZE, :SIZE] + 0.5
    x, y = columns / SIZE * 2 - 1, 1 - rows / SIZE * 2
    if kind == "data":
        v = (y + 1) / 2
        u = (x / (0.6 + 0.4 * v) + 1) / 2
    else:  # two triangles: affine in each
        lower = np.linalg.solve([[-0.6, -1, 1], [0.6, -1, 1], [1, 1, 1]], [[0, 0], [1, 0], [1, 1]])
        upper = np.linalg.solve([[-0.6, -1, 1], [1, 1, 1], [-1, 1, 1]], [[0, 0], [1, 1], [0, 1]])
        both = np.stack([x, y, np.ones_like(x)], -1)
        below = (y + 1) * 1.6 < (x + 0.6) * 2
        u, v = np.moveaxis(np.where(below[..., None], both @ lower, both @ upper), -1, 0)
    seen = (u > 0.02) & (u < 0.98)
    wanted = np.stack(
        [
            ndimage.map_coordinates(
                plain[..., c].astype(float), [(1 - v) * SIZE - 0.5, u * SIZE - 0.5], order=1
            )
            for c in range(3)
        ],
        -1,
    )
    gradient = max(
        ndimage.gaussian_gradient_magnitude(plain[..., c].astype(float), 1).max() for c in range(3)
    )
    off = np.abs(warped.astype(float) - wanted).max(-1)[seen]
    assert np.quantile(off, 0.999) < max(3.0, 0.5 * gradient)  # half a pixel, where it is steepest
    assert off.mean() < 1.0
    assert (warped[~(u > -0.02) | ~(u < 1.02)] == 0).all()


def test_mouse_goes_back_through_the_mesh(beside, tmp_path):
    path = tmp_path / "mesh.data"
    path.write_text(bourke(9, 9, place=lambda u, v: (1 - 2 * u, 2 * v - 1)))
    with beside.window((SIZE, SIZE), fov=180.0, surface=("mesh", str(path))) as finish:
        looking_around(beside.dome)
        finish()
        dome, window = beside.session.dome, beside.session.window
        mirrored = dome.program_place(window, SIZE - 100.0, 150.0)
    with beside.window((SIZE, SIZE), fov=180.0) as finish:
        looking_around(beside.dome)
        finish()
        plain = beside.session.dome.program_place(beside.session.window, 100.0, 150.0)
    assert mirrored == pytest.approx(plain, abs=1e-6)


def test_disc_lies_where_it_is_put(beside):
    picture = beside.through_dome(points, (SIZE, SIZE + 60), fov=180.0, disc=(150.0, 220.0, 120.0)).picture
    assert_spots(picture, disc_of(SEPARATE, Equidistant(180)) * 120 + (150, SIZE + 60 - 220))


def test_mirror_brightness_gamma_and_fade(beside):
    plain = beside.through_dome(checks, (SIZE, SIZE), fov=180.0).picture.astype(float)
    mirrored = beside.through_dome(checks, (SIZE, SIZE), fov=180.0, mirror="both").picture
    assert np.abs(mirrored - plain[::-1, ::-1]).max() <= 1
    toned = beside.through_dome(checks, (SIZE, SIZE), fov=180.0, brightness=0.5, gamma=2.0).picture
    assert np.abs(toned - 255 * np.sqrt(plain / 255 / 2)).max() <= 1.5
    faded = beside.through_dome(checks, (SIZE, SIZE), fov=180.0, fade=30.0).picture.astype(float)
    rows, columns = np.mgrid[:SIZE, :SIZE] + 0.5 - SIZE / 2
    radius = np.hypot(rows, columns) / (SIZE / 2)
    assert np.abs(faded - plain)[radius < 0.66].max() <= 1
    middle = (radius > 0.82) & (radius < 0.84)
    assert 0.4 < faded[middle].sum() / plain[middle].sum() < 0.6


def test_closing_the_window_frees_what_finishes_its_pictures(beside):
    with beside.window((SIZE, SIZE), fov=180.0, mirror="both") as finish:
        points(beside.dome)
        finish()
        held = beside._dome._current._finish[1]
        gl = beside.stock
        assert gl.glGetIntegerv(gl.GL_CURRENT_PROGRAM) == 0
        made = {
            gl.glIsProgram: held._program.glo,
            gl.glIsTexture: held._copy.value,
            gl.glIsFramebuffer: held._framebuffer.value,
        }
        assert all(is_one(name) for is_one, name in made.items())
        window = beside.session.window
        beside.session.window_closed(window)
        assert not any(is_one(name) for is_one, name in made.items())
        beside.session.window_opened(window, (SIZE, SIZE))


def test_hud_lies_beside_the_disc_and_the_rest_is_black(beside):
    def scene(gl):
        gl.glClearColor(0, 0, 1, 1)
        looking_around(gl)
        gl.glBegin(gl.GL_POINTS)
        gl.glVertex3f(0, 0, -5)
        gl.glEnd()
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glLoadIdentity()
        gl.glColor3f(1, 0, 0)
        gl.glRectf(-1, -1, 1, 1)

    width = 2 * SIZE
    picture = beside.through_dome(scene, (width, SIZE), fov=180.0, hud="side").picture
    strip = (width - SIZE) // 2
    assert (picture[SIZE // 2, : strip - 6] == (255, 0, 0)).all()
    assert (picture[:10, :strip] == 0).all()
    assert (picture[:, -strip:] == 0).all()
    assert (picture[SIZE // 2, strip + 10 : width // 2 - 10] == (0, 0, 255)).all()


def test_hud_beside_needs_room(beside):
    from domeshim.errors import OptionError

    with pytest.raises(OptionError, match="no room beside the disc"), beside.window((SIZE, SIZE), hud="side"):
        pass


@pytest.mark.parametrize("samples", [0, 4])
@pytest.mark.parametrize("method", ["auto", "cubemap"])
def test_what_is_never_cleared_goes_on_below_the_mirror(beside, monkeypatch, method, samples):
    monkeypatch.setattr(beside, "surface", SurfaceFormat(samples=samples))

    def after_pictures(count, **options):
        """What is seen when the program has drawn so many triangles, one a picture, and cleared at first."""
        with beside.window((SIZE, SIZE), fov=180.0, method=method, **options) as finish:
            gl = beside.dome
            looking_around(gl)
            for number in range(count):
                gl.glColor3f(1, number / 4, 0)
                gl.glBegin(gl.GL_TRIANGLES)
                for x, y in ((-1, -1), (-0.4, -1), (-1, -0.2)):
                    gl.glVertex3f(x + number / 2, y, -1)
                gl.glEnd()
                finish()
            seen = np.frombuffer(read_pixels(SIZE, SIZE), np.uint8).reshape(SIZE, SIZE, 3)
            own = gl.glReadPixels(0, 0, SIZE, SIZE, gl.GL_RGB, gl.GL_UNSIGNED_BYTE)
            gl.glClear(gl.GL_COLOR_BUFFER_BIT)
            finish()
            assert not any(read_pixels(SIZE, SIZE))
        return seen.astype(int), own

    plain, plain_own = after_pictures(3)
    mirrored, own = after_pictures(3, mirror="horizontal")
    labels = np.unique(plain.reshape(-1, 3), axis=0)
    assert len(labels) >= 4
    off = np.abs(mirrored - plain[:, ::-1]).max(-1) > 1
    if samples:  # an edge over an older edge finds that pixel's mean, not its samples
        assert off.mean() < 1e-3
    else:
        assert not off.any()
        assert own == plain_own
