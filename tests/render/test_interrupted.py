"""A client that is stopped, or killed, is gone on from; its programs end with it."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.render.conftest import ROOT
from tests.render.programs import CLEARS, SPINNER

WRITES_ITSELF_DOWN = CLEARS + "\ndef after():\n    open(sys.argv[1], 'a').write(f'{os.getpid()}\\n')\n"


def wait_for(found: Callable[[], bool]) -> None:
    until = time.monotonic() + 60
    while not found():
        assert time.monotonic() < until
        time.sleep(0.05)


def alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    return Path(f"/proc/{process}/stat").read_text().split()[2] != "Z"


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL])
def test_interrupted_client(tmp_path: Path, how: signal.Signals):
    program, notes, output = (tmp_path / name for name in ("spinner.py", "notes", "show"))
    program.write_text(SPINNER.replace("{}", WRITES_ITSELF_DOWN))
    options = ["--size", "64", "--output", str(output), str(program), str(notes)]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    environment.pop("PYOPENGL_PLATFORM", None)

    def render(frames: str) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [
                "env",
                "--default-signal=INT",
                sys.executable,
                "-m",
                "domeshim",
                "render",
                "--frames",
                frames,
                *options,
            ],
            stderr=subprocess.PIPE,
            text=True,
            env=environment,
        )

    first = render("1:100000")
    wait_for(lambda: len(list(output.glob("*.png"))) > 5)
    first.send_signal(how)
    said = first.communicate(timeout=60)[1]
    if how == signal.SIGINT:
        assert first.returncode == 130
        assert said.rstrip().endswith("domeshim: stopped; the same command goes on from here")
        assert "Traceback" not in said
    host = int(notes.read_text().split()[0])
    wait_for(lambda: not alive(host))
    made = {path: path.stat().st_mtime_ns for path in output.glob("*.png")}
    second = render(f"1:{len(made) + 3}")
    said = second.communicate(timeout=60)[1]
    assert second.returncode == 0, said
    assert len(list(output.glob("*.png"))) == len(made) + 3
    assert all(path.stat().st_mtime_ns == at for path, at in made.items())
