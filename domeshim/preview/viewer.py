"""Who looks at the virtual dome: a place in the room, and a direction."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
EYES = 1.2
"""Height of a seated viewer's eyes, metres."""
_NEAR, _FAR = 0.05, 500.0
_STEEPEST = 89.0


@dataclass
class Viewer:
    """Metres and degrees; the room is VirtualDome's."""

    place: tuple[float, float, float] = (0.0, EYES, 2.5)
    heading: float = 0.0
    """To the right of the front."""
    pitch: float = 35.0
    """Above the horizon."""
    angle: float = 75.0
    """The picture's vertical angle."""

    def to_json(self) -> str:
        """As from_json reads it."""
        return json.dumps(asdict(self))

    @classmethod
    def from_json(cls, text: str) -> Viewer:
        """As to_json wrote it."""
        return cls(**json.loads(text))

    def turn(self, right: float, up: float) -> None:
        """Look elsewhere, by so many degrees."""
        self.heading = (self.heading + right) % 360
        self.pitch = min(max(self.pitch + up, -_STEEPEST), _STEEPEST)

    def fly(self, right: float, ahead: float, up: float) -> None:
        """Move by so many metres, ahead being where one looks; not below the floor."""
        step = np.array([right, 0, -ahead]) @ self._turn + (0, up, 0)
        x, y, z = np.add(self.place, step).tolist()
        self.place = x, max(y, 0.1), z

    def matrix(self, aspect: float) -> Floats:
        """(4, 4): the room -> clip space; aspect: width over height."""
        scale = 1 / np.tan(np.radians(self.angle) / 2)
        depth, both = _NEAR - _FAR, _NEAR + _FAR
        lens = np.array(
            [
                [scale / aspect, 0, 0, 0],
                [0, scale, 0, 0],
                [0, 0, both / depth, 2 * _NEAR * _FAR / depth],
                [0, 0, -1, 0],
            ]
        )
        view = np.eye(4)
        view[:3, :3] = self._turn
        view[:3, 3] = -self._turn @ self.place
        found: Floats = lens @ view
        return found

    @property
    def _turn(self) -> Floats:
        """(3, 3): the room's axes -> the viewer's."""
        a, b = np.radians([self.heading, self.pitch])
        around = np.array([[np.cos(a), 0, np.sin(a)], [0, 1, 0], [-np.sin(a), 0, np.cos(a)]])
        over = np.array([[1, 0, 0], [0, np.cos(b), np.sin(b)], [0, -np.sin(b), np.cos(b)]])
        found: Floats = over @ around
        return found
