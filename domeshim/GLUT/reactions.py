"""What GLUT does when something happens to a window."""

from __future__ import annotations

from collections.abc import Callable

from domeshim import session as sessions
from domeshim.GLUT import constants as c
from domeshim.GLUT import input as program_input
from domeshim.GLUT.closing import user_closes
from domeshim.GLUT.dispatch import call_window, make_current
from domeshim.GLUT.families import lay_out, uncovered
from domeshim.GLUT.state import GlutState, GlutWindow


def dispatch_events(state: GlutState) -> None:
    """Call the program for all that has happened."""
    while state.events:
        window, name, args = state.events.popleft()
        if window.number in state.windows:
            _HANDLERS[name](state, window, *args)


def _resized(state: GlutState, window: GlutWindow, width: int, height: int) -> None:
    size = window.size if window.fixed else (width, height)
    told = window.told_size
    window.size = window.told_size = size
    make_current(state, window)
    sessions.current().window_resized(window.surface, size)
    for child in tuple(window.children):
        lay_out(state, child)
    if size != told:
        _tell_size(state, window)
    window.redisplay = True


def _tell_size(state: GlutState, window: GlutWindow) -> None:
    if "reshape" in window.callbacks:
        call_window(state, window, "reshape", *window.size)
    else:
        from OpenGL import GL  # noqa: PLC0415 - its functions as they are overlaid now

        GL.glViewport(0, 0, *window.size)


def _exposed(_: GlutState, window: GlutWindow) -> None:
    window.redisplay = True


def _moved(state: GlutState, window: GlutWindow, x: int, y: int) -> None:
    call_window(state, window, "position", x, y)


def _visibility_changed(state: GlutState, window: GlutWindow, visible: bool) -> None:
    came_back = visible and not window.visible
    window.visible = visible
    window.redisplay |= visible
    if not visible:
        uncovered(state, window)
    call_window(state, window, "window_status", c.GLUT_FULLY_RETAINED if visible else c.GLUT_HIDDEN)
    call_window(state, window, "visibility", c.GLUT_VISIBLE if visible else c.GLUT_NOT_VISIBLE)
    for child in [inner for inner in window.children if came_back and inner.visible]:
        child.redisplay = True
        call_window(state, child, "visibility", c.GLUT_VISIBLE)


_HANDLERS: dict[str, Callable[..., None]] = {
    "resized": _resized,
    "exposed": _exposed,
    "moved": _moved,
    "visibility_changed": _visibility_changed,
    "close_asked": user_closes,
    "key": program_input.key,
    "character": program_input.character,
    "pointer_moved": program_input.pointer_moved,
    "pointer_entered": program_input.pointer_entered,
    "button": program_input.button,
    "wheel": program_input.wheel,
}
