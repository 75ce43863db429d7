"""How far straight edges land from their true curves on the disc, judged by pictures, as for any renderer.

Each edge is drawn alone. Where it was drawn is the mean of the ink across it, so that a line's width and its
softness are no errors.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from domeshim.bench.meshes import Floats
from domeshim.lens.landing import Lens
from domeshim.lens.projection import disc_of

INNER = 0.99
"""The share of the disc's radius that is looked at."""
FINE = 2048
"""Edges are judged in pictures at least so large, drawn no finer than in the size that is measured."""
_LOST = 2.0
"""Pixels: where no ink is nearer, the edge is lost."""
_STEP = 4.0
"""Pixels along an edge whose ink is taken together."""


@dataclass(frozen=True)
class EdgeError:
    """Of all edges together, in pixels of the dome's picture."""

    mean: float
    largest: float
    lost: float
    """The share of the edges' length with no ink within two pixels of it."""


@dataclass(frozen=True)
class TrueEdge:
    """One edge's curve: where it is to be seen."""

    places: Floats
    """(s, 2) on the disc up to the rim, in order, at most half of _STEP apart at the size asked for."""
    normals: Floats
    """(s, 2): unit vectors across it."""

    @classmethod
    def of(cls, edge: Floats, lens: Lens, size: int) -> TrueEdge | None:
        """The curve of an edge, (2, 3), in a picture of size pixels; None where too little is seen of it."""
        away = np.linalg.norm(edge, axis=1)
        directions = edge / away[:, None]
        angle = np.arctan2(np.linalg.norm(np.cross(*directions)), directions[0] @ directions[1])
        if angle < 1e-6 or angle > np.pi - 1e-6:
            return None
        share = np.linspace(0, 1, 2 + int(2 * size * angle / _STEP))[:, None]
        along = (
            np.sin((1 - share) * angle) * directions[0] + np.sin(share * angle) * directions[1]
        ) / np.sin(angle)
        places = disc_of(along, lens)
        seen = np.linalg.norm(places, axis=1) <= 1
        ways = np.gradient(places, axis=0)
        normals = np.stack([-ways[:, 1], ways[:, 0]], -1)
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
        places, normals = places[seen], normals[seen]
        inner = places[np.linalg.norm(places, axis=1) <= INNER]
        if len(inner) < 3 or _length(inner) * size / 2 < 1.0:
            return None
        return cls(places, normals)

    def deviations(self, picture: NDArray[np.uint8]) -> Floats:
        """(bins,): how far from each stretch of the curve the ink is, in radii; infinite where there is none.

        picture: (size, size), the top row first.
        """
        from scipy.spatial import cKDTree  # noqa: PLC0415 - for measuring alone

        size = len(picture)
        rows, columns = np.nonzero(picture)
        ink = np.stack([2 * columns + 1 - size, size - 2 * rows - 1], -1) / size
        weight = picture[rows, columns].astype(float)
        bins = self._bins(size)
        count = bins[-1] + 1
        judged = np.bincount(bins, np.linalg.norm(self.places, axis=1) > INNER, count) == 0
        if not len(ink):
            return np.asarray(np.full(count, np.inf)[judged])
        _, nearest = cKDTree(self.places).query(ink)
        beside = ink - self.places[nearest]
        signed = np.copysign(np.linalg.norm(beside, axis=1), (beside * self.normals[nearest]).sum(1))
        total = np.bincount(bins[nearest], weight, count)
        moment = np.bincount(bins[nearest], weight * signed, count)
        bare, _ = cKDTree(ink).query(self.places)
        nearest_ink = np.full(count, np.inf)
        np.minimum.at(nearest_ink, bins, bare)
        with np.errstate(invalid="ignore", divide="ignore"):
            off = np.where(total > 0, np.abs(moment / total), nearest_ink)
        return np.asarray(off[judged])

    def _bins(self, size: int) -> NDArray[np.int64]:
        steps = np.linalg.norm(np.diff(self.places, axis=0), axis=1) * size / 2
        along = np.concatenate([[0.0], np.cumsum(steps)])
        count = max(1, round(along[-1] / _STEP))
        return np.asarray(np.minimum((along / max(along[-1], 1e-300) * count).astype(int), count - 1))


def summary(deviations: Sequence[Floats], size: int) -> EdgeError:
    """The error of all edges; deviations in radii, each edge's; size: of the dome's picture, pixels.

    What is nowhere to be seen counts as lost and has no place that could be off.
    """
    off = np.concatenate(deviations) * size / 2
    drawn = off[np.isfinite(off)]
    lost = float((off > _LOST).mean() if len(off) else 0.0)
    if not len(drawn):
        return EdgeError(np.inf, np.inf, lost)
    return EdgeError(float(drawn.mean()), float(drawn.max()), lost)


def telling(edges: Floats, lens: Lens, size: int, count: int) -> list[tuple[Floats, TrueEdge]]:
    """Edges to be measured, with their curves: half of them those that span most, half any.

    edges: (e, 2, 3). Fewer where fewer can be seen.
    """
    directions = edges / np.linalg.norm(edges, axis=2, keepdims=True)
    widest = np.argsort((directions[:, 0] * directions[:, 1]).sum(1))
    found: dict[int, tuple[Floats, TrueEdge]] = {}
    for order, wanted in (
        (widest, (count + 1) // 2),
        (np.random.default_rng(3).permutation(len(edges)), count),
    ):
        for number in order[: 50 * count]:
            if len(found) >= wanted:
                break
            curve = TrueEdge.of(edges[number], lens, size) if number not in found else None
            if curve is not None:
                found[int(number)] = edges[number], curve
    return list(found.values())


def _length(places: Floats) -> float:
    return float(np.linalg.norm(np.diff(places, axis=0), axis=1).sum())
