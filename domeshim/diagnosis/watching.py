"""Has a program looked on in a process of its own, and gives what was seen."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from domeshim.measure.apart import Program, run_apart
from domeshim.measure.exposures import Wanted


@dataclass(frozen=True)
class Seen:
    """What a picture of a program took."""

    frame: int
    size: tuple[int, int]
    draws: tuple[dict[str, Any], ...]
    """One for each distinct way to draw, that with the most vertices first: see observe.Observer."""
    passes: tuple[dict[str, Any], ...]
    """Each kind of pass that made the picture: its name, and how often it was made; the scene's into what."""
    spared: tuple[str, ...]
    """Passes that nothing asked for."""
    calls: dict[str, Any]
    """counts by name, and viewports."""
    perspective: list[list[float]] | None
    """The main view's matrix; None: the program sets no perspective."""
    notes: tuple[str, ...]
    """What domeshim said of what it cannot do exactly."""


def watched(program: Program, frame: int, size: tuple[int, int], settings: Mapping[str, str]) -> Seen:
    """Run the program on the dome until this picture; settings as in exposures.Wanted.

    Raises NoExposureError where it never came.
    """
    with tempfile.TemporaryDirectory() as folder:
        wanted = Wanted(
            folder, (frame,), size, True, dict(settings), program.module, program.fps, program.timeout
        )
        notes = run_apart(program, "domeshim.diagnosis.observe", wanted, ["seen.json"])
        seen = json.loads((Path(folder) / "seen.json").read_text())
    return Seen(
        seen["frame"],
        tuple(seen["size"]),
        tuple(seen["draws"]),
        tuple(seen.get("passes", ())),
        tuple(seen.get("spared", ())),
        seen["calls"],
        seen.get("perspective"),
        notes,
    )
