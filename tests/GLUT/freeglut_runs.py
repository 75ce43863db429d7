"""Start beside_freeglut.py under a virtual X server, where there is one."""

from __future__ import annotations

import ctypes.util
import json
import os
import shutil
import subprocess
import sys
from functools import lru_cache
from pathlib import Path
from typing import Any

import pytest

_SCRIPT = Path(__file__).with_name("beside_freeglut.py")


@lru_cache(maxsize=2)
def beside_freeglut(what: str) -> Any:
    """What the comparison of "solids" or "fonts" found."""
    if shutil.which("xvfb-run") is None:
        pytest.skip("xvfb-run is not installed: freeglut needs an X server")
    if ctypes.util.find_library("glut") is None:
        pytest.skip("freeglut's library is not installed: there is nothing to compare with")
    environment = {name: value for name, value in os.environ.items() if name != "PYOPENGL_PLATFORM"}
    environment["PYTHONPATH"] = str(Path(__file__).parents[2])
    command = ["xvfb-run", "-a", "-s", "-screen 0 800x600x24", sys.executable, str(_SCRIPT), what]
    finished = subprocess.run(
        command, env=environment, capture_output=True, text=True, timeout=300, check=False
    )
    assert finished.returncode == 0, finished.stderr
    return json.loads(finished.stdout)
