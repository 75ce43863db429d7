"""Where a direction lands on the disc, in float64: the numpy twin of glsl/place and glsl/bend."""

from __future__ import annotations

import numpy as np

from domeshim.lens.models import Floats, Lens


def tilted(directions: Floats, tilt: float) -> Floats:
    """Directions as the dome sees them once its axis is raised.

    directions: (..., 3) in eye space; tilt: degrees -> (..., 3), the dome's axis along -z.
    """
    c, s = np.cos(np.radians(tilt)), np.sin(np.radians(tilt))
    x, y, z = np.moveaxis(np.asarray(directions, float), -1, 0)
    return np.stack([x, c * y + s * z, c * z - s * y], -1)


def disc_of(directions: Floats, lens: Lens, tilt: float = 0.0) -> Floats:
    """directions: (..., 3) in eye space, any length -> (..., 2) on the disc, 1 at the inscribed circle."""
    d = tilted(directions, tilt)
    d = d / np.abs(d).max(-1, keepdims=True)
    rxy = np.hypot(d[..., 0], d[..., 1])
    phi = np.arctan2(rxy, -d[..., 2])
    with np.errstate(invalid="ignore", divide="ignore"):
        factor = np.where(rxy > 0, lens.radius(phi) / rxy, 0.0)
    disc: Floats = d[..., :2] * factor[..., None]
    return disc


def direction_of(disc: Floats, lens: Lens, tilt: float = 0.0) -> Floats:
    """disc: (..., 2) -> (..., 3) unit direction in eye space; nan outside the lens."""
    disc = np.asarray(disc, float)
    radius = np.hypot(disc[..., 0], disc[..., 1])
    phi = lens.angle(radius)
    with np.errstate(invalid="ignore", divide="ignore"):
        factor = np.where(radius > 0, np.sin(phi) / radius, 0.0)
    d = np.concatenate([disc * factor[..., None], -np.cos(phi)[..., None]], -1)
    return tilted(d, -tilt)
