"""OpenGL 2.1: the same pictures, by GLSL 1.20 and clip planes in place of clip distances."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from domeshim.driver import Driver
from tests.pictures.beside import GL, SIZE, Beside, looking, looking_around, sphere
from tests.pictures.own_glsl import COLOUR, COLOURED, both
from tests.pictures.test_fragments import SCENES as FRAGMENTS
from tests.pictures.test_fragments import line_widths_and_stipples
from tests.pictures.test_scissor import cleared_parts, head_up_drawing, in_a_list, inset, inside_the_view

OLD = {"MESA_GL_VERSION_OVERRIDE": "2.1", "MESA_GLSL_VERSION_OVERRIDE": "120"}
BARE = "-GL_ARB_framebuffer_object -GL_EXT_transform_feedback -GL_EXT_gpu_shader4 -GL_ARB_texture_rectangle"
PROGRAM = Path(__file__).with_name("legacy_program.py")


@pytest.fixture
def legacy(beside: Beside, monkeypatch: pytest.MonkeyPatch) -> Iterator[Beside]:
    """The ordinary context, in which the dome does as on OpenGL 2.1."""
    driver = beside.session.dome._driver
    monkeypatch.setattr(Driver, "version", (2, 1))
    monkeypatch.setitem(vars(driver), "legacy", True)
    return beside


def planes_are_told_as_they_are(gl: GL) -> list[list[float]]:
    looking(gl)
    told = []
    gl.glEnable(gl.GL_CLIP_PLANE1)
    for k in range(3):
        gl.glRotatef(20, 0, 0, 1)
        gl.glClipPlane(gl.GL_CLIP_PLANE1, (1, k / 2, 0, 0.2))
        sphere(gl, 0.6)
        told.append(list(gl.glGetClipPlane(gl.GL_CLIP_PLANE1)))
        gl.glClipPlane(gl.GL_CLIP_PLANE0, (k, 1, 0, 0.1))
        told.append(list(gl.glGetClipPlane(gl.GL_CLIP_PLANE0)))
        told.append(list(gl.glGetFloatv(gl.GL_MODELVIEW_MATRIX).ravel()))
    return told


def planes_in_a_list(gl: GL) -> None:
    looking(gl)
    gl.glNewList(1, gl.GL_COMPILE)
    gl.glClipPlane(gl.GL_CLIP_PLANE0, (0, 1, 0, 0.1))
    gl.glEnable(gl.GL_CLIP_PLANE0)
    sphere(gl, 0.5)
    gl.glDisable(gl.GL_CLIP_PLANE0)
    gl.glEndList()
    sphere(gl, 0.2)
    gl.glCallList(1)
    gl.glRotatef(90, 0, 0, 1)
    gl.glCallList(1)


def planes_on_an_attribute_stack(gl: GL) -> list[float]:
    looking(gl)
    gl.glEnable(gl.GL_CLIP_PLANE2)
    gl.glClipPlane(gl.GL_CLIP_PLANE2, (1, 0, 0, 0))
    sphere(gl, 0.6)
    gl.glPushAttrib(gl.GL_TRANSFORM_BIT)
    gl.glClipPlane(gl.GL_CLIP_PLANE2, (-1, 1, 0, 0.5))
    sphere(gl, 0.4)
    gl.glPopAttrib()
    gl.glTranslatef(
        0.5, 0.3, 0
    )  # uncut: after glPopAttrib Mesa's fixed pipeline still cuts by the former plane
    sphere(gl, 0.2)
    return list(gl.glGetClipPlane(gl.GL_CLIP_PLANE2))


def arrays_of_the_programs_own(gl: GL) -> None:
    """Long runs go through arrays of the dome's; the program's stay as they were."""
    looking(gl)
    corners = np.array([(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9)], np.float32)
    colours = np.array([(1, 0, 0), (0, 1, 0), (0, 0, 1)], np.float32)
    gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
    gl.glEnableClientState(gl.GL_COLOR_ARRAY)
    gl.glVertexPointer(2, gl.GL_FLOAT, 0, corners)
    gl.glColorPointer(3, gl.GL_FLOAT, 0, colours)
    gl.glDrawArrays(gl.GL_TRIANGLES, 0, 3)
    gl.glColor3f(1, 1, 1)
    sphere(gl, 0.5, slices=48, stacks=8)
    gl.glDisable(gl.GL_DEPTH_TEST)
    gl.glScalef(0.5, 0.5, 0.5)
    gl.glDrawArrays(gl.GL_TRIANGLES, 0, 3)


SCENES = (
    planes_are_told_as_they_are,
    planes_in_a_list,
    planes_on_an_attribute_stack,
    arrays_of_the_programs_own,
    inside_the_view,
    inset,
    head_up_drawing,
    cleared_parts,
    in_a_list,
    *(scene for scene in FRAGMENTS if scene is not line_widths_and_stipples),
)


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.__name__)
def test_as_on_the_monitor(legacy: Beside, scene: object) -> None:
    legacy.equal(scene, wrong=0.004)


def all_around(gl: GL) -> None:
    """Triangles ahead and behind, through a shader of the program's own."""
    looking_around(gl)
    gl.glUseProgram(both(gl, COLOURED, COLOUR))
    gl.glBegin(gl.GL_TRIANGLES)
    for turn in np.radians(np.arange(0, 360, 10)):
        x, z = np.sin(turn), -np.cos(turn)
        for side, up in ((-0.1, -0.5), (0.1, -0.5), (0, 0.5)):
            gl.glVertex3f(3 * (x + side * z), 3 * up, 3 * (z - side * x))
    gl.glEnd()
    gl.glUseProgram(0)


def test_the_programs_own_glsl_ends_at_the_rim(
    beside: Beside, request: pytest.FixtureRequest, capsys: pytest.CaptureFixture[str]
) -> None:
    usual = beside.through_dome(all_around, fov=180.0, method="vertex").picture.astype(int)
    old = request.getfixturevalue("legacy").through_dome(all_around, fov=180.0, method="vertex").picture
    assert (usual.max(-1) > 0).sum() > 1000
    assert (np.abs(usual - old) > 1).any(-1).sum() < 20
    assert "not bent" not in capsys.readouterr().err


def test_too_many_cuts_are_said_once(legacy: Beside, capsys: pytest.CaptureFixture[str]) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        for k in range(5):
            gl.glClipPlane(gl.GL_CLIP_PLANE0 + k, (0, 1, 0, k))
            gl.glEnable(gl.GL_CLIP_PLANE0 + k)
        sphere(gl)
        sphere(gl, 0.2)

    legacy.equal(scene)
    assert capsys.readouterr().err.count("OpenGL 2: at most four") == 1


def test_what_is_hidden_is_not_drawn(legacy: Beside) -> None:
    def scene(gl: GL, *, flat: bool = True) -> None:
        looking_around(gl)
        gl.glTranslatef(0, 0, -3)
        sphere(gl)
        if flat:
            gl.glDisable(gl.GL_DEPTH_TEST)
            gl.glMatrixMode(gl.GL_PROJECTION)
            gl.glLoadIdentity()
            gl.glOrtho(0, 1, 0, 1, -1, 4)
            gl.glMatrixMode(gl.GL_MODELVIEW)
            gl.glColor3f(1, 0, 0)
            gl.glRectf(0, 0, 0.4, 0.4)

    without = legacy.through_dome(partial(scene, flat=False), fov=180.0).picture
    assert (legacy.through_dome(scene, fov=180.0).picture != without).any()
    assert (legacy.through_dome(scene, fov=180.0, hud="off").picture == without).all()


def capture(folder: Path, name: str, **environment: str) -> tuple[np.ndarray, str]:
    output = folder / f"{name}.png"
    words = ["capture", "--frame", "2", "--size", str(SIZE), "--output", output, PROGRAM]
    ran = subprocess.run(
        [sys.executable, "-m", "domeshim", *words],
        env={**os.environ, "DOME_METHOD": "cpu", **environment},
        capture_output=True,
        text=True,
    )
    assert ran.returncode == 0, ran.stderr
    return np.asarray(Image.open(output)).astype(int), ran.stdout + ran.stderr


def test_a_whole_program_with_mesa_as_old_as_that(tmp_path: Path) -> None:
    usual, words = capture(tmp_path, "usual")
    assert "version 4" in words
    old, words = capture(tmp_path, "old", **OLD)
    assert "version 2.1" in words
    assert "planes kept" in words
    assert (usual.max(-1) > 0).mean() > 0.3
    assert (np.abs(usual - old) > 1).any(-1).sum() < 0.001 * SIZE**2
    bare, words = capture(tmp_path, "bare", **OLD, MESA_EXTENSION_OVERRIDE=BARE)
    assert "planes kept" in words
    assert "what is read of the window is the dome's picture" in words
    # Without framebuffer objects the driver's own reading gives one of a pixel's samples.
    assert (np.abs(usual - bare) > 1).any(-1).mean() < 0.2


def test_its_draws_are_explained(tmp_path: Path) -> None:
    reports = []
    for environment in ({}, {**OLD, "MESA_EXTENSION_OVERRIDE": BARE}):
        ran = subprocess.run(
            [sys.executable, "-m", "domeshim", "explain", "--json", PROGRAM],
            env={**os.environ, "DOME_METHOD": "cpu", **environment},
            capture_output=True,
            text=True,
        )
        assert ran.returncode == 0, ran.stderr
        reports.append(json.loads(ran.stdout[ran.stdout.index("{") :])["draws"])
    usual, old = (
        [(way["kind"], way["primitives"], way["generated"]) for way in report] for report in reports
    )
    assert len(usual) > 4
    assert usual == old


@pytest.mark.parametrize("setting", [("DOME_GAMMA", "2"), ("DOME_METHOD", "cubemap")])
def test_what_needs_a_newer_one_says_so_in_one_line(tmp_path: Path, setting: tuple[str, str]) -> None:
    words = ["capture", "--size", "64", "--output", tmp_path / "none.png", PROGRAM]
    ran = subprocess.run(
        [sys.executable, "-m", "domeshim", *words],
        env={**os.environ, **OLD, setting[0]: setting[1]},
        capture_output=True,
        text=True,
    )
    assert ran.returncode == 1
    assert ran.stderr.count("\n") == 1
    assert "3.3" in ran.stderr
