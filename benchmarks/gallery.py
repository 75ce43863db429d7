"""The gallery: every demo on the monitor and on the dome, written to docs/gallery by `make gallery`.

Each picture is captured at twice its size and scaled down, and kept with few colours, so that all of them
together stay small.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from PIL import Image, ImageDraw

ROOT = Path(__file__).resolve().parent.parent
OUTPUT = ROOT / "docs" / "gallery"
SIZE = 480
COLOURS = 256


@dataclass(frozen=True)
class Shot:
    """A picture's name, and the demo that draws it with these arguments at that frame."""

    name: str
    demo: str
    arguments: tuple[str, ...] = ()
    frame: int = 1
    options: tuple[str, ...] = ()


SHOTS = [
    Shot("teapots", "teapots", ("closest",)),
    Shot("mars", "mars"),
    Shot("movie", "movie", ("--start", "2")),
    Shot("field", "field", ("lorenz",)),
    Shot("stiff", "field", ("vanderpol",)),
    Shot("planets", "planets"),
    Shot("ocean", "glsl"),
    Shot("temple", "temple"),
]


def take(shot: Shot, mode: str, folder: Path) -> Image.Image:
    """The demo's picture in a mode, SIZE pixels square; ends the process where there is none."""
    taken = folder / f"{shot.name}-{mode}.png"
    options = ["--mode", mode, "--size", str(2 * SIZE), "--frame", str(shot.frame), "--timeout", "600"]
    program = ROOT / "demos" / f"{shot.demo}.py"
    command = [sys.executable, "-m", "domeshim", "capture", *options, *shot.options, "--output", str(taken)]
    ended = subprocess.run(
        [*command, str(program), *shot.arguments], capture_output=True, text=True, check=False
    )
    if ended.returncode:
        sys.exit(f"{shot.demo} {mode}: {ended.stderr.strip().splitlines()[-1]}")
    return Image.open(taken).convert("RGB").resize((SIZE, SIZE), Image.Resampling.LANCZOS)


def main() -> None:
    """Take all pictures, or those named."""
    OUTPUT.mkdir(parents=True, exist_ok=True)
    wanted = set(sys.argv[1:])
    total = 0
    with tempfile.TemporaryDirectory() as folder:
        for shot in SHOTS:
            for mode in ("monitor", "dome"):
                path = OUTPUT / f"{shot.name}-{mode}.png"
                if not wanted or shot.name in wanted:
                    save(take(shot, mode, Path(folder)), path)
                total += path.stat().st_size
            print(f"{shot.name}: {total / 1e6:.2f} MB so far", flush=True)
    join()


def join() -> None:
    """All dome pictures but the second field's as one, for the README."""
    pictures = [Image.open(OUTPUT / f"{shot.name}-dome.png") for shot in SHOTS if shot.name != "stiff"]
    side = SIZE * 15 // 32
    rows = [pictures[:4], pictures[4:]]
    joined = Image.new("RGB", (side * 4, side * len(rows)), "white")
    for row, shown in enumerate(rows):
        for column, picture in enumerate(shown):
            small = picture.convert("RGB").resize((side, side), Image.Resampling.LANCZOS)
            disc = Image.new("L", (SIZE, SIZE))
            ImageDraw.Draw(disc).ellipse((0, 0, SIZE, SIZE), fill=255)
            left = int((column + (4 - len(shown)) / 2) * side)
            joined.paste(small, (left, row * side), disc.resize((side, side), Image.Resampling.LANCZOS))
    save(joined, OUTPUT / "all.png")


def save(picture: Image.Image, path: Path) -> None:
    """Write it with few colours, mixed by dithering."""
    palette = picture.quantize(COLOURS, kmeans=2)
    picture.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG).save(path, optimize=True)


if __name__ == "__main__":
    main()
