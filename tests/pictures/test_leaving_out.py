"""A picture pays only for what it needs: GL's calls are counted, and the shaders' texts read as compiled."""

from __future__ import annotations

from collections import Counter
from contextlib import closing

import pytest

from domeshim.bench.stage import Stage
from domeshim.driver import Driver
from domeshim.options import Options

PATCHES = 0x000E


class Counted(Counter):
    """How often the dome has called each entry point of GL, and the texts it compiled."""

    def __init__(self):
        super().__init__()
        self.texts = []
        self.modes = []

    def uniforms(self):
        return sum(count for name, count in self.items() if name.startswith("glUniform"))


@pytest.fixture
def calls(monkeypatch):
    """Counts from now on."""
    found = Counted()
    look_up = Driver.__getattr__

    def counted(driver, name):
        function = look_up(driver, name)

        def call(*arguments):
            found[name] += 1
            if name == "glShaderSource":
                found.texts.append(arguments[2].value.decode())
            if name in ("glDrawArrays", "glMultiDrawArrays"):
                found.modes.append(arguments[0])
            return function(*arguments)

        setattr(driver, name, call)
        return call

    monkeypatch.setattr(Driver, "__getattr__", counted)
    return found


def look(gl):
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.gluPerspective(60, 1, 0.1, 100)
    gl.glMatrixMode(gl.GL_MODELVIEW)


def triangle(gl, width=0.05):
    gl.glBegin(gl.GL_TRIANGLES)
    for x, y in ((-width, -width), (width, -width), (0, width)):
        gl.glVertex3f(x, y, -2)
    gl.glEnd()


def draw(scene, pictures=1, **options):
    with closing(Stage(64)) as stage:
        player = stage.dome(Options(enabled=True, **options))
        look(player.gl)

        def picture():
            player.gl.glClear(player.gl.GL_COLOR_BUFFER_BIT)
            scene(player.gl)

        for _ in range(pictures):
            player.show(picture)


@pytest.mark.parametrize(
    ("capability", "word"),
    [
        ("GL_LIGHTING", "gl_LightSource"),
        ("GL_TEXTURE_2D", "gl_MultiTexCoord0"),
        ("GL_FOG", "gl_FogFragCoord"),
        ("GL_CLIP_PLANE0", "gl_ClipPlane"),
    ],
)
def test_the_code_of_a_capability_is_compiled_when_it_is_on(calls, capability, word):
    def scene(gl):
        gl.glEnable(gl.GL_LIGHT0)
        triangle(gl)

    draw(scene)
    assert calls.texts
    assert not any(word in text for text in calls.texts)

    def scene_with(gl):
        gl.glEnable(getattr(gl, capability))
        scene(gl)

    draw(scene_with)
    assert any(word in text for text in calls.texts)


def test_short_edges_see_no_tessellation(calls):
    draw(triangle)
    assert PATCHES not in calls.modes
    assert not calls["glPatchParameteri"]
    assert not any("gl_TessLevelOuter" in text for text in calls.texts)
    draw(lambda gl: triangle(gl, width=2.0))
    assert PATCHES in calls.modes
    assert any("gl_TessLevelOuter" in text for text in calls.texts)


def test_uniforms_that_stay_are_sent_once(calls):
    counts = []

    def scene(gl):
        counts.append(calls.uniforms())
        triangle(gl)

    draw(scene, pictures=4)
    assert 0 == counts[0] < counts[1]
    assert counts[1] == counts[2] == counts[3]


def test_a_second_picture_compiles_nothing(calls):
    compiled = []

    def scene(gl):
        compiled.append(calls["glCompileShader"])
        triangle(gl)
        triangle(gl, width=2.0)

    draw(scene, pictures=4)
    assert compiled[0] < compiled[1]
    assert compiled[1] == compiled[2] == compiled[3]


def test_draws_that_follow_each_other_ask_for_nothing(calls):
    counts = []

    def scene(gl):
        for _ in range(4):
            triangle(gl)
            gl.glFlush()
            counts.append(sum(count for name, count in calls.items() if name.startswith("glGet")))

    draw(scene)
    assert counts[3] - counts[2] == counts[2] - counts[1] <= 4


def test_faces_that_are_not_seen_are_not_drawn(calls):
    drawn = {}
    for fov in (80.0, 180.0, 360.0):

        def scene(gl):
            before = calls["glDrawArrays"] + calls["glBegin"]
            triangle(gl)
            gl.glFlush()
            drawn[fov] = calls["glDrawArrays"] + calls["glBegin"] - before  # noqa: B023 - called in this turn

        draw(scene, fov=fov, method="cubemap:32")
    assert drawn == {80.0: 1, 180.0: 5, 360.0: 6}


def test_nothing_is_resolved_unless_the_window_is_multisampled(calls):
    draw(triangle)
    assert not calls["glBlitFramebuffer"]
    assert not calls["glGenFramebuffers"]
    assert not calls["glGenTextures"]
