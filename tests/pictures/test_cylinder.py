"""A cylindrical screen's pictures against its formula: vertices, edges, the gap behind, the mouse, clears."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from domeshim.lens.cylinder import Cylinder
from domeshim.lens.orientation import Orientation
from domeshim.lens.projection import disc_of
from tests.pictures.beside import looking_around, points_at
from tests.pictures.test_projector import assert_spots

SIZE = (600, 250)
HALF = np.array(SIZE) / 2
RNG = np.random.default_rng(12)
METHODS = ["auto", "geometry", "cpu"]


def surface(screen):
    return {"surface": ("cylinder", (screen.angle, screen.bottom, screen.top))}


def pixels(points, screen, orientation=None):
    """(n, 2) where points land, from the bottom left."""
    return (disc_of(np.asarray(points, float), screen, orientation or Orientation()) + 1) * HALF


def spread(screen):
    """(n, 3) points that the screen shows, apart from each other."""
    kept = []
    for place in RNG.uniform(-0.95, 0.95, (200, 2)):
        if all(np.abs((place - other) * HALF).max() > 8 for other in kept):
            kept.append(place)
    return screen.ray(np.array(kept[:60])) * RNG.uniform(1, 20, (60, 1))


@pytest.mark.parametrize(
    ("screen", "turned"),
    [
        (Cylinder(120, -30, 30), {}),
        (Cylinder(340, -40, 70), {}),
        (Cylinder(200, -10, 40), {"tilt": 20.0, "heading": -30.0}),
    ],
)
def test_points_are_where_the_formula_has_them(beside, screen, turned):
    orientation = Orientation(**turned)
    points = orientation.seen(spread(screen))

    picture = beside.through_dome(points_at(points), SIZE, **surface(screen), **turned).picture
    assert_spots(picture, pixels(points, screen, orientation))


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("screen", "a", "b"),
    [
        (Cylinder(180, -30, 60), (-40, 3, -4), (40, 1, -3)),
        (Cylinder(300, -50, 50), (-9, 2, 8), (9, -6, -7)),
        (Cylinder(180, -30, 60), (3, -40, -4), (3, 90, -4)),
    ],
)
def test_long_lines_follow_the_formula(beside, method, screen, a, b):
    def scene(gl):
        looking_around(gl)
        gl.glBegin(gl.GL_LINES)
        gl.glVertex3f(*a)
        gl.glVertex3f(*b)
        gl.glEnd()

    picture = beside.through_dome(scene, SIZE, method=method, tolerance=0.1, **surface(screen)).picture
    t = np.linspace(0, 1, 200_001)[:, None]
    true = pixels(np.array(a) + t * (np.array(b) - a), screen)
    rows, columns = np.nonzero(picture.max(-1))
    places = np.stack([columns + 0.5, SIZE[1] - rows - 0.5], -1)
    assert len(places) > 60
    assert cKDTree(true).query(places)[0].max() < 0.9
    inside = true[((true > 1) & (true < np.array(SIZE) - 1)).all(1)]
    assert cKDTree(places).query(inside)[0].max() < 1.2


def room(gl):
    """Six coloured walls around the viewer, a triangle or two each."""
    looking_around(gl)
    gl.glBegin(gl.GL_QUADS)
    for axis in range(3):
        for side in (-1, 1):
            color = [0.2, 0.2, 0.2]
            color[axis] = 1.0 if side > 0 else 0.6
            gl.glColor3f(*color)
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                corner = [u, v]
                corner.insert(axis, side)
                gl.glVertex3f(*corner)
    gl.glEnd()


@pytest.mark.parametrize("method", METHODS)
def test_nothing_reaches_round_the_gap_behind(beside, method):
    """Walls pass straight behind, overhead and below: each pixel has the colour of its own direction."""
    screen = Cylinder(340, -75, 75)
    picture = beside.through_dome(room, SIZE, method=method, **surface(screen)).picture.astype(int)
    rows, columns = np.mgrid[: SIZE[1], : SIZE[0]] + 0.5
    rays = screen.ray(np.stack([columns, SIZE[1] - rows], -1) / HALF - 1)
    largest = np.abs(rays).argmax(-1)
    towards = np.take_along_axis(rays, largest[..., None], -1)[..., 0]
    wanted = np.full((*rays.shape[:2], 3), 51)
    np.put_along_axis(wanted, largest[..., None], np.where(towards > 0, 255, 153)[..., None], -1)
    ordered = np.sort(np.abs(rays), -1)
    clear = ordered[..., 2] - ordered[..., 1] > 0.03 * ordered[..., 2]
    assert clear.mean() > 0.8
    assert (np.abs(picture - wanted).max(-1)[clear] <= 2).all()


def test_the_mouse_finds_its_place_in_the_program(beside):
    screen = Cylinder(160, -35, 35)
    with beside.window(SIZE, **surface(screen)) as finish:
        looking_around(beside.dome)
        beside.dome.glRectf(0, 0, 1, 1)
        finish()
        dome, window = beside.session.dome, beside.session.window
        x, y = dome.program_place(window, 410.0, 80.0)
        assert dome.frame_place(window, x, y) == pytest.approx((410.0, 80.0), abs=1e-6)
    ray = screen.ray(np.array([410.0, SIZE[1] - 80.0]) / HALF - 1)
    ahead = np.tan(np.radians(30))  # looking_around's own 60 degrees
    assert (x / HALF[0] - 1, 1 - y / HALF[1]) == pytest.approx(ray[:2] / -ray[2] / ahead, abs=1e-6)


def test_a_clear_within_a_scissor_takes_its_part(beside):
    screen = Cylinder(160, -35, 35)

    def scene(gl):
        looking_around(gl)
        gl.glBegin(gl.GL_POINTS)
        gl.glVertex3f(0, 0, -5)
        gl.glEnd()
        gl.glEnable(gl.GL_SCISSOR_TEST)
        gl.glScissor(SIZE[0] // 2, 0, SIZE[0] // 2, SIZE[1])
        gl.glClearColor(1, 0, 0, 1)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glDisable(gl.GL_SCISSOR_TEST)

    picture = beside.through_dome(scene, SIZE, **surface(screen)).picture
    red = (picture == (255, 0, 0)).all(-1)
    assert red[:, 305:].mean() > 0.99
    assert not red[:, :295].any()


def test_text_stands_on_its_object(beside):
    """gluProject's place, a raster position: where the object itself is."""
    screen = Cylinder(160, -35, 35)
    point = (2.0, 1.0, -4.0)

    def scene(gl):
        looking_around(gl)
        gl.glRasterPos3f(*point)
        gl.glPixelZoom(1, 1)
        gl.glBitmap(3, 3, 1, 1, 0, 0, bytes([0xE0] * 12))

    picture = beside.through_dome(scene, SIZE, **surface(screen)).picture
    rows, columns = np.nonzero(picture.max(-1) > 128)
    place = pixels([point], screen)[0]
    assert (columns.mean() + 0.5, SIZE[1] - rows.mean() - 0.5) == pytest.approx(place, abs=1.01)


def test_the_programs_own_glsl_lands_there_too(beside):
    screen = Cylinder(200, -40, 40)
    points = spread(screen)

    def scene(gl):
        looking_around(gl)
        shader = gl.glCreateShader(gl.GL_VERTEX_SHADER)
        gl.glShaderSource(shader, "void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }")
        gl.glCompileShader(shader)
        colour = gl.glCreateShader(gl.GL_FRAGMENT_SHADER)
        gl.glShaderSource(colour, "void main() { gl_FragColor = vec4(1.0); }")
        gl.glCompileShader(colour)
        program = gl.glCreateProgram()
        for one in (shader, colour):
            gl.glAttachShader(program, one)
        gl.glLinkProgram(program)
        gl.glUseProgram(program)
        gl.glPointSize(3)
        gl.glBegin(gl.GL_POINTS)
        for point in points:
            gl.glVertex3f(*point)
        gl.glEnd()
        gl.glUseProgram(0)

    assert_spots(beside.through_dome(scene, SIZE, **surface(screen)).picture, pixels(points, screen))


def test_each_eye_has_the_whole_screen(beside):
    screen = Cylinder(160, -35, 35)
    points = spread(screen)[:20]

    options = {"stereo": "top-bottom", "eyes": 1e-6, **surface(screen)}
    picture = beside.through_dome(points_at(points), (SIZE[0], 2 * SIZE[1]), **options).picture
    for part in (picture[: SIZE[1]], picture[SIZE[1] :]):
        assert_spots(part, pixels(points, screen))
