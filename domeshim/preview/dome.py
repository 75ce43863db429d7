"""The virtual dome: where in the room each place of a dome picture hangs."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from domeshim.lens.models import lens_of

if TYPE_CHECKING:
    from domeshim.options import Options

Floats = NDArray[np.float64]
_RINGS, _SECTORS = 96, 192


@dataclass(frozen=True)
class VirtualDome:
    """A piece of a sphere over a floor; lengths in metres, angles in degrees.

    The room: x to the right, y up from the floor, -z to the front; the sphere's centre is over the origin.
    """

    radius: float = 8.0
    tilt: float = 0.0
    """By so much the dome leans: 0 has its pole at the zenith, 90 at the front."""
    rim: float = 2.0
    """Height of the sphere's centre over the floor."""
    fov: float = 180.0
    """Full angle of the picture."""
    lens: tuple[str, tuple[float | str, ...]] = ("equidistant", ())

    def to_json(self) -> str:
        """As from_json reads it."""
        return json.dumps(asdict(self))

    @classmethod
    def from_json(cls, text: str) -> VirtualDome:
        """As to_json wrote it."""
        read = json.loads(text)
        name, numbers = read["lens"]
        return cls(**read | {"lens": (name, tuple(numbers))})

    def place(self, phi: Floats, theta: Floats) -> Floats:
        """(...) radians from the pole and around it, 0 at the picture's right -> (..., 3) in the room."""
        across = np.sin(phi)
        upright = np.stack([across * np.cos(theta), np.cos(phi), across * np.sin(theta)], -1)
        lean = np.radians(self.tilt)
        cos, sin = np.cos(lean), np.sin(lean)
        turn = np.array([[1, 0, 0], [0, cos, sin], [0, -sin, cos]])
        found: Floats = self.radius * upright @ turn.T + (0, self.rim, 0)
        return found

    def mesh(self) -> tuple[NDArray[np.float32], NDArray[np.uint32]]:
        """Corners and triangles (m, 3).

        A corner (n, 5) is x, y, z in the room, and its place in the picture, 0 to 1 from the lower left.
        """
        phi = np.radians(self.fov / 2) * np.linspace(0, 1, _RINGS + 1)
        theta = np.linspace(0, 2 * np.pi, _SECTORS + 1)
        phi, theta = np.meshgrid(phi, theta, indexing="ij")
        radius = lens_of(*self.lens, self.fov).radius(phi)  # type: ignore[arg-type] # as the catalogue gave them
        shown = 0.5 + 0.5 * np.stack([radius * np.cos(theta), radius * np.sin(theta)], -1)
        corners = np.concatenate([self.place(phi, theta), shown], -1).reshape(-1, 5).astype(np.float32)
        first = (np.arange(_RINGS)[:, None] * (_SECTORS + 1) + np.arange(_SECTORS)).reshape(-1, 1)
        cell = np.array([[0, 1, _SECTORS + 1], [1, _SECTORS + 2, _SECTORS + 1]]).reshape(1, -1)
        return corners, (first + cell).reshape(-1, 3).astype(np.uint32)


def dome_of(options: Options, **given: float) -> VirtualDome:
    """The dome for a program's picture by these options: what is ahead of the program hangs at the front."""
    own = VirtualDome(tilt=90.0 - options.tilt, fov=options.fov, lens=options.lens)
    return replace(own, **given)  # type: ignore[arg-type] # lengths and angles alone
