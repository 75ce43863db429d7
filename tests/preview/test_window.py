"""The virtual dome's window on a display: mouse and keys move the viewer."""

from __future__ import annotations

from pathlib import Path

from tests.displays import needs_xvfb
from tests.GLUT.program_runs import run_on_screen

DRIVER = """
import subprocess, sys
import numpy as np
from PIL import ImageGrab
from tests.waiting import LONGEST, wait_for
def xdo(*words):
    return subprocess.run(["xdotool", *words], capture_output=True, text=True).stdout.strip()
def seen():
    return np.asarray(ImageGrab.grab(xdisplay=""))
def middle():
    return seen()[200, 200].tolist()
def moved():
    return (seen() != first).any()
def back():
    return (seen() == first).all()
def reset(*words):
    xdo(*words, "key", "r")
    wait_for(back)
with subprocess.Popen([sys.executable, "-m", "domeshim", "preview", *OPTIONS]) as shown:
    try:
        wait_for(lambda: xdo("search", "--onlyvisible", "--name", "^virtual dome"))
        window = xdo("search", "--onlyvisible", "--name", "^virtual dome")
        xdo("windowmove", window, "0", "0", "windowfocus", window)
        wait_for(lambda: middle() == [255, 0, 0])
        first = seen()
        xdo("mousemove", "390", "200", "mousedown", "1", "mousemove", "90", "200")
        wait_for(moved)
        xdo("mousemove", "390", "200", "mouseup", "1")
        wait_for(back)
        for _ in range(2):
            xdo("mousemove", "390", "200", "mousedown", "1", "mousemove", "90", "200", "mouseup", "1")
        wait_for(lambda: middle() == [0, 255, 0])
        reset()
        for key in "wasdqe":
            xdo("keydown", key)
            wait_for(moved)
            reset("keyup", key)
        xdo("click", "4", "click", "4")
        wait_for(moved)
        reset()
        xdo("windowsize", window, "500", "500")
        wait_for(lambda: seen()[490, 490].any())
        xdo("key", "Escape")
        print(shown.wait(LONGEST))
    finally:
        shown.kill()
"""


@needs_xvfb
def test_mouse_and_keys(tmp_path: Path, master: Path):
    options = ["--size", "400", "--at", "0,3,0", "--look", "0,20", str(master)]
    ended = run_on_screen(tmp_path, DRIVER.replace("OPTIONS", repr(options)))
    assert (ended.returncode, ended.stdout) == (0, "0\n"), ended.stderr
