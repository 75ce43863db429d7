"""Primitives that span a wide angle are halved before the GPU subdivides them.

A triangle that passes close to the eye has nearly all of its angle in a sliver of its area; a blend of even
edges cannot follow that, and 64 pieces an edge may not be enough. Halving each wide edge evenly in angle does
both. An edge is split by what its two ends alone say, so neighbours stay together.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from domeshim.record.immediate import Run

_MOST_ROUNDS = 24

Floats = NDArray[np.floating]


def split_wide(piece: Run, corners: int, to_eye: Floats, widest: float) -> Run:
    """The piece with every edge under an angle.

    piece: (n * corners) vertices, primitive after primitive; corners: 2 or 3; to_eye: (4, 4), the piece's
    space to eye space; widest: radians. What has no finite position is left out.
    """
    positions = piece.positions
    if positions.shape[1] == 3:
        positions = np.hstack([positions, np.ones((len(positions), 1), np.float32)])
    names = list(piece.attributes)
    columns = np.cumsum([4, *(piece.attributes[name].shape[1] for name in names)])
    vertices = np.hstack([positions, *(piece.attributes[name] for name in names)]).astype(float)
    primitives = vertices.reshape(-1, corners, vertices.shape[1])
    primitives = primitives[np.isfinite(primitives[:, :, :4]).all((1, 2))]
    done = []
    for _ in range(_MOST_ROUNDS):
        angles, lengths = _edges(primitives[:, :, :4] @ to_eye.T)
        wide = angles.max(1) > widest
        done.append(primitives[~wide])
        if not wide.any():
            break
        primitives = _halved(primitives[wide], angles[wide].argmax(1), lengths[wide])
    else:
        done.append(primitives)
    flat = np.concatenate(done).reshape(-1, vertices.shape[1]).astype(np.float32)
    parts = np.split(flat, columns, axis=1)
    return replace(piece, positions=parts[0], attributes=dict(zip(names, parts[1:-1], strict=True)))


def _edges(eye: Floats) -> tuple[Floats, Floats]:
    """Angle of each edge, corner i to i + 1, and distance of each corner. eye: (m, corners, 4)."""
    points = np.where(eye[..., 3:] < 0, -eye[..., :3], eye[..., :3])
    lengths = np.linalg.norm(points, axis=-1)
    directions = points / np.maximum(lengths, 1e-300)[..., None]
    following = np.roll(directions, -1, 1)
    across = np.linalg.norm(np.cross(directions, following), axis=-1)
    angles = np.arctan2(across, (directions * following).sum(-1))
    return (angles[:, :1] if eye.shape[1] == 2 else angles), lengths


def _halved(primitives: Floats, edge: NDArray[np.integer], lengths: Floats) -> Floats:
    """Each primitive cut in two at the middle, in angle, of one edge."""
    rows = np.arange(len(primitives))
    a, b = edge, (edge + 1) % primitives.shape[1]
    ra, rb = lengths[rows, a][:, None], lengths[rows, b][:, None]
    middle = (rb * primitives[rows, a] + ra * primitives[rows, b]) / np.maximum(ra + rb, 1e-300)
    first, second = primitives.copy(), primitives.copy()
    first[rows, b] = middle
    second[rows, a] = middle
    return np.concatenate([first, second])
