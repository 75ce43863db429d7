"""All scenes at all sizes by all methods, with the progress on stderr."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import chain
from typing import Any

from tqdm import tqdm

from domeshim.bench import programs, vtk_peer
from domeshim.bench.contest import Contest
from domeshim.bench.machine import machine
from domeshim.bench.methods import Method, asked, tolerances_of, usual
from domeshim.bench.results import Results, Row
from domeshim.bench.scenes import Scene
from domeshim.measure.apart import Program
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
    peers: bool = True
    """Measure others' ways as well, where they are installed, unless methods are asked for by name."""

    def by(self, size: int) -> list[Method]:
        """The methods at a size. Raises OptionError."""
        tolerances = tolerances_of(self.tolerances)
        return asked(self.methods, size, tolerances) if self.methods else usual(size, tolerances)


def tournament(scenes: Sequence[Scene], wish: Wish) -> Results:
    """Measure the bench's own scenes. Raises OptionError, ScreenError."""
    contest = Contest(wish.options, wish.rounds, wish.edges)
    steps = [(scene, size, wish.by(size)) for size in wish.sizes for scene in scenes]
    results = Results(machine())
    peers = wish.peers and not wish.methods and _comparable(wish.options, results)
    with _bar(sum(len(methods) + (len(_faces(size)) if peers else 0) for _, size, methods in steps)) as bar:
        heard = partial(bar.set_postfix_str, refresh=False)
        for scene, size, methods in steps:
            found = contest.rows(scene, size, methods, heard)
            if peers:
                found = chain(found, vtk_peer.rows(scene, size, _faces(size), wish.rounds, wish.edges))
            _collect(found, results, bar)
    return results


def program_tournament(program: Program, wish: Wish, settings: Mapping[str, str]) -> Results:
    """Measure a user's program; settings: of every dome. Raises DomeError where it cannot be measured."""
    steps = [(size, wish.by(size)) for size in wish.sizes]
    results = Results(machine())
    with _bar(sum(len(methods) for _, methods in steps)) as bar:
        heard = partial(bar.set_postfix_str, refresh=False)
        for size, methods in steps:
            _collect(programs.rows(program, size, methods, wish.rounds, settings, heard), results, bar)
    return results


def _bar(total: int) -> Any:
    every = 0.1 if sys.stderr.isatty() else 10.0
    return tqdm(total=total, unit="row", desc="bench", mininterval=every)


def _collect(rows: Iterable[Row], results: Results, bar: Any) -> None:
    for row in rows:
        results.rows.append(row)
        bar.update()


def _faces(size: int) -> tuple[int, ...]:
    """Of a peer's cube."""
    return size // 2, size, 2 * size


def _comparable(options: Options, results: Results) -> bool:
    """VTK is there and can draw the same dome; else a note says why not."""
    if not vtk_peer.installed():
        results.notes.append("VTK's panoramic pass was not measured: pip install vtk")
        return False
    if options.fov != 180 or options.lens[0] != "equidistant":
        results.notes.append(
            "VTK's panoramic pass was not measured: it knows the equidistant lens of 180 degrees"
        )
        return False
    return True
