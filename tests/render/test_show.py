"""Rendering in one process: passing by, resuming, failing, checking."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from domeshim.render.manifest import Manifest
from domeshim.render.show import Alone, render
from tests.render.conftest import contents
from tests.render.programs import BUILDS, CLEARS, CRASHES, ENDS, LISTS, READS


@pytest.mark.parametrize(
    "does", [CLEARS, BUILDS, READS, LISTS], ids=["clears", "builds", "reads", "lists of large triangles"]
)
def test_pictures_after_others_are_what_they_are_in_the_whole_show(make_plan, progress, does):
    whole, part = make_plan(1, 6, "whole", does), make_plan(5, 6, "part", does)
    render(whole, Alone(), progress)
    render(part, Alone(), progress)
    shown = contents(whole)
    assert len(set(shown.values())) == 6
    assert contents(part) == {name: shown[name] for name in ("spinner_000005.png", "spinner_000006.png")}


def test_picture_shows_the_program(make_plan, progress):
    plan = make_plan(1, 1)
    render(plan, Alone(), progress)
    pixels = np.asarray(Image.open(plan.path(1)))
    assert pixels.shape == (64, 64, 3)
    assert all((pixels[..., channel] > 100).sum() > 10 for channel in range(3))


def test_only_what_is_missing_is_made_again(make_plan, progress):
    plan = make_plan(1, 4)
    render(plan, Alone(), progress)
    before = contents(plan)
    kept = plan.path(1).stat().st_mtime_ns
    plan.path(3).unlink()
    render(plan, Alone(), progress)
    assert contents(plan) == before
    assert progress.done == 3
    assert plan.path(1).stat().st_mtime_ns == kept


def test_a_part_made_later_joins_the_others(make_plan, progress):
    for first, last in ((1, 2), (4, 5), (2, 3)):
        render(make_plan(first, last), Alone(), progress)
    manifest = Manifest.load(make_plan(1, 5).output)
    assert len(manifest.keys) == 5
    assert not manifest.complaints()
    make_plan(1, 5).path(5).unlink()
    assert manifest.complaints() == {"spinner_000005.png": "missing"}


def test_another_plan_does_not_count_as_made(make_plan, progress):
    render(make_plan(1, 2), Alone(), progress)
    larger = make_plan(1, 2)
    render(
        replace(larger, reel=replace(larger.reel, settings={"hud": "off", "fov": "220"})), Alone(), progress
    )
    assert progress.done == 0


def test_supersampled_picture_is_an_average(make_plan, progress):
    plan = make_plan(1, 1)
    fine = replace(plan, reel=replace(plan.reel, side=256))
    render(fine, Alone(), progress)
    assert Image.open(plan.path(1)).size == (64, 64)


def test_names_numbers_and_format(make_plan, progress):
    plan = make_plan(2, 3, name="Show", suffix="tif", offset=98)
    render(plan, Alone(), progress)
    assert sorted(path.name for path in plan.output.glob("*.tif")) == ["Show_000100.tif", "Show_000101.tif"]
    assert not Manifest.load(plan.output).complaints()


def test_program_that_ends_is_said(make_plan, progress):
    manifest = render(make_plan(3, 8, does=ENDS), Alone(), progress)
    assert sorted(manifest.hashes) == ["spinner_000003.png", "spinner_000004.png"]
    assert sorted(manifest.failed) == [f"spinner_00000{n}.png" for n in (5, 6, 7, 8)]


def test_picture_that_fails_three_times_is_named(make_plan, progress):
    manifest = render(make_plan(1, 3, does=CRASHES), Alone(), progress)
    assert set(manifest.failed) == {"spinner_000003.png"}
    assert "exit status 7" in manifest.failed["spinner_000003.png"]


def test_check_finds_missing_broken_and_changed_pictures(make_plan, progress):
    plan = make_plan(1, 4)
    render(plan, Alone(), progress)
    plan.path(1).unlink()
    plan.path(2).write_bytes(plan.path(2).read_bytes()[:200])
    plan.path(3).write_bytes(plan.path(4).read_bytes())
    assert Manifest.load(plan.output).complaints() == {
        "spinner_000001.png": "missing",
        "spinner_000002.png": "not a whole picture",
        "spinner_000003.png": "differs from what was rendered",
    }
