"""Windows inside others: how they lie, and which of them the pointer is over.

Places are the program's own pixels from the top left, as everywhere in GLUT.
"""

from __future__ import annotations

from collections.abc import Iterator

from domeshim import session as sessions
from domeshim.GLUT import constants as c
from domeshim.GLUT.cursors import show_cursor
from domeshim.GLUT.dispatch import call_window, make_current
from domeshim.GLUT.state import GlutState, GlutWindow
from domeshim.window.frame import Rectangle
from domeshim.window.subwindow import SubWindow

Area = tuple[int, int, int, int]
"""x, y, width, height."""


def outermost(state: GlutState, window: GlutWindow) -> GlutWindow:
    """Return the window that holds this one and lies in none itself."""
    while window.parent and window.parent in state.windows:
        window = state.windows[window.parent]
    return window


def descendants(window: GlutWindow) -> Iterator[GlutWindow]:
    """Yield all that lies inside a window, each before what lies over it."""
    for child in window.children:
        yield child
        yield from descendants(child)


def lineage(state: GlutState, window: GlutWindow | None) -> list[GlutWindow]:
    """Return the window after those that hold it, the outermost first."""
    found: list[GlutWindow] = []
    while window is not None:
        found.insert(0, window)
        window = state.windows.get(window.parent)
    return found


def place_in_outermost(state: GlutState, window: GlutWindow) -> tuple[int, int]:
    """Return where the window's top left corner lies in the outermost window."""
    inner = lineage(state, window)[1:]
    return sum(w.surface.position[0] for w in inner), sum(w.surface.position[1] for w in inner)


def inside(state: GlutState, window: GlutWindow) -> Rectangle:
    """Return where a window lies in the outermost one, x and y from its bottom left, and that one's size."""
    x, y = place_in_outermost(state, window)
    width, height = outermost(state, window).size
    return x, height - y - window.size[1], width, height


def visible_area(state: GlutState, window: GlutWindow) -> Area:
    """Return what of it the windows around it leave to be seen, in the outermost window."""
    left, top, right, bottom = -(2**31), -(2**31), 2**31, 2**31
    for holder in lineage(state, window):
        x, y = place_in_outermost(state, holder)
        left, top = max(left, x), max(top, y)
        right, bottom = min(right, x + holder.size[0]), min(bottom, y + holder.size[1])
    return left, top, max(right - left, 0), max(bottom - top, 0)


def shown(state: GlutState, window: GlutWindow) -> bool:
    """Return whether neither it nor a window around it is hidden."""
    return all(holder.visible for holder in lineage(state, window))


def lay_out(state: GlutState, window: GlutWindow) -> None:
    """Tell the surface of a window inside another, and of all inside it, where they lie now."""
    outer = outermost(state, window)
    outer.stale = True
    former = state.current
    for inner in (window, *descendants(window)):
        if isinstance(inner.surface, SubWindow):
            inner.surface.inside = inside(state, inner)
            make_current(state, inner)
            inner.surface.frame_resized()
            sessions.current().window_resized(inner.surface, inner.size)
    if former is not None:
        make_current(state, former)


def uncovered(state: GlutState, window: GlutWindow) -> None:
    """Have the window around one that went or moved drawn again, as a screen does."""
    parent = state.windows.get(window.parent)
    if parent is not None:
        parent.redisplay = True
        outermost(state, parent).stale = True


# The pointer.


def pointed_window(window: GlutWindow) -> GlutWindow:
    """Return the one of an outermost window and those inside it that hears of keys and buttons."""
    return window.pointed or window


def point(state: GlutState, outer: GlutWindow, x: int, y: int) -> GlutWindow:
    """Note that the pointer is at a place of an outermost window; return the window that hears of its moves.

    That is the one under it, or while buttons are held the one where they were pressed.
    """
    outer.pointer = x, y
    if not outer.children:
        return outer
    held = next((w for w in (outer, *descendants(outer)) if w.buttons), None)
    under = _under(state, outer, x, y)
    if not held:
        enter(state, outer, under)
    heard = held or under
    left, top = place_in_outermost(state, heard)
    heard.pointer = x - left, y - top
    return heard


def _under(state: GlutState, outer: GlutWindow, x: int, y: int) -> GlutWindow:
    """Return the highest window at a place; beyond the outermost one's picture what fills the dome."""
    candidates = [w for w in descendants(outer) if shown(state, w)]
    for window in reversed(candidates):
        left, top, width, height = visible_area(state, window)
        if left <= x < left + width and top <= y < top + height:
            return window
    if 0 <= x < outer.size[0] and 0 <= y < outer.size[1]:
        return outer
    dome = sessions.current().dome
    filling = [w for w in candidates if dome is not None and dome.fills(w.surface)]
    return filling[-1] if filling else outer


def enter(state: GlutState, outer: GlutWindow, window: GlutWindow | None) -> None:
    """Tell of the pointer's way from window to window, through those around them; None: outside."""
    before, after = lineage(state, outer.pointed), lineage(state, window)
    outer.pointed = window
    if before == after:
        return
    common = [w for w in before if w in after]
    left = [w for w in reversed(before) if w not in common]
    entered = [w for w in after if w not in common]
    if before and before[-1] in common:
        left = [before[-1]]  # into a window inside it
    if after and after[-1] in common:
        entered = [after[-1]]  # back out of one
    for gone in left:
        call_window(state, gone, "entry", c.GLUT_LEFT)
    for come in entered:
        call_window(state, come, "entry", c.GLUT_ENTERED)
    if window is not None:
        show_cursor(state, window)
