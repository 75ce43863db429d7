"""Two eyes: points at known distances are as far apart as they must be, wherever the viewer looks."""

import numpy as np
import pytest
from scipy import ndimage

from domeshim.driver import Driver
from domeshim.options import Options
from domeshim.state.views import Dressing, View, Worn
from tests.pictures.beside import looking_around

SIZE = 512
EYES = 0.5
DISTANCE = 4.0


def towards(azimuth, height):
    """A direction of eye space: degrees to the right of ahead, and above the horizon."""
    a, h = np.radians(azimuth), np.radians(height)
    return np.array([np.sin(a) * np.cos(h), np.sin(h), -np.cos(a) * np.cos(h)])


def dot(gl, direction, distance):
    gl.glPointSize(5)
    gl.glBegin(gl.GL_POINTS)
    gl.glVertex3f(*(direction * distance))
    gl.glEnd()


def line_through(gl, direction, distance):
    """One long upright line, which is subdivided, through the point and far beyond it both ways."""
    up = np.array([0, 1, 0]) - direction * direction[1]
    gl.glLineWidth(5)
    gl.glBegin(gl.GL_LINES)
    for end in (-3.0, 3.0):
        gl.glVertex3f(*(direction * distance + up * end))
    gl.glEnd()


def seen_at(picture):
    """Where the content's middle is seen: a unit direction, by an equidistant lens of 180 degrees."""
    rows, columns = np.nonzero(picture.max(-1) > 128)
    assert rows.size, "nothing to see"
    side = picture.shape[0]
    x, y = (columns.mean() + 0.5) * 2 / side - 1, 1 - (rows.mean() + 0.5) * 2 / side
    phi = np.hypot(x, y) * np.pi / 2
    return np.array([*(np.array([x, y]) * np.sin(phi) / np.hypot(x, y)), -np.cos(phi)])


def expected(direction, distance, side):
    """Seen by the eye of that side, -1 left: the formula of docs/reference.md, in float64."""
    right = np.cross(direction, (0, 1, 0)) / max(np.hypot(direction[0], direction[2]), 0.5)
    ray = direction * distance - side * EYES / 2 * right
    return ray / np.linalg.norm(ray)


PLACES = {
    "ahead": (1, 0.5),
    "left": (-70, 3),
    "right": (70, 3),
    "up": (5, 55),
    "down right": (40, -50),
    "high up": (3, 80),
}


@pytest.mark.parametrize("distance", [2.0, DISTANCE, 1000.0])
@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES)
@pytest.mark.parametrize("eye", ["left", "right"])
def test_each_eye_sees_a_point_where_it_must(beside, place, distance, eye):
    direction = towards(*place)

    def scene(gl):
        looking_around(gl)
        dot(gl, direction, distance if distance < 100 else 90.0)

    distance = min(distance, 90.0)
    picture = beside.through_dome(scene, (SIZE, SIZE), fov=180.0, stereo=eye, eyes=EYES).picture
    wanted = expected(direction, distance, -1 if eye == "left" else 1)
    pixel = np.pi / SIZE
    assert np.arccos(min(1.0, float(seen_at(picture) @ wanted))) < 1.2 * pixel


@pytest.mark.parametrize("tilt", [0.0, 90.0])
def test_the_eyes_turn_with_the_direction_looked_at(beside, tilt):
    """Ahead, left, right and up the two pictures of a point are equally far apart; at the zenith nowhere."""

    def apart(azimuth, height):
        direction = towards(azimuth, height)

        def scene(gl):
            looking_around(gl)
            dot(gl, direction, 2.0)

        shown = {}
        for eye in ("left", "right"):
            options = {"fov": 200.0, "stereo": eye, "eyes": EYES, "tilt": tilt}
            picture = beside.through_dome(scene, (SIZE, SIZE), **options).picture
            rows, columns = np.nonzero(picture.max(-1) > 128)
            x, y = (columns.mean() + 0.5) * 2 / SIZE - 1, 1 - (rows.mean() + 0.5) * 2 / SIZE
            phi, theta = np.hypot(x, y) * np.radians(100), np.arctan2(y, x)
            d = np.array([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), -np.cos(phi)])
            c, s = np.cos(np.radians(tilt)), np.sin(np.radians(tilt))
            shown[eye] = np.array([d[0], c * d[1] - s * d[2], s * d[1] + c * d[2]])
        return np.degrees(np.arccos(min(1.0, float(shown["left"] @ shown["right"]))))

    disparity = np.degrees(2 * np.arctan(EYES / 2 / 2.0))
    for azimuth, height in ((0.5, 1), (-80, 5), (80, 5), (0.5, 45)):
        assert apart(azimuth, height) == pytest.approx(disparity, abs=0.7)
    assert apart(0.5, 89.5) < 0.5


@pytest.mark.parametrize("method", ["vertex", "auto", "geometry", "cpu"])
def test_a_long_line_has_the_disparity_of_each_of_its_points(beside, method):
    direction = towards(30, 0)

    def scene(gl):
        looking_around(gl)
        line_through(gl, direction, 2.0)
        if method == "vertex":  # which bends vertices alone: give it enough of them
            gl.glClear(gl.GL_COLOR_BUFFER_BIT)
            gl.glBegin(gl.GL_LINE_STRIP)
            for end in np.linspace(-3, 3, 200):
                gl.glVertex3f(*(direction * 2.0 + np.array([0, end, 0])))
            gl.glEnd()

    picture = beside.through_dome(
        scene, (SIZE, SIZE), fov=180.0, stereo="left", eyes=EYES, method=method, tolerance=0.1
    ).picture
    rows, columns = np.nonzero(picture.max(-1) > 128)
    x, y = (columns + 0.5) * 2 / SIZE - 1, 1 - (rows + 0.5) * 2 / SIZE
    phi, theta = np.hypot(x, y) * np.pi / 2, np.arctan2(y, x)
    seen = np.stack([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), -np.cos(phi)], -1)
    heights = np.linspace(-3, 3, 2000)
    points = direction * 2.0 + heights[:, None] * np.array([0, 1.0, 0])
    truth = np.array([expected(p / np.linalg.norm(p), np.linalg.norm(p), -1) for p in points])
    nearest = np.arccos(np.clip((seen @ truth.T).max(1), -1, 1))
    assert nearest.max() < 4 * np.pi / SIZE  # half of the line's width, and a pixel


def halves(picture, stereo):
    middle = SIZE // 2
    if stereo == "top-bottom":
        return picture[:middle], picture[middle:]
    return picture[:, :middle], picture[:, middle:]


@pytest.mark.parametrize("stereo", ["top-bottom", "left-right"])
def test_the_frame_holds_what_each_eye_sees(beside, stereo):
    def scene(gl):
        looking_around(gl)
        gl.glNewList(4, gl.GL_COMPILE)
        dot(gl, towards(20, 10), 2.0)
        gl.glColor3f(1, 0, 0)
        gl.glTranslatef(0, 0.4, 0)
        gl.glEndList()
        gl.glCallList(4)
        gl.glCallList(4)
        gl.glRasterPos3f(-1, -1, -3)
        gl.glBitmap(8, 1, 0, 0, 9, 0, b"\xff")
        gl.glNewList(11, gl.GL_COMPILE)  # a letter of a bitmap font
        gl.glBitmap(8, 1, 0, 0, 9, 2, b"\xff")
        gl.glEndList()
        gl.glListBase(10)
        gl.glCallLists(b"\x01\x01\x01")
        return tuple(gl.glGetFloatv(gl.GL_CURRENT_COLOR)), tuple(gl.glGetIntegerv(gl.GL_VIEWPORT))

    size = (SIZE, SIZE // 2) if stereo == "left-right" else (SIZE // 2, SIZE)
    both = beside.through_dome(scene, size, fov=180.0, stereo=stereo, eyes=EYES)
    assert both.answer == ((1.0, 0.0, 0.0, 1.0), (0, 0, *size))
    for eye, half in zip(("left", "right"), halves(both.picture, stereo), strict=True):
        alone = beside.through_dome(scene, half.shape[1::-1], fov=180.0, stereo=eye, eyes=EYES).picture
        assert alone.any()
        # The window's shape differs, which nothing of this scene depends on.
        assert unlike(half, alone) == 0
        assert unlike(alone, half) == 0


def unlike(one, other):
    """How many pixels of one are unlike everything within a pixel of the other."""
    low, high = ndimage.minimum_filter(other, (3, 3, 1)), ndimage.maximum_filter(other, (3, 3, 1))
    return int(((one < low.astype(int) - 2) | (one > high.astype(int) + 2)).any(-1).sum())


def test_the_panel_is_infinitely_far_away(beside):
    def scene(gl):
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glRectf(-0.5, -0.2, 0.3, 0.6)

    options = {"fov": 180.0, "panel": 60.0, "eyes": EYES}
    pictures = [beside.through_dome(scene, **options, stereo=eye).picture for eye in ("left", "right")]
    assert pictures[0].any()
    assert np.array_equal(*pictures)


def test_the_programs_own_shaders_are_seen_by_each_eye(beside):
    from OpenGL.GL import shaders

    def scene(gl):
        looking_around(gl)
        vertex = shaders.compileShader(
            "void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; gl_PointSize = 5.0; }",
            gl.GL_VERTEX_SHADER,
        )
        fragment = shaders.compileShader("void main() { gl_FragColor = vec4(1.0); }", gl.GL_FRAGMENT_SHADER)
        program = gl.glCreateProgram()
        for shader in (vertex, fragment):
            gl.glAttachShader(program, shader)
        gl.glLinkProgram(program)
        gl.glUseProgram(program)
        dot(gl, towards(10, 5), 2.0)

    for eye, side in (("left", -1), ("right", 1)):
        options = {"fov": 180.0, "stereo": eye, "eyes": EYES}
        picture = beside.through_dome(scene, (SIZE, SIZE), **options).picture
        away = np.arccos(min(1.0, float(seen_at(picture) @ expected(towards(10, 5), 2.0, side))))
        assert away < 1.2 * np.pi / SIZE


def test_the_pointer_and_pixels_are_the_left_eyes(beside):
    def scene(gl):
        looking_around(gl)
        gl.glBegin(gl.GL_QUADS)
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            gl.glVertex3f(x, y, -50)
        gl.glEnd()
        return bytes(np.asarray(bytearray(gl.glReadPixels(256, 128, 1, 1, gl.GL_RGB, gl.GL_UNSIGNED_BYTE))))

    size = (SIZE, SIZE // 2)
    assert beside.through_dome(scene, size, fov=180.0, stereo="left-right").answer == b"\xff\xff\xff"
    with beside.window(size, fov=180.0, stereo="left-right") as finish:
        scene(beside.dome)
        place = beside._dome.program_place(beside.session.window, 128, 128)
        finish()
    assert place == pytest.approx((256, 128), abs=1e-6)


class Recorded(Driver):
    """A driver that notes which colour buffer is chosen."""

    def __init__(self):
        self.chosen = []

    def __getattr__(self, name):
        return self.chosen.append if name == "glDrawBuffer" else lambda *args: None

    def integer(self, name):
        return 0x0405  # GL_BACK


def test_each_eye_has_its_buffer_in_quad_stereo():
    views = tuple(View((0, 0, 8, 8), buffer=buffer) for buffer in (0x0402, 0x0403))
    driver = Recorded()
    worn = Worn(driver)
    worn.put_on(Dressing(0, (), views), View((0, 0, 8, 8)), 0)
    for view in views:
        worn.show(view)
    worn.take_off(0)
    assert driver.chosen == [0x0402, 0x0403, 0x0405]


def test_quad_stereo_needs_a_window_that_has_it(beside):
    from domeshim.errors import ScreenError

    with (
        pytest.raises(ScreenError, match="no window with a buffer for each eye could be had"),
        beside.window(stereo="quad"),
    ):
        pass
    assert Options().stereo == "off"
