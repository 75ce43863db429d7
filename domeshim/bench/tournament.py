"""All scenes at all sizes by all methods, with the progress on stderr."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

from tqdm import tqdm

from domeshim.bench.contest import Contest
from domeshim.bench.machine import machine
from domeshim.bench.methods import Method, asked, tolerances_of, usual
from domeshim.bench.results import Results
from domeshim.bench.scenes import Scene
from domeshim.options import Options


@dataclass(frozen=True)
class Wish:
    """What is to be measured, and how carefully."""

    options: Options
    sizes: tuple[int, ...]
    methods: tuple[str, ...] = ()
    """As DOME_METHOD; none: the usual ones."""
    tolerances: str = "0.1,0.5,2,8"
    rounds: int = 15
    edges: int = 24

    def by(self, size: int) -> list[Method]:
        """The methods at a size. Raises OptionError."""
        tolerances = tolerances_of(self.tolerances)
        return asked(self.methods, size, tolerances) if self.methods else usual(size, tolerances)


def tournament(scenes: Sequence[Scene], wish: Wish) -> Results:
    """Measure it. Raises OptionError, ScreenError."""
    contest = Contest(wish.options, wish.rounds, wish.edges)
    steps = [(scene, size, wish.by(size)) for size in wish.sizes for scene in scenes]
    results = Results(machine())
    every = 0.1 if sys.stderr.isatty() else 10.0
    total = sum(len(methods) for *_, methods in steps)
    with tqdm(total=total, unit="row", desc="bench", mininterval=every) as bar:
        for scene, size, methods in steps:
            for row in contest.rows(scene, size, methods, partial(bar.set_postfix_str, refresh=False)):
                results.rows.append(row)
                bar.update()
    return results
