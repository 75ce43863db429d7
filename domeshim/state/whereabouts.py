"""Where draws go: viewport, scissor and projection, asked of GL again only where they may have changed."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from domeshim.driver import Driver
from domeshim.state.own_programs import OwnPrograms
from domeshim.state.perspective import Matrix
from domeshim.state.placement import Placement, Placer
from domeshim.state.scissor import Edges, edges_of
from domeshim.state.views import View
from domeshim.window.frame import Frame, Rectangle

MODELVIEW, PROJECTION = 0x1700, 0x1701
_VIEWPORT, _MATRIX_MODE, _MODELVIEW_MATRIX, _PROJECTION_MATRIX = 0x0BA2, 0x0BA0, 0x0BA6, 0x0BA7
_SCISSOR_TEST, _SCISSOR_BOX = 0x0C11, 0x0C10


@dataclass(frozen=True)
class Seen:
    """What GL said of where draws go."""

    viewport: Rectangle
    scissor: Rectangle | None
    """None: off."""
    edges: Edges
    """What the scissor leaves of the viewport."""
    projection: Matrix
    placement: Placement

    @cached_property
    def view(self) -> View:
        """Viewport and scissor as a view."""
        return View(self.viewport, self.scissor)


class Whereabouts:
    """What one context knows of where its draws go."""

    def __init__(self, driver: Driver, placer: Placer, own: OwnPrograms) -> None:
        self._driver = driver
        self._placer = placer
        self._own = own
        self.known: Seen | None = None
        """What was said last."""
        self.changed = True
        """A call was made that may have changed it."""
        self.matrix_mode = driver.integer(_MATRIX_MODE)
        """The stack that calls go to."""

    def ask_again(self) -> None:
        """Any of it may have changed."""
        self.changed = True
        self.matrix_mode = self._driver.integer(_MATRIX_MODE)

    @property
    def stale(self) -> bool:
        """It may have changed, or be changing unseen, call by call: GL must be asked."""
        return self.changed or self.matrix_mode == PROJECTION or self._placer.on_modelview

    def ask(self, frame: Frame) -> Seen:
        """Where what is drawn now belongs; nothing of the dome's may be on."""
        x, y, w, h = self._driver.integers(_VIEWPORT, 4)
        viewport, scissor = (x, y, w, h), self._ask_scissor()
        self.changed = False
        modelview = matrix(self._driver, _MODELVIEW_MATRIX) if self._placer.on_modelview else None
        projection = self._own.projection(matrix(self._driver, _PROJECTION_MATRIX))
        placement = self._placer.place(projection, modelview, viewport, frame)
        self.known = Seen(viewport, scissor, edges_of(scissor, viewport), projection, placement)
        return self.known

    def _ask_scissor(self) -> Rectangle | None:
        if not self._driver.glIsEnabled(_SCISSOR_TEST):
            return None
        x, y, w, h = self._driver.integers(_SCISSOR_BOX, 4)
        return x, y, w, h


def matrix(driver: Driver, name: int) -> Matrix:
    """One of GL's matrices, (4, 4)."""
    return np.array(driver.doubles(name, 16)).reshape(4, 4).T
