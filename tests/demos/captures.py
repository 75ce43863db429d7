"""Captures demos as a user does, and looks at a dome's picture through a monitor's window."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from scipy import ndimage

from tests.waiting import LONGEST

ROOT = Path(__file__).resolve().parent.parent.parent
DEMOS = ROOT / "demos"
BY_DESIGN = "domeshim: long edges drawn by the program's own GLSL"
"""What is said of a mesh that is never looked at closely: glsl.py's is fine enough."""
Picture = NDArray[np.uint8]
"""(height, width, 3), the top row first."""


def environment(**more: str) -> dict[str, str]:
    """This process's, with the package and the demos to be found."""
    return {**os.environ, "PYTHONPATH": f"{ROOT}{os.pathsep}{DEMOS}", "PYTHONHASHSEED": "0", **more}


def capture(
    output: Path, program: Path, *arguments: str, options: tuple[str, ...] = ()
) -> tuple[Picture, str]:
    """The picture that `domeshim capture` takes of a program, and what the program printed."""
    run = subprocess.run(
        [
            sys.executable,
            "-m",
            "domeshim",
            "capture",
            *options,
            "--output",
            str(output),
            str(program),
            *arguments,
        ],
        env=environment(XDG_CACHE_HOME=str(output.parent / "cache")),
        cwd=output.parent,
        capture_output=True,
        text=True,
        timeout=LONGEST,
    )
    complaints = [line for line in run.stderr.splitlines() if not line.startswith(BY_DESIGN)]
    assert (run.returncode, complaints) == (0, [])
    return np.asarray(Image.open(output).convert("RGB")), run.stdout


def through_window(dome: Picture, size: int, fovy: float) -> Picture:
    """What a square monitor of so many pixels and degrees shows of a dome picture of 180 degrees."""
    across = (np.arange(size) + 0.5) / size * 2 - 1
    x, y = np.meshgrid(across * np.tan(np.radians(fovy / 2)), -across * np.tan(np.radians(fovy / 2)))
    phi, theta = np.arctan(np.hypot(x, y)), np.arctan2(y, x)
    half = dome.shape[0] / 2
    radius = phi / (np.pi / 2) * half
    places = half - radius * np.sin(theta) - 0.5, half + radius * np.cos(theta) - 0.5
    channels = [ndimage.map_coordinates(dome[..., c].astype(float), places, order=1) for c in range(3)]
    return np.stack(channels, -1).round().astype(np.uint8)
