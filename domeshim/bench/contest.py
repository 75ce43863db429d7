"""Runs the bench's own scenes by all methods: times in turns, and errors against the truth."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from domeshim.bench.artist import Artist, draw_edge, look
from domeshim.bench.colour_error import colour_rms, true_picture
from domeshim.bench.edge_error import FINE, EdgeError, summary, telling
from domeshim.bench.methods import Method
from domeshim.bench.results import Cost, Row, Seconds
from domeshim.bench.scenes import Scene
from domeshim.bench.stage import Player, Stage
from domeshim.lens.models import lens_of
from domeshim.options import Options

_WARM = 2
"""Pictures that build shaders, and do not count."""
_PATIENCE = 1.0
"""Seconds that all rounds of one method may take, if there are three of them."""

Heard = Callable[[str], object]
"""Hears what comes next."""


@dataclass(frozen=True)
class Contest:
    """How carefully to measure, and what to leave as it is."""

    options: Options
    """Of every dome, but for method and tolerance."""
    rounds: int = 15
    edges: int = 24
    """So many are drawn to see where they land."""

    def rows(self, scene: Scene, size: int, methods: Sequence[Method], heard: Heard) -> Iterator[Row]:
        """A row for each method, at size x size pixels.

        Raises DomeError for a method that this machine's GL cannot do.
        """
        costs, colours = self._timed(scene, size, methods, heard)
        for method in methods:
            heard(f"{scene.name} {size}: edges by {method}")
            row = Row(scene.name, scene.title, size, method.family, method.detail, costs[method])
            yield Row(
                **{**vars(row), "edges": self._edge_error(scene, size, method), "colour": colours.get(method)}
            )

    def _timed(
        self, scene: Scene, size: int, methods: Sequence[Method], heard: Heard
    ) -> tuple[dict[Method, Cost], dict[Method, float]]:
        """Every method's cost, and how far its colours are off where rays can tell."""
        lens = lens_of(*self.options.lens, self.options.fov)
        true = true_picture(scene.look, lens, size) if scene.look is not None else None
        with closing(Stage(size)) as stage:
            heard(f"{scene.name} {size}: shaders")
            stock = _Performance(stage.stock(), scene)
            players = {
                method: _Performance(stage.dome(method.options(self.options)), scene) for method in methods
            }
            for player in (stock, *players.values()):
                player.warm_up()
            colours = {
                method: colour_rms(player.picture(), true)
                for method, player in players.items()
                if true is not None
            }
            for number in range(self.rounds):
                heard(f"{scene.name} {size}: round {number + 1}")
                for player in (stock, *players.values()):
                    player.take(number)
            return {method: player.cost(stock) for method, player in players.items()}, colours

    def _edge_error(self, scene: Scene, size: int, method: Method) -> EdgeError:
        lens = lens_of(*self.options.lens, self.options.fov)
        scale = max(2, FINE // size)
        with closing(Stage(scale * size)) as stage:
            player = stage.dome(method.options(self.options, scale))
            look(player.gl, 1.0)
            found = []
            for edge, curve in telling(scene.edges, lens, scale * size, self.edges):
                player.show(lambda edge=edge: draw_edge(player.gl, edge))  # type: ignore[misc]
                found.append(curve.deviations(_grey(player)))
        return summary(found, size)


class _Performance:
    """One player with the scene set up in its window, and its times."""

    def __init__(self, player: Player, scene: Scene) -> None:
        self._player = player
        self._artist = Artist(player.gl, scene)
        self._times: dict[int, Seconds] = {}
        self._rounds = 0

    def warm_up(self) -> None:
        """Build what is built once; a very slow method is measured in fewer rounds."""
        for _ in range(_WARM):
            last = self._player.timed(self._artist.draw)
        self._rounds = max(3, int(_PATIENCE / max(last.wall, 1e-9)))

    def take(self, number: int) -> None:
        """Its turn in this round, counted from 0."""
        if number < self._rounds:
            self._times[number] = self._player.timed(self._artist.draw)

    def picture(self) -> NDArray[np.uint8]:
        """What it drew last, (size, size, 3), the top row first."""
        self._player.window.make_current()
        return _rgb(self._player)

    def cost(self, stock: _Performance) -> Cost:
        """Its times against the stock monitor's in the same rounds."""
        pairs = [(self._times[k], stock._times[k]) for k in self._times if k in stock._times]
        return Cost.of(pairs)


def _rgb(player: Player) -> NDArray[np.uint8]:
    width, height = player.window.size
    return np.frombuffer(player.pixels(), np.uint8).reshape(height, width, 3)


def _grey(player: Player) -> NDArray[np.uint8]:
    return _rgb(player)[..., 0]
