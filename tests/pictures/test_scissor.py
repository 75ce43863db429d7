"""The scissor cuts on the dome what it cuts in the program's window."""

from __future__ import annotations

import numpy as np
import pytest

from domeshim.state.scissor import Edges, edges_of
from tests.pictures.beside import GL, SIZE, Beside, flat, looking, sphere
from tests.pictures.test_raster import write


def colourful(gl: GL) -> None:
    gl.glBegin(gl.GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        gl.glColor3f(0.5 + x / 2, 0.5 + y / 2, 0.7)
        gl.glVertex2f(x, y)
    gl.glEnd()


def inside_the_view(gl: GL) -> None:
    looking(gl)
    gl.glEnable(gl.GL_SCISSOR_TEST)
    gl.glScissor(60, 80, 90, 50)
    colourful(gl)
    gl.glScissor(20, 150, 150, 200)
    sphere(gl, 0.8)
    gl.glDisable(gl.GL_SCISSOR_TEST)
    gl.glTranslatef(0.5, -0.5, 0.5)
    sphere(gl, 0.2)


def outside_the_view(gl: GL) -> None:
    looking(gl)
    sphere(gl, 0.2)
    gl.glEnable(gl.GL_SCISSOR_TEST)
    for box in ((300, 0, 50, 50), (10, 10, 0, 0), (-50, -50, 40, 40)):
        gl.glScissor(*box)
        colourful(gl)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)


def flat_drawing(gl: GL) -> None:
    gl.glClear(gl.GL_COLOR_BUFFER_BIT)
    flat(gl)
    gl.glEnable(gl.GL_SCISSOR_TEST)
    for k in range(4):
        gl.glScissor(50 + 40 * k, 60 + 20 * k, 30, 50)
        gl.glColor3f(1, k / 4, 0)
        gl.glRectf(0, 0, SIZE, SIZE)


def head_up_drawing(gl: GL) -> None:
    inside_the_view(gl)
    gl.glDisable(gl.GL_DEPTH_TEST)
    flat(gl)
    gl.glScissor(60, 40, 120, 60)
    gl.glEnable(gl.GL_SCISSOR_TEST)
    gl.glColor3f(1, 1, 1)
    for k in range(12):
        gl.glRectf(20 * k, 0, 20 * k + 10, SIZE)


def inset(gl: GL) -> None:
    looking(gl)
    sphere(gl, 0.9)
    gl.glViewport(60, 60, 100, 80)
    gl.glScissor(70, 50, 60, 60)
    gl.glEnable(gl.GL_SCISSOR_TEST)
    gl.glClearColor(0, 0.4, 0, 1)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    colourful(gl)


def cleared_parts(gl: GL) -> None:
    looking(gl)
    sphere(gl, 0.7)
    gl.glEnable(gl.GL_SCISSOR_TEST)
    for k in range(5):
        gl.glScissor(40 * k + 20, 30 * k + 30, 50, 40)
        gl.glClearColor(k / 5, 1 - k / 5, 0.5, 1)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
    gl.glColorMask(1, 0, 0, 1)
    gl.glScissor(0, 110, 256, 10)
    gl.glClearColor(1, 1, 1, 1)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT)


def cleared_depth_and_stencil(gl: GL) -> None:
    looking(gl)
    gl.glColor3f(0.5, 0.5, 0)
    colourful(gl)
    gl.glEnable(gl.GL_SCISSOR_TEST)
    gl.glScissor(60, 60, 70, 140)
    gl.glClearDepth(1)
    gl.glClearStencil(3)
    gl.glClear(gl.GL_DEPTH_BUFFER_BIT | gl.GL_STENCIL_BUFFER_BIT)
    gl.glDisable(gl.GL_SCISSOR_TEST)
    gl.glTranslatef(0, 0, -1)
    gl.glColor3f(1, 1, 1)
    gl.glRectf(-0.8, -0.3, 0.8, 0.3)
    gl.glDisable(gl.GL_DEPTH_TEST)
    gl.glEnable(gl.GL_STENCIL_TEST)
    gl.glStencilFunc(gl.GL_EQUAL, 3, 255)
    gl.glColor3f(0, 1, 1)
    gl.glRectf(-0.8, 0.4, 0.8, 0.6)


def whole_window(gl: GL) -> None:
    gl.glEnable(gl.GL_SCISSOR_TEST)
    gl.glScissor(0, 0, SIZE, SIZE)
    looking(gl)
    sphere(gl)


def in_a_list(gl: GL) -> None:
    looking(gl)
    gl.glNewList(1, gl.GL_COMPILE)
    gl.glPushAttrib(gl.GL_SCISSOR_BIT)
    gl.glEnable(gl.GL_SCISSOR_TEST)
    gl.glScissor(60, 80, 90, 50)
    gl.glClearColor(0, 1, 0, 1)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT)
    sphere(gl)
    gl.glPopAttrib()
    gl.glEndList()
    gl.glCallList(1)
    gl.glTranslatef(-0.6, 0.5, 0)
    sphere(gl, 0.2)


def with_clip_planes(gl: GL) -> None:
    looking(gl)
    gl.glClipPlane(gl.GL_CLIP_PLANE0, (1, 1, 0, 0))
    gl.glClipPlane(gl.GL_CLIP_PLANE2, (0, -1, 0, 0.4))
    gl.glEnable(gl.GL_CLIP_PLANE0)
    gl.glEnable(gl.GL_CLIP_PLANE2)
    gl.glEnable(gl.GL_SCISSOR_TEST)
    gl.glScissor(60, 60, 120, 120)
    colourful(gl)


SCENES = (
    inside_the_view,
    outside_the_view,
    flat_drawing,
    head_up_drawing,
    inset,
    cleared_parts,
    cleared_depth_and_stencil,
    whole_window,
    in_a_list,
    with_clip_planes,
)


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.__name__)
def test_scissored_as_on_the_monitor(beside: Beside, scene: object) -> None:
    beside.equal(scene, wrong=0.012)


def test_a_split_window_splits_the_dome(beside: Beside) -> None:
    """The left half by scissor: everything left of the middle to the very rim, and nothing right of it."""

    def scene(gl: GL) -> None:
        gl.glClearColor(0, 0, 0, 1)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.gluPerspective(60, 1, 0.1, 100)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glTranslatef(0, 0, 0)
        gl.glEnable(gl.GL_SCISSOR_TEST)
        gl.glScissor(0, 0, SIZE // 2, SIZE)
        gl.glClearColor(1, 0, 0, 1)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glColor3f(0, 1, 0)
        for turn in range(0, 360, 3):
            gl.glPushMatrix()
            gl.glRotatef(turn, 0, 1, 0)
            gl.glBegin(gl.GL_QUADS)
            for x, y in ((-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1)):
                gl.glVertex3f(x, y, -1)
            gl.glEnd()
            gl.glPopMatrix()

    picture = beside.through_dome(scene, fov=180).picture
    left, right = picture[:, : SIZE // 2], picture[:, SIZE // 2 :]
    assert not right.any()
    disc = np.hypot(*np.meshgrid(np.arange(SIZE) - 127.5, np.arange(SIZE) - 127.5))[:, : SIZE // 2] < 126
    assert (left[disc].max(-1) == 255).all()
    assert left[SIZE // 2, 10].tolist() == [0, 255, 0]


@pytest.mark.parametrize("tilt", [0.0, 35.0])
def test_flat_text_and_clears_meet_what_is_drawn(beside: Beside, tilt: float) -> None:
    """On a whole dome: a scissored clear, a glWindowPos and a drawn rectangle of one place coincide."""

    def at(draw: str) -> np.ndarray:
        def scene(gl: GL) -> None:
            gl.glClear(gl.GL_COLOR_BUFFER_BIT)
            flat(gl)
            if draw == "rectangle":
                gl.glBegin(gl.GL_QUADS)
                for k in range(400):  # so fine that nothing bends
                    x, y = 150 + k % 20 * 3, 30 + k // 20 * 2
                    for dx, dy in ((0, 0), (3, 0), (3, 2), (0, 2)):
                        gl.glVertex2f(x + dx, y + dy)
                gl.glEnd()
            elif draw == "clear":
                gl.glEnable(gl.GL_SCISSOR_TEST)
                gl.glScissor(150, 30, 60, 40)
                gl.glClearColor(1, 1, 1, 1)
                gl.glClear(gl.GL_COLOR_BUFFER_BIT)
            elif draw == "window":
                gl.glWindowPos2f(150, 30)
                write(gl, 1)
            else:
                gl.glRasterPos2f(150, 30)
                write(gl, 1)

        return beside.through_dome(scene, fov=180.0, panel=80.0, tilt=tilt).picture[..., 0].astype(int)

    rectangle, cleared = at("rectangle"), at("clear")
    assert rectangle.any()
    assert (rectangle != cleared).sum() < 0.04 * (rectangle > 0).sum()
    assert at("window").any()
    assert (at("window") == at("raster")).all()


def test_edges() -> None:
    view = (0, 0, 100, 50)
    assert edges_of(None, view) == Edges()
    assert edges_of((0, 0, 100, 50), view) == Edges()
    assert edges_of((-9, -9, 200, 100), view) == Edges()
    assert edges_of((25, 0, 75, 25), view) == Edges((-0.5, 1.0, -1.0, 0.0), (0, 3))
    assert edges_of((200, 0, 10, 10), view).empty
    assert edges_of((10, 10, 0, 10), view).empty
    assert not edges_of((10, 10, 1, 1), view).empty
