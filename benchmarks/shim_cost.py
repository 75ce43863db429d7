"""What the shim itself costs: until a program's first picture, and for each call of GL."""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping
from contextlib import closing
from pathlib import Path
from typing import Any

from domeshim.bench.artist import look
from domeshim.bench.stage import Stage
from domeshim.measure.reference import virtual_display
from domeshim.options import Options

ROOT = Path(__file__).parents[1]
PROGRAM = """
import os
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *

def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glBegin(GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        glColor3f(1, 0.5 + x / 2, 0.5 + y / 2)
        glVertex3f(x, y, -3)
    glEnd()
    glutSwapBuffers()
    glFinish()
    os._exit(0)

glutInit()
glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH)
glutInitWindowSize(512, 512)
glutCreateWindow("first")
glMatrixMode(GL_PROJECTION)
gluPerspective(60, 1, 0.1, 100)
glMatrixMode(GL_MODELVIEW)
glutDisplayFunc(display)
glutMainLoop()
"""
HOOK = "import _domeshim_gate\n_domeshim_gate.arm()\n"
"""What the installed hook does as Python starts."""
STOCK, DOME = "stock, not installed", "DOME=1"
"""The ways of which first_pictures tells, besides the one with DOME unset."""
CALLS = 20_000
Seconds = tuple[float, float]
"""By the clock, and of the processor."""


def first_pictures(rounds: int) -> dict[str, Seconds]:
    """Medians until a small GLUT program has its first picture and ends, in turns, on its own display."""
    with virtual_display() as display, tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "first.py"
        program.write_text(PROGRAM)
        (Path(folder) / "hook").mkdir()
        (Path(folder) / "hook" / "sitecustomize.py").write_text(HOOK)
        # An installed package has its bytecode: the checkout's is written by the first run.
        left_out = ("DOME", "PYOPENGL", "PYTHONDONTWRITEBYTECODE")
        plain = {name: value for name, value in os.environ.items() if not name.startswith(left_out)}
        plain = plain | {"DISPLAY": display, "LIBGL_ALWAYS_SOFTWARE": "1"}
        hooked = plain | {"PYTHONPATH": f"{folder}/hook{os.pathsep}{ROOT}"}
        ways: dict[str, Mapping[str, str]] = {
            STOCK: {name: value for name, value in plain.items() if name != "PYTHONPATH"},
            "DOME unset": hooked,
            DOME: hooked | {"DOME": "1"},
        }
        times: dict[str, list[Seconds]] = {name: [] for name in ways}
        for number in range(rounds + 1):
            for name, environment in ways.items():
                seconds = _run(program, environment)
                if number:  # the first fills caches
                    times[name].append(seconds)
    return {name: _medians(each) for name, each in times.items()}


def _run(program: Path, environment: Mapping[str, str]) -> Seconds:
    begun = time.perf_counter()
    process = subprocess.Popen([sys.executable, str(program)], env=environment)
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise RuntimeError(f"the program ended with status {process.returncode}")
    return time.perf_counter() - begun, used.ru_utime + used.ru_stime


def _medians(times: list[Seconds]) -> Seconds:
    wall, processor = (statistics.median(each) for each in zip(*times, strict=True))
    return wall, processor


def calls(rounds: int) -> dict[str, tuple[float, float]]:
    """Nanoseconds of the processor for a call, by stock PyOpenGL and on the dome: medians, in turns."""
    found: dict[str, tuple[float, float]] = {}
    with closing(Stage(64)) as stage:
        players = (stage.stock(), stage.dome(Options(enabled=True)))
        for player in players:
            player.window.make_current()
            look(player.gl, 1.0)
            player.gl.glNewList(1, player.gl.GL_COMPILE)
            player.gl.glEndList()
        for name, kind in KINDS.items():
            taken: tuple[list[float], list[float]] = ([], [])
            for _ in range(rounds):
                for player, times in zip(players, taken, strict=True):
                    player.window.make_current()
                    kind(player.gl, CALLS // 10)
                    player.gl.glFinish()
                    begun = time.process_time()
                    kind(player.gl, CALLS)
                    player.gl.glFinish()
                    times.append(1e9 * (time.process_time() - begun) / CALLS)
            found[name] = statistics.median(taken[0]), statistics.median(taken[1])
    return found


def _vertices(gl: Any, count: int) -> None:
    vertex = gl.glVertex3f
    gl.glBegin(gl.GL_POINTS)
    for _ in range(count):
        vertex(0.0, 0.0, -5.0)
    gl.glEnd()


def _repeated(call: Callable[[Any], Callable[[], object]]) -> Callable[[Any, int], None]:
    def repeat(gl: Any, count: int) -> None:
        once = call(gl)
        for _ in range(count):
            once()

    return repeat


def _pushed(gl: Any) -> Callable[[], object]:
    push, pop = gl.glPushMatrix, gl.glPopMatrix

    def both() -> None:
        push()
        pop()

    return both


KINDS: dict[str, Callable[[Any, int], None]] = {
    "glVertex3f, until it is drawn": _vertices,
    "glColor3f outside glBegin": _repeated(lambda gl: lambda: gl.glColor3f(1.0, 1.0, 1.0)),
    "glPushMatrix and glPopMatrix": _repeated(_pushed),
    "glTranslatef": _repeated(lambda gl: lambda: gl.glTranslatef(0.0, 0.0, 0.0)),
    "glEnable(GL_BLEND)": _repeated(lambda gl: lambda: gl.glEnable(gl.GL_BLEND)),
    "glCallList of an empty list": _repeated(lambda gl: lambda: gl.glCallList(1)),
    "glGetFloatv(GL_MODELVIEW_MATRIX)": _repeated(lambda gl: lambda: gl.glGetFloatv(gl.GL_MODELVIEW_MATRIX)),
}
