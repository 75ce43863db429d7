"""How far what the GPU draws lies from where it belongs: straight pieces against great circles, in float64.

Nothing here draws: primitives caught on their way to the rasteriser are joined as it would join them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from domeshim.lens.orientation import Orientation
from domeshim.lens.projection import direction_of, disc_of
from domeshim.lens.radial import RadialLens
from domeshim.measure.feedback import Caught

Floats = NDArray[np.float64]

_FINE = 2000
"""Up to so many pieces each is looked at in many places."""
_CHUNK = 200_000
"""So many pieces are looked at in one go."""
_SAMPLES = 4001
"""Places along a true edge."""


@dataclass(frozen=True)
class Sight:
    """What decides where a point of eye space lands, and whether it is seen."""

    lens: RadialLens
    fov: float
    orientation: Orientation
    depth: tuple[float, float]
    """As the shaders' domeDepth: (a, b) with depth * r = a r + b."""

    @property
    def rim(self) -> float:
        """Where the picture ends, 1 at the inscribed circle."""
        return self.lens.rim

    def disc(self, points: Floats) -> Floats:
        """(..., 4) homogeneous points -> (..., 2) on the disc."""
        with np.errstate(invalid="ignore", divide="ignore"):
            return disc_of(_directions(points), self.lens, self.orientation)

    def sees(self, points: Floats) -> NDArray[np.bool_]:
        """Whether (..., 4) homogeneous points lie in the picture and between near and far."""
        with np.errstate(invalid="ignore", over="ignore"):
            a, b = self.depth
            r = np.linalg.norm(_directions(points), axis=-1)
            depth = a * r + b * np.abs(points[..., 3])
            within = (depth >= -r) & (depth <= r)
            inside = np.linalg.norm(self.disc(points), axis=-1) <= self.rim
        return np.asarray(within & inside & (self.from_axis(points) <= np.radians(self.fov / 2)))

    def from_axis(self, points: Floats) -> Floats:
        """(...): the angle of (..., 4) homogeneous points from the lens's axis, radians."""
        x, y, z = np.moveaxis(self.orientation.aimed(_directions(points)), -1, 0)
        return np.asarray(np.arctan2(np.hypot(x, y), -z))


class Deviation(NamedTuple):
    """The largest distances between what is drawn and what should be, in radii of the disc."""

    edges: float
    """Of any place of a drawn line, or of the edge at which a drawn surface ends, from where that should be,
    and of what should be seen from what is drawn; infinite where something should be and nothing is."""
    inside: float
    """Of any place inside a drawn surface from where it belongs: how far a texture is off."""


def deviation(caught: list[Caught], edges: Floats, allowed: Floats, sight: Sight) -> Deviation:
    """How far what is drawn lies from where it belongs.

    edges: (m, 2, 4) homogeneous ends of the lines, or of the outlines of the surfaces, that should be seen;
    allowed: (n, 2, 4) of those beside them that may be seen, as a point say, and need not.
    """
    lines = _finite([c for c in caught if c.positions.shape[1] == 2])
    surfaces = _finite([c for c in caught if c.positions.shape[1] == 3])
    drawn = np.concatenate([_clipped(lines), _clipped(_open_edges(surfaces))])
    truth = _true_curves(edges, sight)
    known = np.concatenate([truth, _true_curves(allowed, sight, truth.shape[1])])
    wrong, missing = _farthest_from_curves(drawn, known, sight), _farthest_from_pieces(truth, drawn, sight)
    short = _farthest_from_curves(_cuts(surfaces), known[:0], sight)
    return Deviation(max(wrong, missing, short), bend(surfaces, sight))


def bend(surfaces: Caught, sight: Sight) -> float:
    """How far a place inside a drawn triangle lies at most from where it belongs, given the corners' places.

    In radii of the disc; 0 where nothing is drawn. A corner of a triangle is w away in its own direction.
    """
    weights = _grid(12 if len(surfaces.positions) <= _FINE else 2)
    worst = 0.0
    for first in range(0, len(surfaces.positions), _CHUNK):
        part = slice(first, first + _CHUNK)
        corners = surfaces.positions[part].astype(float)
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            places = corners[..., :2] / corners[..., 3:]
            rays = direction_of(places, sight.lens, sight.orientation) * corners[..., 3:]
            clip = np.einsum("sk,nkc->nsc", weights, corners)
            cut = np.einsum("sk,nk->ns", weights, surfaces.distances[part].astype(float))
            drawn = clip[..., :2] / clip[..., 3:]
            true = disc_of(np.einsum("sk,nkc->nsc", weights, rays), sight.lens, sight.orientation)
            apart = np.linalg.norm(drawn - true, axis=-1)
            shown = (cut >= 0) & (np.abs(clip[..., 2]) <= clip[..., 3]) & (clip[..., 3] > 0)
            shown &= (np.linalg.norm(drawn, axis=-1) <= sight.rim) & np.isfinite(apart)
        worst = max(worst, float(apart[shown].max(initial=0.0)))
    return worst


def _finite(caught: list[Caught]) -> Caught:
    """All of it together without what has no finite place: the rasteriser draws nothing of that."""
    if not caught:
        nothing = np.zeros((0, 2, 4), np.float32)
        return Caught(nothing, nothing[..., 0])
    positions = np.concatenate([c.positions for c in caught])
    kept = np.isfinite(positions).all((1, 2))
    return Caught(positions[kept], np.concatenate([c.distances for c in caught])[kept])


def _grid(steps: int) -> Floats:
    """(n, 3) weights of evenly spread places of a triangle, the corners among them, and of its middle."""
    places = [(i, j, steps - i - j) for i in range(steps + 1) for j in range(steps + 1 - i)]
    places_and_middle = [*np.array(places) / steps, np.full(3, 1 / 3)]
    return np.array(places_and_middle)


def _open_edges(surfaces: Caught) -> Caught:
    """The edges that only one triangle has: where the surface ends, or is torn by as little as one bit."""
    positions = surfaces.positions
    if not len(positions):
        return _finite([])
    _, vertex = np.unique(positions.reshape(-1, 4), axis=0, return_inverse=True)
    triangles = vertex.reshape(-1, 3)
    solid = (triangles != np.roll(triangles, 1, 1)).all(1)
    starts = np.flatnonzero(solid)
    rows, columns = np.repeat(starts, 3), np.tile([0, 1, 2], len(starts))
    ends = np.sort(np.stack([triangles[rows, columns], triangles[rows, (columns + 1) % 3]], -1), 1)
    _, first, count = np.unique(ends, axis=0, return_index=True, return_counts=True)
    rows, columns = rows[first[count % 2 == 1]], columns[first[count % 2 == 1]]
    pair = np.stack([columns, (columns + 1) % 3], -1)
    return Caught(
        positions[rows[:, None], pair],
        surfaces.distances[rows[:, None], pair],
    )


def _cuts(surfaces: Caught) -> Floats:
    """(n, 2, 2): where triangles are cut off behind, on the disc: it should be at or beyond the rim."""
    inside = surfaces.distances >= 0
    halves = inside.any(1) & ~inside.all(1)
    positions, distances = surfaces.positions[halves].astype(float), surfaces.distances[halves].astype(float)
    alone = np.where(inside[halves].sum(1) == 1, inside[halves].argmax(1), (~inside[halves]).argmax(1))
    rows = np.arange(len(alone))[:, None]
    others = (alone[:, None] + [1, 2]) % 3
    a, b = distances[rows, alone[:, None]], distances[rows, others]
    t = (a / (a - b))[..., None]
    ends = positions[rows, alone[:, None]] * (1 - t) + positions[rows, others] * t
    with np.errstate(invalid="ignore", divide="ignore"):
        places = ends[..., :2] / ends[..., 3:]
    return np.asarray(places[np.isfinite(places).all((1, 2))])


def _clipped(pieces: Caught) -> Floats:
    """(n, 2, 2): the ends on the disc of what the clipping leaves of straight pieces."""
    ends = pieces.positions.astype(float)
    z, w = ends[..., 2], ends[..., 3]
    low, high = np.zeros(len(ends)), np.ones(len(ends))
    with np.errstate(invalid="ignore", divide="ignore"):
        for inside in (pieces.distances.astype(float), w - z, w + z):
            a, b = inside[:, 0], inside[:, 1]
            crossing = a / (a - b)
            low = np.where((a < 0) & (b >= 0), np.maximum(low, crossing), low)
            high = np.where((a >= 0) & (b < 0), np.minimum(high, crossing), high)
            high = np.where((a < 0) & (b < 0), -1.0, high)
        t = np.stack([low, high], -1)[..., None]
        cut = ends[:, :1] * (1 - t) + ends[:, 1:] * t
        places = cut[..., :2] / cut[..., 3:]
    return np.asarray(places[(low < high) & np.isfinite(places).all((1, 2)) & (cut[..., 3] > 0).all(1)])


def _true_curves(edges: Floats, sight: Sight, samples: int = 0) -> Floats:
    """(m, s, 3): each edge's places on the disc, evenly in angle, and 1 where it is seen, else 0.

    samples: how many, if not as many as it takes.
    """
    s = np.linspace(0, 1, samples or _SAMPLES)
    if sight.fov > 300 and not samples:  # close to straight behind the disc's places run fast
        s = np.sort(np.concatenate([s, *(_closer(edge, sight) for edge in edges)]))
    curves = []
    for edge in edges:
        points = _along(edge, s)
        curves.append(np.concatenate([sight.disc(points), sight.sees(points)[:, None]], -1))
    return np.array(curves).reshape(len(edges), len(s), 3)


def _closer(edge: Floats, sight: Sight) -> Floats:
    """Shares of an edge's angle, ever closer to where it passes nearest to straight behind."""
    s: Floats = np.linspace(0, 1, _SAMPLES)
    for _ in range(3):
        nearest, span = float(s[sight.from_axis(_along(edge, s)).argmax()]), float(s[1] - s[0])
        s = np.clip(np.linspace(nearest - 2 * span, nearest + 2 * span, _SAMPLES), 0, 1)
    around = np.geomspace(1e-9, 1, 2000)
    return np.asarray(np.clip(np.concatenate([nearest - around, nearest + around]), 0, 1))


def _along(edge: Floats, s: Floats) -> Floats:
    """(len(s), 4) homogeneous points at shares s of an edge's angle. edge: (2, 4)."""
    points = np.where(edge[:, 3:] < 0, -edge, edge)
    r = np.linalg.norm(points[:, :3], axis=-1)
    rays = points / np.maximum(r, 1e-300)[:, None]
    angle = np.arctan2(np.linalg.norm(np.cross(rays[0, :3], rays[1, :3])), rays[0, :3] @ rays[1, :3])
    if angle < 1e-12:
        return np.outer(1 - s, rays[0]) + np.outer(s, rays[1])
    return np.outer(np.sin((1 - s) * angle), rays[0]) + np.outer(np.sin(s * angle), rays[1])


def _directions(points: Floats) -> Floats:
    """(..., 4) homogeneous points -> (..., 3) as seen from the eye; w < 0 flips."""
    return np.asarray(np.where(points[..., 3:] < 0, -points[..., :3], points[..., :3]), float)


def _farthest_from_curves(pieces: Floats, curves: Floats, sight: Sight) -> float:
    """How far a place of the pieces, (n, 2, 2), inside the picture is at most from all curves and the rim."""
    from scipy.spatial import cKDTree  # noqa: PLC0415 - needed for measuring alone

    t = np.linspace(0, 1, 9 if len(pieces) > _FINE else 65)[:, None]
    places = (pieces[:, :1] * (1 - t) + pieces[:, 1:] * t).reshape(-1, 2)
    places = places[np.linalg.norm(places, axis=-1) < sight.rim]
    if not len(places):
        return 0.0
    from_rim = sight.rim - np.linalg.norm(places, axis=-1)
    apart = from_rim
    for curve in curves:
        even = _evenly(curve[np.isfinite(curve).all(1), :2])
        if len(even) > 1:
            _, near = cKDTree((even[1:] + even[:-1]) / 2).query(places, k=min(3, len(even) - 1))
            near = near.reshape(len(places), -1)
            apart = np.minimum(apart, _to_segments(places[:, None], even[near], even[near + 1]).min(1))
    return float(apart.max())


def _evenly(curve: Floats) -> Floats:
    """(m, 2): places of a curve, (n, 2), equally far apart: the nearest middle is the nearest part's."""
    lengths = np.linalg.norm(np.diff(curve, axis=0), axis=-1)
    along = np.concatenate([[0.0], np.cumsum(lengths)])
    if not along[-1] > 0:
        return curve[:2]
    even = np.linspace(0, along[-1], 10 * _SAMPLES)
    return np.stack([np.interp(even, along, curve[:, axis]) for axis in range(2)], -1)


def _farthest_from_pieces(curves: Floats, pieces: Floats, sight: Sight) -> float:
    """How far a place of the curves that is seen lies at most from all pieces, (n, 2, 2)."""
    places = curves.reshape(-1, 3)
    places = places[places[:, 2] > 0, :2]
    places = places[np.linalg.norm(places, axis=-1) < sight.rim * (1 - 1e-9)]
    if not len(places):
        return 0.0
    if not len(pieces):
        return np.inf
    from scipy.spatial import cKDTree  # noqa: PLC0415 - needed for measuring alone

    longest = np.linalg.norm(pieces[:, 1] - pieces[:, 0], axis=-1).max()
    parts = int(np.clip(np.ceil(longest / 2e-3), 1, 2000))
    t = np.linspace(0, 1, parts + 1)[None, :, None]
    cut = pieces[:, :1] * (1 - t) + pieces[:, 1:] * t
    starts, ends = cut[:, :-1].reshape(-1, 2), cut[:, 1:].reshape(-1, 2)
    _, near = cKDTree((starts + ends) / 2).query(places, k=min(6, len(starts)))
    near = near.reshape(len(places), -1)
    return float(_to_segments(places[:, None], starts[near], ends[near]).min(1).max())


def _to_segments(places: Floats, starts: Floats, ends: Floats) -> Floats:
    """Distance of places to segments, (..., 2) each."""
    along = ends - starts
    square = np.maximum((along**2).sum(-1), 1e-300)
    t = np.clip(((places - starts) * along).sum(-1) / square, 0, 1)
    return np.asarray(np.linalg.norm(places - starts - t[..., None] * along, axis=-1))
