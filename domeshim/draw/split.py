"""Primitives that span a wide angle are halved, edge by edge, evenly in angle.

A triangle that passes close to the eye has nearly all of its angle in a sliver of its area; a blend of even
edges cannot follow that, and the GPU's pieces of an edge may not be enough. Halving each wide edge evenly in
angle does both. An edge is split by what its two ends alone say, so neighbours stay together.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from domeshim.record.immediate import Run

_MOST_ROUNDS = 64

Floats = NDArray[np.floating]


def split_wide(run: Run, corners: int, to_eye: Floats, widest: float) -> Run:
    """Pieces with every edge under an angle, which keep the corners of the primitive that they come from.

    run: (n * corners) vertices, primitive after primitive; corners: 2 or 3; to_eye: (4, 4), the run's space
    to eye space; widest: radians. What has no finite position is left out. The result has two attributes
    more: "place", each piece's own corners, and "weights", where they lie in the whole primitive.
    """
    parents, places, weights = _pieces(run, corners, to_eye, widest)
    chosen = (parents[:, None] * corners + np.arange(corners)).ravel()
    attributes = {name: values[chosen] for name, values in run.attributes.items()}
    if corners == 2:
        weights = np.concatenate([weights, np.zeros_like(weights[:, :, :1])], -1)
    attributes["place"] = places.reshape(-1, 4).astype(np.float32)
    attributes["weights"] = weights.reshape(-1, 3).astype(np.float32)
    return replace(run, positions=run.positions[chosen], attributes=attributes)


def triangles_under(run: Run, to_eye: Floats, widest: float, *, flat: bool) -> Run:
    """The same for triangles, as vertices of their own: all attributes are blended.

    flat: what a colour is made of is the third corner's all over a triangle.
    """
    parents, places, weights = _pieces(run, 3, to_eye, widest)

    def blended(name: str, values: NDArray[np.float32]) -> NDArray[np.float32]:
        of_corners = values.reshape(-1, 3, values.shape[1])[parents]
        if flat and makes_color(name):
            of_corners = np.broadcast_to(of_corners[:, 2:], of_corners.shape)
        mixed: NDArray[np.float32] = (weights @ of_corners).reshape(-1, values.shape[1]).astype(np.float32)
        return mixed

    attributes = {name: blended(name, values) for name, values in run.attributes.items()}
    return replace(run, positions=places.reshape(-1, 4).astype(np.float32), attributes=attributes)


def makes_color(attribute: str) -> bool:
    """An attribute is one value all over a flat-shaded primitive."""
    return attribute != "fog" and not attribute.startswith("texture")


def homogeneous(positions: Floats) -> Floats:
    """(n, 3 or 4) positions as (n, 4) in float64."""
    if positions.shape[1] == 3:
        positions = np.hstack([positions, np.ones((len(positions), 1), np.float32)])
    return positions.astype(float)


def _pieces(run: Run, corners: int, to_eye: Floats, widest: float) -> tuple[NDArray[np.intp], Floats, Floats]:
    """Each piece's primitive, (m,), its corners, (m, corners, 4), and where those lie in the primitive.

    The last are weights of the primitive's corners: (m, corners, corners), the rows of sum 1.
    """
    places = homogeneous(run.positions).reshape(-1, corners, 4)
    parents = np.flatnonzero(np.isfinite(places).all((1, 2)))
    weights = np.broadcast_to(np.eye(corners), (len(places), corners, corners))
    pieces = np.concatenate([places, weights], -1)[parents]
    done_pieces, done_parents = [], []
    for _ in range(_MOST_ROUNDS):
        angles, lengths = angles_between(pieces[:, :, :4] @ to_eye.T)
        wide = angles.max(1, initial=0) > widest
        done_pieces.append(pieces[~wide])
        done_parents.append(parents[~wide])
        if not wide.any():
            break
        pieces = _halved(pieces[wide], angles[wide].argmax(1), lengths[wide])
        parents = np.tile(parents[wide], 2)
    else:
        done_pieces.append(pieces)
        done_parents.append(parents)
    all_pieces = np.concatenate(done_pieces)
    return np.concatenate(done_parents), all_pieces[:, :, :4], all_pieces[:, :, 4:]


def angles_between(eye: Floats) -> tuple[Floats, Floats]:
    """Angle of each edge, corner i to i + 1, and distance of each corner. eye: (m, corners, 4)."""
    points = np.where(eye[..., 3:] < 0, -eye[..., :3], eye[..., :3])
    lengths = np.linalg.norm(points, axis=-1)
    directions = points / np.maximum(lengths, 1e-300)[..., None]
    following = np.roll(directions, -1, 1)
    across = np.linalg.norm(np.cross(directions, following), axis=-1)
    angles = np.arctan2(across, (directions * following).sum(-1))
    return (angles[:, :1] if eye.shape[1] == 2 else angles), lengths


def _halved(pieces: Floats, edge: NDArray[np.integer], lengths: Floats) -> Floats:
    """Each piece cut in two at the middle, in angle, of one edge."""
    rows = np.arange(len(pieces))
    a, b = edge, (edge + 1) % pieces.shape[1]
    ra, rb = lengths[rows, a][:, None], lengths[rows, b][:, None]
    middle = (rb * pieces[rows, a] + ra * pieces[rows, b]) / np.maximum(ra + rb, 1e-300)
    first, second = pieces.copy(), pieces.copy()
    first[rows, b] = middle
    second[rows, a] = middle
    return np.concatenate([first, second])
