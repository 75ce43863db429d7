"""Where draws are placed: true angles for the main perspective, the panel for the rest."""

import numpy as np
import pytest

from domeshim.options import Options
from domeshim.state.perspective import perspective
from domeshim.state.placement import Placer
from domeshim.window.frame import Frame
from tests.state.test_perspective import rigid

FRAME = Frame((800, 600), (800, 600))
FULL = (0, 0, 800, 600)
P = perspective(45, 800 / 600, 0.1, 100)


def matrix(placement):
    return np.array(placement.view).reshape(4, 4).T


def known(p=P, on_modelview=False, **options):
    placer = Placer(Options(**options))
    placer.perspective_set(p, on_modelview=on_modelview)
    return placer


def test_plain_perspective_is_the_programs_own_eye_space():
    assert known().place(P, None, FULL, FRAME).place == "modelview"


def test_float32_rounding_of_gl_does_not_matter():
    assert known().place(P.astype(np.float32).astype(float), None, FULL, FRAME).place == "modelview"


def test_look_at_on_projection_is_undone():
    v = rigid(3)
    placement = known().place(P @ v, None, FULL, FRAME)
    assert placement.place == "view"
    assert matrix(placement) == pytest.approx(v, abs=1e-9)


def test_perspective_on_modelview_is_undone():
    v = rigid(4)
    placement = known(on_modelview=True).place(np.eye(4), P @ v, FULL, FRAME)
    point = np.array([1, 2, -3, 1.0])
    assert matrix(placement) @ (P @ v @ point) == pytest.approx(v @ point, abs=1e-9)


def test_mirror_after_the_perspective_stays():
    mirror = np.diag([1, 1, -1, 1.0])
    assert matrix(known().place(P @ mirror, None, FULL, FRAME)) == pytest.approx(mirror, abs=1e-9)


def test_loaded_matrix_never_announced_is_understood():
    v = rigid(5)
    assert matrix(Placer(Options()).place(P @ v, None, FULL, FRAME)) == pytest.approx(v, abs=1e-6)


def test_of_two_perspectives_the_one_inside_is_taken():
    placer = known()
    placer.perspective_set(perspective(100, 1, 0.1, 100), on_modelview=False)
    assert placer.place(P, None, FULL, FRAME).place == "modelview"


def test_fill_widens_the_programs_own_view():
    placement = known(fill=90.0).place(P, None, FULL, FRAME)
    top = np.array([0, np.tan(np.radians(22.5)), -1, 1])
    _, y, z, _ = matrix(placement) @ top
    assert np.degrees(np.arctan2(y, -z)) == pytest.approx(45)


def panel_direction(placement, clip):
    d = (matrix(placement) @ clip)[:3]
    return d / -d[2]


def test_hud_lies_where_it_stood_on_the_monitor():
    placer = known()
    placer.place(P, None, FULL, FRAME)
    placement = placer.place(np.eye(4), None, FULL, FRAME)
    assert placement.place == "panel"
    assert placement.hud
    t = np.tan(np.radians(22.5))
    assert panel_direction(placement, [1, 1, 0, 1]) == pytest.approx([t * 800 / 600, t, -1])


def test_inset_viewport_lies_where_it_stood():
    placer = known()
    placer.place(P, None, FULL, FRAME)
    placement = placer.place(P, None, (600, 450, 200, 150), FRAME)
    t = np.tan(np.radians(22.5))
    assert placement.place == "panel"
    assert panel_direction(placement, [-1, -1, 0, 1]) == pytest.approx([t * 800 / 600 / 2, t / 2, -1])
    assert panel_direction(placement, [1, 1, 0, 1]) == pytest.approx([t * 800 / 600, t, -1])


def test_program_without_a_perspective_is_a_panel():
    placement = Placer(Options(panel=60.0)).place(np.eye(4), None, FULL, FRAME)
    t = np.tan(np.radians(30))
    assert not placement.hud
    assert panel_direction(placement, [0, 1, 0, 1]) == pytest.approx([0, t, -1])


def test_shadow_matrix_on_modelview_is_no_perspective():
    shadow = np.array([[1, 0, 0, 0], [0, 0, 0, 0], [0, 0, 1, 0], [0, -0.2, 0, 1.0]])
    assert known().place(P, shadow, FULL, FRAME).place == "modelview"
