"""One picture of a window and those inside it: each is drawn and finished by itself, and kept until all are.

On the monitor each picture lies in its rectangle. On the dome a subwindow that covers most of its outermost
window, and is drawn in perspective, fills the dome; the others lie over it where they are seen.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from domeshim import session as sessions
from domeshim.draw.paste import paste
from domeshim.draw.target import drawing_to
from domeshim.driver import Driver
from domeshim.GLUT.dispatch import make_current
from domeshim.GLUT.families import Area, descendants, outermost, place_in_outermost, shown, visible_area
from domeshim.GLUT.popup import draw_open_menu
from domeshim.GLUT.state import GlutState, GlutWindow
from domeshim.measure.pixels import read_pixels
from domeshim.window.contract import Window

_BACK, _FRONT, _DRAW_BUFFER = 0x0405, 0x0404, 0x0C01
Picture = NDArray[np.uint8]
"""(height, width, 3), the top row first."""


class Composition:
    """Makes the pictures of all outermost windows that have others inside."""

    def __init__(self, state: GlutState) -> None:
        self._state = state
        self._driver = Driver()

    def keep(self, window: Window) -> bool:
        """Keep a finished picture, whose window is current; False where it is a whole one."""
        part = next((w for w in self._state.windows.values() if w.surface is window), None)
        if part is None or not (part.parent or part.children):
            return False
        if part.fresh:  # it is drawn again: what there was before is a whole picture
            self._show(outermost(self._state, part))
        part.picture = self._read(window)
        part.fresh = True
        return True

    def round_ended(self) -> None:
        """Show the pictures of which a part was finished or has changed its place."""
        for window in list(self._state.windows.values()):
            changed = window.stale or any(w.fresh for w in (window, *descendants(window)))
            if not window.parent and window.children and changed:
                self._show(window)

    def _show(self, outer: GlutWindow) -> None:
        if outer.picture is None and outer.redisplay:
            return  # its own picture is about to be drawn
        session, former = sessions.current(), self._state.current
        make_current(self._state, outer)
        if session.dome is not None:
            session.dome.frame_ending(outer.surface)
        with drawing_to(self._driver, outer.surface.framebuffer):
            paste(self._driver, self._composed(outer))
        draw_open_menu(self._state, outer)
        if session.dome is not None:
            session.dome.frame_ending(outer.surface)
        outer.stale = False
        for window in (outer, *descendants(outer)):
            window.fresh = False
        session.show(outer.surface)
        if former is not None and former.number in self._state.windows:
            make_current(self._state, former)

    def _composed(self, outer: GlutWindow) -> Picture:
        width, height = outer.surface.pixels
        whole = np.zeros((height, width, 3), np.uint8)
        if outer.picture is not None and outer.picture.shape == whole.shape:
            whole[:] = outer.picture
        parts = [w for w in descendants(outer) if shown(self._state, w)]
        if sessions.current().dome is None:
            for window in parts:
                self._lay_flat(whole, window)
        else:
            for window in self._from_below(parts, whole):
                self._lay_on_dome(whole, window)
        return whole

    def _lay_flat(self, whole: Picture, window: GlutWindow) -> None:
        """Copy a picture into its rectangle."""
        left, top, width, height = visible_area(self._state, window)
        x, y = place_in_outermost(self._state, window)
        if window.picture is not None:
            seen = window.picture[top - y : top - y + height, left - x : left - x + width]
            whole[top : top + seen.shape[0], left : left + seen.shape[1]] = seen

    def _from_below(self, parts: list[GlutWindow], whole: Picture) -> list[GlutWindow]:
        """Order windows on the dome: what fills it first, and without what lies under that on the monitor."""
        dome = sessions.current().dome
        assert dome is not None
        areas = {w.number: visible_area(self._state, w) for w in parts}
        filling = [w for w in parts if dome.fills(w.surface)]
        over = {w.number: [f for f in filling if parts.index(f) > parts.index(w)] for w in parts}
        left = [
            w
            for w in parts
            if w not in filling and not any(_holds(areas[f.number], areas[w.number]) for f in over[w.number])
        ]
        if filling and _is_drawn_on(whole):
            self._state.say_once(
                "a subwindow fills the dome: what the window around it shows beside it is not seen"
            )
        return [*filling, *left]

    def _lay_on_dome(self, whole: Picture, window: GlutWindow) -> None:
        """Copy what of a picture shows its window."""
        dome, picture = sessions.current().dome, window.picture
        assert dome is not None
        left, top, width, height = visible_area(self._state, window)
        x, y = place_in_outermost(self._state, window)
        own = (left - x, window.size[1] - (top - y) - height, width, height)
        region = dome.region(window.surface, own) if min(width, height) > 0 else None
        if region is None or picture is None or picture.shape != whole.shape:
            return
        x, y, width, height = region.box
        rows, columns = slice(len(whole) - y - height, len(whole) - y), slice(x, x + width)
        seen = True if region.within is None else region.within[::-1, :, None]
        np.copyto(whole[rows, columns], picture[rows, columns], where=seen)

    def _read(self, window: Window) -> Picture:
        width, height = window.pixels
        front = not window.format.double_buffer and self._driver.integer(_DRAW_BUFFER) == _FRONT
        data = read_pixels(width, height, buffer=_FRONT if front else _BACK)
        return np.frombuffer(data, np.uint8).reshape(height, width, 3)


def _holds(outer: Area, inner: Area) -> bool:
    x, y, width, height = inner
    left, top, wide, high = outer
    return left <= x and top <= y and x + width <= left + wide and y + height <= top + high


def _is_drawn_on(picture: Picture) -> bool:
    """The square inside the disc has more than one colour."""
    height, width, _ = picture.shape
    half = int(min(height, width) / 2**1.5)
    inner = picture[height // 2 - half : height // 2 + half, width // 2 - half : width // 2 + half]
    return bool(np.ptp(inner, axis=(0, 1)).any())
