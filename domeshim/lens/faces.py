"""The cube around the viewer: which of its faces a dome needs, how fine, and what of each.

A face's own axes are right, up and ahead; its plane lies at distance 1, and the face spans -reach to reach on
it. The cube is turned with the dome: its front lies around the dome's axis (-z).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from domeshim.lens.landing import Floats
from domeshim.lens.orientation import Orientation
from domeshim.lens.radial import RadialLens

Axes = tuple[tuple[int, int, int], ...]
_AXES: tuple[Axes, ...] = (
    ((1, 0, 0), (0, 1, 0), (0, 0, -1)),  # front
    ((0, 0, 1), (0, 1, 0), (1, 0, 0)),  # right
    ((0, 0, -1), (0, 1, 0), (-1, 0, 0)),  # left
    ((1, 0, 0), (0, 0, 1), (0, 1, 0)),  # top
    ((1, 0, 0), (0, 0, -1), (0, -1, 0)),  # bottom
    ((-1, 0, 0), (0, 1, 0), (0, 0, 1)),  # back
)
BORDER = 1 / 32
"""Each face is drawn so much wider on every side, in its sizes: what lies across a seam stays whole."""
_MARGIN = 2 * BORDER
"""What is seen is found along a grid of directions; in a face's plane none is farther from it than this."""
_RINGS, _SPOKES = 257, 1024


@dataclass(frozen=True)
class Face:
    """One face of the cube."""

    axes: Axes
    """Rows: right, up and ahead, in the dome's space."""
    reach: float
    """1; less where the dome shows less than the front face."""
    part: tuple[float, float, float, float]
    """Left, right, bottom, top of what the dome shows of it, border included, in its plane."""


def faces_of(fov: float, orientation: Orientation) -> list[Face]:
    """The faces that a dome shows; fov: of its lens, degrees.

    From the dome's centre these are 1 up to 90 degrees, 5 up to 250.5 and 6 beyond.
    """
    seen = _seen(math.radians(fov / 2), orientation)
    nearest = np.stack([seen @ np.array(axes[2], float) for axes in _AXES]).argmax(0)
    parts = {axes: seen[nearest == number] @ np.array(axes, float).T for number, axes in enumerate(_AXES)}
    shown = {axes: places[:, :2] / places[:, 2:] for axes, places in parts.items() if len(places)}
    reach = 1.0 if len(shown) > 1 else min(1.0, float(np.abs(next(iter(shown.values()))).max()))
    return [Face(axes, reach, _part(places, reach)) for axes, places in shown.items()]


def face_size(face: Face, lens: RadialLens, fov: float, diameter: float) -> int:
    """Pixels across a face such that its middle is as fine as the dome's picture there.

    diameter: of the disc, pixels. A face has size / (2 reach) pixels a radian in its middle; the disc has its
    radius times the lens's slope outwards, and its radius times the lens's radius / sin(phi) around, of which
    the larger counts. The middle of a side is 90 degrees from the disc's, or the rim if that is nearer; the
    back, in whose middle there is no such number, is as fine as the sides.
    """
    in_front = face.axes[2] == (0, 0, -1)
    phi = np.array([1e-4 if in_front else min(math.radians(fov / 2), math.pi / 2)])
    slope = (lens.radius(phi) - lens.radius(phi - 1e-4)) / 1e-4
    around = lens.radius(phi) / np.sin(phi)
    return 2 * round(face.reach * diameter * float(np.maximum(slope, around).max()) / 2)


def _seen(half: float, orientation: Orientation) -> Floats:
    """(n, 3): directions that fill what a lens of half a field of view shows, its rim included."""
    phi, theta = np.meshgrid(np.linspace(0, half, _RINGS), np.arange(_SPOKES) * 2 * np.pi / _SPOKES)
    rays = np.stack([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), -np.cos(phi)], -1)
    found: Floats = orientation.seen(rays.reshape(-1, 3)) @ orientation.turn.T
    return found


def _part(places: Floats, reach: float) -> tuple[float, float, float, float]:
    """The rectangle around places (n, 2) of a face's plane, a little larger."""
    edge, margin = reach * (1 + 2 * BORDER), reach * _MARGIN
    left, bottom = np.maximum(places.min(0) - margin, -edge).tolist()
    right, top = np.minimum(places.max(0) + margin, edge).tolist()
    return left, right, bottom, top
