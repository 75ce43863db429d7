"""The current raster position, which GL keeps where the dome has it, as the monitor would tell of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from domeshim.state.perspective import planar

if TYPE_CHECKING:
    from domeshim.options import Options
    from domeshim.state.context import DomeContext

_CURRENT_RASTER_POSITION, _DEPTH_RANGE = 0x0B07, 0x0B70


@dataclass(frozen=True)
class Raster:
    """A raster position in the program's window."""

    position: tuple[float, float, float, float]
    """x, y, depth and w, as GL gives them; w is that of the point seen there, also after glWindowPos."""
    distance: float | None = None
    """From the origin of MODELVIEW's space; None where the dome does not know better than GL."""


def monitor_raster(context: DomeContext, options: Options) -> Raster | None:
    """The raster position in the program's window; None where GL's own is the answer.

    It is found from where the position is on the dome now, by what is in force for drawing now. So after a
    bitmap it has moved by as much of the program's window as the bitmap takes on the dome.
    """
    x, y, depth, w = context.driver.doubles(_CURRENT_RASTER_POSITION, 4)
    placement, sight = context.seen.placement, context.pixels.sight
    if placement.hud and options.flat_hud:
        return Raster((*context.frame.from_flat(x, y), depth, w))
    found = context.canvas.direction(x, y)
    if found is None:
        return None  # out of sight, or not set yet
    direction, ahead = found[0] @ sight.view.turn, found[1]
    x, y = (float(at) for at in sight.seen(direction))
    near, far = context.driver.doubles(_DEPTH_RANGE, 2)
    if placement.place == "panel" or near == far:
        return Raster((x, y, depth, 1.0))
    share = (depth - near) / (far - near)
    point = np.array([0.0, 0.0, 0.0, 1.0])
    if context.canvas.kind == "face":
        a, b = planar(placement.depth)
        point[:3] = direction * b / (2 * share - 1 - a) / ahead
    else:
        point[:3] = sight.points(np.array(share), direction)
    clip = sight.view.camera @ point
    shown = np.append(sight.view.turn @ point[:3], point[3])
    in_modelview = np.linalg.solve(np.array(placement.view).reshape(4, 4).T, shown)
    distance = float(np.linalg.norm(in_modelview[:3] / in_modelview[3]))
    depth = near + (far - near) * float(clip[2] / clip[3] + 1) / 2
    return Raster((x, y, depth, float(clip[3])), distance)
