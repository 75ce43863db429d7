"""A textured room around the viewer: each method's picture beside the one that rays say is right."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from domeshim.errors import DomeError

Floats = NDArray[np.float64]

TEXELS = 1024
SIZE = 1024
FOV = 180.0
METHODS = ("paper", "vertex", "tessellate", "geometry", "cpu", "cubemap:1024", "auto")
"""The yardstick with faces as large as the picture."""
_LOW, _HIGH = np.array([-2.0, -1.5, -3.0]), np.array([3.0, 2.0, 1.5])
_FINER = 4
"""Rays a pixel and axis."""
_INNER = 0.99
"""The share of the disc's radius that is looked at: the rim's own pixels are half black."""


def _faces() -> Iterator[Floats]:
    """(4, 3) corners of each wall: s grows from the first to the second, t from the first to the last."""
    for axis in range(3):
        across, up = (axis + 1) % 3, (axis + 2) % 3
        for end in (_LOW, _HIGH):
            corners = np.empty((4, 3))
            corners[:, axis] = end[axis]
            corners[:, across] = _LOW[across], _HIGH[across], _HIGH[across], _LOW[across]
            corners[:, up] = _LOW[up], _LOW[up], _HIGH[up], _HIGH[up]
            yield corners


FACES = tuple(_faces())
"""The room's six walls, two for each axis, the lower end first."""


@dataclass(frozen=True)
class RoomError:
    """How far one method's picture of the room is from the true one."""

    method: str
    rms: float
    """Root of the mean square of the differences of all channels of all pixels of the disc, of 255."""
    wrong: float
    """The share of the pixels with a channel off by more than 8 of 255."""


def colors(face: int, s: Floats, t: Floats) -> Floats:
    """(..., 3), 0 to 1: a wall's colour at texture coordinates, a few waves and a shade of its own."""
    waves = (
        np.sin(2 * np.pi * (5 * s + face / 6)),
        np.sin(2 * np.pi * (6 * t)),
        np.sin(2 * np.pi * 4 * (s + t)),
    )
    return np.asarray(0.5 + 0.4 * np.stack(waves, -1) + 0.1 * np.cos(face + np.arange(3)))


def cast(directions: Floats, paint: Callable[[int, Floats, Floats], Floats] = colors) -> Floats:
    """(..., 3) colours that rays from the origin meet in the room.

    directions: (..., 3); paint: what is painted on a wall at its texture coordinates.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        ways = np.where(directions > 0, _HIGH, _LOW) / directions
    ways = np.where(np.isfinite(ways), ways, np.inf)
    axis = ways.argmin(-1)
    points = directions * np.take_along_axis(ways, axis[..., None], -1)
    share = (points - _LOW) / (_HIGH - _LOW)
    seen = np.zeros(directions.shape)
    for face in range(6):
        k = face // 2
        here = (axis == k) & ((directions[..., k] > 0) == (face % 2 == 1))
        seen[here] = paint(face, share[here][:, (k + 1) % 3], share[here][:, (k + 2) % 3])
    return seen


def true_picture(size: int = SIZE) -> Floats:
    """(size, size, 3), 0 to 255, the top row first: the room on an equidistant disc, each pixel's mean."""
    fine = size * _FINER
    across = (2 * np.arange(fine) + 1 - fine) / fine
    rows = []
    for band in np.split(-across, size):
        x, y = np.meshgrid(across, band)
        radius = np.hypot(x, y)
        phi = radius * np.radians(FOV / 2)
        away = np.sin(phi) / radius
        seen = cast(np.stack([x * away, y * away, -np.cos(phi)], -1))
        rows.append(seen.reshape(_FINER, size, _FINER, 3).mean((0, 2)))
    return 255 * np.array(rows)


def room_errors(methods: Sequence[str] = METHODS, size: int = SIZE) -> list[RoomError]:
    """Each method's picture of the room against the true one.

    Raises DomeError where a picture cannot be taken.
    """
    true = true_picture(size)
    across = (2 * np.arange(size) + 1 - size) / size
    disc = np.hypot(*np.meshgrid(across, across)) < _INNER
    found = []
    for method in methods:
        off = np.abs(_picture(method, size) - true)[disc]
        found.append(RoomError(method, float(np.sqrt((off**2).mean())), float((off.max(-1) > 8).mean())))
    return found


def _picture(method: str, size: int) -> Floats:
    from PIL import Image  # noqa: PLC0415 - only for pictures

    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "room.png"
        program = Path(__file__).with_name("room_program.py")
        command = [sys.executable, "-m", "domeshim", "capture", "--method", method, "--size", str(size)]
        packages = os.pathsep.join([str(Path(__file__).parents[2]), os.environ.get("PYTHONPATH", "")])
        ended = subprocess.run(
            [*command, "--output", str(output), str(program)],
            env={**os.environ, "PYTHONPATH": packages},
            capture_output=True,
            text=True,
            check=False,
        )
        if ended.returncode:
            raise DomeError(f"no picture of the room by method {method}: {ended.stderr.strip()}")
        return np.asarray(Image.open(output).convert("RGB"), float)
