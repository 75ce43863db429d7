"""Start beside_freeglut.py under a virtual X server, where there is one."""

from __future__ import annotations

import ctypes.util
import json
import shutil
import sys
from functools import lru_cache
from pathlib import Path
from typing import Any

import pytest

from tests.displays import run_on_display

_SCRIPT = Path(__file__).with_name("beside_freeglut.py")


@lru_cache(maxsize=2)
def beside_freeglut(what: str) -> Any:
    """What the comparison of "solids" or "fonts" found."""
    if shutil.which("Xvfb") is None:
        pytest.skip("Xvfb is not installed: freeglut needs an X server")
    if ctypes.util.find_library("glut") is None:
        pytest.skip("freeglut's library is not installed: there is nothing to compare with")
    command = [sys.executable, str(_SCRIPT), what]
    finished = run_on_display(command, {"PYTHONPATH": str(Path(__file__).parents[2])})
    assert finished.returncode == 0, finished.stderr
    return json.loads(finished.stdout)
