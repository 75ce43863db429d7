"""How the dome stands to the program's view: turned by three angles, and seen or lit from off its centre.

The numpy twin of glsl/aim. The dome's space is the disc's: x to the disc's right, y to its top, the dome's
axis along -z; lengths in the dome's radii.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from domeshim.options import Options

Floats = NDArray[np.float64]
Place = tuple[float, float, float]
Aim = Literal["straight", "turned", "seated"]
_CENTRE: Place = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Orientation:
    """Where the dome looks, in degrees, and where its viewer and its projector are, in its radii.

    With q a point of the dome, |q| = 1, s the seat and p the projector: what the viewer sees in the unit
    direction d falls on q = s + t d, t = sqrt((s d)^2 + 1 - s^2) - s d (s d: the dot product), and the
    projector throws it towards q - p. Back: a ray u of the projector meets q = p + t u,
    t = sqrt((p u)^2 + 1 - p^2) - p u, which is seen towards q - s.
    """

    tilt: float = 0.0
    """By how much the dome's axis is raised above the program's forward direction."""
    heading: float = 0.0
    """By how much the dome is turned to the right around the program's up, before it is raised."""
    roll: float = 0.0
    """By how much the picture is turned clockwise on the disc."""
    seat: Place = _CENTRE
    projector: Place = _CENTRE

    @classmethod
    def of(cls, options: Options) -> Orientation:
        """What the options say, with its lengths in the dome's radii."""
        seat, projector = (_in_radii(place, options.radius) for place in (options.seat, options.projector))
        return cls(options.tilt, options.heading, options.roll, seat, projector)

    @property
    def aim(self) -> Aim:
        """The snippet of glsl/aim that this needs."""
        if self.off_centre:
            return "seated"
        return "turned" if self.tilt or self.heading or self.roll else "straight"

    @property
    def off_centre(self) -> bool:
        """The viewer or the projector is off the dome's centre."""
        return self.seat != _CENTRE or self.projector != _CENTRE

    @cached_property
    def turn(self) -> Floats:
        """(3, 3): eye space to the dome's."""
        return _roll(self.roll) @ _tilt(self.tilt) @ _heading(self.heading)

    @property
    def turned_only(self) -> Orientation:
        """The same dome, seen and lit from its centre."""
        return replace(self, seat=_CENTRE, projector=_CENTRE)

    @property
    def uniforms(self) -> tuple[tuple[str, tuple[float, ...]], ...]:
        """The snippet's uniforms, by name."""
        if self.aim == "straight":
            return ()
        turn = ("domeTurn", tuple(self.turn.T.ravel().tolist()))
        if not self.off_centre:
            return (turn,)
        return turn, ("domeSeat", self.seat), ("domeProjector", self.projector)

    def aimed(self, directions: Floats) -> Floats:
        """(..., 3) of any length in eye space -> (..., 3) as the lens sees them, the dome's axis along -z."""
        turned = np.asarray(directions, float) @ self.turn.T
        return self.thrown(self.on_dome(turned)) if self.off_centre else turned

    def seen(self, rays: Floats) -> Floats:
        """The inverse of aimed: (..., 3) as the lens sees them -> (..., 3) in eye space."""
        rays = np.asarray(rays, float)
        if self.off_centre:
            rays = _on_dome(np.array(self.projector), rays) - self.seat
        return rays @ self.turn

    def on_dome(self, turned: Floats) -> Floats:
        """(..., 3) directions in the dome's space, from the seat -> (..., 3) points of the dome."""
        return _on_dome(np.array(self.seat), turned)

    def thrown(self, points: Floats) -> Floats:
        """(..., 3) points of the dome -> (..., 3) directions from the projector."""
        return np.asarray(points - np.array(self.projector), float)


STRAIGHT = Orientation()


def _on_dome(origin: Floats, directions: Floats) -> Floats:
    """Where rays from a place within the unit sphere meet it."""
    d = directions / np.abs(directions).max(-1, keepdims=True)
    d = d / np.linalg.norm(d, axis=-1, keepdims=True)
    along = (d @ origin)[..., None]
    return np.asarray(origin + d * (np.sqrt(along**2 + 1 - origin @ origin) - along), float)


def _in_radii(place: Place | None, radius: float) -> Place:
    x, y, z = place or _CENTRE
    return x / radius, y / radius, -z / radius


def _tilt(degrees: float) -> Floats:
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[1, 0, 0], [0, c, s], [0, -s, c]])


def _heading(degrees: float) -> Floats:
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def _roll(degrees: float) -> Floats:
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
