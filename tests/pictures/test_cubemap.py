"""Method cubemap shows what the direct methods show, and the program notices nothing of its faces."""

import subprocess
import sys
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from scipy import ndimage

from tests.pictures.beside import SIZE, checks, looking, sphere
from tests.pictures.own_glsl import COLOUR, COLOURED, both

CUBE = {"method": "cubemap"}


def lit(gl):
    looking(gl)
    for capability in (gl.GL_LIGHTING, gl.GL_LIGHT0, gl.GL_NORMALIZE):
        gl.glEnable(capability)
    gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, (1, 1, 2, 1))
    sphere(gl)


def textured_in_fog(gl):
    looking(gl)
    checks(gl)
    gl.glEnable(gl.GL_FOG)
    gl.glFogi(gl.GL_FOG_MODE, gl.GL_LINEAR)
    gl.glFogf(gl.GL_FOG_START, 100)
    gl.glFogf(gl.GL_FOG_END, 130)
    sphere(gl)


def stencilled(gl):
    looking(gl)
    gl.glEnable(gl.GL_STENCIL_TEST)
    gl.glStencilFunc(gl.GL_ALWAYS, 1, 1)
    gl.glStencilOp(gl.GL_KEEP, gl.GL_KEEP, gl.GL_REPLACE)
    gl.glColor3f(0, 0, 1)
    gl.glRectf(-0.5, -0.4, 0.2, 0.6)
    gl.glStencilFunc(gl.GL_EQUAL, 1, 1)
    gl.glDisable(gl.GL_DEPTH_TEST)
    gl.glColor3f(1, 1, 0)
    gl.glRectf(-0.1, -0.7, 0.7, 0.5)


def scissored(gl):
    looking(gl)
    gl.glEnable(gl.GL_SCISSOR_TEST)
    gl.glScissor(64, 40, 100, 120)
    gl.glClearColor(0, 0.5, 0, 1)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT)
    sphere(gl)
    return tuple(gl.glGetIntegerv(gl.GL_SCISSOR_BOX)), bool(gl.glIsEnabled(gl.GL_SCISSOR_TEST))


def under_a_hud(gl):
    looking(gl)
    sphere(gl, 0.5)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gl.gluOrtho2D(0, SIZE, 0, SIZE)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glLoadIdentity()
    gl.glDisable(gl.GL_DEPTH_TEST)
    gl.glColor3f(1, 0, 0)
    gl.glRectf(100, 100, 180, 140)


def with_text(gl):
    looking(gl)
    gl.glColor3f(0, 1, 1)
    gl.glRasterPos2f(-0.3, 0.1)
    gl.glColor3f(1, 0, 0)  # comes too late for the bitmap
    gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
    for _ in range(3):
        gl.glBitmap(16, 16, 2, 3, 18, 0, bytes(range(7, 71, 2)))
    gl.glWindowPos2i(60, 90)
    gl.glDrawPixels(20, 14, gl.GL_RGB, gl.GL_UNSIGNED_BYTE, np.full((14, 20, 3), 200, np.uint8))
    return gl.glGetBooleanv(gl.GL_CURRENT_RASTER_POSITION_VALID)


SCENES = (lit, textured_in_fog, stencilled, scissored, under_a_hud, with_text)


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.__name__)
def test_one_face_is_the_monitor_under_a_narrow_lens(beside, scene):
    beside.equal(scene, name=f"cubemap_{scene.__name__}", wrong=0.006, **CUBE)


def room(gl):
    """Walls of checks in every direction, by a list that turns as it goes."""
    gl.glClearColor(0.2, 0, 0, 1)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gl.gluPerspective(60, 1, 0.1, 100)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glLoadIdentity()
    gl.glNewList(1, gl.GL_COMPILE)
    gl.glBegin(gl.GL_QUADS)
    for i in range(8):
        for j in range(8):
            gl.glColor3f((i + j) % 2, i / 8, j / 8)
            for x, y in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                gl.glVertex3f(x / 4 - 1, y / 4 - 1, -1)
    gl.glEnd()
    gl.glRotatef(90, 0, 1, 0)
    gl.glEndList()
    gl.glPushMatrix()
    gl.glRotatef(20, 1, 1, 0)
    gl.glScalef(3, 3, 3)
    for _ in range(4):
        gl.glCallList(1)
    gl.glRotatef(90, 1, 0, 0)
    gl.glCallList(1)
    gl.glRotatef(-90, 0, 1, 0)
    gl.glRotatef(180, 1, 0, 0)
    gl.glCallList(1)
    gl.glPopMatrix()


def unlike_all_around(one, other):
    """The share of the disc's pixels of one that are unlike everything within two pixels of the other."""
    low, high = ndimage.minimum_filter(other, (5, 5, 1)), ndimage.maximum_filter(other, (5, 5, 1))
    beyond = ((one < low.astype(int) - 30) | (one > high.astype(int) + 30)).any(-1)
    rows, columns = np.mgrid[: len(one), : len(one)] - (len(one) - 1) / 2
    return beyond[np.hypot(rows, columns) < len(one) / 2 - 2].mean()


@pytest.mark.parametrize(("fov", "tilt"), [(60, 0), (100, 0), (180, 0), (180, 60), (240, 30), (300, 0)])
def test_faces_show_what_the_direct_method_shows(beside, fov, tilt):
    direct = beside.through_dome(room, fov=float(fov), tilt=float(tilt)).picture
    cube = beside.through_dome(room, fov=float(fov), tilt=float(tilt), **CUBE).picture
    assert direct.std() > 20
    assert unlike_all_around(cube, direct) < 2e-3
    assert unlike_all_around(direct, cube) < 2e-3


def test_the_whole_sphere_is_shown(beside):
    def inside(gl):
        room(gl)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
        gl.glColor3f(0, 1, 0)
        sphere(gl, 5.0)

    picture = beside.through_dome(inside, fov=360.0, **CUBE).picture
    middles = np.arange(SIZE) + 0.5 - SIZE / 2
    disc = np.hypot(*np.meshgrid(middles, middles)) < SIZE / 2 - 1
    assert (picture[disc] == (0, 255, 0)).all()


def test_the_programs_own_glsl_reaches_beyond_the_monitors_window(beside):
    """A floor as wide as the dome by the program's own shaders: no face cuts it at the monitor's edges."""

    def floor(gl, *, own):
        gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glLoadIdentity()
        gl.gluPerspective(60, 1, 0.1, 100)
        if own:
            gl.glUseProgram(both(gl, COLOURED, COLOUR))
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glLoadIdentity()
        gl.glRotatef(90, 1, 0, 0)
        gl.glColor3f(1, 0, 0)
        gl.glBegin(gl.GL_QUADS)
        for x, y in ((-50, -50), (50, -50), (50, 50), (-50, 50)):
            gl.glVertex3f(x, y, 1)
        gl.glEnd()
        gl.glUseProgram(0)

    plain, own = (
        beside.through_dome(partial(floor, own=o), fov=180.0, **CUBE).picture for o in (False, True)
    )
    assert (plain == (255, 0, 0)).all(-1).mean() > 0.3
    assert (plain == own).all()


def test_a_draw_leaves_behind_what_one_draw_leaves(beside):
    """Attributes, matrices and the raster position after lists that change them between their draws."""

    def scene(gl):
        room(gl)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glNewList(2, gl.GL_COMPILE)
        gl.glBegin(gl.GL_TRIANGLES)
        gl.glVertex3f(0, 0, -3)  # in the colour of before
        gl.glColor3f(0.25, 0.5, 0.75)
        gl.glVertex3f(1, 0, -3)
        gl.glVertex3f(0, 1, -3)
        gl.glEnd()
        gl.glTranslatef(0.5, 0, 0)
        gl.glPushMatrix()
        gl.glRectf(0, 0, 1, 1)
        gl.glTranslatef(0, 0.5, 0)
        gl.glEndList()
        gl.glNewList(3, gl.GL_COMPILE)
        gl.glBitmap(8, 1, 0, 0, 9, 2, b"\xff")
        gl.glPopMatrix()
        gl.glEndList()
        gl.glRasterPos3f(0, 0, -3)
        before = np.array(beside.stock.glGetFloatv(gl.GL_CURRENT_RASTER_POSITION))  # in the frame's pixels
        for name in (2, 3, 2, 3):
            gl.glCallList(name)
        moved = np.array(beside.stock.glGetFloatv(gl.GL_CURRENT_RASTER_POSITION)) - before
        return (
            np.array(gl.glGetFloatv(gl.GL_CURRENT_COLOR)),
            np.array(gl.glGetFloatv(gl.GL_MODELVIEW_MATRIX)),
            int(gl.glGetIntegerv(gl.GL_MODELVIEW_STACK_DEPTH)),
            moved[:2],
        )

    monitor = beside.monitor(scene).answer
    cube = beside.through_dome(scene, fov=180.0, **CUBE).answer
    for one, other in zip(cube, monitor, strict=True):
        np.testing.assert_allclose(one, other, atol=1e-5)


def everything(gl):
    """What GL says of itself, as far as the faces' making and resampling could touch it."""
    stock = gl
    names = [
        *("VIEWPORT", "SCISSOR_BOX", "CURRENT_PROGRAM", "DRAW_FRAMEBUFFER_BINDING", "ACTIVE_TEXTURE"),
        *("READ_FRAMEBUFFER_BINDING", "RENDERBUFFER_BINDING", "VERTEX_ARRAY_BINDING", "TEXTURE_BINDING_2D"),
        *("ARRAY_BUFFER_BINDING", "UNPACK_ALIGNMENT", "UNPACK_ROW_LENGTH", "PACK_ALIGNMENT", "BLEND_SRC"),
        *("BLEND_DST", "DEPTH_FUNC", "DEPTH_WRITEMASK", "COLOR_WRITEMASK", "DRAW_BUFFER", "READ_BUFFER"),
        *("DEPTH_RANGE", "CURRENT_COLOR", "CURRENT_RASTER_POSITION", "MATRIX_MODE", "POLYGON_MODE"),
        *(
            "ATTRIB_STACK_DEPTH",
            "CLIENT_ATTRIB_STACK_DEPTH",
            "PIXEL_UNPACK_BUFFER_BINDING",
            "MODELVIEW_MATRIX",
        ),
    ]
    values = {name: np.ravel(stock.glGetDoublev(getattr(gl, f"GL_{name}"))).tolist() for name in names}
    capabilities = ("BLEND", "SCISSOR_TEST", "DEPTH_TEST", "CULL_FACE", "TEXTURE_2D", "PROGRAM_POINT_SIZE")
    more = ("PRIMITIVE_RESTART", "TEXTURE_CUBE_MAP_SEAMLESS", "MULTISAMPLE", "CLIP_PLANE0", "STENCIL_TEST")
    for name in (*capabilities, *more):
        values[name] = bool(stock.glIsEnabled(getattr(gl, f"GL_{name}")))
    return values


def test_gl_is_left_as_it_was(beside):
    def scene(gl):
        looking(gl)
        before = everything(beside.stock)
        sphere(gl)
        beside._dome.context.settle(deep=True)
        return before, everything(beside.stock)

    with beside.window((64, 64), fov=180.0) as finish:
        fresh = everything(beside.stock)
        finish()
    with beside.window((64, 64), fov=180.0, **CUBE) as finish:
        assert everything(beside.stock) == fresh
        before, after = scene(beside.dome)
        after["CURRENT_COLOR"], before["CURRENT_COLOR"] = 0, 0
        assert after == before
        finish()
        assert everything(beside.stock) | {"CURRENT_COLOR": 0} == before


def test_a_point_that_is_picked_is_found(beside):
    """Depth and colour of a pixel, and gluUnProject, as the monitor has them."""

    def scene(gl):
        looking(gl)
        gl.glColor3f(0, 1, 0)
        sphere(gl, 0.5)
        depth = gl.glReadPixels(150, 128, 1, 1, gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT)
        colour = gl.glReadPixels(150, 128, 1, 1, gl.GL_RGB, gl.GL_UNSIGNED_BYTE)
        return float(np.ravel(depth)[0]), bytes(np.asarray(bytearray(colour)))

    monitor, cube = beside.monitor(scene).answer, beside.through_dome(scene, **CUBE).answer
    assert cube[1] == monitor[1]
    assert abs(cube[0] - monitor[0]) < 2e-3


def test_a_picture_is_copied_and_accumulated(beside):
    def scene(gl):
        looking(gl)
        sphere(gl, 0.5)
        gl.glAccum(gl.GL_LOAD, 0.5)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
        gl.glTranslatef(0.3, 0, 0)
        sphere(gl, 0.4)
        gl.glAccum(gl.GL_ACCUM, 0.5)
        gl.glAccum(gl.GL_RETURN, 1)

    direct, cube = beside.through_dome(scene).picture, beside.through_dome(scene, **CUBE).picture
    assert direct.std() > 20
    beside.assert_equal(direct, cube, name="cubemap_accumulated", wrong=0.006)


def test_a_framebuffer_of_the_programs_own_is_drawn_as_on_the_monitor(beside):
    def scene(gl):
        looking(gl)
        texture, framebuffer = gl.glGenTextures(1), gl.glGenFramebuffers(1)
        gl.glBindTexture(gl.GL_TEXTURE_2D, texture)
        gl.glTexParameteri(gl.GL_TEXTURE_2D, gl.GL_TEXTURE_MIN_FILTER, gl.GL_LINEAR)
        gl.glTexImage2D(gl.GL_TEXTURE_2D, 0, gl.GL_RGBA, 64, 64, 0, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE, None)
        gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, framebuffer)
        gl.glFramebufferTexture2D(gl.GL_FRAMEBUFFER, gl.GL_COLOR_ATTACHMENT0, gl.GL_TEXTURE_2D, texture, 0)
        gl.glViewport(0, 0, 64, 64)
        gl.glClearColor(0, 0, 1, 1)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT)
        gl.glColor3f(1, 1, 0)
        gl.glRectf(0, 0, 0.9, 0.6)
        held = gl.glReadPixels(0, 0, 64, 64, gl.GL_RGB, gl.GL_UNSIGNED_BYTE)
        gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, 0)
        gl.glViewport(0, 0, SIZE, SIZE)
        gl.glColor3f(1, 1, 1)
        sphere(gl, 0.4)
        return bytes(np.asarray(bytearray(held)))

    for options in ({}, CUBE):
        beside.equal(scene, name=f"own_framebuffer_{len(options)}", wrong=0.006, **options)


def test_closing_the_window_frees_the_faces(beside):
    from domeshim.driver import Driver

    made = []
    with beside.window((64, 64), fov=180.0, **CUBE) as finish:
        room(beside.dome)
        finish()
        canvas = beside._dome.context.canvas
        made = [canvas._atlas.framebuffer, *(texture.value for texture in canvas._atlas.textures)]
        assert all(beside.stock.glIsTexture(name) for name in made[1:])
        window = beside.session.window
        beside.session.window_closed(window)
        assert not any(beside.stock.glIsTexture(name) for name in made[1:])
        assert not beside.stock.glIsFramebuffer(made[0])
        beside.session.window_opened(window, (64, 64))
    assert Driver().integer


def test_moderngl_is_imported_for_this_method_alone():
    code = (
        "import sys; from domeshim.state.context import DomeContext; from domeshim.intercept import gl;"
        "print('moderngl' in sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split()[-1] == "False"


def test_options_of_the_face(beside):
    assert replace(beside.options, method="cubemap:128").face_size == 128
    with beside.window((64, 64), fov=180.0, method="cubemap:128") as finish:
        assert beside._dome.context.canvas.views[0].viewport[2:] == (136, 136)
        finish()


def test_a_seat_off_the_centre_is_seen_through_the_faces(beside):
    options = {"fov": 180.0, "seat": (0.3, -0.2, 0.2), "radius": 1.0, "heading": 40.0, "roll": 20.0}
    one = beside.through_dome(room, **options, method="auto", tolerance=0.1).picture
    cube = beside.through_dome(room, **options, **CUBE).picture
    assert unlike_all_around(cube, one) < 2e-3
    assert unlike_all_around(one, cube) < 2e-3


def test_what_is_drawn_flat_lies_over_the_faces(beside):
    direct = beside.through_dome(under_a_hud, hud="flat").picture
    cube = beside.through_dome(under_a_hud, hud="flat", **CUBE).picture
    assert (direct == (255, 0, 0)).all(-1).sum() > 1000
    beside.assert_equal(direct, cube, name="cubemap_flat", wrong=0.006)


def test_it_is_said_where_the_scene_goes_on_over_what_is_flat(beside, capsys):
    def scene(gl):
        under_a_hud(gl)
        looking(gl)
        sphere(gl, 0.2)
        gl.glClear(0)

    def goes_on(gl):
        under_a_hud(gl)
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glLoadIdentity()
        gl.gluPerspective(1, 1, 100, 130)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glTranslatef(0, 0, -115)
        sphere(gl, 0.2)

    beside.through_dome(scene, hud="flat", **CUBE)
    assert "straight into the window" not in capsys.readouterr().err  # a clear begins anew
    beside.through_dome(goes_on, hud="flat", **CUBE)
    assert (
        capsys.readouterr().err.count("the scene goes on over what was drawn straight into the window") == 1
    )
