"""A window may be a framebuffer object, as Qt's are: its pictures are those of a window of GL's own."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from domeshim.intercept.toolkits.windows import ToolkitWindow
from tests.lens.test_surfaces import bourke
from tests.pictures.beside import GL, Beside, assert_alike, looking_around

SIZE = (160, 160)


class Framed(Beside):
    """Its windows' pictures are in framebuffer objects while `framed`."""

    framed = False

    def _open(self, size: tuple[int, int]) -> Any:
        surface = super()._open(size)
        if not self.framed:
            return surface
        name = framebuffer(self.stock)
        window = ToolkitWindow(lambda: size, lambda: None, framebuffer=lambda: name)
        window.close = surface.close  # type: ignore[method-assign]
        return window


@pytest.fixture(scope="module")
def beside(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Framed]:
    pair = Framed(Path(tmp_path_factory.getbasetemp()) / "differences")
    yield pair
    pair.close()


def framebuffer(gl: GL) -> int:
    """A framebuffer object as large as the window, bound, with colours, depths and stencils."""
    name = int(gl.glGenFramebuffers(1))
    gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, name)
    for point, holds in (
        (gl.GL_COLOR_ATTACHMENT0, gl.GL_RGBA8),
        (gl.GL_DEPTH_STENCIL_ATTACHMENT, gl.GL_DEPTH24_STENCIL8),
    ):
        buffer = gl.glGenRenderbuffers(1)
        gl.glBindRenderbuffer(gl.GL_RENDERBUFFER, buffer)
        gl.glRenderbufferStorage(gl.GL_RENDERBUFFER, holds, *SIZE)
        gl.glFramebufferRenderbuffer(gl.GL_FRAMEBUFFER, point, gl.GL_RENDERBUFFER, buffer)
    assert gl.glCheckFramebufferStatus(gl.GL_FRAMEBUFFER) == gl.GL_FRAMEBUFFER_COMPLETE
    return name


def wall(gl: GL, left: float = -2) -> None:
    gl.glColor3ub(230, 100, 25)
    gl.glRectf(left, -1, 1, 2)


def scene(gl: GL) -> None:
    gl.glClearColor(0.1, 0.1, 0.3, 1)
    gl.glEnable(gl.GL_DEPTH_TEST)
    looking_around(gl)
    gl.glTranslatef(0, 0, -3)
    wall(gl)
    gl.glBegin(gl.GL_LINES)
    for place in ((-9, -1, 2), (9, 1, -5)):
        gl.glVertex3f(*place)
    gl.glEnd()


def part_cleared(gl: GL) -> None:
    scene(gl)
    gl.glEnable(gl.GL_SCISSOR_TEST)
    gl.glScissor(20, 30, 60, 70)
    gl.glClearColor(0, 0.6, 0, 1)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT)
    gl.glDisable(gl.GL_SCISSOR_TEST)


def pixels_read(gl: GL) -> list[Any]:
    scene(gl)
    depths = gl.glReadPixels(60, 60, 40, 40, gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT)
    colour = gl.glReadPixels(85, 95, 2, 2, gl.GL_RGB, gl.GL_UNSIGNED_BYTE)
    wall(gl, left=-3)
    return [np.asarray(depths), colour]


def accumulated(gl: GL) -> None:
    scene(gl)
    gl.glAccum(gl.GL_LOAD, 0.5)
    gl.glAccum(gl.GL_RETURN, 1.0)


def elsewhere(gl: GL) -> list[int]:
    """Draw into a framebuffer object of the program's own between two draws."""
    scene(gl)
    window = gl.glGetIntegerv(gl.GL_DRAW_FRAMEBUFFER_BINDING)
    framebuffer(gl)
    wall(gl)
    gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, window)
    wall(gl, left=-3)
    return [int(gl.glGetIntegerv(name)) - window for name in (0x8CA6, 0x8CAA)]


def elsewhere_at_the_end(gl: GL) -> None:
    scene(gl)
    framebuffer(gl)
    gl.glBindFramebuffer(gl.GL_READ_FRAMEBUFFER, 0)
    wall(gl)


MESH = "a warp mesh"
WAYS = [
    {},
    {"method": "cubemap"},
    {"surface": MESH},
    {"surface": MESH, "method": "cubemap"},
    {"mirror": "horizontal"},
    {"surface": ("keystone", (0.1, 0.05, 0.95, 0, 0.9, 1, 0, 0.9))},
    {"stereo": "top-bottom"},
    {"tilt": 30.0},
    {"debug": "levels"},
]


def options(way: dict[str, Any], folder: Path) -> dict[str, Any]:
    given = {"fov": 180.0} | way
    if given.get("surface") == MESH:
        file = folder / "m.data"
        file.write_text(bourke(place=lambda u, v: ((2 * u - 1) * (1 - 0.2 * v), 1.8 * v - 0.9)))
        given["surface"] = ("mesh", str(file))
    return given


def of_both(beside: Framed, drawing: Any, **given: Any) -> tuple[Any, Any]:
    """What is drawn with the dome in a window of GL's own, and in a framebuffer object."""
    found = []
    for framed in (False, True):
        beside.framed = framed
        with beside.window(SIZE, **given) as finish:
            answer = drawing(beside.dome, finish)
            window = beside.session.window
            assert window is not None
            gl = beside.stock
            gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, window.framebuffer)
            found.append((beside._read(SIZE), answer))
    (plain, told), (framed_picture, framed_told) = found
    assert plain.std() > 10
    assert np.abs(plain.astype(int) - framed_picture).max() <= 1  # colours are rounded
    return told, framed_told


@pytest.mark.parametrize("way", WAYS, ids=lambda way: ",".join(map(str, way.values())) or "plain")
def test_the_picture_is_the_windows(beside: Framed, tmp_path: Path, way: dict[str, Any]) -> None:
    def drawing(gl: GL, finish: Any) -> None:
        part_cleared(gl)
        finish()

    of_both(beside, drawing, **options(way, tmp_path))


@pytest.mark.parametrize("method", ["auto", "cubemap"])
@pytest.mark.parametrize("drawn", [pixels_read, accumulated, elsewhere, elsewhere_at_the_end])
def test_what_programs_do_with_framebuffers(beside: Framed, method: str, drawn: Any) -> None:
    def drawing(gl: GL, finish: Any) -> Any:
        answer = drawn(gl)
        finish()
        return answer

    plain, framed = of_both(beside, drawing, fov=180.0, method=method)
    assert_alike(framed, plain)


def test_the_next_picture_goes_on_from_the_unfinished_one(beside: Framed, tmp_path: Path) -> None:
    def drawing(gl: GL, finish: Any) -> None:
        scene(gl)
        finish()
        wall(gl, left=-3)
        finish()

    of_both(beside, drawing, **options({"surface": MESH, "mirror": "vertical"}, tmp_path))


@pytest.mark.parametrize("framed", [False, True])
@pytest.mark.parametrize("method", ["auto", "cubemap"])
def test_a_toolkit_binds_the_windows_again_unseen(beside: Framed, method: str, framed: bool) -> None:
    def left_elsewhere_before(gl: GL) -> None:
        framebuffer(gl)
        window = beside.session.window
        assert window is not None
        beside.stock.glBindFramebuffer(gl.GL_FRAMEBUFFER, window.framebuffer)
        beside.session.window_current(window)
        scene(gl)

    beside.framed = framed
    once, again = (
        beside.through_dome(drawn, SIZE, fov=180.0, method=method).picture
        for drawn in (scene, left_elsewhere_before)
    )
    assert once.std() > 10
    assert (again == once).all()


def test_the_card_lies_over_it(beside: Framed) -> None:
    def drawing(gl: GL, finish: Any) -> None:
        window, dome = beside.session.window, beside.session.dome
        assert window is not None
        assert dome is not None
        assert dome.toggle_card(window)
        scene(gl)
        finish()

    of_both(beside, drawing, fov=180.0)
