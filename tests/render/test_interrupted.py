"""A client that is stopped, or killed, is gone on from; its programs end with it."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import pytest

from tests.render.conftest import ROOT
from tests.render.programs import CLEARS, SPINNER
from tests.waiting import LONGEST, wait_for

WRITES_ITSELF_DOWN = CLEARS + "\ndef after():\n    open(sys.argv[1], 'a').write(f'{os.getpid()}\\n')\n"


def running(session: int, hosts: set[int]) -> list[int]:
    """The processes of that session, and of the programs that run in sessions of their own."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):  # it has gone meanwhile
            state, _, _, belongs, *_ = stat.read_text().rpartition(")")[2].split()
            process = int(stat.parent.name)
            if state != "Z" and (int(belongs) == session or process in hosts):
                found.append(process)
    return found


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL])
@pytest.mark.parametrize("workers", [[], ["--workers", "2", "--chunk", "4"]], ids=["alone", "two workers"])
def test_interrupted_client(tmp_path: Path, how: signal.Signals, workers: list[str]):
    if workers:
        pytest.importorskip("distributed")
    program, notes, output = (tmp_path / name for name in ("spinner.py", "notes", "show"))
    program.write_text(SPINNER.replace("{}", WRITES_ITSELF_DOWN))
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    environment.pop("PYOPENGL_PLATFORM", None)

    def render(frames: str, *options: str, output: Path = output) -> subprocess.Popen[str]:
        command = [sys.executable, "-m", "domeshim", "render", "--frames", frames, "--size", "64", *options]
        return subprocess.Popen(
            ["env", "--default-signal=INT", *command, "--output", str(output), str(program), str(notes)],
            stderr=subprocess.PIPE,
            text=True,
            env=environment,
            start_new_session=True,
        )

    first = render("1:2000", *workers)
    wait_for(lambda: len(list(output.glob("*.png"))) > 9)
    if how == signal.SIGINT:  # as a terminal does: all that was started hears it
        os.killpg(first.pid, how)
    else:
        first.send_signal(how)
    said = first.communicate(timeout=LONGEST)[1]
    if how == signal.SIGINT:
        assert first.returncode == 130
        assert said.rstrip().endswith("domeshim: stopped; the same command goes on from here")
        assert "Traceback" not in said
    wait_for(lambda: not running(first.pid, {int(host) for host in notes.read_text().split()}))
    made = {path: path.stat().st_mtime_ns for path in output.glob("*.png")}
    last = max(int(path.stem[-6:]) for path in made) + 3
    second = render(f"1:{last}", *workers)
    said = second.communicate(timeout=LONGEST)[1]
    assert second.returncode == 0, said
    assert all(path.stat().st_mtime_ns == at for path, at in made.items())
    undisturbed = render(f"1:{last}", output=tmp_path / "undisturbed")
    said = undisturbed.communicate(timeout=LONGEST)[1]
    assert undisturbed.returncode == 0, said
    shown = {path.name: path.read_bytes() for path in output.iterdir() if path.suffix == ".png"}
    assert len(shown) == last
    assert shown == {path.name: path.read_bytes() for path in (tmp_path / "undisturbed").glob("*.png")}
    assert not [path for path in output.iterdir() if path.name.startswith(".domeshim-")]
