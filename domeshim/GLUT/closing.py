"""How windows go: by the program, by the user, or with the main loop."""

from __future__ import annotations

from domeshim import session as sessions
from domeshim.GLUT import constants as c
from domeshim.GLUT.dispatch import call_window, close_surface
from domeshim.GLUT.families import uncovered
from domeshim.GLUT.state import GlutState, GlutWindow


def mark_closed(state: GlutState, window: GlutWindow) -> None:
    """Forget the window and those inside it; its context stays until this round of the main loop is over."""
    for child in tuple(window.children):
        mark_closed(state, child)
    uncovered(state, window)
    for other in state.windows.values():
        other.pointed = None if other.pointed is window else other.pointed
        other.children = [child for child in other.children if child is not window]
    state.windows.pop(window.number, None)
    state.closing.append(window)
    if state.current is window:
        state.current = None


def close_marked(state: GlutState) -> None:
    """Tell the program of each window that it or the user closed, and destroy it."""
    while state.closing:
        window = state.closing.pop(0)
        call_window(state, window, "close")
        close_surface(state, window)


def user_closes(state: GlutState, window: GlutWindow) -> None:
    """Close a window as the user asked, and end what GLUT_ACTION_ON_WINDOW_CLOSE says ends with it."""
    mark_closed(state, window)
    close_marked(state)
    action = closing_action(state)
    if action == c.GLUT_ACTION_EXIT:
        close_all(state)
        raise SystemExit(0)
    if action == c.GLUT_ACTION_GLUTMAINLOOP_RETURNS:
        state.running = False


def close_all(state: GlutState) -> None:
    """Close all windows, telling the program of each."""
    for window in list(state.windows.values()):
        if window.number in state.windows:
            mark_closed(state, window)
    close_marked(state)


def closing_action(state: GlutState) -> int:
    """Return the program's choice for GLUT_ACTION_ON_WINDOW_CLOSE; GLUT_ACTION_EXIT unless it chose."""
    return state.options.get(c.GLUT_ACTION_ON_WINDOW_CLOSE, c.GLUT_ACTION_EXIT)


def fgDeinitialize(*_: object) -> None:
    """Close all windows and forget everything; the program may call glutInit again."""
    session = sessions.current()
    if session.glut is not None:
        close_all(session.glut)
        session.glut = None
