"""Windows on a display: how they begin, and how many samples one has that asks for what suits the dome."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest

from tests.displays import needs_xvfb
from tests.GLUT.program_runs import run_on_screen

OPEN_TWO = """
from domeshim.window import contract, handles
from domeshim.window.contract import SurfaceFormat, WindowEvents
from domeshim.window.screen import ScreenBackend
{before}
made, create = [], handles.create
def counting(*args, **named):
    made.append(named["shown"])
    return create(*args, **named)
import domeshim.window.screen as screen
screen.create = counting
backend = ScreenBackend()
windows = [
    backend.open_window("one", (64, 48), None, SurfaceFormat(samples=None), WindowEvents()) for _ in range(2)
]
import glfw
print([window.format.samples for window in windows], made)
print([window.size for window in windows], [glfw.get_window_attrib(w.handle, glfw.VISIBLE) for w in windows])
"""


@needs_xvfb
@pytest.mark.parametrize(
    ("before", "told"),
    [
        ("", "[0, 0] [False, True]"),
        ("contract._PROCESSOR = ()  # as if a GPU drew", "[4, 4] [False, True, True]"),
    ],
)
def test_the_first_window_tells_how_many_samples_suit_the_dome(tmp_path, before, told):
    ran = run_on_screen(tmp_path, OPEN_TWO.format(before=before))
    assert ran.stdout.splitlines() == [told, "[(64, 48), (64, 48)] [1, 1]"], ran.stderr


LIBRARY = """
import os, subprocess
started = []
popen = subprocess.Popen
class Counting(popen):
    def __init__(self, command, *args, **named):
        started.append(command)
        popen.__init__(self, command, *args, **named)
subprocess.Popen = Counting
from domeshim.window.choose import choose_backend
{before}
choose_backend()
print(bool(started), os.environ.get("PYGLFW_LIBRARY"))
"""


@needs_xvfb
@pytest.mark.parametrize(
    ("before", "told"),
    [
        ("", "False None\n"),
        ("from domeshim.window import choose; choose.find_spec = lambda name: None", "True None\n"),
    ],
)
def test_glfw_starts_no_python_to_look_for_its_library(tmp_path, before, told):
    package = importlib.util.find_spec("glfw")
    bundled = Path(package.submodule_search_locations[0], "x11", "libglfw.so")
    if not bundled.is_file():
        pytest.skip("glfw's package has no library of its own")
    ran = run_on_screen(tmp_path, LIBRARY.format(before=before))
    assert ran.stdout == told, ran.stderr
