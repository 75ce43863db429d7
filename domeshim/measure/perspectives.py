"""Through which perspectives each colour of a picture was drawn: looked at as each draw is made.

An anaglyph has its red from one eye and its green from another, a cockpit may be drawn over a landscape;
where the monitor shows a direction then depends on what was drawn.
"""

from __future__ import annotations

from functools import wraps
from typing import TYPE_CHECKING, Any

import numpy as np

from domeshim.state.context import DomeContext

if TYPE_CHECKING:
    from domeshim.driver import Driver
    from domeshim.session import Session
    from domeshim.state.placement import View

_COLOR_WRITEMASK = 0x0C23
_CAMERA = [0, 1, 3]
"""The rows of a perspective that say where a direction is seen."""


class Perspectives:
    """What the channels of the picture that is being drawn were drawn through; red, green and blue."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._views: dict[int, list[list[View]]] = {}
        """By the main view's identity: of each channel, each view that is not as the one before."""
        self._last: tuple[View, tuple[int, ...]] | None = None

    def watch(self, session: Session) -> None:
        """Look on from now on, for as long as the process lasts."""
        dress, clearing = DomeContext.dress, session.clearing

        @wraps(dress)
        def dressed(context: DomeContext, *args: Any, **named: Any) -> None:
            dress(context, *args, **named)
            if not context.compiling and not context.aside.bypassed:
                self._note(context)

        @wraps(clearing)
        def cleared(*, colour: bool) -> None:
            if colour:
                self._forget(self._written())
            clearing(colour=colour)

        setattr(DomeContext, "dress", dressed)  # noqa: B010 - a method stands in for another
        setattr(session, "clearing", cleared)  # noqa: B010

    def begin_picture(self) -> None:
        """Forget the picture before."""
        self._views.clear()
        self._last = None

    def of(self, context: DomeContext) -> list[list[View]]:
        """Of each channel the views that it was drawn through, the last one last."""
        return self._views.get(id(context.placer.main), [[], [], []])

    def _note(self, context: DomeContext) -> None:
        view = context.placer.main.view
        if view is None:
            return
        drawn = view, self._written()
        if self._last is not None and drawn[0] is self._last[0] and drawn[1] == self._last[1]:
            return
        self._last = drawn
        for views, written in zip(
            self._views.setdefault(id(context.placer.main), [[], [], []]), drawn[1], strict=True
        ):
            if written and not (views and _alike(views[-1], view)):
                views.append(view)

    def _written(self) -> tuple[int, ...]:
        """Which channels are drawn to."""
        return self._driver.integers(_COLOR_WRITEMASK, 4)[:3]

    def _forget(self, written: tuple[int, ...]) -> None:
        self._last = None
        for channels in self._views.values():
            for views, cleared in zip(channels, written, strict=True):
                if cleared:
                    views.clear()


def _alike(one: View, other: View) -> bool:
    """They show each direction at the same place."""
    return (
        one.viewport == other.viewport
        and np.allclose(one.camera[_CAMERA], other.camera[_CAMERA], rtol=1e-6)
        and np.array_equal(one.turn, other.turn)
    )
