"""Textures, generated coordinates, several units, points and sprites look as they do on the monitor."""

from __future__ import annotations

import numpy as np
import pytest

from domeshim.shading.recipe import Texture
from tests.pictures.beside import DISTANCE, GL, Beside, checks, looking, sphere


def textured_quad(gl: GL, size: float = 0.7) -> None:
    gl.glBegin(gl.GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        gl.glTexCoord2f(x, y)
        gl.glVertex2f(size * x, size * y)
    gl.glEnd()


def modulated(gl: GL) -> None:
    looking(gl)
    checks(gl)
    gl.glRotatef(50, 0, 1, 0)
    gl.glColor3f(1, 0.8, 0.5)
    textured_quad(gl)


def replaced_and_lit(gl: GL) -> None:
    looking(gl)
    checks(gl)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glEnable(gl.GL_LIGHT0)
    gl.glTexEnvi(gl.GL_TEXTURE_ENV, gl.GL_TEXTURE_ENV_MODE, gl.GL_REPLACE)
    sphere(gl, 0.5)
    gl.glTexEnvi(gl.GL_TEXTURE_ENV, gl.GL_TEXTURE_ENV_MODE, gl.GL_MODULATE)
    gl.glTranslatef(0.4, 0.4, 0.4)
    sphere(gl, 0.3)


def matrix(gl: GL) -> None:
    looking(gl)
    checks(gl)
    gl.glMatrixMode(gl.GL_TEXTURE)
    gl.glRotatef(30, 0, 0, 1)
    gl.glScalef(2, 1.5, 1)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    textured_quad(gl)


def matrix_changed_after_a_draw_in_its_mode(gl: GL) -> None:
    looking(gl)
    checks(gl)
    gl.glMatrixMode(gl.GL_TEXTURE)
    textured_quad(gl, 0.2)
    gl.glScalef(3, 3, 1)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glTranslatef(-0.5, 0, 0)
    textured_quad(gl, 0.2)


def projective(gl: GL) -> None:
    looking(gl)
    checks(gl)
    gl.glBegin(gl.GL_QUADS)
    for (x, y), q in zip(((-1, -1), (1, -1), (1, 1), (-1, 1)), (1, 2, 3, 1.5), strict=True):
        gl.glTexCoord4f(q * x, q * y, 0, q)
        gl.glVertex2f(0.7 * x, 0.7 * y)
    gl.glEnd()


def one_dimensional(gl: GL) -> None:
    looking(gl)
    checks(gl, gl.GL_TEXTURE_1D)
    textured_quad(gl)


def three_dimensional(gl: GL) -> None:
    looking(gl)
    texels = np.random.default_rng(3).integers(0, 255, (4, 4, 4, 4)).astype(np.uint8)
    gl.glBindTexture(gl.GL_TEXTURE_3D, gl.glGenTextures(1))
    gl.glTexParameteri(gl.GL_TEXTURE_3D, gl.GL_TEXTURE_MIN_FILTER, gl.GL_LINEAR)
    gl.glTexImage3D(gl.GL_TEXTURE_3D, 0, gl.GL_RGBA, 4, 4, 4, 0, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE, texels)
    gl.glEnable(gl.GL_TEXTURE_3D)
    gl.glBegin(gl.GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        gl.glTexCoord3f(x, y, x * y)
        gl.glVertex2f(0.7 * x, 0.7 * y)
    gl.glEnd()


def rectangle(gl: GL) -> None:
    looking(gl)
    checks(gl, gl.GL_TEXTURE_RECTANGLE)
    gl.glMatrixMode(gl.GL_TEXTURE)
    gl.glScalef(8, 8, 1)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    textured_quad(gl)


def cube_map(gl: GL) -> None:
    looking(gl)
    checks(gl, gl.GL_TEXTURE_CUBE_MAP)
    for axis in "STR":
        gl.glTexGeni(getattr(gl, f"GL_{axis}"), gl.GL_TEXTURE_GEN_MODE, gl.GL_NORMAL_MAP)
        gl.glEnable(getattr(gl, f"GL_TEXTURE_GEN_{axis}"))
    gl.glRotatef(20, 1, 1, 0)
    sphere(gl)


def several_units(gl: GL) -> None:
    looking(gl)
    checks(gl)
    gl.glActiveTexture(gl.GL_TEXTURE1)
    checks(gl, size=4)
    gl.glTexEnvi(gl.GL_TEXTURE_ENV, gl.GL_TEXTURE_ENV_MODE, gl.GL_ADD)
    gl.glActiveTexture(gl.GL_TEXTURE2)
    checks(gl, size=2)
    gl.glMatrixMode(gl.GL_TEXTURE)
    gl.glTranslatef(0.3, 0, 0)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glBegin(gl.GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        gl.glMultiTexCoord2f(gl.GL_TEXTURE0, x, y)
        gl.glMultiTexCoord2fv(gl.GL_TEXTURE1, (y, 2 * x))
        gl.glMultiTexCoord3d(gl.GL_TEXTURE2, x + y, x - y, 0)
        gl.glVertex2f(0.7 * x, 0.7 * y)
    gl.glEnd()


def color_sum(gl: GL) -> None:
    looking(gl)
    checks(gl)
    gl.glEnable(gl.GL_COLOR_SUM)
    gl.glBegin(gl.GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        gl.glTexCoord2f(x, y)
        gl.glSecondaryColor3f(max(x, 0), 0.2, max(y, 0))
        gl.glVertex2f(0.7 * x, 0.7 * y)
    gl.glEnd()


def texture_switched_per_object(gl: GL) -> None:
    looking(gl)
    checks(gl)
    for i in range(4):
        (gl.glEnable if i % 2 else gl.glDisable)(gl.GL_TEXTURE_2D)
        gl.glPushMatrix()
        gl.glTranslatef(i / 2 - 0.75, 0, 0)
        textured_quad(gl, 0.2)
        gl.glPopMatrix()


SCENES = (
    modulated,
    replaced_and_lit,
    matrix,
    matrix_changed_after_a_draw_in_its_mode,
    projective,
    one_dimensional,
    three_dimensional,
    rectangle,
    cube_map,
    several_units,
    color_sum,
    texture_switched_per_object,
)


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.__name__)
def test_textures_lie_as_on_the_monitor(beside: Beside, scene: object) -> None:
    beside.equal(scene, wrong=0.003)


@pytest.mark.parametrize(
    "mode", ["OBJECT_LINEAR", "EYE_LINEAR", "SPHERE_MAP", "REFLECTION_MAP", "NORMAL_MAP"]
)
def test_generated_coordinates(beside: Beside, mode: str) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        checks(gl)
        gl.glRotatef(30, 1, 0, 0)
        for axis, plane in (("S", (1, 0.5, 0, 0.2)), ("T", (0, 1, 1, 0.1))):
            name = getattr(gl, f"GL_{axis}")
            gl.glTexGeni(name, gl.GL_TEXTURE_GEN_MODE, getattr(gl, f"GL_{mode}"))
            if "LINEAR" in mode:
                gl.glTexGenfv(name, getattr(gl, f"GL_{mode[:-7]}_PLANE"), plane)
            gl.glEnable(getattr(gl, f"GL_TEXTURE_GEN_{axis}"))
        gl.glTranslatef(0.1, 0, 0)
        sphere(gl)

    beside.equal(scene, name=mode, wrong=0.003)


def test_points_and_sprites(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        gl.glPointSize(9)
        gl.glBegin(gl.GL_POINTS)
        for i in range(6):
            gl.glColor3f(1, i / 6, 0)
            gl.glVertex2f(i / 4 - 0.6, 0.3)
        gl.glEnd()
        gl.glEnable(gl.GL_POINT_SMOOTH)
        gl.glEnable(gl.GL_BLEND)
        gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
        gl.glBegin(gl.GL_POINTS)
        for i in range(6):
            gl.glVertex2f(i / 4 - 0.6, 0)
        gl.glEnd()
        gl.glDisable(gl.GL_POINT_SMOOTH)
        checks(gl)
        gl.glEnable(gl.GL_POINT_SPRITE)
        gl.glTexEnvi(gl.GL_POINT_SPRITE, gl.GL_COORD_REPLACE, 1)
        gl.glPointSize(24)
        gl.glBegin(gl.GL_POINTS)
        for i in range(6):
            gl.glVertex2f(i / 4 - 0.6, -0.4)
        gl.glEnd()

    beside.equal(scene, name="points")


def test_point_parameters(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        gl.glPointSize(20)
        gl.glPointParameterfv(gl.GL_POINT_DISTANCE_ATTENUATION, (0.2, 0, 4 / DISTANCE**2))
        gl.glPointParameterf(gl.GL_POINT_SIZE_MAX, 12)
        for i in range(6):
            gl.glBegin(gl.GL_POINTS)
            gl.glVertex3f(i / 4 - 0.6, 0.3, i / 2)
            gl.glEnd()
        gl.glPointParameterfv(gl.GL_POINT_DISTANCE_ATTENUATION, (1, 0, 0))
        gl.glBegin(gl.GL_POINTS)
        gl.glVertex3f(0, -0.3, 0)
        gl.glEnd()

    beside.equal(scene, name="point parameters")


def switched(gl: GL) -> None:
    looking(gl)
    checks(gl)
    for k in range(8):
        (gl.glDisable if k % 2 else gl.glEnable)(gl.GL_TEXTURE_2D)
        gl.glColor3f(1, k / 8, 0.5)
        gl.glBegin(gl.GL_QUADS)
        for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
            gl.glTexCoord2f(s, t)
            gl.glVertex3f((k % 4 + s) / 2 - 1, (k // 4 + t) / 2 - 0.5, 0)
        gl.glEnd()


def test_a_texture_that_is_switched_on_and_off_takes_one_program(beside: Beside) -> None:
    beside.equal(switched)
    with beside.window() as finish:
        switched(beside.dome)
        context = beside._dome.context
        assert context is not None
        assert [recipe.scene.textures for recipe in context.programs] == [(Texture(0),)]
        finish()
        looking(beside.dome)
        beside.dome.glRectf(-0.5, -0.5, 0.5, 0.5)
        finish()
        assert [recipe.scene.textures for recipe in context.programs] == [(Texture(0),), ()]
