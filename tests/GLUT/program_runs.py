"""Running small GLUT programs in a process of their own, off screen or under Xvfb."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

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
needs_xvfb = pytest.mark.skipif(
    not (shutil.which("xvfb-run") and shutil.which("xdotool")), reason="needs xvfb-run and xdotool"
)


def _run(command: list[str], environment: dict[str, str]) -> subprocess.CompletedProcess[str]:
    clean = {name: value for name, value in os.environ.items() if not name.startswith("DOME")}
    clean.pop("PYOPENGL_PLATFORM", None)
    return subprocess.run(
        command,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
        env=clean | environment | {"PYTHONPATH": str(REPOSITORY)},
    )


def run_off_screen(folder: Path, source: str, options: str = "") -> subprocess.CompletedProcess[str]:
    """Run prog.py off screen; preamble.py sets its session up, so that its own lines count from 1."""
    (folder / "preamble.py").write_text(OFF_SCREEN.format(options=options))
    program = folder / "prog.py"
    program.write_text("import preamble\n" + textwrap.dedent(source))
    return _run([sys.executable, str(program)], {})


def run_on_screen(folder: Path, source: str, platform: str = "glx") -> subprocess.CompletedProcess[str]:
    """Run prog.py on a display of its own."""
    program = folder / "prog.py"
    program.write_text(textwrap.dedent(source))
    screen = ["xvfb-run", "-a", "-s", "-screen 0 800x600x24"]
    return _run([*screen, sys.executable, str(program)], {"PYOPENGL_PLATFORM": platform})


def run_without_display(folder: Path, source: str) -> subprocess.CompletedProcess[str]:
    """Run prog.py where there is no display."""
    program = folder / "prog.py"
    program.write_text(textwrap.dedent(source))
    environment = ["env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", "-u", "XDG_SESSION_TYPE"]
    return _run([*environment, sys.executable, str(program)], {})
