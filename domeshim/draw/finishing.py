"""What a projector wants of the finished picture, and where the picture's places go by it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from domeshim.lens.mesh import WarpMesh, read_mesh
from domeshim.lens.models import lens_of
from domeshim.options import Options
from domeshim.window.frame import Frame

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Finishing:
    """One window's: the mesh that its pictures are drawn by, and their light."""

    options: Options
    frame: Frame

    @cached_property
    def mesh(self) -> WarpMesh:
        """The user's mesh, or one that leaves the picture where it is; mirrored if that is wanted.

        Raises MeshError.
        """
        width, height = self.frame.size
        kind, file = self.options.surface
        mesh = read_mesh(Path(str(file)), width / height) if kind == "mesh" else self._whole_frame()
        across, over = (self.options.mirror in (way, "both") for way in ("horizontal", "vertical"))
        turn = np.array([-1.0 if across else 1.0, -1.0 if over else 1.0])
        return WarpMesh(mesh.places * turn, mesh.picture, mesh.intensity, mesh.triangles)

    @property
    def fade(self) -> tuple[float, float]:
        """The radii on the disc where the picture begins to fade and where it is black."""
        options = self.options
        lens = lens_of(*options.lens, options.fov)
        begins = float(lens.radius(np.radians(max(options.fov / 2 - options.fade, 0.0))))
        return (min(begins, lens.rim), lens.rim) if options.fade else (1.0, 0.0)

    @property
    def tone(self) -> tuple[float, float]:
        """Brightness, and 1 / gamma."""
        return self.options.brightness, 1 / self.options.gamma

    def before(self, place: Floats) -> Floats:
        """A place (2,) of what the projector shows, pixels -> of the picture before it was finished.

        Where the projector shows nothing the place itself is returned.
        """
        size = np.array(self.frame.size, float)
        picture = self.mesh.shown_at((place / size * 2 - 1)[None])[0]
        x, y, width, height = self.frame.square
        return place if np.isnan(picture).any() else picture * (width, height) + (x, y)

    def _whole_frame(self) -> WarpMesh:
        x, y, width, height = self.frame.square
        corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
        picture = (corners * self.frame.size - (x, y)) / (width, height)
        return WarpMesh(corners * 2 - 1, picture, np.ones(4), np.array([[0, 1, 2], [0, 2, 3]]))
