"""The virtual dome's window on a display: mouse and keys move the viewer."""

from __future__ import annotations

import json
from pathlib import Path

from tests.GLUT.program_runs import needs_xvfb, run_on_screen

DRIVER = """
import json, subprocess, sys, time
import numpy as np
from PIL import ImageGrab
shown = subprocess.Popen([sys.executable, "-m", "domeshim", "preview", *OPTIONS])
def xdo(*words):
    return subprocess.run(["xdotool", *words], capture_output=True, text=True).stdout.strip()
def wait(found, seconds=20):
    until = time.monotonic() + seconds
    while not found() and time.monotonic() < until and shown.poll() is None:
        time.sleep(0.1)
def seen():
    return np.asarray(ImageGrab.grab(xdisplay=""))
def middle():
    return seen()[200, 200].tolist()
said = {}
wait(lambda: xdo("search", "--onlyvisible", "--name", "^virtual dome"))
window = xdo("search", "--onlyvisible", "--name", "^virtual dome")
xdo("windowmove", window, "0", "0", "windowfocus", window)
wait(lambda: middle() == [255, 0, 0])
said["start"], first = middle(), seen()
xdo("mousemove", "390", "200", "mousedown", "1", "mousemove", "90", "200")
wait(lambda: (seen() != first).any())
said["dragged there"] = bool((seen() != first).any())
xdo("mousemove", "390", "200", "mouseup", "1")
wait(lambda: (seen() == first).all())
said["and back"] = bool((seen() == first).all())
for _ in range(2):
    xdo("mousemove", "390", "200", "mousedown", "1", "mousemove", "90", "200", "mouseup", "1")
wait(lambda: middle() == [0, 255, 0])
said["dragged twice"] = middle()
def moved(*words):
    xdo(*words)
    wait(lambda: (seen() != first).any(), 5)
    changed = bool((seen() != first).any())
    xdo("key", "r")
    wait(lambda: (seen() == first).all(), 5)
    return changed, bool((seen() == first).all())
said["back"] = moved("key", "r")[1]
for key in "wasdqe":
    said[key] = moved("keydown", key, "sleep", "0.4", "keyup", key)
said["wheel"] = moved("click", "4", "click", "4")
xdo("windowsize", window, "500", "500")
wait(lambda: seen()[490, 490].any(), 5)
said["resized"] = bool(seen()[490, 490].any())
xdo("key", "Escape")
said["ended"] = shown.wait(10)
print(json.dumps(said))
"""


@needs_xvfb
def test_mouse_and_keys(tmp_path: Path, master: Path):
    options = ["--size", "400", "--at", "0,3,0", "--look", "0,20", str(master)]
    ended = run_on_screen(tmp_path, DRIVER.replace("OPTIONS", repr(options)))
    assert ended.returncode == 0, ended.stderr
    said = json.loads(ended.stdout)
    moves = {move: [True, True] for move in (*"wasdqe", "wheel")}
    assert said == {
        "start": [255, 0, 0],
        "dragged there": True,
        "and back": True,
        "dragged twice": [0, 255, 0],
        "back": True,
        **moves,
        "resized": True,
        "ended": 0,
    }
