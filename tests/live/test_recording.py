"""What the audience sees becomes a film at its real times, and pictures for another process."""

from __future__ import annotations

import re
import textwrap
from pathlib import Path
from threading import Event

import numpy as np
import pytest

from domeshim.errors import OptionError
from domeshim.live.audience import unused
from domeshim.live.readback import Picture
from domeshim.live.shared import LARGEST, Board
from tests.displays import needs_xvfb
from tests.GLUT.program_runs import run_on_screen


def test_newest_picture_is_handed_on():
    writer = Board()
    reader = Board(writer.name)
    try:
        assert reader.take() is None
        pictures = np.random.default_rng(0).integers(0, 255, (5, 30, 40, 3), np.uint8)
        for picture in pictures:
            writer.put(picture)
        assert (reader.take() == pictures[-1]).all()
        assert reader.take() is None
        writer.put(np.zeros((2 * LARGEST, 10, 3), np.uint8))
        assert reader.take().shape == (LARGEST, 5, 3)
    finally:
        writer.close()
        assert reader.ended
        assert not Path(writer.name).exists()


def test_other_kinds_of_film_are_refused(tmp_path: Path):
    from domeshim.live.recording import Recording

    with pytest.raises(OptionError, match="accepted"):
        Recording(tmp_path / "film.gif")


def test_a_recording_takes_a_name_that_is_free(tmp_path: Path):
    found = []
    for _ in range(3):
        found.append(unused(tmp_path / "film.mp4"))
        found[-1].touch()
    assert [path.name for path in found] == ["film.mp4", "film-2.mp4", "film-3.mp4"]


@pytest.mark.parametrize("suffix", ["mp4", "webm"])
def test_film_keeps_the_pictures_times(tmp_path: Path, suffix: str):
    av = pytest.importorskip("av")
    from domeshim.live.recording import Recording

    film = Recording(tmp_path / f"film.{suffix}")
    times = [10.0, 10.1, 10.35, 11.0]
    for number, at in enumerate(times):
        content = np.full((48, 64, 4), 60 * number, np.uint8)
        content[:24] = 255 - 60 * number  # the lower half: rows begin at the bottom
        film.add(Picture(at, content))
    film.close()
    assert (film.error, film.taken, film.dropped) == ("", 4, 0)
    with av.open(str(film.path)) as read:
        frames = [(float(f.time), f.to_ndarray(format="rgb24")) for f in read.decode(video=0)]
    assert [at for at, _ in frames] == pytest.approx([0, 0.1, 0.35, 1.0], abs=0.002)
    for number, (_, pixels) in enumerate(frames):
        assert pixels[:20].mean() == pytest.approx(60 * number, abs=8)
        assert pixels[-20:].mean() == pytest.approx(255 - 60 * number, abs=8)


def test_pictures_that_come_too_fast_are_counted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    pytest.importorskip("av")
    from domeshim.live import recording

    all_came = Event()

    def late(self):
        all_came.wait()
        write(self)

    write = recording.Recording._write
    monkeypatch.setattr(recording.Recording, "_write", late)
    film = recording.Recording(tmp_path / "film.mp4")
    for number in range(30):
        film.add(Picture(number / 10, np.zeros((48, 64, 4), np.uint8)))
    all_came.set()
    film.close()
    assert film.dropped > 0
    assert film.taken > 0
    assert film.taken + film.dropped == 30


PROGRAM = """
import os, subprocess, sys
os.environ.update(DOME="1", {setting})
import domeshim
domeshim.install()
from pathlib import Path
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
from tests.waiting import Steps
n, heard = 0, []
def display():
    global n
    n += 1
    glClearColor(0, 0.2 + 0.6 * (n % 2), 0, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glutSwapBuffers()
def xdotool(words):
    return subprocess.run(["xdotool", *words.split()], capture_output=True).returncode == 0
def more(pictures):
    return lambda until=n + pictures: n >= until
def steps():
{steps}
taken = Steps(steps())
def timer(_):
    if taken.ended():
        print(n, heard, glGetError(), flush=True)
        sys.exit()
    glutPostRedisplay()
    glutTimerFunc(20, timer, 0)
glutInit(sys.argv)
glutInitDisplayMode(GLUT_DOUBLE)
glutInitWindowSize(200, 200)
glutCreateWindow("film")
glutDisplayFunc(display)
glutKeyboardFunc(lambda key, x, y: heard.append(key))
glutTimerFunc(0, timer, 0)
glutMainLoop()
"""


def program(setting: str, *steps: str) -> str:
    return PROGRAM.format(setting=setting, steps=textwrap.indent("\n".join(steps), "    "))


@needs_xvfb
def test_program_is_recorded_from_its_start(tmp_path: Path):
    av = pytest.importorskip("av")
    film = tmp_path / "film.mp4"
    ended = run_on_screen(tmp_path, program(f"DOME_RECORD={str(film)!r}", "yield more(10)"))
    assert ended.returncode == 0, ended.stderr
    count, heard, error = ended.stdout.split()[:3]
    assert (heard, error) == ("[]", "0")
    with av.open(str(film)) as read:
        frames = [frame.to_ndarray(format="rgb24") for frame in read.decode(video=0)]
    told = re.search(r"(\d+) pictures recorded to (\S+?)(?:; (\d+) dropped, .*)?\n", ended.stderr)
    assert (int(told[1]), told[2]) == (len(frames), str(film))
    assert len(frames) + int(told[3] or 0) == int(count)
    greens = [frame[100, 100, 1] for frame in frames]
    assert {bool(green > 120) for green in greens} == {True, False}
    assert frames[0][2, 2].max() < 30  # the rim


@needs_xvfb
def test_key_begins_and_ends_a_recording(tmp_path: Path):
    pytest.importorskip("av")
    steps = (
        "yield more(1)",
        "xdotool('key ctrl+shift+r')",
        "yield lambda: list(Path().glob('domeshim-*.mp4'))",
        "yield more(5)",
        "xdotool('key ctrl+shift+r key a')",
        "yield lambda: heard",
        "yield more(1)",
    )
    source = program(f"PWD={str(tmp_path)!r}", *steps)
    ended = run_on_screen(tmp_path, f"import os\nos.chdir({str(tmp_path)!r})\n" + source)
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout.split()[1] == "[b'a']"
    assert len(list(tmp_path.glob("domeshim-*.mp4"))) == 1
    assert "pictures recorded to" in ended.stderr


@needs_xvfb
def test_virtual_dome_opens_beside_the_program(tmp_path: Path):
    found = "yield lambda: xdotool('search --onlyvisible --name ^virtual.dome')"
    ended = run_on_screen(tmp_path, program("DOME_PREVIEW='1'", found))
    assert ended.returncode == 0, ended.stderr
    assert ended.stderr.strip() == ""
