"""The bench's scenes are drawn as they are meant, and its figures tell good methods from bad ones."""

from __future__ import annotations

from contextlib import closing

import numpy as np
import pytest
from OpenGL import GL

from domeshim.bench.artist import Artist
from domeshim.bench.colour_error import colour_rms, true_picture
from domeshim.bench.contest import Contest
from domeshim.bench.methods import Method, asked, tolerances_of, usual
from domeshim.bench.scenes import SCENES, scene
from domeshim.bench.stage import Stage
from domeshim.errors import OptionError
from domeshim.lens.models import lens_of
from domeshim.options import Options

SIZE = 256
LENS = lens_of("equidistant", (), 180.0)
ON = Options(enabled=True)


def drawn(name: str, method: Method) -> np.ndarray:
    with closing(Stage(SIZE)) as stage:
        player = stage.dome(method.options(ON))
        player.show(Artist(player.gl, scene(name)).draw)
        return np.frombuffer(player.pixels(), np.uint8).reshape(SIZE, SIZE, 3)


@pytest.mark.parametrize("name", ["room", "panorama"])
def test_what_rays_meet_is_what_the_dome_shows(name):
    look = scene(name).look
    assert look is not None
    true = true_picture(look, LENS, SIZE)
    assert colour_rms(drawn(name, Method("auto", 0.1)), true) < 8
    assert colour_rms(np.zeros((SIZE, SIZE, 3), np.uint8), true) > 80


def test_a_wall_that_is_missing_is_told_by_its_colour():
    look = scene("room").look
    assert look is not None
    true = true_picture(look, LENS, SIZE)
    assert colour_rms(drawn("room", Method("paper")), true) > 40


@pytest.mark.parametrize("each", SCENES, ids=lambda each: each.name)
def test_stock_gl_and_the_dome_draw_every_scene_and_leave_no_error(each):
    with closing(Stage(64)) as stage:
        for player in (stage.stock(), stage.dome(ON)):
            player.show(Artist(player.gl, each).draw)
            assert any(player.pixels()), player
            assert GL.glGetError() == 0


def test_the_figures_of_lines_part_bent_from_straight():
    rows = list(
        Contest(ON, rounds=3, edges=6).rows(
            scene("lines"),
            SIZE,
            [Method("vertex"), Method("auto", 0.5), Method("cubemap:256")],
            lambda _: None,
        )
    )
    vertex, auto, cubemap = rows
    assert auto.edges is not None
    assert vertex.edges is not None
    assert cubemap.edges is not None
    assert auto.edges.largest <= 0.5 + 0.15  # the judge's own grain
    assert vertex.edges.largest > 10
    assert cubemap.edges.largest < 2
    assert all(row.cost.rounds == 3 and row.cost.ratio > 0 and row.cost.milliseconds > 0 for row in rows)


def test_a_finer_tolerance_gives_a_smaller_error():
    coarse, fine = Contest(ON, rounds=3, edges=6).rows(
        scene("lines"), SIZE, [Method("auto", 4.0), Method("auto", 0.2)], lambda _: None
    )
    assert coarse.edges is not None
    assert fine.edges is not None
    assert fine.edges.largest < coarse.edges.largest / 3


def test_methods_come_with_their_tolerances_and_face_sizes():
    assert [str(each) for each in asked(["auto", "paper"], 512, (0.1, 2.0))] == [
        "auto 0.1 px",
        "auto 2 px",
        "paper",
    ]
    assert [str(each) for each in asked(["cubemap"], 512, ())] == [
        "cubemap 256",
        "cubemap 512",
        "cubemap 1024",
    ]
    assert {each.family for each in usual(512, (0.5,))} == {
        *("paper", "vertex", "tessellate", "geometry", "cpu", "cubemap", "auto")
    }
    with pytest.raises(OptionError, match="--method=magic"):
        asked(["magic"], 512, ())
    with pytest.raises(OptionError, match=r"--tolerance=0\.1,x"):
        tolerances_of("0.1,x")
