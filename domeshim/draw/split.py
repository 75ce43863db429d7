"""Primitives that span a wide angle are halved, edge by edge, evenly in angle.

A triangle that passes close to the eye has nearly all of its angle in a sliver of its area; a blend of even
edges cannot follow that, and the GPU's pieces of an edge may not be enough. Halving each wide edge evenly in
angle does both. An edge is split by what its two ends alone say, so neighbours stay together.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from domeshim.lens.detail import room_behind
from domeshim.record.runs import Run

_MOST_ROUNDS = 64
_SHARE = 0.5
"""How long an edge may be as a share of its angle from straight behind: its pieces are alike then."""
_HORIZON = 1e-6
"""How small a share of a primitive's largest w still lies ahead: far outside of any view."""
_SECOND_ENDS = {2: [1], 3: [1, 2, 0], 4: [1, 2, 3, 0]}
"""Each edge's second end, by how many corners there are; its first has the edge's own number."""
_TURNED = [0, 1, 2, 0, 1]
_STIFFEST = np.log(1e30)
"""How many times farther away an edge's one end may be than the other, as a logarithm."""
_SURELY_NOT_STIFF = 1e29
_SQUARE = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
"""(4, 2): where a quad's corners lie in it."""

Floats = NDArray[np.floating]


@dataclass(frozen=True)
class Limit:
    """Up to what angle an edge may stay whole: less the closer it comes to straight behind, where all bends.

    Angles are in radians.
    """

    widest: float
    """For an edge at least one radian away from straight behind."""
    aft: tuple[float, float, float] = (0.0, 0.0, 1.0)
    """The direction straight behind, in eye space."""
    least: float = 1.0
    """Closer to straight behind than this nothing is drawn; 1: close enough to make no difference."""
    piece: float = np.inf
    """The longest edge that needs no pieces."""

    def at(self, behind: float) -> float:
        """The limit of an edge that is nowhere closer to straight behind than this."""
        return self.widest if self.least == 1 else float(self._near(np.array(behind)))

    def of_edges(self, directions: Floats, angles: Floats, lengths: Floats) -> Floats:
        """The limit of each edge, or of all, by its ends alone. directions: (m, corners, 3).

        angles: (m, edges), corner i to i + 1; lengths: (m, corners). An arc is nowhere closer to straight
        behind than its closer end less half its own angle. An edge too stiff for single precision has to come
        out as one piece.
        """
        edges = angles.shape[1]
        if self.least == 1 and lengths.max(initial=0.0) < _SURELY_NOT_STIFF * lengths.min(initial=np.inf):
            return np.asarray(self.widest)
        with np.errstate(divide="ignore", invalid="ignore"):
            stiff = (np.abs(np.log(lengths / np.roll(lengths, -1, 1))) > _STIFFEST)[:, :edges]
        whole = np.where(stiff, self.piece, np.inf)
        if self.least == 1:
            return np.minimum(whole, self.widest)
        behind = _angles_between(directions, np.array(self.aft))
        closer = np.minimum(behind, np.roll(behind, -1, 1))[:, :edges]
        return np.minimum(whole, self._near(closer - angles / 2))

    def _near(self, behind: Floats) -> Floats:
        if self.least == 1:
            return np.full_like(behind, self.widest)
        near = room_behind(behind, self.least)
        limits: Floats = np.minimum(self.widest * np.minimum(near, 1.0), near * _SHARE)
        return limits


def split_wide(run: Run, corners: int, to_eye: Floats, limit: Limit) -> Run:
    """Pieces with every edge under its limit, which keep the corners of the primitive that they come from.

    run: (n * corners) vertices, primitive after primitive; corners: 2, 3 or a parallelogram's 4; to_eye:
    (4, 4), the run's space to eye space. What has no finite position is left out. The result has two
    attributes more: "place", each piece's own corners, and "weights", where they lie in the whole primitive.
    """
    parents, places, weights = _pieces(run, corners, to_eye, limit)
    chosen = (parents[:, None] * corners + np.arange(corners)).ravel()
    attributes = {name: values[chosen] for name, values in run.attributes.items()}
    attributes["place"] = places.reshape(-1, 4).astype(np.float32)
    attributes["weights"] = np.zeros((len(chosen), 3), np.float32)
    attributes["weights"][:, : weights.shape[2]] = weights.reshape(-1, weights.shape[2])
    return replace(run, positions=run.positions[chosen], attributes=attributes)


def triangles_under(run: Run, to_eye: Floats, limit: Limit, *, flat: bool, counting: bool = False) -> Run:
    """The same for triangles, as vertices of their own: all attributes are blended.

    flat: what a colour is made of is the third corner's all over a triangle. counting: the result has the
    attribute "pieces", of an edge, as many as make so many pieces of the whole triangle.
    """
    parents, places, weights = _pieces(run, 3, to_eye, limit)

    def blended(name: str, values: NDArray[np.float32]) -> NDArray[np.float32]:
        of_corners = values.reshape(-1, 3, values.shape[1])[parents]
        if flat and makes_color(name):
            of_corners = np.broadcast_to(of_corners[:, 2:], of_corners.shape)
        mixed: NDArray[np.float32] = (weights @ of_corners).reshape(-1, values.shape[1]).astype(np.float32)
        return mixed

    attributes = {name: blended(name, values) for name, values in run.attributes.items()}
    if counting:
        of_edges = np.ceil(np.sqrt(np.bincount(parents)))[parents]
        attributes["pieces"] = np.repeat(of_edges, 3)[:, None].astype(np.float32)
    return replace(run, positions=places.reshape(-1, 4).astype(np.float32), attributes=attributes)


def makes_color(attribute: str) -> bool:
    """An attribute is one value all over a flat-shaded primitive."""
    return attribute != "fog" and not attribute.startswith("texture")


def _pieces(run: Run, corners: int, to_eye: Floats, limit: Limit) -> tuple[NDArray[np.intp], Floats, Floats]:
    """Each piece's primitive, (m,), its corners, (m, corners, 4), and where those lie in the primitive.

    The last are weights of the primitive's corners: (m, corners, corners), the rows of sum 1; of a quad the
    places in it, (m, 4, 2), from (0, 0) at its first corner to (1, 1) at its third.
    """
    within = _SQUARE if corners == 4 else np.eye(corners)
    whole = np.empty((len(run.positions) // corners, corners, 4 + within.shape[1]))
    whole[..., 3] = 1.0
    whole[..., : run.positions.shape[1]] = run.positions.reshape(len(whole), corners, -1)
    whole[..., 4:] = within
    parents = np.flatnonzero(np.isfinite(whole).all((1, 2)))
    pieces, parents = ahead_of_viewer(whole[parents], parents, to_eye)
    cut = _cut if corners == 4 else _halved
    done_pieces, done_parents = [], []
    for _ in range(_MOST_ROUNDS):
        angles, limits, lengths = edges_of((pieces[:, :, None, :4] * to_eye).sum(-1), limit)
        over = angles > limits
        wide = over.any(1)
        count = np.count_nonzero(wide)
        if not count:
            done_pieces.append(pieces)
            done_parents.append(parents)
            break
        if count < len(pieces):
            done_pieces.append(pieces[~wide])
            done_parents.append(parents[~wide])
            pieces, parents, over = pieces[wide], parents[wide], over[wide]
            angles, lengths = angles[wide], lengths[wide]
        pieces = cut(pieces, np.where(over, angles, 0), lengths)
        parents = np.concatenate([parents, parents])
    else:
        done_pieces.append(pieces)
        done_parents.append(parents)
    all_pieces = np.concatenate(done_pieces)
    return np.concatenate(done_parents), all_pieces[:, :, :4], all_pieces[:, :, 4:]


def ahead_of_viewer(
    pieces: Floats, parents: NDArray[np.intp], to_eye: Floats
) -> tuple[Floats, NDArray[np.intp]]:
    """Of pieces that have w both above 0 and below, by to_eye, what lies above: nothing else is seen of them.

    So it is with what passes the viewer of a small view on the panel. An edge from one side to the other
    passes infinity: halving it would not end. pieces: (m, corners, 4 or more), homogeneous places and what
    goes with them; parents: (m,). Lines stay as many, and in their order.
    """
    w = (pieces[:, :, :4] * to_eye[3]).sum(-1)
    if w.min(initial=0.0) == 0:
        return pieces, parents
    passing = w.min(1, keepdims=True) < 0
    heights = np.where(passing, w - _HORIZON * np.abs(w).max(1, keepdims=True), 1.0)
    ahead = heights > 0
    count = np.where((w < 0).any(1), ahead.sum(1), 0)
    one, two = count == 1, (count == 2) & (ahead.shape[1] == 3)
    if one.any():
        pieces = pieces.copy()
        pieces[one] = _point_ahead(pieces[one], heights[one])
    if two.any():
        pieces = np.concatenate([pieces[~two], *_edge_ahead(pieces[two], heights[two])])
        parents = np.concatenate([parents[~two], np.tile(parents[two], 2)])
    return pieces, parents


def _point_ahead(pieces: Floats, heights: Floats) -> Floats:
    """Of pieces with one corner above height 0, what lies there."""
    rows, top = np.arange(len(pieces)), heights.argmax(1)
    cut = pieces.copy()
    for step in range(1, pieces.shape[1]):
        other = (top + step) % pieces.shape[1]
        cut[rows, other] = _at_height_0(pieces, heights, top, other)
    return cut


def _edge_ahead(pieces: Floats, heights: Floats) -> list[Floats]:
    """Of triangles with two corners above height 0, what lies there: two triangles of each."""
    rows, under = np.arange(len(pieces)), heights.argmin(1)
    following, before = (under + 1) % 3, (under + 2) % 3
    first, second = pieces.copy(), pieces.copy()
    first[rows, under] = second[rows, following] = _at_height_0(pieces, heights, under, following)
    second[rows, under] = _at_height_0(pieces, heights, under, before)
    return [first, second]


def _at_height_0(pieces: Floats, heights: Floats, start: NDArray[np.intp], end: NDArray[np.intp]) -> Floats:
    """The point of height 0 between two corners of each piece, of which one lies above and one below."""
    rows = np.arange(len(pieces))
    a, b = np.abs(heights[rows, start])[:, None], np.abs(heights[rows, end])[:, None]
    point: Floats = (b * pieces[rows, start] + a * pieces[rows, end]) / (a + b)
    return point


def edges_of(eye: Floats, limit: Limit) -> tuple[Floats, Floats, Floats]:
    """Each edge's angle and limit, corner i to i + 1, and each corner's distance. eye: (m, corners, 4)."""
    points = np.where(eye[..., 3:] < 0, -eye[..., :3], eye[..., :3])
    lengths = np.sqrt(_summed(points * points))
    directions = points / np.maximum(lengths, 1e-300)[..., None]
    others = _SECOND_ENDS[eye.shape[1]]
    angles = _angles_between(directions[:, : len(others)], directions[:, others])
    return angles, limit.of_edges(directions, angles, lengths), lengths


def _angles_between(a: Floats, b: Floats) -> Floats:
    """Radians between unit vectors, (..., 3)."""
    u, v = a[..., _TURNED], b[..., _TURNED]
    across = u[..., 1:4] * v[..., 2:5] - u[..., 2:5] * v[..., 1:4]  # np.cross takes several times as long
    angles: Floats = np.arctan2(np.sqrt(_summed(across * across)), _summed(a * b))
    return angles


def _summed(vectors: Floats) -> Floats:
    """The sum of each vector's three numbers, in their order: np.sum takes another for other shapes."""
    total: Floats = vectors[..., 0] + vectors[..., 1] + vectors[..., 2]
    return total


def _halved(pieces: Floats, wide: Floats, lengths: Floats) -> Floats:
    """Each line or triangle cut in two at the middle, in angle, of its widest edge. Shapes as for _cut."""
    rows = np.arange(len(pieces))
    a = wide.argmax(1)
    b = (a + 1) % pieces.shape[1]
    middle = _middle(pieces[rows, a], pieces[rows, b], lengths[rows, a], lengths[rows, b])
    halves = np.concatenate([pieces, pieces])
    halves[rows, b] = halves[len(rows) + rows, a] = middle
    return halves


def _cut(pieces: Floats, wide: Floats, lengths: Floats) -> Floats:
    """Each quad cut in two at the middle, in angle, of its widest edge.

    pieces: (n, 4, k), the corners' places first; wide: (n, 4), the angle of each edge, corner i to i + 1, 0
    where it may stay whole; lengths: (n, 4). The cut goes to the opposite edge where that is wide as well,
    else to a corner: no edge is cut but for its own sake. A triangle comes out as a quad whose last two
    corners are one.
    """
    rows = np.arange(len(pieces))[:, None]
    order = (wide.argmax(1)[:, None] + np.arange(4)) % 4
    pieces, lengths = pieces[rows, order], lengths[rows, order]
    middles = _middle(pieces[:, ::2], pieces[:, 1::2], lengths[:, ::2], lengths[:, 1::2])
    opposite_wide = wide[rows, order[:, 2:3]] > 0
    halves = np.concatenate([pieces, pieces])
    first, second = halves[: len(pieces)], halves[len(pieces) :]
    first[:, 1] = second[:, 0] = middles[:, 0]
    first[:, 2] = second[:, 3] = np.where(opposite_wide, middles[:, 1], pieces[:, 2])
    return halves


def _middle(a: Floats, b: Floats, a_length: Floats, b_length: Floats) -> Floats:
    """Halfway, in angle, between points at these distances from the eye. a, b: (.., k); lengths: (..)."""
    a_length, b_length = a_length[..., None], b_length[..., None]
    middle: Floats = (b_length * a + a_length * b) / np.maximum(a_length + b_length, 1e-300)
    return middle
