"""Keystone: the four corners of the dome's square picture go where the projector's flat picture needs them.

The numpy twin of glsl/surface/keystone.glsl.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from domeshim.options import Options

Floats = NDArray[np.float64]

WHOLE = (0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0)
"""The corners of the square itself."""


@dataclass(frozen=True)
class Keystone:
    """The one projective map of the square that takes its corners to four others."""

    corners: tuple[float, ...]
    """x and y of the lower left, lower right, upper right and upper left, 0 to 1 within the square."""

    @cached_property
    def matrix(self) -> Floats:
        """(3, 3): homogeneous places of the square, -1 to 1, -> where they go."""
        square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], float)
        goal = 2 * np.reshape(self.corners, (4, 2)) - 1
        rows = []
        for (x, y), (u, v) in zip(square, goal, strict=True):
            rows += [[x, y, 1, 0, 0, 0, -u * x, -u * y, -u], [0, 0, 0, x, y, 1, -v * x, -v * y, -v]]
        *_, last = np.linalg.svd(np.array(rows))
        found = last[-1].reshape(3, 3)
        return np.asarray(found / found[2, 2], float)

    def to_frame(self, disc: Floats) -> Floats:
        """disc: (..., 2) -> (..., 2) where the square's place goes."""
        return _through(self.matrix, disc)

    def to_disc(self, places: Floats) -> Floats:
        """The inverse of to_frame."""
        return _through(np.asarray(np.linalg.inv(self.matrix), float), places)

    @property
    def uniform(self) -> tuple[float, ...]:
        """The value of the snippet's domeKeystone."""
        return tuple(self.matrix.T.ravel().tolist())

    @property
    def stretch(self) -> float:
        """The most by which a length in the square grows."""
        steps = np.linspace(-1, 1, 33)
        grid = np.stack(np.meshgrid(steps, steps), -1)
        aside = [(self.to_frame(grid + step) - self.to_frame(grid)) / 1e-5 for step in ((1e-5, 0), (0, 1e-5))]
        return float(np.linalg.norm(np.stack(aside, -1), ord=2, axis=(-2, -1)).max())


def keystone_of(options: Options) -> Keystone | None:
    """The keystone that the options ask for, if any."""
    kind, corners = options.surface
    return Keystone(tuple(map(float, corners))) if kind == "keystone" else None


def _through(matrix: Floats, places: Floats) -> Floats:
    homogeneous = np.concatenate([places, np.ones_like(places[..., :1])], -1) @ matrix.T
    found: Floats = homogeneous[..., :2] / homogeneous[..., 2:]
    return found
