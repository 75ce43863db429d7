"""Lighting, materials, normals and fog look as they do on the monitor."""

from __future__ import annotations

import pytest

from tests.pictures.beside import DISTANCE, GL, Beside, checks, looking, sphere


def lit(gl: GL) -> None:
    looking(gl)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glEnable(gl.GL_LIGHT0)
    gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, (1, 2, 3, 0))


def directional(gl: GL) -> None:
    lit(gl)
    sphere(gl)


def positional(gl: GL) -> None:
    lit(gl)
    gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, (1, 0.5, 1, 1))
    gl.glLightf(gl.GL_LIGHT0, gl.GL_CONSTANT_ATTENUATION, 0.5)
    gl.glLightf(gl.GL_LIGHT0, gl.GL_LINEAR_ATTENUATION, 0.3)
    gl.glLightf(gl.GL_LIGHT0, gl.GL_QUADRATIC_ATTENUATION, 0.2)
    sphere(gl)


def homogeneous_position(gl: GL) -> None:
    lit(gl)
    gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, (2, 1, 2, 2))
    sphere(gl)


def spot(gl: GL) -> None:
    lit(gl)
    gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, (0, 0, 2, 1))
    gl.glLightfv(gl.GL_LIGHT0, gl.GL_SPOT_DIRECTION, (0.1, 0, -2))
    gl.glLightf(gl.GL_LIGHT0, gl.GL_SPOT_CUTOFF, 15)
    gl.glLightf(gl.GL_LIGHT0, gl.GL_SPOT_EXPONENT, 4)
    sphere(gl, slices=60, stacks=60)


def shining(gl: GL) -> None:
    lit(gl)
    gl.glMaterialfv(gl.GL_FRONT_AND_BACK, gl.GL_SPECULAR, (1, 1, 0.5, 1))
    gl.glMaterialf(gl.GL_FRONT, gl.GL_SHININESS, 20)
    gl.glMaterialfv(gl.GL_FRONT, gl.GL_EMISSION, (0, 0, 0.2, 1))
    sphere(gl)


def shininess_zero(gl: GL) -> None:
    lit(gl)
    gl.glMaterialfv(gl.GL_FRONT, gl.GL_SPECULAR, (0.4, 0.2, 0.5, 1))
    sphere(gl)


def local_viewer(gl: GL) -> None:
    shine = (1, 1, 1, 1)
    lit(gl)
    gl.glLightModeli(gl.GL_LIGHT_MODEL_LOCAL_VIEWER, 1)
    gl.glTranslatef(0, 0, DISTANCE - 3)
    gl.glScalef(0.03, 0.03, 0.03)
    gl.glEnable(gl.GL_NORMALIZE)
    gl.glMaterialfv(gl.GL_FRONT, gl.GL_SPECULAR, shine)
    gl.glMaterialf(gl.GL_FRONT, gl.GL_SHININESS, 10)
    sphere(gl)


def several_lights(gl: GL) -> None:
    lit(gl)
    colours = ((1, 0, 0, 1), (0, 1, 0, 1), (0, 0, 1, 1))
    for i, colour in enumerate(colours, 1):
        light = gl.GL_LIGHT0 + 2 * i
        gl.glEnable(light)
        gl.glLightfv(light, gl.GL_POSITION, (2 - 2 * i, i - 1, 1, i % 2))
        gl.glLightfv(light, gl.GL_DIFFUSE, colour)
        gl.glLightfv(light, gl.GL_SPECULAR, colour)
        gl.glLightfv(light, gl.GL_AMBIENT, (0.05 * i, 0, 0.1, 1))
    gl.glLightModelfv(gl.GL_LIGHT_MODEL_AMBIENT, (0.3, 0.1, 0.1, 1))
    gl.glMaterialfv(gl.GL_FRONT, gl.GL_SPECULAR, (0.5, 0.5, 0.5, 1))
    gl.glMaterialf(gl.GL_FRONT, gl.GL_SHININESS, 5)
    sphere(gl)


def two_sided(gl: GL) -> None:
    lit(gl)
    gl.glLightModeli(gl.GL_LIGHT_MODEL_TWO_SIDE, 1)
    gl.glMaterialfv(gl.GL_FRONT, gl.GL_DIFFUSE, (1, 0.2, 0, 1))
    gl.glMaterialfv(gl.GL_BACK, gl.GL_DIFFUSE, (0, 0.2, 1, 1))
    gl.glMaterialfv(gl.GL_BACK, gl.GL_EMISSION, (0, 0.3, 0, 1))
    gl.glRotatef(60, 1, 1, 0)
    gl.glNormal3f(0, 0, 1)
    for x, turn in ((-0.6, 0), (0.1, 180)):
        gl.glPushMatrix()
        gl.glTranslatef(x, 0, 0)
        gl.glRotatef(turn, 0, 1, 0)
        gl.glRectf(-0.3, -0.8, 0.3, 0.8)
        gl.glPopMatrix()


def separate_specular(gl: GL) -> None:
    shining(gl)
    looking(gl)
    gl.glLightModeli(gl.GL_LIGHT_MODEL_COLOR_CONTROL, gl.GL_SEPARATE_SPECULAR_COLOR)
    checks(gl)
    sphere(gl)


def color_material(gl: GL) -> None:
    lit(gl)
    gl.glColorMaterial(gl.GL_FRONT, gl.GL_DIFFUSE)
    gl.glEnable(gl.GL_COLOR_MATERIAL)
    gl.glColor3f(0.2, 0.9, 0.4)
    sphere(gl)
    gl.glColorMaterial(gl.GL_FRONT_AND_BACK, gl.GL_EMISSION)
    gl.glTranslatef(0.5, 0.5, 0.5)
    gl.glColor3f(0.4, 0, 0)
    sphere(gl, 0.3)
    gl.glDisable(gl.GL_COLOR_MATERIAL)
    gl.glTranslatef(-1, 0, 0)
    gl.glColor3f(1, 1, 1)
    sphere(gl, 0.3)


def color_material_within_strip(gl: GL) -> None:
    lit(gl)
    gl.glEnable(gl.GL_COLOR_MATERIAL)
    gl.glNormal3f(0, 0, 1)
    gl.glBegin(gl.GL_TRIANGLE_STRIP)
    for i in range(40):
        gl.glColor3f(i / 40, 1 - i / 40, i % 2)
        gl.glVertex3f(i / 20 - 1, 0.5 * (i % 2), 0)
    gl.glEnd()


def unnormalised(gl: GL) -> None:
    lit(gl)
    gl.glScalef(0.5, 0.5, 0.5)
    sphere(gl)


def normalised(gl: GL) -> None:
    lit(gl)
    gl.glEnable(gl.GL_NORMALIZE)
    gl.glScalef(0.7, 1.1, 0.4)
    sphere(gl)


def rescaled(gl: GL) -> None:
    lit(gl)
    gl.glEnable(gl.GL_RESCALE_NORMAL)
    gl.glScalef(0.7, 0.7, 0.7)
    sphere(gl)


def transparent(gl: GL) -> None:
    lit(gl)
    gl.glEnable(gl.GL_BLEND)
    gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
    gl.glDisable(gl.GL_DEPTH_TEST)
    gl.glEnable(gl.GL_CULL_FACE)
    sphere(gl, 0.4)
    gl.glMaterialfv(gl.GL_FRONT, gl.GL_DIFFUSE, (1, 0, 0, 0.4))
    sphere(gl)


def front_faces(gl: GL) -> None:
    lit(gl)
    gl.glEnable(gl.GL_CULL_FACE)
    gl.glFrontFace(gl.GL_CW)
    sphere(gl)


def flat(gl: GL) -> None:
    lit(gl)
    gl.glShadeModel(gl.GL_FLAT)
    sphere(gl)


def lights_come_and_go(gl: GL) -> None:
    lit(gl)
    for i in range(9):
        if i % 3 == 0:
            (gl.glDisable if i % 2 else gl.glEnable)(gl.GL_LIGHTING)
        (gl.glEnable if i % 4 else gl.glDisable)(gl.GL_LIGHT0)
        gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, (1, i - 4, 1, i % 2))
        gl.glColor3f(i / 9, 0.5, 1)
        gl.glPushMatrix()
        gl.glTranslatef(i % 3 / 2 - 0.5, i // 3 / 2 - 0.5, 0)
        sphere(gl, 0.24)
        gl.glPopMatrix()


def light_moves_with_the_model(gl: GL) -> None:
    lit(gl)
    gl.glPushMatrix()
    gl.glRotatef(120, 0, 0, 1)
    gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, (2, 0, 1, 1))
    gl.glPopMatrix()
    sphere(gl)


SCENES = (
    directional,
    positional,
    homogeneous_position,
    spot,
    shining,
    shininess_zero,
    local_viewer,
    several_lights,
    two_sided,
    separate_specular,
    color_material,
    color_material_within_strip,
    unnormalised,
    normalised,
    rescaled,
    transparent,
    front_faces,
    flat,
    lights_come_and_go,
    light_moves_with_the_model,
)


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.__name__)
def test_light_falls_as_on_the_monitor(beside: Beside, scene: object) -> None:
    beside.equal(scene)


@pytest.mark.parametrize("mode", ["GL_LINEAR", "GL_EXP", "GL_EXP2"])
def test_fog_of_every_mode(beside: Beside, mode: str) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        gl.glEnable(gl.GL_FOG)
        gl.glFogi(gl.GL_FOG_MODE, getattr(gl, mode))
        gl.glFogf(gl.GL_FOG_START, DISTANCE - 1)
        gl.glFogf(gl.GL_FOG_END, DISTANCE + 1)
        gl.glFogf(gl.GL_FOG_DENSITY, 0.7 / DISTANCE)
        gl.glFogfv(gl.GL_FOG_COLOR, (0.2, 0.9, 0.3, 1))
        gl.glRotatef(60, 0, 1, 0)
        gl.glColor3f(1, 0.3, 0)
        gl.glRectf(-1.4, -0.8, 1.4, 0.8)

    beside.equal(scene, name=f"fog {mode}")


def test_fog_coordinates(beside: Beside) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        gl.glEnable(gl.GL_FOG)
        gl.glFogi(gl.GL_FOG_MODE, gl.GL_LINEAR)
        gl.glFogf(gl.GL_FOG_START, 0)
        gl.glFogf(gl.GL_FOG_END, 1)
        gl.glFogi(gl.GL_FOG_COORD_SRC, gl.GL_FOG_COORD)
        gl.glFogfv(gl.GL_FOG_COLOR, (1, 1, 0, 1))
        gl.glBegin(gl.GL_QUADS)
        for (x, y), coordinate in zip(((-1, -1), (1, -1), (1, 1), (-1, 1)), (0, 0.3, 1, 0.6), strict=True):
            gl.glFogCoordf(coordinate)
            gl.glVertex2f(0.8 * x, 0.8 * y)
        gl.glEnd()

    beside.equal(scene)


@pytest.mark.parametrize("stack", ["look-at on PROJECTION", "perspective on MODELVIEW"])
@pytest.mark.parametrize("what", ["light", "spot", "fog", "sphere map", "reflection", "eye", "shine"])
def test_untidy_matrices_change_nothing(beside: Beside, stack: str, what: str) -> None:
    def scene(gl: GL) -> None:
        looking(gl)
        gl.glLoadIdentity()
        gl.glMatrixMode(gl.GL_PROJECTION if "PROJ" in stack else gl.GL_MODELVIEW)
        if "MODEL" in stack:
            gl.glMatrixMode(gl.GL_PROJECTION)
            gl.glLoadIdentity()
            gl.glMatrixMode(gl.GL_MODELVIEW)
            gl.gluPerspective(1, 1, DISTANCE - 4, DISTANCE + 4)
        gl.gluLookAt(0, DISTANCE * 0.6, DISTANCE * 0.8, 0, 0, 0, 0, 1, 0)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        if what in ("light", "shine", "spot"):
            gl.glEnable(gl.GL_LIGHTING)
            gl.glEnable(gl.GL_LIGHT0)
            gl.glEnable(gl.GL_NORMALIZE)
            gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, (1, 2, 3, 1))
            if what == "spot":
                gl.glLightfv(gl.GL_LIGHT0, gl.GL_SPOT_DIRECTION, (-1, -2, -3))
                gl.glLightf(gl.GL_LIGHT0, gl.GL_SPOT_CUTOFF, 8)
            if what == "shine":
                gl.glMaterialfv(gl.GL_FRONT, gl.GL_SPECULAR, (1, 1, 0.5, 1))
                gl.glMaterialf(gl.GL_FRONT, gl.GL_SHININESS, 8)
                gl.glLightModeli(gl.GL_LIGHT_MODEL_LOCAL_VIEWER, 1)
        elif what == "fog":
            gl.glEnable(gl.GL_FOG)
            gl.glFogi(gl.GL_FOG_MODE, gl.GL_LINEAR)
            at = 0 if "PROJ" in stack else DISTANCE
            near = -1 if "MODEL" in stack else 0
            gl.glFogf(gl.GL_FOG_START, near if at else 0)
            gl.glFogf(gl.GL_FOG_END, 4 if at else 0.7)
        else:
            checks(gl)
            mode = {
                "sphere map": gl.GL_SPHERE_MAP,
                "reflection": gl.GL_REFLECTION_MAP,
                "eye": gl.GL_EYE_LINEAR,
            }[what]
            for axis in ("S", "T"):
                gl.glTexGeni(getattr(gl, f"GL_{axis}"), gl.GL_TEXTURE_GEN_MODE, mode)
                gl.glEnable(getattr(gl, f"GL_TEXTURE_GEN_{axis}"))
        sphere(gl)

    beside.equal(scene, name=f"{what}, {stack}")
