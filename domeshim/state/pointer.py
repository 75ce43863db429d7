"""Where a place of the real frame is in the window that the program believes in, and back.

The lens and the dome's orientation give the direction that a place of the dome stands for; the program's main
perspective gives the place in its window where the monitor would show that direction. Places are (..., 2)
float64 in pixels, continuous (a pixel's middle is at a half), the origin at the bottom left as in glViewport.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from domeshim.lens.landing import Floats, Lens
from domeshim.lens.orientation import STRAIGHT, Orientation
from domeshim.lens.projection import direction_of, disc_of
from domeshim.state.perspective import depth_range
from domeshim.state.placement import View
from domeshim.window.frame import Frame

LARGEST_PLACE = 32767.0
"""No place in the program's window is farther out than this: what a mouse event of X11 can say."""
_CAMERA = [0, 1, 3]
_PAPER_FAR = 1000.0
"""The far plane of the paper's glOrtho: see glsl/bend/paper.glsl."""


@dataclass(frozen=True)
class Sight:
    """How the program's window lies on the dome at one moment."""

    view: View
    frame: Frame
    lens: Lens
    orientation: Orientation = STRAIGHT
    paper: bool = False
    """Drawn by the paper's own method: its depth is another."""

    def to_program(self, places: Floats) -> Floats:
        """Places of the frame -> of the program's window.

        Directions outside of the program's view have places outside of its window: farther out the larger the
        angle, at LARGEST_PLACE for all that the monitor's flat picture could never show (90 degrees and more
        from its axis). Outside the disc the rim's nearest place counts: nothing is drawn there, and a lens
        need not be known beyond its rim.
        """
        return self.seen(self.directions_on_dome(places))

    def to_frame(self, places: Floats) -> Floats:
        """Places of the program's window -> of the frame, also beyond the disc's rim."""
        disc = disc_of(self.directions(places) @ self.view.turn.T, self.lens, self.orientation)
        return self.frame.place_of(disc)

    def directions(self, places: Floats) -> Floats:
        """Places of the program's window -> (..., 3) where they are seen, in the program's eye space."""
        x, y, w, h = self.view.viewport
        window = (np.asarray(places, float) - (x, y)) * (2 / w, 2 / h) - 1
        clip = np.concatenate([window, np.ones_like(window[..., :1])], -1)
        found: Floats = clip @ np.linalg.inv(self.view.camera[_CAMERA, :3]).T
        return found

    def directions_on_dome(self, places: NDArray[np.floating]) -> Floats:
        """Places of the frame -> (..., 3) what is seen there, unit vectors in the program's eye space."""
        disc = self.lens.nearest(self.frame.disc_of(places))
        seen: Floats = direction_of(disc, self.lens, self.orientation) @ self.view.turn
        return seen

    def within(self, places: NDArray[np.floating]) -> NDArray[np.bool_]:
        """Which places of the frame lie on the dome's picture: (...)."""
        return self.lens.within(self.frame.disc_of(places))

    def monitor_depth(self, depth: Floats, directions: Floats) -> Floats:
        """What the monitor's depth buffer would hold, 0 to 1, where the dome's holds depth.

        depth: (...) 0 to 1; directions: (..., 3) unit, in which the depths were found. The dome shows more
        than the monitor before the near plane and behind the far plane: there the answer is beyond 0 or 1.
        """
        p, points = self.view.camera, self.points(depth, directions)
        z, w = (points @ p[row, :3] + p[row, 3] for row in (2, 3))
        found: Floats = (z / w + 1) / 2
        return found

    def points(self, depth: Floats, directions: Floats) -> Floats:
        """(..., 3) in eye space: what lies in unit directions where the dome's depth buffer holds depth."""
        if self.paper:
            aimed = self.orientation.aimed(directions @ self.view.turn.T)
            distance = _PAPER_FAR * depth / np.maximum(-aimed[..., 2], 1e-9)
        else:
            a, b = depth_range(self.view.camera).uniform
            distance = b / (2 * np.asarray(depth, float) - 1 - a)
        found: Floats = directions * distance[..., None]
        return found

    def seen(self, directions: Floats) -> Floats:
        """Unit directions -> places of the program's window, kept within LARGEST_PLACE."""
        x, y, w, h = self.view.viewport
        rows = self.view.camera[_CAMERA, :3]
        ahead = -rows[:, 2]
        axis = ahead[:2] / ahead[2]
        clip = directions @ rows.T
        aside = (clip[..., :2] - clip[..., 2:] * axis) * (w / 2, h / 2)
        largest = np.abs(aside).max(-1)
        behind = (largest < 1e-12) & (clip[..., 2] <= 0)  # straight behind: no way is nearer than another
        aside = np.where(behind[..., None], (0.0, 1.0), aside)
        largest = np.where(behind, 1.0, largest)
        reach = LARGEST_PLACE - max(self.frame.program_size)
        away = aside / np.maximum(clip[..., 2], largest / reach)[..., None]
        middle = (axis + 1) * (w / 2, h / 2) + (x, y)
        seen: Floats = np.clip(middle + away, -reach, LARGEST_PLACE)
        return seen
