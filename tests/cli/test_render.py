"""domeshim render: what its options ask for, and what it refuses before anything runs."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.render.conftest import ROOT
from tests.render.programs import CLEARS, SPINNER
from tests.waiting import LONGEST


def render(folder: Path, *args: str) -> subprocess.CompletedProcess[str]:
    (folder / "spinner.py").write_text(SPINNER.replace("{}", CLEARS))
    environment = {name: value for name, value in os.environ.items() if not name.startswith("DOME")}
    environment.pop("PYOPENGL_PLATFORM", None)
    return subprocess.run(
        [sys.executable, "-m", "domeshim", "render", *args],
        capture_output=True,
        text=True,
        timeout=LONGEST,
        cwd=folder,
        env={**environment, "PYTHONPATH": str(ROOT)},
    )


def test_two_eyes_in_tiles(tmp_path: Path):
    options = (
        "--frames",
        "2",
        "--size",
        "64",
        "--tile",
        "64",
        "--supersample",
        "2",
        "--stereo",
        "--eyes",
        "0.5",
    )
    done = render(tmp_path, *options, "--output", "show", "spinner.py")
    assert done.returncode == 0, done.stderr
    left, right = (np.asarray(Image.open(tmp_path / "show" / eye / "spinner_000002.png")) for eye in "LR")
    assert left.shape == right.shape == (64, 64, 3)
    assert (left != right).any()
    assert render(tmp_path, "--check", "show").returncode == 0
    (tmp_path / "show" / "R" / "spinner_000002.png").unlink()
    checked = render(tmp_path, "--check", "show")
    assert checked.returncode == 1
    assert "R/spinner_000002.png: missing" in checked.stdout


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--tile", "64", "--mirror", "horizontal"], "--mirror is not to be had in tiles"),
        (["--size", "8192", "--supersample", "2", "--hud", "flat"], "--hud is not to be had in tiles"),
        (["--size", "8192", "--supersample", "8"], "at most 32768"),
        (["--video", "show.gif"], "accepted"),
    ],
)
def test_what_cannot_be_is_one_line(tmp_path: Path, options: list[str], said: str):
    done = render(tmp_path, "--frames", "1", "--output", "show", *options, "spinner.py")
    assert done.returncode == 2
    assert said in done.stderr
    assert done.stderr.count("\n") == 1
