"""The figures of docs/mathematics.md and docs/methods.md, written to docs/pictures by `make figures`.

The curves come from the package's own numpy twins, the pictures from domeshim capture.
"""

from __future__ import annotations

import math
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib as mpl
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from domeshim.lens.models import lens_of
from domeshim.lens.projection import disc_of
from domeshim.lens.weights import line_weights

mpl.use("agg")
from matplotlib import pyplot as plt

ROOT = Path(__file__).resolve().parent.parent
OUTPUT = ROOT / "docs" / "pictures"
EDGE = np.array([[-50.0, 3.0, -2.0], [50.0, 3.0, -2.0]])
"""One of the stiff ones: 172 degrees, passing the eye at a distance of 3.6."""
PIECES = 32
RADIUS = 512
"""Of the disc in which pixels are counted."""
METHODS = ("paper", "vertex", "auto")
SCENE = "temple.py"
"""Its floor, beams and sky are large polygons."""
LEVELS = (("field.py", "lorenz"), ("temple.py",), ("teapots.py", "closest"))
SIZE = 400

Floats = NDArray[np.floating]


def angle_of(edge: Floats) -> float:
    """The angle that an edge subtends, radians."""
    first, second = edge / np.linalg.norm(edge, axis=1)[:, None]
    return math.acos(float(np.clip(first @ second, -1, 1)))


def points_of(edge: Floats, pieces: int, *, by_angle: bool) -> Floats:
    """(pieces + 1, 3): the ends of equal pieces, equal in angle or in length."""
    share = np.linspace(0, 1, pieces + 1)
    shares = np.stack([1 - share, share], 1)
    if by_angle:
        distances = np.linalg.norm(edge, axis=1)
        shares = line_weights(
            shares, np.full(len(share), angle_of(edge)), np.tile(distances, (len(share), 1))
        )
    return np.asarray(shares @ edge)


def off_by(edge: Floats, drawn: Floats) -> float:
    """How far a polyline is from the edge's true curve at most, pixels. drawn: (n, 2), on the disc."""
    lens = lens_of("equidistant", (), 180.0)
    true = disc_of(points_of(edge, 20000, by_angle=True), lens)
    starts, steps = drawn[:-1], np.diff(drawn, axis=0)
    along = np.einsum("nij,ij->ni", true[:, None] - starts, steps) / (steps**2).sum(1)
    nearest = starts + np.clip(along, 0, 1)[..., None] * steps
    return float(np.linalg.norm(true[:, None] - nearest, axis=-1).min(1).max() * RADIUS)


def draw_pieces() -> None:
    """An edge as one piece, even in length, and even in angle."""
    lens = lens_of("equidistant", (), 180.0)
    figure, axes = plt.subplots(1, 3, figsize=(11, 2.9), layout="constrained")
    true = disc_of(points_of(EDGE, 2000, by_angle=True), lens)
    for axis, (name, pieces, by_angle) in zip(
        axes,
        [
            ("its two ends alone", 1, False),
            (f"{PIECES} pieces even in length", PIECES, False),
            (f"{PIECES} pieces even in angle", PIECES, True),
        ],
        strict=True,
    ):
        drawn = disc_of(points_of(EDGE, pieces, by_angle=by_angle), lens)
        off = off_by(EDGE, drawn)
        axis.add_patch(plt.Circle((0, 0), 1, color="0.93"))
        axis.plot(*true.T, color="0.6", linewidth=5)
        axis.plot(*drawn.T, color="tab:red", linewidth=1, marker="o", markersize=3)
        axis.set_title(f"{name}\noff by {off:.{0 if off > 10 else 2}f} pixels")
        axis.set(aspect="equal", xlim=(-1.02, 1.02), ylim=(-0.1, 1.02))
        axis.axis("off")
    figure.savefig(OUTPUT / "pieces.png", dpi=80)


def draw_lenses() -> None:
    """The radius of each lens over the angle from the axis, 180 degrees wide."""
    figure, axis = plt.subplots(figsize=(6.4, 4), layout="constrained")
    phi = np.radians(np.linspace(0, 90, 181))
    for name in ("equidistant", "equisolid", "stereographic", "orthographic"):
        axis.plot(np.degrees(phi), lens_of(name, (), 180.0).radius(phi), label=name)
    axis.set(
        xlabel="angle from the dome's axis, degrees", ylabel="radius on the disc", xlim=(0, 90), ylim=(0, 1)
    )
    axis.grid(alpha=0.3)
    axis.legend()
    figure.savefig(OUTPUT / "lenses.png", dpi=80)


def draw_methods() -> None:
    """The same moment of one program by three methods, side by side."""
    save_row([((SCENE,), ("--method", method)) for method in METHODS], "methods.png")


def draw_levels() -> None:
    """Programs coloured by how finely what they draw is subdivided."""
    save_row([(program, ("--debug", "levels")) for program in LEVELS], "levels.png")


def save_row(shots: list[tuple[tuple[str, ...], tuple[str, ...]]], name: str) -> None:
    """Dome pictures side by side: (a demo and its arguments, the options of capture) each."""
    sheet = Image.new("RGB", ((SIZE + 8) * len(shots) - 8, SIZE), "white")
    with tempfile.TemporaryDirectory() as folder:
        for place, ((demo, *arguments), options) in enumerate(shots):
            taken = Path(folder, f"{place}.png")
            command = [sys.executable, "-m", "domeshim", "capture", *options, "--size", str(2 * SIZE)]
            command += ["--timeout", "600", "--output", str(taken), str(ROOT / "demos" / demo), *arguments]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
            picture = Image.open(taken).convert("RGB").resize((SIZE, SIZE), Image.Resampling.LANCZOS)
            sheet.paste(picture, ((SIZE + 8) * place, 0))
    sheet.quantize(256).save(OUTPUT / name, optimize=True)


if __name__ == "__main__":
    draw_pieces()
    draw_lenses()
    draw_methods()
    draw_levels()
