"""Times a user's program by several methods, each in a process of its own, its pictures in turns."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from domeshim.bench.contest import Heard
from domeshim.bench.methods import Method
from domeshim.bench.results import Cost, Row, Seconds, Seen
from domeshim.bench.timekeeper import Errand
from domeshim.errors import DomeError
from domeshim.measure.apart import Program
from domeshim.measure.comparison import Comparison
from domeshim.measure.piped import Piped

_WARM = 3
"""Pictures that import, build shaders and textures, and do not count."""


class Timed:
    """One program in a process of its own, which draws a picture when it is told to."""

    def __init__(self, errand: Errand) -> None:
        silent = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        self._child = Piped("domeshim.bench.timekeeper", errand.to_json(), **silent)

    def picture(self) -> Seconds:
        """What the program's next picture took. Raises DomeError where there is none."""
        with suppress(BrokenPipeError):
            self._child.orders.write(b"\n")
            self._child.orders.flush()
        line = self._child.replies.readline()
        if not line:
            status = self._child.wait()
            raise DomeError(f"the program could not be timed: its process ended (status {status})")
        told: dict[str, Any] = json.loads(line)
        if "failed" in told:
            raise DomeError(f"the program could not be timed: {told['failed']}")
        return Seconds(told["wall"], told["processor"])

    def close(self) -> None:
        """End the process."""
        self._child.close()


def rows(
    program: Program,
    size: int,
    methods: Sequence[Method],
    rounds: int,
    settings: Mapping[str, str],
    heard: Heard,
) -> Iterator[Row]:
    """A row for each method; how far off it is, is what domeshim compare finds.

    settings: of every dome. Raises DomeError where the program does not draw as many pictures.
    """
    name = Path(program.prog).stem if not program.module else program.prog
    costs = _costs(program, size, methods, rounds, settings, heard)
    for method, cost in zip(methods, costs, strict=True):
        heard(f"{name} {size}: compare {method}")
        compared = next(Comparison(program, (1,), (size, size), {**settings, **method.settings}).results())
        found = compared.difference
        moved = found.moved.largest if found.moved is not None else None
        yield Row(name, name, size, method.family, method.detail, cost, seen=Seen(moved, found.wrong))


def _costs(
    program: Program,
    size: int,
    methods: Sequence[Method],
    rounds: int,
    settings: Mapping[str, str],
    heard: Heard,
) -> list[Cost]:
    errand = Errand(program.prog, program.args, program.module, (size, size), timeout=program.timeout)
    with ExitStack() as stack:
        runs = []
        for method in (None, *methods):
            given = None if method is None else {**settings, **method.settings}
            runs.append(Timed(replace(errand, settings=given)))
            stack.callback(runs[-1].close)
        taken: list[list[Seconds]] = [[] for _ in runs]
        for number in range(rounds + _WARM):
            heard(f"{program.prog} {size}: picture {number + 1}")
            for run, times in zip(runs, taken, strict=True):
                seconds = run.picture()
                if number >= _WARM:
                    times.append(seconds)
    stock, *domes = taken
    return [Cost.of(list(zip(times, stock, strict=True))) for times in domes]
