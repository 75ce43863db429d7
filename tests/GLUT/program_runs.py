"""Running small GLUT programs in a process of their own, off screen or on a display."""

from __future__ import annotations

import os
import subprocess
import sys
import textwrap
from pathlib import Path

from tests.displays import run_on_display
from tests.waiting import LONGEST

REPOSITORY = Path(__file__).parents[2]
OFF_SCREEN = """
import os
os.environ["PYOPENGL_PLATFORM"] = "egl"
from domeshim import session
from domeshim.options import Options
from domeshim.window.clock import VirtualClock
from domeshim.window.offscreen import OffscreenBackend
session.begin(session.Session(Options({options}), clock=VirtualClock(), backend=OffscreenBackend))
"""


def _run(command: list[str]) -> subprocess.CompletedProcess[str]:
    clean = {name: value for name, value in os.environ.items() if not name.startswith("DOME")}
    clean.pop("PYOPENGL_PLATFORM", None)
    return subprocess.run(
        command,
        capture_output=True,
        text=True,
        timeout=LONGEST,
        check=False,
        env=clean | {"PYTHONPATH": str(REPOSITORY)},
    )


def run_off_screen(folder: Path, source: str, options: str = "") -> subprocess.CompletedProcess[str]:
    """Run prog.py off screen; preamble.py sets its session up, so that its own lines count from 1."""
    (folder / "preamble.py").write_text(OFF_SCREEN.format(options=options))
    program = folder / "prog.py"
    program.write_text("import preamble\n" + textwrap.dedent(source))
    return _run([sys.executable, str(program)])


def run_on_screen(folder: Path, source: str, platform: str = "glx") -> subprocess.CompletedProcess[str]:
    """Run prog.py on a display of its own."""
    program = folder / "prog.py"
    program.write_text(textwrap.dedent(source))
    environment = {"PYOPENGL_PLATFORM": platform, "PYTHONPATH": str(REPOSITORY)}
    return run_on_display([sys.executable, str(program)], environment)


def run_without_display(folder: Path, source: str) -> subprocess.CompletedProcess[str]:
    """Run prog.py where there is no display."""
    program = folder / "prog.py"
    program.write_text(textwrap.dedent(source))
    environment = ["env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", "-u", "XDG_SESSION_TYPE"]
    return _run([*environment, sys.executable, str(program)])
