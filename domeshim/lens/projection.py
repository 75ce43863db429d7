"""Where a direction lands on the disc, in float64: the numpy twin of glsl/aim and glsl/bend."""

from __future__ import annotations

import numpy as np

from domeshim.lens.models import Floats, Lens
from domeshim.lens.orientation import STRAIGHT, Orientation


def disc_of(directions: Floats, lens: Lens, orientation: Orientation = STRAIGHT) -> Floats:
    """directions: (..., 3) in eye space, any length -> (..., 2) on the disc, 1 at the inscribed circle."""
    d = orientation.aimed(directions)
    d = d / np.abs(d).max(-1, keepdims=True)
    rxy = np.hypot(d[..., 0], d[..., 1])
    phi = np.arctan2(rxy, -d[..., 2])
    with np.errstate(invalid="ignore", divide="ignore"):
        factor = np.where(rxy > 0, lens.radius(phi) / rxy, 0.0)
    disc: Floats = d[..., :2] * factor[..., None]
    return disc


def direction_of(disc: Floats, lens: Lens, orientation: Orientation = STRAIGHT) -> Floats:
    """disc: (..., 2) -> (..., 3) unit direction in eye space; nan outside the lens."""
    disc = np.asarray(disc, float)
    radius = np.hypot(disc[..., 0], disc[..., 1])
    phi = lens.angle(radius)
    with np.errstate(invalid="ignore", divide="ignore"):
        factor = np.where(radius > 0, np.sin(phi) / radius, 0.0)
    d = orientation.seen(np.concatenate([disc * factor[..., None], -np.cos(phi)[..., None]], -1))
    return np.asarray(d / np.linalg.norm(d, axis=-1, keepdims=True), float)
