"""Windows on a display: how many samples one has that asks for what suits the dome."""

from __future__ import annotations

import pytest

from tests.GLUT.program_runs import needs_xvfb, run_on_screen

OPEN_TWO = """
from domeshim.window import handles
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
        ("handles._PROCESSOR = ()  # as if a GPU drew", "[4, 4] [False, True, True]"),
    ],
)
def test_the_first_window_tells_how_many_samples_suit_the_dome(tmp_path, before, told):
    ran = run_on_screen(tmp_path, OPEN_TWO.format(before=before))
    assert ran.stdout.splitlines() == [told, "[(64, 48), (64, 48)] [1, 1]"], ran.stderr
