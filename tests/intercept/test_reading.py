"""glReadPixels in the program's window coordinates."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from tests.pictures.beside import GL, Beside

SIZE = (320, 240)


@pytest.fixture(scope="module")
def beside(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Beside]:
    pair = Beside(Path(tmp_path_factory.getbasetemp()) / "differences")
    yield pair
    pair.close()


def scene(gl: GL) -> None:
    """A wall 4 units ahead that fills the view, with a green square nearer, left of the middle."""
    gl.glClearColor(0.0, 0.0, 0.2, 1)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT | gl.GL_STENCIL_BUFFER_BIT)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gl.gluPerspective(60, SIZE[0] / SIZE[1], 1, 20)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glLoadIdentity()
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glEnable(gl.GL_STENCIL_TEST)
    gl.glStencilOp(gl.GL_KEEP, gl.GL_KEEP, gl.GL_REPLACE)
    gl.glStencilFunc(gl.GL_ALWAYS, 3, 255)
    gl.glColor3ub(200, 100, 50)
    gl.glBegin(gl.GL_QUADS)
    for x, y in ((-3, -2), (3, -2), (3, 2), (-3, 2)):
        gl.glVertex3f(x, y, -4)
    gl.glEnd()
    gl.glStencilFunc(gl.GL_ALWAYS, 5, 255)
    gl.glColor3ub(10, 250, 20)
    gl.glBegin(gl.GL_QUADS)
    for x, y in ((-1, -0.5), (0, -0.5), (0, 0.5), (-1, 0.5)):
        gl.glVertex3f(x, y, -2)
    gl.glEnd()


DOMES = [{}, {"tilt": 20.0}, {"fov": 230.0}, {"fill": 110.0}, {"lens": ("polynomial", (0.6, 0.02))}]


def away(depth: np.ndarray) -> np.ndarray:
    """The distance from the eye's plane at which the scene's perspective puts a depth."""
    return 20 / (20 - 19 * depth.astype(float))


@pytest.mark.parametrize("tolerance", [0.5, 0.05])
@pytest.mark.parametrize("options", DOMES, ids=lambda o: ",".join(o) or "plain")
def test_depths_are_the_monitors(beside: Beside, options: dict, tolerance: float) -> None:
    """Up to the chords of the dome's edges: tolerance pixels of the disc's radius, seen along the view."""

    def read(gl: GL) -> np.ndarray:
        scene(gl)
        return gl.glReadPixels(0, 0, *SIZE, gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT).reshape(SIZE[::-1])

    monitor = beside.monitor(read, SIZE).answer
    dome = beside.through_dome(read, SIZE, **({"fov": 180.0, "tolerance": tolerance} | options)).answer
    assert sorted(np.unique(away(monitor).round(1))) == [2, 4, 20]
    wrong = np.abs(away(dome) / away(monitor) - 1)
    assert np.mean(wrong > 3 * tolerance / (SIZE[1] / 2)) < 0.05  # edges differ by a pixel of the dome


def test_depths_within_a_depth_range(beside: Beside) -> None:
    def read(gl: GL) -> float:
        gl.glDepthRange(0.2, 0.5)
        scene(gl)
        found = gl.glReadPixels(130, 120, 1, 1, gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT)
        gl.glDepthRange(0, 1)
        return float(found.item())

    monitor = beside.monitor(read, SIZE).answer
    assert 0.2 < monitor < 0.5
    dome = beside.through_dome(read, SIZE, fov=180.0, tolerance=0.02).answer
    assert dome == pytest.approx(monitor, abs=1e-4)


def test_every_way_of_asking(beside: Beside) -> None:
    """Types, the typed functions, an array of the program's own, scales, and a buffer object."""

    def read(gl: GL) -> list:
        scene(gl)
        at, depth = (130, 120, 1, 1), gl.GL_DEPTH_COMPONENT
        answers = [gl.glReadPixels(*at, depth, gl.GL_UNSIGNED_INT).item() / 2**32]
        answers.append(gl.glReadPixels(*at, depth, gl.GL_UNSIGNED_SHORT).item() / 2**16)
        answers.append(gl.glReadPixelsf(*at, depth).item())
        answers.append(gl.glReadPixels(*at, format=depth, type=gl.GL_FLOAT).item())
        mine = np.zeros((4, 8), np.float32)
        gl.glReadPixels(130, 120, 1, 1, depth, gl.GL_FLOAT, mine)
        answers.append(float(mine.max()))
        gl.glPixelTransferf(gl.GL_DEPTH_SCALE, 0.5)
        answers.append(2 * gl.glReadPixels(*at, depth, gl.GL_FLOAT).item())
        gl.glPixelTransferf(gl.GL_DEPTH_SCALE, 1.0)
        buffer = gl.glGenBuffers(1)
        gl.glBindBuffer(gl.GL_PIXEL_PACK_BUFFER, buffer)
        gl.glBufferData(gl.GL_PIXEL_PACK_BUFFER, 16, None, gl.GL_STREAM_READ)
        gl.glReadPixels(*at, depth, gl.GL_FLOAT, 4)
        answers.append(float(gl.glGetBufferSubData(gl.GL_PIXEL_PACK_BUFFER, 4, 4).view(np.float32)[0]))
        gl.glBindBuffer(gl.GL_PIXEL_PACK_BUFFER, 0)
        return answers

    monitor = beside.monitor(read, SIZE).answer
    assert monitor == pytest.approx([monitor[0]] * 7, abs=1e-4)
    dome = beside.through_dome(read, SIZE, fov=180.0, tolerance=0.02).answer
    assert dome == pytest.approx(monitor, abs=1e-4)


def test_colours_and_stencil_at_a_place(beside: Beside) -> None:
    def read(gl: GL) -> list:
        scene(gl)
        gl.glPixelStorei(gl.GL_PACK_ALIGNMENT, 1)
        places = [(130, 120), (200, 120), (20, 60), (160, 2)]
        colours = [gl.glReadPixels(*place, 1, 1, gl.GL_RGB, gl.GL_UNSIGNED_BYTE) for place in places]
        stencil = (1, 1, gl.GL_STENCIL_INDEX, gl.GL_UNSIGNED_BYTE)
        stencils = [gl.glReadPixels(*place, *stencil) for place in places]
        area = gl.glReadPixels(195, 115, 16, 12, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE)
        return [colours, stencils, area]

    monitor = beside.monitor(read, SIZE).answer
    assert monitor[0] == [b"\n\xfa\x14", b"\xc8d2", b"\xc8d2", b"\0\0\x33"]
    assert beside.through_dome(read, SIZE, fov=180.0, tilt=10.0).answer == monitor


def test_a_place_beyond_the_programs_window_is_answered(beside: Beside) -> None:
    """80 degrees to the right of the axis, far outside of a view of 60 degrees."""

    def read(gl: GL) -> tuple:
        scene(gl)
        gl.glColor3ub(1, 2, 3)
        gl.glBegin(gl.GL_QUADS)
        for y, z in ((-2, -2), (-2, 1), (2, 1), (2, -2)):
            gl.glVertex3f(6, y, z)
        gl.glEnd()
        x = int(160 + 120 / np.tan(np.radians(30)) * np.tan(np.radians(80)))
        depth = gl.glReadPixels(x, 120, 1, 1, gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT).item()
        point = gl.gluUnProject(x + 0.5, 120.5, depth)
        return gl.glReadPixels(x, 120, 1, 1, gl.GL_RGB, gl.GL_UNSIGNED_BYTE), point

    colour, point = beside.through_dome(read, (320, 240), fov=180.0).answer
    assert colour == b"\1\2\3"
    assert point == pytest.approx([6, 0, -6 / np.tan(np.radians(80))], abs=0.1)


def test_nothing_is_off_the_disc(beside: Beside) -> None:
    def read(gl: GL) -> tuple:
        scene(gl)
        place = (0, 0, 1, 1)
        depth = gl.glReadPixels(*place, gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT).item()
        return depth, gl.glReadPixels(*place, gl.GL_RGB, gl.GL_UNSIGNED_BYTE)

    assert beside.through_dome(read, SIZE, fov=60.0).answer == (1.0, b"\0\0\x33")


def test_a_screenshot_is_the_domes_picture(beside: Beside) -> None:
    def read(gl: GL) -> np.ndarray:
        scene(gl)
        return gl.glReadPixels(0, 0, *SIZE, gl.GL_RGB, gl.GL_UNSIGNED_BYTE)

    drawn = beside.through_dome(read, SIZE, fov=180.0)
    told = np.frombuffer(drawn.answer, np.uint8).reshape(SIZE[1], SIZE[0], 3)[::-1]
    x, y = np.meshgrid(np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2, np.arange(SIZE[1]) + 0.5 - SIZE[1] / 2)
    disc = np.hypot(x, y) < SIZE[1] / 2 - 1
    assert np.array_equal(told[disc], drawn.picture[disc])


def test_a_flat_program_keeps_its_depths(beside: Beside) -> None:
    def read(gl: GL) -> list:
        gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
        gl.glEnable(gl.GL_DEPTH_TEST)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glLoadIdentity()
        gl.glOrtho(0, SIZE[0], 0, SIZE[1], -1, 1)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glLoadIdentity()
        gl.glBegin(gl.GL_QUADS)
        for x, y in ((40, 40), (200, 40), (200, 160), (40, 160)):
            gl.glVertex3f(x, y, 0.5)
        gl.glEnd()
        pixel = (100, 1, 1, gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT)
        return [gl.glReadPixels(x, *pixel).item() for x in (20, 50, 190, 220)]

    monitor = beside.monitor(read, SIZE).answer
    assert monitor == pytest.approx([1, 0.25, 0.25, 1])
    assert beside.through_dome(read, SIZE, fov=180.0, panel=60.0).answer == pytest.approx(monitor, abs=1e-4)


def test_the_programs_own_framebuffer_is_left_alone(beside: Beside) -> None:
    def read(gl: GL) -> tuple:
        scene(gl)
        framebuffer, colour = gl.glGenFramebuffers(1), gl.glGenRenderbuffers(1)
        gl.glBindRenderbuffer(gl.GL_RENDERBUFFER, colour)
        gl.glRenderbufferStorage(gl.GL_RENDERBUFFER, gl.GL_RGBA8, 8, 8)
        gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, framebuffer)
        gl.glFramebufferRenderbuffer(gl.GL_FRAMEBUFFER, gl.GL_COLOR_ATTACHMENT0, gl.GL_RENDERBUFFER, colour)
        gl.glClearColor(1, 0, 1, 1)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        found = gl.glReadPixels(7, 7, 1, 1, gl.GL_RGB, gl.GL_UNSIGNED_BYTE)
        bound = gl.glGetIntegerv(gl.GL_READ_FRAMEBUFFER_BINDING) == framebuffer
        gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, 0)
        return found, bool(bound)

    assert beside.through_dome(read, SIZE, fov=180.0).answer == (b"\xff\0\xff", True)


def test_the_programs_state_is_left_as_it_was(beside: Beside) -> None:
    def read(gl: GL) -> list:
        scene(gl)
        gl.glPixelStorei(gl.GL_UNPACK_ROW_LENGTH, 7)
        gl.glPixelTransferf(gl.GL_RED_SCALE, 0.5)
        texture = gl.glGenTextures(1)
        gl.glBindTexture(gl.GL_TEXTURE_2D, texture)
        gl.glReadPixels(130, 120, 1, 1, gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT)
        names = (gl.GL_UNPACK_ROW_LENGTH, gl.GL_READ_FRAMEBUFFER_BINDING, gl.GL_TEXTURE_BINDING_2D)
        state = [int(gl.glGetIntegerv(name)) for name in names]
        state.append(float(gl.glGetFloatv(gl.GL_RED_SCALE)))
        gl.glPixelTransferf(gl.GL_RED_SCALE, 1.0)
        return [*state, int(texture)]

    row_length, framebuffer, bound, scale, texture = beside.through_dome(read, SIZE, fov=180.0).answer
    assert (row_length, framebuffer, scale) == (7, 0, 0.5)
    assert bound == texture
