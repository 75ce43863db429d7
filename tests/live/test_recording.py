"""What the audience sees becomes a film at its real times, and pictures for another process."""

from __future__ import annotations

import re
import time
from pathlib import Path

import numpy as np
import pytest

from domeshim.errors import OptionError
from domeshim.live.readback import Picture
from domeshim.live.shared import LARGEST, Board
from tests.GLUT.program_runs import needs_xvfb, run_on_screen


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

    def slow(self):
        time.sleep(0.3)
        write(self)

    write = recording.Recording._write
    monkeypatch.setattr(recording.Recording, "_write", slow)
    film = recording.Recording(tmp_path / "film.mp4")
    for number in range(30):
        film.add(Picture(number / 10, np.zeros((48, 64, 4), np.uint8)))
    film.close()
    assert film.dropped > 0
    assert film.taken + film.dropped == 30


PROGRAM = """
import os, subprocess, sys
os.environ.update(DOME="1", {})
import domeshim
domeshim.install()
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
n, heard = 0, []
def display():
    global n
    n += 1
    glClearColor(0, 0.2 + 0.6 * (n % 2), 0, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glutSwapBuffers()
STEPS = iter({})
def timer(_):
    words = next(STEPS, "end")
    if words == "end":
        print(n, heard, glGetError(), flush=True)
        sys.exit()
    if words:
        subprocess.run(["xdotool", *words.split()], check=True)
    glutPostRedisplay()
    glutTimerFunc(60, timer, 0)
glutInit(sys.argv)
glutInitDisplayMode(GLUT_DOUBLE)
glutInitWindowSize(200, 200)
glutCreateWindow("film")
glutDisplayFunc(display)
glutKeyboardFunc(lambda key, x, y: heard.append(key))
glutTimerFunc(500, timer, 0)
glutMainLoop()
"""


@needs_xvfb
def test_program_is_recorded_from_its_start(tmp_path: Path):
    av = pytest.importorskip("av")
    film = tmp_path / "film.mp4"
    ended = run_on_screen(
        tmp_path, PROGRAM.replace("{}", f"DOME_RECORD={str(film)!r}", 1).replace("{}", "[''] * 9")
    )
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
    steps = ["key ctrl+shift+r", *[""] * 8, "key ctrl+shift+r", "key a", ""]
    source = PROGRAM.replace("{}", f"PWD={str(tmp_path)!r}", 1).replace("{}", repr(steps))
    ended = run_on_screen(tmp_path, f"import os\nos.chdir({str(tmp_path)!r})\n" + source)
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout.split()[1] == "[b'a']"
    assert len(list(tmp_path.glob("domeshim-*.mp4"))) == 1
    assert "pictures recorded to" in ended.stderr


@needs_xvfb
def test_virtual_dome_opens_beside_the_program(tmp_path: Path):
    steps = [*[""] * 60, "search --name ^virtual.dome"]
    source = PROGRAM.replace("{}", "DOME_PREVIEW='1'", 1).replace("{}", repr(steps))
    ended = run_on_screen(tmp_path, source)
    assert ended.returncode == 0, ended.stderr
    assert ended.stderr.strip() == ""
