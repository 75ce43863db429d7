"""An animated program may run for ever: neither memory nor GL objects grow."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

from tests.waiting import LONGEST

ROOT = Path(__file__).parent.parent
LINE = re.compile(r"frame +(\d+) +([\d.]+) MiB +(\d+) objects")


def test_nothing_grows() -> None:
    run = subprocess.run(
        [sys.executable, "benchmarks/endurance.py", "1000"],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        timeout=LONGEST,
    )
    assert run.returncode == 0, run.stderr
    found = [(int(m[1]), float(m[2]), int(m[3])) for m in map(LINE.fullmatch, run.stdout.splitlines()) if m]
    assert [frame for frame, _, _ in found] == list(range(10, 1001, 10))
    objects = {count for _, _, count in found[30:]}
    assert len(objects) == 1, f"GL objects come and go: {sorted(objects)}"
    middle = max(memory for _, memory, _ in found[50:60])
    # An array lost each frame would be seen; the allocator's own steps are a few hundred KiB.
    assert found[-1][1] - middle < 4
