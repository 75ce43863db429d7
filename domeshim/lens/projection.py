"""Where a direction lands in the picture, in float64: the numpy twin of glsl/aim and glsl/bend."""

from __future__ import annotations

import numpy as np

from domeshim.lens.landing import Floats, Lens
from domeshim.lens.orientation import STRAIGHT, Orientation


def disc_of(directions: Floats, lens: Lens, orientation: Orientation = STRAIGHT) -> Floats:
    """directions: (..., 3) in eye space, any length -> (..., 2) in the picture, 1 at its sides."""
    return lens.landed(orientation.aimed(directions))


def direction_of(disc: Floats, lens: Lens, orientation: Orientation = STRAIGHT) -> Floats:
    """disc: (..., 2) -> (..., 3) unit direction in eye space; nan outside the lens."""
    d = orientation.seen(lens.ray(disc))
    return np.asarray(d / np.linalg.norm(d, axis=-1, keepdims=True), float)
