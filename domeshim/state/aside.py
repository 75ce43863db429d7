"""Where the dome stands aside: draws that go to GL as the program makes them, and those that are left out."""

from __future__ import annotations

from collections.abc import Callable

from domeshim.draw.target import drawn_to
from domeshim.driver import Driver

_RASTERIZER_DISCARD = 0x8C89
_NOT_IN_WINDOW = frozenset(("render mode", "framebuffer"))
"""Reasons to stay out of draws that leave no pixel in the window."""


class Aside:
    """Why the dome stands aside in one context, if it does."""

    def __init__(self, driver: Driver, window: Callable[[], int], undress: Callable[[], None]) -> None:
        """window: asks for the number of the window's framebuffer; undress: gives GL back to the program."""
        self._driver = driver
        self._window = window
        self._undress = undress
        self.reasons: set[str] = set()
        """Why draws go to GL as the program makes them, if they do."""
        self.passing = False
        """Draws are left out, for nobody looks at them."""

    def bypass(self, reason: str, on: bool) -> None:
        """While any reason is on, draws go to GL as the program makes them."""
        (self.reasons.add if on else self.reasons.discard)(reason)
        self._undress()

    def framebuffer_bound(self) -> None:
        """The program may have bound a framebuffer of its own, or the window again."""
        self.bypass("framebuffer", on=drawn_to(self._driver) != self._window())

    @property
    def bypassed(self) -> bool:
        """Draws go to GL as the program makes them."""
        return bool(self.reasons)

    @property
    def straight_into_window(self) -> bool:
        """They do, and leave pixels in the window."""
        return bool(self.reasons) and not self.reasons & _NOT_IN_WINDOW

    @property
    def in_own_framebuffer(self) -> bool:
        """What the program draws goes into a framebuffer of its own."""
        return "framebuffer" in self.reasons

    @property
    def selects(self) -> bool:
        """Draws select or give feedback."""
        return "render mode" in self.reasons

    def pass_by(self, on: bool) -> None:
        """Leave out the draws from now on, or make them again; the context must be current.

        OpenGL 2 cannot leave them out, and they are made, unseen.
        """
        if on != self.passing and not self._driver.legacy:
            self._undress()
            self.passing = on
            (self._driver.glEnable if on else self._driver.glDisable)(_RASTERIZER_DISCARD)
