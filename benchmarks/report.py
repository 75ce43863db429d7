"""Writes docs/report.md: error against run time, and what the shim itself costs.

    make report, or python benchmarks/report.py [FOLDER ...]

FOLDERs hold results of `domeshim bench --output`, which are taken instead of measuring anew.
"""

from __future__ import annotations

import os

os.environ["PYOPENGL_PLATFORM"] = "egl"  # before OpenGL is imported

import json
import subprocess
import sys
import tempfile
from pathlib import Path
from textwrap import fill

import shim_cost
from shim_cost import DOME, STOCK

from domeshim.bench.plot import work_precision
from domeshim.bench.results import Results, Row

ROOT = Path(__file__).parents[1]
PAGE, PLOTS = ROOT / "docs/report.md", ROOT / "docs/report"
ROUNDS = 9
RUNS: tuple[tuple[str, ...], ...] = (
    ("--size=1024", "--rounds=9", "--edges=16"),
    (
        *("--size=2048", "--rounds=9", "--edges=8", "--scene=room", "--tolerance=0.5,2"),
        *("--method=auto", "--method=vertex", "--method=cubemap:2048"),
    ),
)
"""What is measured, by domeshim bench's options."""
GOALS = (
    ("auto over the stock monitor, 100,000 triangles", ("mesh-100k", 1024, "auto 0.5 px"), None, 1.05),
    ("auto over the stock monitor, 500,000 triangles", ("mesh-500k", 1024, "auto 0.5 px"), None, 1.05),
    ("auto over vertex, 10,000 triangles", ("mesh-10k", 1024, "auto 0.5 px"), "vertex", 1.05),
    ("auto over vertex, 100,000 triangles", ("mesh-100k", 1024, "auto 0.5 px"), "vertex", 1.05),
    ("auto over vertex, 500,000 triangles", ("mesh-500k", 1024, "auto 0.5 px"), "vertex", 1.05),
    ("20,000 vertices by glBegin, over the stock monitor", ("immediate", 1024, "auto 0.5 px"), None, 0.60),
    ("200 long lines, over the stock monitor", ("lines", 1024, "auto 0.5 px"), None, 1.50),
    ("textured room, over the stock monitor", ("room", 1024, "auto 0.5 px"), None, 1.30),
    ("textured room at 2048, over the stock monitor", ("room", 2048, "auto 0.5 px"), None, 1.00),
)
"""(what, (scene, size, method), over which method if not the monitor, the most that is wanted)."""
START_UP = 0.25
"""Seconds by which the dome's first picture may come later than stock's."""
GRAIN = 0.05
"""Pixels by which two measurements of the same edge may differ."""
RIVALS = (("domeshim's cubemap", "cubemap"), ("VTK's panoramic pass", "VTK panoramic"))
INTRODUCTION = """\
How each figure is measured: [bench.md](bench.md). Ratios are medians over rounds in which the pictures take
turns in one process; *processor* is the ratio of the processors' time, which other work on the machine
disturbs less.

## Error against run time

![A panel a scene: time over the stock monitor's against error, both logarithmic](report/bench.png)

To the left is more exact, below is faster; the line at 1 is the stock monitor. A cube much finer than the
picture shows thin lines as dashes, and what is missing counts by its distance."""
ELSEWHERE = """\
## Elsewhere

- Stiff and extreme geometry: [stability.md](stability.md).
- Every program of PyOpenGL-Demo: [corpus.md](corpus.md).

## Again

    make report

It takes some five minutes on two quiet cores. `python benchmarks/report.py FOLDER` takes what
`domeshim bench --output FOLDER` has measured."""


def main(folders: list[str]) -> None:
    """Measure what is not there, and write the page and its plots."""
    results = merged([read(Path(folder)) for folder in folders] or [measured(run) for run in RUNS])
    PLOTS.mkdir(exist_ok=True)
    work_precision(results, PLOTS / "bench.png")
    first, calls = shim_cost.first_pictures(ROUNDS), shim_cost.calls(ROUNDS)
    PAGE.write_text(page(results, first, calls))


def measured(arguments: tuple[str, ...]) -> Results:
    """One run of domeshim bench."""
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "domeshim", "bench", f"--output={folder}", *arguments]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return read(Path(folder))


def read(folder: Path) -> Results:
    """What such a run left."""
    return Results.from_json(json.loads((folder / "bench.json").read_text()))


def merged(parts: list[Results]) -> Results:
    """All rows; of those measured twice the later ones."""
    rows = {(r.scene, r.size, r.family, r.detail): r for part in parts for r in part.rows}
    return Results(parts[0].machine, list(rows.values()), [note for part in parts for note in part.notes])


def page(
    results: Results, first: dict[str, tuple[float, float]], calls: dict[str, tuple[float, float]]
) -> str:
    """The whole page as Markdown."""
    machine = ", ".join(results.machine.values())
    load = os.getloadavg()[1]
    others = (
        f" It was busy with other work as well (load {load:.0f})." if load > (os.cpu_count() or 1) + 1 else ""
    )
    parts = [
        "# Report\n\n" + fill(f"Measured by `make report` on {machine}.{others}", 110),
        INTRODUCTION,
        "## Goals\n\n" + goals(results),
        "## Against cube maps\n\n" + rivals(results),
        "## The shim itself\n\n" + shim(first, calls),
        ELSEWHERE,
        "## All figures\n\n" + "\n\n".join(results.tables()),
    ]
    return "\n\n".join([*parts, *(f"- {note}" for note in results.notes)]) + "\n"


def goals(results: Results) -> str:
    """What was to be reached, and what is."""
    rows = {(r.scene, r.size, f"{r.family} {r.detail}".strip()): r for r in results.rows}
    lines = ["| | wanted | time | processor | |", "|---|---:|---:|---:|---|"]
    for what, key, over, wanted in GOALS:
        if key not in rows:
            continue
        cost = rows[key].cost
        under = rows[key[0], key[1], over].cost if over else None
        time = cost.ratio / (under.ratio if under else 1)
        processor = cost.processor_ratio / (under.processor_ratio if under else 1)
        verdict = "reached" if processor <= wanted else "not reached"
        lines.append(f"| {what} | {wanted:.2f} | {time:.2f} | {processor:.2f} | {verdict} |")
    return "\n".join(lines) + "\n\nThe verdict goes by the processors' time."


def rivals(results: Results) -> str:
    """How many times faster auto is than cube maps of at best the same error, each over its own monitor."""
    lines = [
        "How many times faster auto is than a cube map with faces as large as the picture, each over its own",
        "monitor picture, by the processors' time: the fastest auto whose largest error of an edge is no",
        f"larger, to {GRAIN:g} pixels.",
        "",
        "| scene | " + " | ".join(name for name, _ in RIVALS) + " |",
        "|---|" + "---:|" * len(RIVALS),
    ]
    for title, size, rows in results.scenes():
        autos = [row for row in rows if row.family == "auto"]
        cells = []
        for _, family in RIVALS:
            cube = next((r for r in rows if r.family == family and r.detail == str(size)), None)
            cells.append("" if cube is None else _against(cube, autos))
        lines.append(f"| {title}, {size} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _against(cube: Row, autos: list[Row]) -> str:
    assert cube.edges is not None
    good = [r for r in autos if r.edges is not None and r.edges.largest <= cube.edges.largest + GRAIN]
    if not good:
        return "no auto as exact"
    best = min(good, key=lambda row: row.cost.processor_ratio)
    return f"{cube.cost.processor_ratio / best.cost.processor_ratio:.1f} ({best.detail})"


def shim(first: dict[str, tuple[float, float]], calls: dict[str, tuple[float, float]]) -> str:
    """Start-up and calls."""
    more, of_processor = (dome - stock for dome, stock in zip(first[DOME], first[STOCK], strict=True))
    lines = [
        "A small GLUT program in a process of its own until its first picture is finished, shaders included;",
        "stock is PyOpenGL with freeglut, on the same X display. Medians, in turns.",
        "",
        "| | seconds | of the processor |",
        "|---|---:|---:|",
        *(f"| {name} | {wall:.2f} | {processor:.2f} |" for name, (wall, processor) in first.items()),
        "",
        f"DOME=1 is to take at most {START_UP:.2f} s more than stock; it takes {more:.2f} s, or"
        f" {of_processor:.2f} s of the processor.",
        "",
        "With DOME unset none of domeshim's modules is imported, but for the hook of a few lines.",
        "",
        "| nanoseconds of the processor for | stock | dome |",
        "|---|---:|---:|",
        *(f"| {name} | {stock:.0f} | {dome:.0f} |" for name, (stock, dome) in calls.items()),
    ]
    return "\n".join(lines)


if __name__ == "__main__":
    main(sys.argv[1:])
