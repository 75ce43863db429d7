"""A view that turns no faster than an audience can bear (DOME_MAX_TURN).

A picture all around that turns fast makes people dizzy. The program's view is taken from its gluLookAt; what
the dome shows follows it at no more than so many degrees a second, by the shortest way.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Turn = NDArray[np.float64]
"""(3, 3), a rotation."""
_LONGEST_STEP = 0.1
"""A program that pauses for longer than so many seconds has not let its audience rest for all of them."""


class SteadyView:
    """How the dome's view follows the program's."""

    def __init__(self, fastest: float) -> None:
        """fastest: degrees a second."""
        self._fastest = np.radians(fastest)
        self._shown: Turn | None = None
        self._when = 0.0
        self.turn: Turn = np.eye(3)
        """From the program's eye space to the one that the dome shows: the rest of the way, backwards."""

    @property
    def blind(self) -> bool:
        """The program has never said where it looks."""
        return self._shown is None

    def look(self, view: Turn, now: float) -> None:
        """The program looks on from here: view takes the world to its eye space; now: its clock, seconds.

        Views at the same moment are of the same picture: the first one counts.
        """
        if self._shown is None:
            self._shown, self._when = view, now
            return
        if now == self._when:
            return
        most = self._fastest * min(now - self._when, _LONGEST_STEP)
        self._when = now
        self._shown = _towards(self._shown, view, most)
        self.turn = self._shown @ view.T


def looking_at(eye: Turn, centre: Turn, up: Turn) -> Turn | None:
    """The rotation of gluLookAt, from the world to eye space; None where it looks nowhere."""
    forward = centre - eye
    side = np.cross(forward, up)
    if not np.linalg.norm(side) > 0 or not np.isfinite(side).all():
        return None
    forward, side = forward / np.linalg.norm(forward), side / np.linalg.norm(side)
    return np.array([side, np.cross(side, forward), -forward])


def _towards(shown: Turn, view: Turn, most: float) -> Turn:
    """The rotation on the shortest way from one view to another, at most so far, radians."""
    between = view @ shown.T
    axis = np.array(
        [between[2, 1] - between[1, 2], between[0, 2] - between[2, 0], between[1, 0] - between[0, 1]]
    )
    angle = float(np.arctan2(np.linalg.norm(axis), np.trace(between) - 1))
    if angle <= most:
        return view
    if np.linalg.norm(axis) < 1e-9:  # half a turn: any way is as short; around the viewer's own up
        axis = np.array([0.0, 1.0, 0.0])
    return _around(axis / np.linalg.norm(axis), most) @ shown


def _around(axis: Turn, angle: float) -> Turn:
    """Rodrigues' rotation."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turned: Turn = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    return turned
