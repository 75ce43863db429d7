"""Programs that tests run on an X display of their own, whatever displays there are already."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path

import pytest

from domeshim.measure.reference import virtual_display
from tests.waiting import LONGEST

needs_xvfb = pytest.mark.skipif(
    not (shutil.which("Xvfb") and shutil.which("xdotool")), reason="needs Xvfb and xdotool"
)
_OTHER_SCREENS = ("WAYLAND_DISPLAY", "XDG_SESSION_TYPE", "XAUTHORITY", "SDL_VIDEODRIVER", "QT_QPA_PLATFORM")


def only_on(display: str) -> dict[str, str]:
    """This process's variables for a program that shall find that display alone, and nobody's dome."""
    unwanted = ("DOME", "PYOPENGL_", *_OTHER_SCREENS)
    return {n: v for n, v in os.environ.items() if not n.startswith(unwanted)} | {"DISPLAY": display}


def run_on_display(
    command: Sequence[str],
    environment: Mapping[str, str],
    size: tuple[int, int] = (800, 600),
    folder: Path | None = None,
) -> subprocess.CompletedProcess[str]:
    """Run it to its end, and to that of all that it leaves running, on a display of this size."""
    with virtual_display(size) as display:
        child = subprocess.Popen(
            command,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            cwd=folder,
            env=only_on(display) | environment,
            start_new_session=True,
        )
        try:
            out, err = child.communicate(timeout=LONGEST)
        except BaseException:
            with suppress(ProcessLookupError):
                os.killpg(child.pid, signal.SIGKILL)
            child.communicate()
            raise
    return subprocess.CompletedProcess(command, child.returncode, out, err)
