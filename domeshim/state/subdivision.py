"""Whether a mesh has to be subdivided to keep the tolerance, and how finely."""

from __future__ import annotations

import math
from typing import Literal

from domeshim.lens.detail import pieces_per_radian
from domeshim.lens.models import Lens
from domeshim.options import Options
from domeshim.window.frame import Frame

Subdivision = Literal["pieces", "split"] | None
"""Nothing, pieces of the edges, or to be split first."""

_MOST_PIECES = 60
"""A little under the 64 pieces that every driver has."""
_WIDEST = 1.75
"""Within this angle a triangle's inside follows its edges, radians."""


class Tolerance:
    """What DOME_TOLERANCE asks of a lens in a frame."""

    def __init__(self, options: Options, lens: Lens, frame: Frame) -> None:
        self._options = options
        self.detail = pieces_per_radian(lens, options.fov, frame.square[2] / 2, options.tolerance)
        """How many pieces an arc of one radian needs."""
        self.widest = min(_WIDEST, _MOST_PIECES / self.detail)
        """The angle up to which the GPU subdivides an edge well, radians."""
        whole = min(1 / self.detail, math.pi / 2) if options.method == "auto" else 0.0
        self.far = 0.5 / math.tan(whole / 2) if whole else math.inf
        """From how far an edge of length 1 surely needs nothing, if anything does not."""

    def broken_by(self, angle: float) -> bool:
        """An edge of this angle, radians, is off by too much as one straight piece."""
        return angle * self.detail > 1

    def subdivision(self, angle: float) -> Subdivision:
        """What a mesh needs whose edges subtend at most this angle, radians."""
        if angle > self.widest:
            return "split"
        return "pieces" if self.broken_by(angle) or self._options.method == "tessellate" else None
