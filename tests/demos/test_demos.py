"""Every demo: an ordinary program whose dome picture shows, in its middle, what the monitor shows."""

from __future__ import annotations

import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from domeshim.measure.match import match
from tests.demos.captures import DEMOS, capture, environment, through_window
from tests.waiting import LONGEST

SIZE, DOME_SIZE = 160, 448
MODULES = {"masonry", "paint", "stage"}


@dataclass(frozen=True)
class Demo:
    """How a demo is run for its picture; degrees that its monitor shows; a file it is given."""

    name: str
    fovy: float
    arguments: tuple[str, ...] = ()
    file: str | None = None


CASES = [
    Demo("teapots", 50.0),
    Demo("mars", 70.0, file="panorama.png"),
    Demo("movie", 88.0, file="film.mp4"),
    Demo("field", 70.0, ("hopf",)),
    Demo("planets", 60.0),
    Demo("glsl", 65.0),
    Demo("temple", 70.0),
]
BY_GLUT = [demo for demo in CASES if demo.name not in ("teapots", "temple")]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where pictures and the files for the demos lie."""
    folder = tmp_path_factory.mktemp("demos")
    rows, columns = np.mgrid[0:128, 0:256]
    waves = [127 + 120 * np.sin(columns / 256 * 2 * np.pi * k + rows / 20) for k in (2, 3, 5)]
    Image.fromarray(np.stack(waves, -1).astype(np.uint8)).save(folder / "panorama.png")
    return folder


@pytest.fixture(scope="module")
def film(folder: Path) -> Path:
    """A film of 30 pictures at 10 a second, 64x36, each brighter than the one before."""
    av = pytest.importorskip("av")
    path = folder / "film.mp4"
    with av.open(str(path), "w") as out:
        stream = out.add_stream("mpeg4", 10)
        stream.width, stream.height, stream.pix_fmt = 64, 36, "yuv420p"
        for number in range(30):
            pixels = np.full((36, 64, 3), 20 + 7 * number, np.uint8)
            pixels[:, :8] = (200, 40, 40)
            out.mux(stream.encode(av.VideoFrame.from_ndarray(pixels, "rgb24")))
        out.mux(stream.encode())
    return path


def arguments(demo: Demo, folder: Path, request: pytest.FixtureRequest) -> tuple[str, ...]:
    if demo.name == "movie":
        request.getfixturevalue("film")
    return (*demo.arguments, *([str(folder / demo.file)] if demo.file else ()))


def python(*arguments: str, folder: Path | None = None) -> subprocess.CompletedProcess[str]:
    """What Python says, run with these arguments and the demos to be imported."""
    return subprocess.run(
        [sys.executable, *arguments],
        env=environment(),
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=LONGEST,
    )


def test_all_demos_are_looked_at():
    assert {demo.name for demo in CASES} | MODULES == {path.stem for path in DEMOS.glob("*.py")}


@pytest.mark.parametrize("path", sorted(DEMOS.glob("*.py")), ids=lambda path: path.stem)
def test_a_demo_knows_nothing_of_the_dome(path: Path):
    assert not re.search(r"domeshim|DOME\b|DOME_", path.read_text())


@pytest.mark.parametrize("demo", CASES, ids=lambda demo: demo.name)
def test_the_dome_shows_what_the_monitor_shows(demo: Demo, folder: Path, request: pytest.FixtureRequest):
    given = arguments(demo, folder, request)
    program = DEMOS / f"{demo.name}.py"
    monitor, said = capture(
        folder / f"{demo.name}-monitor.png",
        program,
        *given,
        options=("--mode", "monitor", "--size", str(SIZE)),
    )
    dome, _ = capture(
        folder / f"{demo.name}-dome.png",
        program,
        *given,
        options=("--mode", "dome", "--size", str(DOME_SIZE)),
    )
    assert "ESC" in said, "it prints its keys"
    assert monitor.std() > 5, "the monitor is blank"
    y, x = np.mgrid[:DOME_SIZE, :DOME_SIZE] + 0.5 - DOME_SIZE / 2
    beside = (np.hypot(x, y) < DOME_SIZE / 2 - 2) & (np.hypot(x, y) > DOME_SIZE / 2 * demo.fovy * 1.45 / 180)
    assert dome[beside].std() > 4, "there is nothing to see beside the monitor's view"
    assert match(monitor, through_window(dome, SIZE, demo.fovy)).share < 0.03


PRESS = """
import sys
import {name} as demo
from stage import Stage
sys.argv[0] = {path!r}
before = Stage.display
def display(self):
    keys = [key for key in self.keys if key != "ESC"]
    if not hasattr(self, "left"):
        self.left = keys
    if self.left:
        key = self.left.pop(0)
        self.keyboard({{"space": b" "}}.get(key) or key.encode(), 10, 10)
        self.special(101, 10, 10)
        self.mouse(3, 0, 10, 10)
        self.mouse(0, 0, 10, 10)
        self.motion(14, 12)
        self.mouse(0, 1, 14, 12)
    before(self)
Stage.display = display
demo.main()
"""


@pytest.mark.parametrize("demo", BY_GLUT, ids=lambda demo: demo.name)
def test_every_key_and_the_mouse_do_something_and_end_nothing(
    demo: Demo, folder: Path, request: pytest.FixtureRequest
):
    given = arguments(demo, folder, request)
    program = folder / f"press_{demo.name}.py"
    program.write_text(PRESS.format(name=demo.name, path=str(DEMOS / f"{demo.name}.py")))
    options = ("--mode", "monitor", "--size", "96", "--frame", "22")
    pressed, _ = capture(folder / f"{demo.name}-pressed.png", program, *given, options=options)
    plain, _ = capture(folder / f"{demo.name}-plain.png", DEMOS / f"{demo.name}.py", *given, options=options)
    assert pressed.tobytes() != plain.tobytes()


@pytest.mark.parametrize(("name", "needs", "line"), [
    ("movie", "av", "movie.py reads films with PyAV: pip install av\n"),
    ("field", "scipy.integrate", "field.py integrates with scipy: pip install scipy\n"),
    ("temple", "pygame", "temple.py needs pygame: pip install pygame\n"),
])  # fmt: skip
def test_a_demo_says_what_it_lacks(name: str, needs: str, line: str):
    code = f"import sys, runpy; sys.modules[{needs!r}] = None; runpy.run_path({str(DEMOS / name)!r} + '.py')"
    run = subprocess.run(
        [sys.executable, "-c", code], env=environment(), capture_output=True, text=True, timeout=LONGEST
    )
    assert (run.returncode, run.stdout, run.stderr) == (1, "", line)


@pytest.mark.parametrize(("name", "given", "line"), [
    ("mars", ["nowhere.png"], "cannot read nowhere.png: No such file or directory"),
    ("movie", ["nowhere.mp4"], "cannot show nowhere.mp4: No such file or directory"),
    ("movie", [str(DEMOS / "movie.py")], "cannot show"),
    ("field", ["--without", "box,roof"], "--without=box,roof: roof is none of arrows, lines, box, text"),
])  # fmt: skip
def test_a_wrong_argument_is_one_clear_line(name: str, given: list[str], line: str, tmp_path: Path):
    if name == "movie":
        pytest.importorskip("av")
    run = python(str(DEMOS / f"{name}.py"), *given, folder=tmp_path)
    assert run.returncode == 2
    assert line in run.stderr.splitlines()[-1]
    assert "Traceback" not in run.stderr


def test_mars_makes_a_landscape_with_a_horizon():
    """In small: the sky above is smooth, the ground below is not, and the Sun is the brightest."""
    code = (
        "import sys, mars; mars.SIZE = (192, 96); from paint import bytes_of;"
        "sys.stdout.buffer.write(bytes_of(mars.landscape()).tobytes())"
    )
    run = subprocess.run(
        [sys.executable, "-c", code], env=environment(), capture_output=True, timeout=LONGEST
    )
    assert (run.returncode, run.stderr) == (0, b"")
    picture = np.frombuffer(run.stdout, np.uint8).reshape(96, 192, 3).astype(int)
    rough = abs(np.diff(picture.sum(-1), axis=1)).mean(1)
    assert rough[:25].max() < 6 < rough[60:75].min()
    row, column = np.unravel_index(picture.sum(-1).argmax(), (96, 192))
    assert abs(column - (31 / 360 + 0.5) * 192) < 3
    assert abs(row - (90 - 17) / 180 * 96) < 3


def test_a_film_keeps_its_time_and_drops_what_is_late(film: Path):
    code = f"""
import time, pathlib, movie
film = movie.Film(pathlib.Path({str(film)!r}), 0.0)
def filled():
    while not film.waiting.full():
        time.sleep(0.01)
def light(pixels):
    return None if pixels is None else round((float(pixels[18, 40:].mean(dtype=float)) * 4 - 255) / 3)
filled()
print(light(film.picture(0.0)), light(film.picture(0.05)), film.dropped)
print(light(film.picture(0.35)), film.dropped)
filled()
print(light(film.picture(0.41)), film.dropped)
"""
    run = subprocess.run(
        [sys.executable, "-c", code], env=environment(), capture_output=True, text=True, timeout=LONGEST
    )
    assert (run.returncode, run.stderr) == (0, "")
    first, second, third = (line.split() for line in run.stdout.splitlines())
    assert first[1:] == ["None", "0"]
    assert [second[1], third[1]] == ["2", "2"], "the pictures of 0.1 and 0.2 seconds come too late"
    lights = [int(line[0]) for line in (first, second, third)]
    assert np.allclose(lights, [20, 20 + 3 * 7, 20 + 4 * 7], atol=4)
