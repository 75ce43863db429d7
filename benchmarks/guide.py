"""The pictures of docs/dome.md, and the warp mesh that it tries, by `make guide`."""

from __future__ import annotations

import math
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

ROOT = Path(__file__).resolve().parent.parent
OUTPUT = ROOT / "docs" / "pictures"
HIGH = 300
"""Pixels of each picture; taken twice as high."""
COLOURS = 64
Floats = NDArray[np.float64]

PATTERN = f"lens pattern --size {2 * HIGH}"
WIDE = f"lens pattern --size {8 * HIGH // 3}x{2 * HIGH}"
KEYSTONE = "--surface keystone:0.1,0,0.9,0,1,1,0,1"
MESH = "--surface docs/dome/mirror.data"
PLANETS = "demos/planets.py"

ROWS = {
    "card": [PATTERN, f"{WIDE} --disc 300,330,260"],
    "tilt": [f"{PATTERN} {turn}" for turn in ("--tilt 30", "--tilt 30 --heading 20", "--preset domemaster")],
    "seat": [f"{PATTERN} --tilt 60", f"{PATTERN} --tilt 60 --seat 0,-0.5,0"],
    "surfaces": [f"{PATTERN} {KEYSTONE}", f"{WIDE} {MESH}"],
    "cylinder": [f"{WIDE} --surface cylinder:160,-50,50", "2 --surface cylinder:160,-50,50 demos/temple.py"],
    "light": ["1 demos/mars.py", "1 --fade 25 --gamma 1.4 demos/mars.py"],
    "stereo": ["2 --stereo left-right --eyes 1 demos/teapots.py closest"],
    "side": [f"1.6 --hud side --disc 660,300,290 {PLANETS}"],
}
"""Each picture: what stands side by side in it. A capture begins with its width over its height."""


def take(said: str, folder: Path) -> Image.Image:
    """The picture that a command makes; ends the process where there is none."""
    first, *words = shlex.split(said)
    if first != "lens":
        size = f"{round(2 * HIGH * float(first))}x{2 * HIGH}"
        words = ["capture", "--size", size, "--timeout", "600", *words]
    else:
        words = [first, *words]
    at = next((i for i, word in enumerate(words) if word.startswith("demos/")), len(words))
    taken = folder / "taken.png"
    command = [sys.executable, "-m", "domeshim", *words[:at], "--output", str(taken), *words[at:]]
    ended = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    if ended.returncode:
        sys.exit(f"{said}: {ended.stderr.strip().splitlines()[-1]}")
    picture = Image.open(taken).convert("RGB")
    return picture.resize((picture.width // 2, picture.height // 2), Image.Resampling.LANCZOS)


def beside(pictures: list[Image.Image]) -> Image.Image:
    """All of them in a row on white."""
    gap = 8
    row = Image.new("RGB", (sum(p.width + gap for p in pictures) - gap, HIGH), "white")
    left = 0
    for picture in pictures:
        row.paste(picture, (left, 0))
        left += picture.width + gap
    return row


def mirror_mesh(columns: int = 33, rows: int = 25, aspect: float = 4 / 3) -> str:
    """A mesh of Bourke's kind for a spherical mirror at the edge of a dome, with a projector beside it.

    In the dome's radii, y ahead and z up: each node's ray meets the mirror, is thrown back, and meets the
    dome, whose place on an equidistant 180 degree disc is what the node shows. Those that miss are off.
    """
    eye, mirror, size = np.array([0.0, 0.45, -0.12]), np.array([0.0, 0.92, -0.14]), 0.16
    ahead = mirror + np.array([0.0, -0.5, 0.55]) * size - eye
    ahead /= np.linalg.norm(ahead)
    right = np.cross(ahead, (0.0, 0.0, 1.0))
    right /= np.linalg.norm(right)
    x, y = np.meshgrid(np.linspace(-aspect, aspect, columns), np.linspace(-1, 1, rows))
    rays = ahead + 0.3 * (x[..., None] * right + y[..., None] * np.cross(right, ahead))
    rays /= np.linalg.norm(rays, axis=-1, keepdims=True)
    hit, on_mirror = _meets(eye, rays, mirror, size, near=True)
    normal = (hit - mirror) / size
    back = rays - 2 * (rays * normal).sum(-1, keepdims=True) * normal
    dome, _ = _meets(hit, back, np.zeros(3), 1.0, near=False)
    phi = np.arccos(np.clip(dome[..., 2], -1, 1))
    theta = np.arctan2(dome[..., 1], dome[..., 0])
    seen = on_mirror & (phi <= math.pi / 2)
    radius = np.where(seen, phi / (math.pi / 2), 0.0)
    u, v = 0.5 + 0.5 * radius * np.cos(theta), 0.5 - 0.5 * radius * np.sin(theta)
    nodes = np.stack([x, y, u, v, np.where(seen, 1.0, -1.0)], -1).reshape(-1, 5)
    lines = [" ".join(f"{number:.4f}" for number in node) for node in nodes]
    return "\n".join(["2", f"{columns} {rows}", *lines, ""])


def _meets(
    origin: Floats, rays: Floats, centre: Floats, radius: float, *, near: bool
) -> tuple[Floats, NDArray[np.bool_]]:
    """Where unit rays meet a sphere, and whether they do."""
    towards = origin - centre
    along = (rays * towards).sum(-1)
    inside = along**2 - (towards * towards).sum(-1) + radius**2
    way = -along + (-1 if near else 1) * np.sqrt(np.maximum(inside, 0))
    return origin + rays * way[..., None], (inside >= 0) & (way > 0)


def save(picture: Image.Image, path: Path) -> None:
    """Write it with few colours."""
    picture.quantize(COLOURS, kmeans=1, dither=Image.Dither.NONE).save(path, optimize=True)
    print(f"{path.name}: {path.stat().st_size / 1024:.0f} KiB", flush=True)


def main() -> None:
    """Make all of them, or those named."""
    wanted = set(sys.argv[1:])
    (ROOT / "docs" / "dome" / "mirror.data").write_text(mirror_mesh())
    with tempfile.TemporaryDirectory() as folder:
        for name, row in ROWS.items():
            if not wanted or name in wanted:
                save(beside([take(said, Path(folder)) for said in row]), OUTPUT / f"dome-{name}.png")
        if not wanted or "fit" in wanted:
            plot = Path(folder) / "fit.png"
            fit = ["lens", "fit", "docs/dome/lens.csv", "--size", "1080", "--plot", str(plot)]
            subprocess.run([sys.executable, "-m", "domeshim", *fit], cwd=ROOT, check=True)
            picture = Image.open(plot).convert("RGB")
            high = picture.height * 640 // picture.width
            save(picture.resize((640, high), Image.Resampling.LANCZOS), OUTPUT / "dome-fit.png")


if __name__ == "__main__":
    main()
