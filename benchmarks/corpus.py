"""Every program of PyOpenGL-Demo on the dome, beside stock PyOpenGL: writes docs/corpus.md.

    python benchmarks/corpus.py [PROGRAM.py ...]

With programs' paths it measures those alone and prints the table instead. Needs Xvfb, freeglut and scipy.
"""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from queue import SimpleQueue

import numpy as np
from corpus_page import FINE_SIZE, FRAME, LIMIT, ON_SCREEN, SIZE, Row, brief, page, table
from PIL import Image

from domeshim.measure.match import Picture, match, match_discs
from domeshim.measure.reference import (
    NoPictureError,
    StockRuns,
    stock_environment,
    virtual_display,
)
from domeshim.measure.words import last_words

TIMEOUT = 60.0
AT_ONCE = 2
OUTPUT = Path(__file__).parents[1] / "docs" / "corpus.md"
ARGUMENTS = {"proesch/stereo/stereoDemo.py": ("ANAGLYPH",)}
"""What those programs must be told that do not run without."""
MAIN_LOOP = re.compile(r"[mM]ain[lL]oop\s*\(")
START = re.compile(f"{MAIN_LOOP.pattern}|__main__")
"""What the text of a module has that can be started as a program."""


def measure(program: Path, name: str, display: str) -> Row:
    """Run one program natively and on the dome, and compare the pictures."""
    row = Row(name)
    runs = StockRuns(display, program, ARGUMENTS.get(name, ()), FRAME, SIZE, TIMEOUT)
    text = program.read_text(errors="replace")
    if not START.search(text):
        return replace(row, is_program=False)
    try:
        stock = runs.monitor()
    except NoPictureError as error:
        tried_itself = error.ended and (error.silent or not MAIN_LOOP.search(text))
        return replace(row, native=str(error), is_program=not tried_itself)
    row = replace(row, stock=stock, on_screen=run_on_screen(program, display, runs.arguments))
    row = replace(row, monitor=compare_monitor(runs, stock.picture))
    if not (row.flat or row.split):
        row = compare_dome(row, runs)
    elif isinstance(taken := capture(runs, "dome", SIZE), str):
        row = replace(row, dome=taken)
    if row.fails:
        row = replace(row, repeats=np.array_equal(runs.monitor().picture, stock.picture))
    return row


def compare_monitor(runs: StockRuns, stock: Picture) -> float | str:
    """The share of wrong pixels of our monitor picture, or why there is none."""
    taken = capture(runs, "monitor", SIZE)
    return taken if isinstance(taken, str) else match(stock, taken).share


def compare_dome(row: Row, runs: StockRuns) -> Row:
    """The row with the dome's share, and with that of the finer picture where the first is over the limit."""
    taken = capture(runs, "dome", SIZE)
    if isinstance(taken, str):
        return replace(row, dome=taken)
    try:
        reference = runs.dome()
    except NoPictureError as error:
        return replace(row, unjudged=f"no reference: {error}")
    share = match_discs(reference, taken).share
    if share <= LIMIT:
        return replace(row, dome=share)
    taken = capture(runs, "dome", FINE_SIZE)
    if isinstance(taken, str):
        return replace(row, dome=share, fine=taken)
    smaller = np.asarray(Image.fromarray(taken).resize((SIZE, SIZE), Image.Resampling.BOX))
    return replace(row, dome=share, fine=match_discs(reference, smaller).share)


def capture(runs: StockRuns, mode: str, size: int) -> Picture | str:
    """Our picture of a program, without its HUD on the dome, or why there is none."""
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "picture.png"
        wanted = ["--mode", mode, "--frame", str(FRAME), "--size", str(size), "--output", str(output)]
        program = [str(runs.program), *runs.arguments]
        command = [sys.executable, "-m", "domeshim", "capture", *wanted, "--hud", "off", *program]
        environment = stock_environment("")
        try:
            ended = run(command, runs.program, environment, 2 * TIMEOUT)
        except subprocess.TimeoutExpired:
            return f"no picture within {2 * TIMEOUT:g} seconds"
        if ended.returncode or not output.exists():
            return last_words(ended.stderr, ended.returncode)
        return np.asarray(Image.open(output).convert("RGB"))


def run_on_screen(program: Path, display: str, arguments: tuple[str, ...]) -> str:
    """Run DOME=1 python PROGRAM for a while; what went wrong, or nothing."""
    environment = {**stock_environment(display), "DOME": "1"}
    try:
        ended = run([sys.executable, str(program), *arguments], program, environment, ON_SCREEN)
    except subprocess.TimeoutExpired as running:
        words = running.stderr or b""
        return last_words(words, 0) if b"Traceback" in words else ""
    return last_words(ended.stderr, ended.returncode) if ended.returncode else ""


def run(
    command: list[str], program: Path, environment: dict[str, str], timeout: float
) -> subprocess.CompletedProcess[bytes]:
    """Run a command in the program's own folder.

    Raises TimeoutExpired, with what was said until then.
    """
    return subprocess.run(
        command,
        cwd=program.parent,
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        timeout=timeout,
        check=False,
    )


def measure_all(programs: dict[str, Path]) -> list[Row]:
    """Measure programs by name, some at once, each worker on a display of its own; tell how it goes."""
    began = time.monotonic()
    displays: SimpleQueue[str] = SimpleQueue()
    done: list[Row] = []

    def work(name: str) -> Row:
        display = displays.get()
        try:
            row = measure(programs[name], name, display)
        finally:
            displays.put(display)
        done.append(row)
        seconds = time.monotonic() - began
        print(f"{len(done)} of {len(programs)}, {seconds:.0f} s: {name}: {brief(row)}", flush=True)
        return row

    with virtual_display() as first, virtual_display() as second, ThreadPoolExecutor(AT_ONCE) as workers:
        displays.put(first)
        displays.put(second)
        return list(workers.map(work, sorted(programs)))


def corpus() -> dict[str, Path]:
    """The files of PyOpenGL-Demo by their path within it."""
    spec = importlib.util.find_spec("OpenGL_Demo")
    if spec is None or not spec.submodule_search_locations:
        raise SystemExit("PyOpenGL-Demo is not installed: pip install PyOpenGL-Demo")
    folder = Path(spec.submodule_search_locations[0])
    files = (path for path in folder.rglob("*.py") if path.name != "__init__.py")
    return {str(path.relative_to(folder)): path for path in files}


def check_gate() -> None:
    """End the process where DOME=1 would do nothing in this Python."""
    armed = "import sys; sys.exit('domeshim' not in sys.modules)"
    environment = {**stock_environment(""), "DOME": "1"}
    if subprocess.run([sys.executable, "-c", armed], env=environment, check=False).returncode:
        raise SystemExit("DOME=1 does nothing in this Python: install domeshim into it, pip install -e .")


def main(arguments: list[str]) -> None:
    """Measure the programs named, or the whole corpus, and write what was found."""
    check_gate()
    programs = {path: Path(path).absolute() for path in arguments} or corpus()
    rows = measure_all(programs)
    if arguments:
        print("\n".join(table(rows)))
    else:
        OUTPUT.write_text(page(rows))
        print(f"wrote {OUTPUT}")


if __name__ == "__main__":
    main(sys.argv[1:])
