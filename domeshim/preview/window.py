"""The virtual dome in a window: the mouse looks around, keys fly."""

from __future__ import annotations

import time

import glfw

from domeshim.draw.attached import attached
from domeshim.driver import Driver
from domeshim.preview.dome import VirtualDome
from domeshim.preview.pictures import Pictures
from domeshim.preview.room import Room
from domeshim.preview.viewer import Viewer
from domeshim.window.contract import SurfaceFormat, WindowEvents
from domeshim.window.screen import ScreenBackend

TITLE = "virtual dome: drag to look, W A S D E Q to fly, wheel to zoom, R back to the seat"
_SPEED = 3.0
"""Metres a second."""
_PER_PIXEL = 0.15
"""Degrees."""
_STEPS = {
    glfw.KEY_W: (0, 1, 0),
    glfw.KEY_S: (0, -1, 0),
    glfw.KEY_A: (-1, 0, 0),
    glfw.KEY_D: (1, 0, 0),
    glfw.KEY_E: (0, 0, 1),
    glfw.KEY_Q: (0, 0, -1),
    glfw.KEY_UP: (0, 1, 0),
    glfw.KEY_DOWN: (0, -1, 0),
    glfw.KEY_LEFT: (-1, 0, 0),
    glfw.KEY_RIGHT: (1, 0, 0),
}
"""Right, ahead and up by key."""
_WAIT = 1 / 60


class Hands(WindowEvents):
    """Mouse and keys move a viewer."""

    def __init__(self, viewer: Viewer) -> None:
        self.viewer = viewer
        self.closed = False
        self._seat = viewer.place, viewer.heading, viewer.pitch, viewer.angle
        self._held: set[int] = set()
        self._tapped: set[int] = set()
        """Pressed since the last move: however slow the pictures come, a touch moves the viewer."""
        self._grip: tuple[float, float] | None = None
        self._pointer = (0.0, 0.0)

    def close_asked(self) -> None:
        """End."""
        self.closed = True

    def key(self, key: int, pressed: bool, modifiers: int) -> None:  # noqa: ARG002 - the contract's own
        """Fly while a key is held; R goes back to the seat, Escape ends."""
        (self._held.add if pressed else self._held.discard)(key)
        if pressed:
            self._tapped.add(key)
        if pressed and key == glfw.KEY_R:
            self._tapped.clear()
            self.viewer.place, self.viewer.heading, self.viewer.pitch, self.viewer.angle = self._seat
        self.closed = self.closed or (pressed and key == glfw.KEY_ESCAPE)

    def button(self, button: int, pressed: bool, modifiers: int) -> None:  # noqa: ARG002 - the contract's own
        """Take hold of the view, or let it go."""
        self._grip = self._pointer if pressed else None

    def pointer_moved(self, x: float, y: float) -> None:
        """Turn while a button is held."""
        self._pointer = (x, y)
        if self._grip is not None:
            scale = _PER_PIXEL * self.viewer.angle / 75
            self.viewer.turn(scale * (self._grip[0] - x), scale * (y - self._grip[1]))
            self._grip = (x, y)

    def wheel(self, dx: float, dy: float) -> None:  # noqa: ARG002 - the contract's own
        """Zoom."""
        self.viewer.angle = min(max(self.viewer.angle * 0.92**dy, 10.0), 130.0)

    def move(self, seconds: float) -> None:
        """Fly on for so long."""
        for key in (self._held | self._tapped) & set(_STEPS):
            right, ahead, up = (_SPEED * seconds * part for part in _STEPS[key])
            self.viewer.fly(right, ahead, up)
        self._tapped.clear()


def show_dome(pictures: Pictures, dome: VirtualDome, viewer: Viewer, size: tuple[int, int]) -> None:
    """Show the virtual dome until the user closes it, or the pictures end.

    Raises ScreenError where there is no display.
    """
    backend = ScreenBackend()
    try:
        hands = Hands(viewer)
        window = backend.open_window(TITLE, size, None, SurfaceFormat(samples=4), hands)
        context = attached(Driver(), "domeshim preview")
        room = Room(context, dome)
        began = former = time.perf_counter()
        while not (hands.closed or pictures.ended):
            now = time.perf_counter()
            hands.move(now - former)
            picture = pictures.at(now - began)
            if picture is not None:
                room.show(picture)
            if min(window.size) > 0:
                context.screen.use()
                room.draw(viewer, window.size)
                window.swap_buffers()
            former = now
            backend.poll(max(_WAIT - (time.perf_counter() - now), 0.0))
    finally:
        backend.close()
