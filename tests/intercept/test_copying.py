"""glCopyTexImage and glCopyTexSubImage take the monitor's picture."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.intercept.test_reading import SIZE, away, scene
from tests.pictures.beside import GL, Beside

PLAIN = {"fov": 180.0}


@pytest.fixture(scope="module")
def beside(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Beside]:
    pair = Beside(Path(tmp_path_factory.getbasetemp()) / "differences")
    yield pair
    pair.close()


def empty(gl: GL, internal: Any, layout: Any, width: int, height: int) -> None:
    """A texture of the program's own, bound."""
    gl.glBindTexture(gl.GL_TEXTURE_2D, gl.glGenTextures(1))
    data = np.zeros((height, width, 4), np.uint8)
    gl.glTexImage2D(gl.GL_TEXTURE_2D, 0, internal, width, height, 0, layout, gl.GL_UNSIGNED_BYTE, data)


def held(gl: GL) -> np.ndarray:
    """(height, width, 3) the colours of the bound texture, the bottom row first."""
    width, height = (
        gl.glGetTexLevelParameteriv(gl.GL_TEXTURE_2D, 0, size)
        for size in (gl.GL_TEXTURE_WIDTH, gl.GL_TEXTURE_HEIGHT)
    )
    gl.glPixelStorei(gl.GL_PACK_ALIGNMENT, 1)
    data = gl.glGetTexImage(gl.GL_TEXTURE_2D, 0, gl.GL_RGB, gl.GL_UNSIGNED_BYTE)
    return np.frombuffer(data, np.uint8).reshape(height, width, 3)


def whole(gl: GL) -> np.ndarray:
    scene(gl)
    gl.glBindTexture(gl.GL_TEXTURE_2D, gl.glGenTextures(1))
    gl.glCopyTexImage2D(gl.GL_TEXTURE_2D, 0, gl.GL_RGB, 0, 0, *SIZE, 0)
    return held(gl)


def part(gl: GL) -> np.ndarray:
    """A part of the window in a part of a texture."""
    scene(gl)
    empty(gl, gl.GL_RGB, gl.GL_RGBA, 128, 100)
    gl.glCopyTexSubImage2D(gl.GL_TEXTURE_2D, 0, 16, 8, 90, 70, 100, 80)
    return held(gl)


def unlike(first: np.ndarray, second: np.ndarray) -> float:
    """The share of pixels that differ."""
    assert first.shape == second.shape
    return float((np.abs(first.astype(int) - second).max(-1) > 2).mean())


@pytest.mark.parametrize("options", [PLAIN, {"tilt": 20.0}, {"fill": 110.0}, {"method": "cubemap"}], ids=str)
@pytest.mark.parametrize("copy", [whole, part])
def test_the_texture_is_the_monitors(beside: Beside, copy: Any, options: dict[str, Any]) -> None:
    monitor = beside.monitor(copy, SIZE).answer
    assert len(np.unique(monitor.reshape(-1, 3), axis=0)) >= 3
    edges = 0.06 if options.get("method") == "cubemap" else 0.02  # faces are resampled, which blends edges
    assert unlike(beside.through_dome(copy, SIZE, **(PLAIN | options)).answer, monitor) < edges


def test_a_row(beside: Beside) -> None:
    def copy(gl: GL) -> bytes:
        scene(gl)
        gl.glBindTexture(gl.GL_TEXTURE_1D, gl.glGenTextures(1))
        gl.glCopyTexImage1D(gl.GL_TEXTURE_1D, 0, gl.GL_RGB, 96, 120, 128, 0)
        return bytes(gl.glGetTexImage(gl.GL_TEXTURE_1D, 0, gl.GL_RGB, gl.GL_UNSIGNED_BYTE))

    monitor, dome = (
        np.frombuffer(drawn.answer, np.uint8).reshape(1, 128, 3)
        for drawn in (beside.monitor(copy, SIZE), beside.through_dome(copy, SIZE, **PLAIN))
    )
    assert unlike(dome, monitor) < 0.05


@pytest.mark.parametrize("sub", [False, True])
def test_depths_are_the_monitors(beside: Beside, sub: bool) -> None:
    def copy(gl: GL) -> np.ndarray:
        scene(gl)
        depth = gl.GL_DEPTH_COMPONENT24
        if sub:
            empty(gl, depth, gl.GL_DEPTH_COMPONENT, *SIZE)
            gl.glCopyTexSubImage2D(gl.GL_TEXTURE_2D, 0, 0, 0, 0, 0, *SIZE)
        else:
            gl.glBindTexture(gl.GL_TEXTURE_2D, gl.glGenTextures(1))
            gl.glCopyTexImage2D(gl.GL_TEXTURE_2D, 0, depth, 0, 0, *SIZE, 0)
        return np.asarray(gl.glGetTexImage(gl.GL_TEXTURE_2D, 0, gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT))

    monitor = beside.monitor(copy, SIZE).answer
    assert sorted(np.unique(away(monitor).round(1))) == [2, 4, 20]
    dome = beside.through_dome(copy, SIZE, **PLAIN).answer
    assert np.mean(np.abs(away(dome) / away(monitor) - 1) > 0.02) < 0.05


def small_view(gl: GL) -> np.ndarray:
    """Draws a small picture into the window's corner, over a scene, and takes it."""
    scene(gl)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    gl.glViewport(0, 0, 96, 96)
    scene(gl)
    empty(gl, gl.GL_RGB, gl.GL_RGBA, 96, 96)
    gl.glCopyTexSubImage2D(gl.GL_TEXTURE_2D, 0, 0, 0, 0, 0, 96, 96)
    gl.glViewport(0, 0, *SIZE)
    return held(gl)


@pytest.mark.parametrize("hud", ["panel", "flat"])
def test_a_small_view_is_found_where_it_is_drawn(beside: Beside, hud: str) -> None:
    monitor = beside.monitor(small_view, SIZE).answer
    assert unlike(beside.through_dome(small_view, SIZE, **PLAIN, hud=hud).answer, monitor) < 0.08


def test_depths_of_what_is_drawn_flat(beside: Beside) -> None:
    """The shadow map of a lamp that is infinitely far away."""

    def copy(gl: GL) -> np.ndarray:
        scene(gl)
        gl.glClear(gl.GL_DEPTH_BUFFER_BIT)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glLoadIdentity()
        gl.glOrtho(-1, 1, -1, 1, 0, 10)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glBegin(gl.GL_QUADS)
        for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
            gl.glVertex3f(x, y, -4 - x)
        gl.glEnd()
        gl.glBindTexture(gl.GL_TEXTURE_2D, gl.glGenTextures(1))
        gl.glCopyTexImage2D(gl.GL_TEXTURE_2D, 0, gl.GL_DEPTH_COMPONENT, 0, 0, *SIZE, 0)
        return np.asarray(gl.glGetTexImage(gl.GL_TEXTURE_2D, 0, gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT))

    monitor = beside.monitor(copy, SIZE).answer
    assert (monitor.min(), monitor.max()) == pytest.approx((0.35, 1), abs=0.01)
    dome = beside.through_dome(copy, SIZE, **PLAIN).answer
    assert np.mean(np.abs(dome - monitor) > 0.005) < 0.03


def test_another_view_is_looked_up_anew(beside: Beside) -> None:
    def copy(gl: GL) -> list[np.ndarray]:
        first = whole(gl)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glLoadIdentity()
        gl.gluPerspective(30, SIZE[0] / SIZE[1], 1, 20)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
        gl.glBegin(gl.GL_QUADS)
        for x, y in ((-1, -0.5), (0, -0.5), (0, 0.5), (-1, 0.5)):
            gl.glVertex3f(x, y, -2)
        gl.glEnd()
        gl.glCopyTexImage2D(gl.GL_TEXTURE_2D, 0, gl.GL_RGB, 0, 0, *SIZE, 0)
        return [first, held(gl)]

    monitor = beside.monitor(copy, SIZE).answer
    assert unlike(*monitor) > 0.2
    for mine, theirs in zip(beside.through_dome(copy, SIZE, **PLAIN).answer, monitor, strict=True):
        assert unlike(mine, theirs) < 0.02


def test_the_programs_own_framebuffer_is_left_alone(beside: Beside) -> None:
    def copy(gl: GL) -> np.ndarray:
        scene(gl)
        framebuffer, colour = gl.glGenFramebuffers(1), gl.glGenRenderbuffers(1)
        gl.glBindRenderbuffer(gl.GL_RENDERBUFFER, colour)
        gl.glRenderbufferStorage(gl.GL_RENDERBUFFER, gl.GL_RGBA8, 8, 8)
        gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, framebuffer)
        gl.glFramebufferRenderbuffer(gl.GL_FRAMEBUFFER, gl.GL_COLOR_ATTACHMENT0, gl.GL_RENDERBUFFER, colour)
        gl.glClearColor(1, 0, 1, 1)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        empty(gl, gl.GL_RGB, gl.GL_RGBA, 8, 8)
        gl.glCopyTexSubImage2D(gl.GL_TEXTURE_2D, 0, 0, 0, 0, 0, 8, 8)
        gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, 0)
        return held(gl)

    assert (beside.through_dome(copy, SIZE, **PLAIN).answer == (255, 0, 255)).all()
