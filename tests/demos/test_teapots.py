"""The teapots, an ordinary GLUT program, as they come out on the monitor and on the dome."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

from tests.waiting import LONGEST

ROOT = Path(__file__).resolve().parent.parent.parent
DEMO = ROOT / "demos" / "teapots.py"
SIZE = 160
PLACES = ("far", "closer", "closest", "inside")
Picture = NDArray[np.int_]
Take = Callable[..., Picture]


@pytest.fixture(scope="module")
def take(tmp_path_factory: pytest.TempPathFactory) -> Take:
    """Captures the demo in a mode, with arguments; each picture once: (SIZE, SIZE, 3), the top row first."""
    folder = tmp_path_factory.mktemp("teapots")

    def take(mode: str, *arguments: str) -> Picture:
        output = folder / f"{mode}-{'-'.join(arguments)}.png"
        if not output.exists():
            options = ["--mode", mode, "--size", str(SIZE), "--output", str(output)]
            run = subprocess.run(
                [sys.executable, "-m", "domeshim", "capture", *options, str(DEMO), *arguments],
                env={**os.environ, "PYTHONPATH": str(ROOT)},
                cwd=folder,
                capture_output=True,
                text=True,
                timeout=LONGEST,
            )
            assert (run.returncode, run.stderr) == (0, "")
            assert run.stdout.startswith("Keys: 1 far")
        return np.asarray(Image.open(output).convert("RGB"), int)

    return take


def disc() -> tuple[Picture, Picture]:
    """x and y of each pixel's centre, 1 at the rim, y up."""
    centre = (np.arange(SIZE) + 0.5) / SIZE * 2 - 1
    x, y = np.meshgrid(centre, -centre)
    return x, y


def content(picture: Picture) -> Picture:
    """Where there is something other than the program's background and black."""
    background = np.array([0.06, 0.08, 0.16]) * 255
    return (abs(picture - background).max(-1) > 12) & (picture.max(-1) > 12)


@pytest.mark.parametrize("drawn", ["--solid", "--wire"])
@pytest.mark.parametrize("mode", ["monitor", "dome"])
def test_the_teapots_grow_as_the_eye_comes_closer(take: Take, mode: str, drawn: str):
    places = PLACES[:3] if mode == "dome" else PLACES[:2]
    shares = [content(take(mode, place, drawn)).mean() for place in places]
    assert shares[0] > 0.01
    assert all(nearer > 1.4 * farther for farther, nearer in pairwise(shares)), shares


@pytest.mark.parametrize("mode", ["monitor", "dome"])
def test_each_distance_is_a_picture_of_its_own(take: Take, mode: str):
    pictures = [take(mode, place).tobytes() for place in PLACES]
    assert len(set(pictures)) == len(PLACES)
    assert take(mode, "closest", "--wire").tobytes() not in pictures
    assert take(mode, "closest", "--solid").tobytes() in pictures


@pytest.mark.parametrize("place", PLACES)
def test_the_dome_is_black_outside_the_rim_and_nowhere_inside(take: Take, place: str):
    radius = np.hypot(*disc())
    picture = take("dome", place)
    assert picture[radius > 1.0].max() == 0
    assert picture[radius < 0.97].max(-1).min() > 12
    assert take("monitor", place).max(-1).min() > 12


def test_far_away_the_teapots_stand_together_in_front(take: Take):
    x, y = disc()
    seen = content(take("dome", "far"))
    # The group reaches 5.5 from its middle at most, which is 12 away.
    assert np.hypot(x[seen], y[seen]).max() < np.degrees(np.arcsin(5.5 / 12)) / 90
    assert abs(x[seen].mean()) < 0.02
    assert abs(y[seen].mean()) < 0.02


def test_close_by_each_teapot_stands_in_its_own_direction(take: Take):
    """(angle from the axis, direction on the disc, degrees; the colour's channels from strong to weak)."""
    corner = np.degrees(np.arccos(1 / np.sqrt(3)))
    expected = {
        "red": (88, 180, "rgb"),
        "blue": (88, 0, "bgr"),
        "yellow": (85, 90, "rgb"),
        "violet": (85, 270, "brg"),
        "orange": (corner, 135, "rgb"),
        "green": (corner, 45, "gbr"),
        "cyan": (corner, 225, "bgr"),
        "pink": (corner, 315, "rbg"),
    }
    picture = take("dome", "closest")
    for name, (phi, theta, channels) in expected.items():
        x, y = phi / 90 * np.cos(np.radians(theta)), phi / 90 * np.sin(np.radians(theta))
        pixel = picture[int((1 - y) / 2 * SIZE), int((1 + x) / 2 * SIZE)]
        values = [pixel["rgb".index(channel)] for channel in channels]
        assert values == sorted(values, reverse=True), (name, pixel)
        assert values[0] > values[2] + 20, (name, pixel)


def test_inside_it_is_all_around(take: Take):
    radius = np.hypot(*disc())
    assert content(take("dome", "inside"))[radius < 0.9].all()


def test_the_same_program_draws_the_same_picture_each_time(take: Take):
    assert np.array_equal(take("dome", "closer"), take("dome", "closer", "--solid"))


def test_a_place_that_does_not_exist_is_one_clear_line():
    run = subprocess.run(
        [sys.executable, str(DEMO), "nowhere"], capture_output=True, text=True, timeout=LONGEST
    )
    assert run.returncode == 2
    assert "invalid choice: 'nowhere'" in run.stderr
    assert "Traceback" not in run.stderr
