"""Cube faces as tiles of one picture: each as large as it must be; only what is seen of it has a place."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from domeshim.lens.faces import BORDER, Face
from domeshim.lens.landing import Floats
from domeshim.state.views import View
from domeshim.window.frame import Rectangle


@dataclass(frozen=True)
class Tile:
    """A face of so many pixels across, without its border."""

    face: Face
    size: int

    @property
    def side(self) -> int:
        """Pixels across, the border included."""
        return self.size + 2 * math.ceil(self.size * BORDER)

    @property
    def edge(self) -> float:
        """How far that reaches in the face's plane, each way."""
        return self.face.reach * self.side / self.size

    @cached_property
    def axes(self) -> Floats:
        """(3, 3), rows: the face's right, up and ahead."""
        return np.array(self.face.axes, float)

    @cached_property
    def part(self) -> Rectangle:
        """What is seen of it, in its own pixels."""
        low, left_out = (
            [round((end / self.edge + 1) / 2 * self.side) for end in self.face.part[start::2]]
            for start in (0, 1)
        )
        x, y = (max(end, 0) for end in low)
        right, top = (min(end, self.side) for end in left_out)
        return x, y, right - x, top - y

    def view_at(self, x: int, y: int) -> View:
        """The view whose seen part lies at this place of the picture; its viewport may reach beyond it."""
        left, bottom, width, height = self.part
        scaled = np.zeros((4, 4))
        scaled[:3, :3] = self.axes / [[self.edge], [self.edge], [1.0]]
        viewport = x - left, y - bottom, self.side, self.side
        face = tuple(scaled.T.ravel().tolist())
        return View(viewport, (x, y, width, height), (("domeFace", face),))


def packed(tiles: Sequence[Tile]) -> tuple[tuple[View, ...], tuple[int, int]]:
    """The tiles' views side by side, on shelves, the highest first; and the picture's width and height."""
    boxes = [tile.part[2:] for tile in tiles]
    widest = max(width for width, _ in boxes)
    limit = max(widest, math.isqrt(sum(width * height for width, height in boxes)))
    views: dict[int, View] = {}
    x = y = shelf = across = 0
    for number in sorted(range(len(tiles)), key=lambda i: -boxes[i][1]):
        width, height = boxes[number]
        if x and x + width > limit:
            x, y, shelf = 0, y + shelf, 0
        views[number] = tiles[number].view_at(x, y)
        x, shelf = x + width, max(shelf, height)
        across = max(across, x)
    return tuple(views[number] for number in range(len(tiles))), (across, y + shelf)
