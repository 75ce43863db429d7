"""What this machine's OpenGL can do, found by doing it: each trial in a process of its own.

    python -m domeshim.diagnosis.machine window|offscreen

opens one window that way and prints what its GL says of itself, as JSON.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from domeshim.driver import OLDEST_GL
from domeshim.errors import DomeError
from domeshim.measure.words import last_words
from domeshim.wording import counted

SCREENS = ("window", "offscreen")
METHODS = ("vertex", "tessellate", "geometry", "cpu", "cubemap", "paper")
SPECIMEN = Path(__file__).with_name("specimen.py")
_TIMEOUT = 60.0
_STRINGS = {"vendor": 0x1F00, "renderer": 0x1F01, "version": 0x1F02, "glsl": 0x8B8C}
_LIMITS = {"largest texture": 0x0D33, "most samples": 0x8D57, "texture units": 0x84E2}
_EXTENSIONS = (
    "GL_ARB_compatibility",
    "GL_ARB_tessellation_shader",
    "GL_ARB_framebuffer_object",
    "GL_ARB_vertex_array_object",
    "GL_ARB_transform_feedback3",
)
_NUM_EXTENSIONS, _EXTENSIONS_STRING, _PROFILE_MASK, _COMPATIBILITY = 0x821D, 0x1F03, 0x9126, 2


@dataclass(frozen=True)
class Trial:
    """What came of one trial."""

    name: str
    works: bool
    words: str = ""
    """Why it does not, or what is to be said though it does."""
    found: dict[str, Any] | None = None


def screens() -> list[Trial]:
    """Whether windows can be had on the screen and off it, and what GL they have."""
    with ThreadPoolExecutor(len(SCREENS)) as workers:
        return list(workers.map(_try_screen, SCREENS))


def methods() -> list[Trial]:
    """Which methods draw, off screen."""
    from domeshim.measure.apart import NoExposureError, Program  # noqa: PLC0415 - for this alone
    from domeshim.measure.comparison import Comparison  # noqa: PLC0415 - for this alone

    def attempt(method: str) -> Trial:
        program = Program(str(SPECIMEN), timeout=_TIMEOUT)
        try:
            run = Comparison(program, size=(64, 64), settings={"method": method}).take(dome=True)
        except NoExposureError as error:
            return Trial(method, False, str(error))
        drawn = run.exposures[1].picture[32, 32].min() > 200
        return Trial(method, bool(drawn), "; ".join(run.notes) or ("" if drawn else "it draws nothing"))

    with ThreadPoolExecutor(2) as workers:
        return list(workers.map(attempt, METHODS))


def _try_screen(screen: str) -> Trial:
    command = [sys.executable, "-m", "domeshim.diagnosis.machine", screen]
    environ = {name: value for name, value in os.environ.items() if name != "DOME"}
    if screen == "offscreen":
        environ["PYOPENGL_PLATFORM"] = "egl"
    else:
        environ.pop("PYOPENGL_PLATFORM", None)
    try:
        ended = subprocess.run(command, env=environ, capture_output=True, timeout=_TIMEOUT, check=False)
    except subprocess.TimeoutExpired:
        return Trial(screen, False, f"nothing came for {counted(_TIMEOUT, 'second')}")
    if ended.returncode:
        return Trial(screen, False, last_words(ended.stderr, ended.returncode).removeprefix("domeshim: "))
    found = json.loads(ended.stdout.splitlines()[-1])
    return Trial(screen, not found["lacks"], found["lacks"], found)


def look(screen: str) -> dict[str, Any]:
    """Open a window that way and ask its GL.

    Raises ScreenError or DriverError.
    """
    from domeshim.driver import Driver  # noqa: PLC0415 - in the process of the trial alone
    from domeshim.window.contract import SurfaceFormat, WindowEvents  # noqa: PLC0415

    if screen == "window":
        from domeshim.window.choose import choose_backend  # noqa: PLC0415

        backend = choose_backend()
    else:
        from domeshim.window.offscreen import OffscreenBackend  # noqa: PLC0415

        backend = OffscreenBackend()
    window = backend.open_window("domeshim doctor", (64, 64), None, SurfaceFormat(), WindowEvents())
    window.make_current()
    gl = Driver()
    found: dict[str, Any] = {
        name: (gl.glGetString(number) or b"").decode(errors="replace") for name, number in _STRINGS.items()
    }
    limits = {name: gl.integer(number) for name, number in _LIMITS.items()}
    found |= {"backend": backend.name, "limits": limits, "extensions": _extensions(gl), "lacks": _lacks(gl)}
    gl.glGetError()  # an old GL does not know each limit
    return found


def _extensions(gl: Any) -> dict[str, bool]:
    """Which of the extensions that matter this GL names, or has as part of its version."""
    named = (gl.glGetString(_EXTENSIONS_STRING) or b"").decode().split()
    return {name: name in named for name in _EXTENSIONS}


def _lacks(gl: Any) -> str:
    """What this GL lacks for any dome at all; nothing if it is enough."""
    if gl.version < OLDEST_GL:
        version, oldest = (".".join(map(str, numbers)) for numbers in (gl.version, OLDEST_GL))
        return f"OpenGL {version}; the dome needs {oldest}"
    if gl.version >= (3, 2) and not gl.integer(_PROFILE_MASK) & _COMPATIBILITY:
        return "a core profile: existing programs need the compatibility profile"
    return ""


def main(screen: str) -> None:
    """Try one way and print what was found."""
    try:
        print(json.dumps(look(screen)))
    except DomeError as error:
        sys.stderr.write(f"domeshim: {error}\n")
        sys.exit(1)


if __name__ == "__main__":
    main(sys.argv[1])
