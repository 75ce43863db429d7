"""Where points even in angle lie on a line, triangle or parallelogram: the twins of glsl/tessellate."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.floating]

_STRAIGHT = 1e-3
"""Below this angle, radians, evenly in angle is evenly in length."""


def line_weights(shares: Floats, angles: Floats, distances: Floats) -> Floats:
    """The weights of a line's two ends at shares of its angle: (n, 2), rows of sum 1.

    shares: (n, 2), rows of sum 1, of the ends; angles: (n,), of the lines, radians; distances: (n, 2), of
    the ends from the eye. With distances r0, r1 and angle a the point at fraction s of the angle has weights
    in the ratio of sin((1 - s) a) / r0 to sin(s a) / r1 (law of sines).
    """
    return _blended(shares, angles, distances, distances.min(1, keepdims=True))


def triangle_weights(shares: Floats, angles: Floats, distances: Floats) -> Floats:
    """The weights of a triangle's corners at shares of it, on each edge those of the line: (n, 3).

    shares: (n, 3), rows of sum 1; angles: (n, 3), radians, of the edge opposite to each corner; distances:
    (n, 3), of the corners from the eye.
    """
    products = np.roll(shares, -1, 1) * np.roll(shares, -2, 1)
    total = products.sum(1)
    inner = total > 0
    angle = (products * angles).sum(1) / np.where(inner, total, 1)
    nearest = np.where(shares == 0, np.inf, distances).min(1, keepdims=True)
    return np.where(inner[:, None], _blended(shares, angle, distances, nearest), shares)


def quad_weights(shares: Floats, angles: Floats, distances: Floats) -> Floats:
    """The weights of a parallelogram's corners at shares of its two ways, on edges those of lines: (n, 4).

    shares: (n, 2), from the first corner to the second, and to the fourth; angles: (n, 4), radians, of the
    edge from each corner to the next; distances: (n, 4), of the corners from the eye. Inside, the corners'
    directions are blended evenly in angle both ways, each by the angles of the two edges that go that way.
    """
    across, up = shares[:, :1], shares[:, 1:]
    nearest = distances.min(1, keepdims=True)
    of_across = _even(np.hstack([1 - across, across]), angles[:, :1] * (1 - up) + angles[:, 2:3] * up)
    of_up = _even(np.hstack([1 - up, up]), angles[:, 3:] * (1 - across) + angles[:, 1:2] * across)
    weights = of_across[:, [0, 1, 1, 0]] * of_up[:, [0, 0, 1, 1]] * (nearest / distances)
    for side, (on_side, along, ends) in enumerate(
        (
            (up == 0, across, [0, 1]),
            (across == 1, up, [1, 2]),
            (up == 1, across, [3, 2]),
            (across == 0, up, [0, 3]),
        )
    ):
        edge = np.zeros_like(weights)
        edge[:, ends] = line_weights(np.hstack([1 - along, along]), angles[:, side], distances[:, ends])
        weights = np.where(on_side, edge, weights)
    return np.asarray(weights / weights.sum(1, keepdims=True))


def _even(shares: Floats, angles: Floats) -> Floats:
    even: Floats = np.where(angles > _STRAIGHT, np.sin(shares * angles), shares)
    return even


def _blended(shares: Floats, angles: Floats, distances: Floats, nearest: Floats) -> Floats:
    even = _even(shares, angles[:, None])
    ratio = nearest / np.maximum(distances, np.finfo(float).tiny)
    weights = even * np.minimum(ratio, 1)
    total = weights.sum(1, keepdims=True)
    return np.where(total > 0, weights / np.where(total > 0, total, 1), shares)
