"""Pictures put together of tiles are those that are drawn whole."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from domeshim.render.plan import Plan
from domeshim.render.show import Alone, render
from domeshim.window.frame import Frame
from tests.render.conftest import contents
from tests.render.programs import CLEARS, PAINTS, SHARDS

OPTIONS = {"hud": "panel", "fov": "200"}


def picture(plan: Plan) -> np.ndarray:
    return np.asarray(Image.open(plan.path(2))).astype(int)


@pytest.fixture
def whole(make_plan, progress):
    plan = make_plan(2, 2, "whole", PAINTS)
    plan = replace(plan, size=96, reel=replace(plan.reel, side=96, settings=OPTIONS))
    render(plan, Alone(), progress)
    assert len(np.unique(picture(plan).reshape(-1, 3), axis=0)) > 8
    return plan


def test_lines_points_and_text_are_the_same_in_tiles(whole, progress):
    tiled = replace(whole, tile=40, output=whole.output.with_name("tiled"))
    assert len(tiled.parts) == 9
    manifest = render(tiled, Alone(), progress)
    assert not manifest.failed
    assert np.abs(picture(tiled) - picture(whole)).max() <= 1


def test_averaged_tiles(whole, progress):
    fine = replace(whole, reel=replace(whole.reel, side=192), output=whole.output.with_name("fine"))
    tiled = replace(fine, tile=100, output=whole.output.with_name("tiled"))
    for plan in (fine, tiled):
        render(plan, Alone(), progress)
    assert np.abs(picture(tiled) - picture(fine)).max() <= 1


def test_every_edge_falls_to_the_same_side(make_plan, progress):
    whole, tiled = (
        make_plan(2, 2, name, SHARDS, size=1024, tile=tile) for name, tile in (("whole", 0), ("tiled", 600))
    )
    for plan in (whole, tiled):
        render(replace(plan, reel=replace(plan.reel, side=1024)), Alone(), progress)
    assert (picture(whole).max(-1) > 0).mean() > 0.1
    assert np.array_equal(picture(tiled), picture(whole))


def test_a_row_of_pictures_in_tiles(make_plan, progress):
    whole, tiled = make_plan(1, 3, "whole", CLEARS), make_plan(1, 3, "tiled", CLEARS, tile=40)
    for plan in (whole, tiled):
        render(plan, Alone(), progress)
    pixels = [
        [np.asarray(Image.open(plan.path(n))).astype(int) for n in (1, 2, 3)] for plan in (whole, tiled)
    ]
    assert np.abs(np.subtract(*pixels)).max() <= 1
    assert len(contents(tiled)) == 3


@pytest.mark.parametrize("part", [(0, 0, 40, 40), (80, 0, 16, 40), (40, 40, 40, 40)])
@pytest.mark.parametrize("viewport", [96, 50])
def test_all_stands_where_it_stood(part, viewport):
    frame = Frame((96, 96), (96, 96))
    cut = frame.cut(part, viewport)
    disc = np.random.default_rng(0).uniform(-1, 1, (20, 2))
    assert cut.size == part[2:]
    np.testing.assert_allclose(cut.place_of(disc) + part[:2], frame.place_of(disc), atol=1e-9)
    x, y, side, _ = cut.square
    assert side == min(viewport, 96)
    assert x <= 0
    assert y <= 0
    assert x + side >= part[2]
    assert y + side >= part[3]
