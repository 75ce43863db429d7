"""Where points even in angle lie on a line or a triangle: the twins of glsl/tessellate's weights."""

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


def _blended(shares: Floats, angles: Floats, distances: Floats, nearest: Floats) -> Floats:
    angles = angles[:, None]
    even = np.where(angles > _STRAIGHT, np.sin(shares * angles), shares)
    ratio = nearest / np.maximum(distances, np.finfo(float).tiny)
    weights = even * np.minimum(ratio, 1)
    total = weights.sum(1, keepdims=True)
    return np.where(total > 0, weights / np.where(total > 0, total, 1), shares)
