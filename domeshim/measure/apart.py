"""A program run for its pictures in a process of its own, where it may do what it wants."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from domeshim.errors import DomeError
from domeshim.measure.exposures import Wanted
from domeshim.measure.words import last_words


class NoExposureError(DomeError):
    """A run gave no picture; says why, as far as the program did."""


@dataclass(frozen=True)
class Program:
    """What is run: a file, folder or module, its arguments, and how."""

    prog: str
    args: tuple[str, ...] = ()
    module: bool = False
    fps: float = 60.0
    timeout: float = 60.0
    folder: Path | None = None
    """Where it is run; None: here."""


def run_apart(program: Program, by: str, wanted: Wanted, files: Sequence[str]) -> tuple[str, ...]:
    """Have a program run by a module that takes what is wanted; what domeshim said of what is not exact.

    files: what that module leaves in the wanted folder. Raises NoExposureError where it did not.
    """
    folder = Path(wanted.folder)
    told = folder / "wanted.json"
    told.write_text(wanted.to_json())
    ended = subprocess.run(
        [sys.executable, "-m", by, str(told), program.prog, *program.args],
        cwd=program.folder,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        check=False,
    )
    if not all((folder / name).exists() for name in files):
        words = last_words(ended.stderr, ended.returncode).removeprefix("domeshim: ")
        raise NoExposureError(f"no picture {'on the dome' if wanted.dome else 'as on the monitor'}: {words}")
    lines = ended.stderr.decode(errors="replace").splitlines()
    return tuple(line.removeprefix("domeshim: ") for line in lines if line.startswith("domeshim: "))
