"""glutCreateWindow and what a program can do to its windows."""

from __future__ import annotations

from typing import Any

from domeshim import session as sessions
from domeshim.GLUT.arguments import integer, text
from domeshim.GLUT.closing import mark_closed
from domeshim.GLUT.cursors import show_cursor
from domeshim.GLUT.dispatch import make_current
from domeshim.GLUT.families import lay_out, outermost, pointed_window, uncovered
from domeshim.GLUT.input import frame_pointer
from domeshim.GLUT.opening import open_subwindow, open_window
from domeshim.GLUT.state import GlutWindow, current_window, glut_state, initialised_state


def glutCreateWindow(title: Any, *_more: object) -> int:
    """Open a window with a context of its own, make it current and return its number."""
    name = text("glutCreateWindow", "title", title)
    state = initialised_state("glutCreateWindow")
    x, y = state.init_position
    window = open_window(state, name, state.init_size, (x, y) if x >= 0 and y >= 0 else None)
    if state.iconic:
        window.surface.iconify()
    return window.number


def glutCreateSubWindow(window: Any, x: Any, y: Any, width: Any, height: Any, *_more: object) -> int:
    """Open a window with a context of its own inside another, make it current and return its number.

    x, y: from the left and the top of that window; negative, its right or bottom edge that far from the
    other side. A width or height under 0 leaves that much free there. Returns 0 where no window has that
    number.
    """
    function = "glutCreateSubWindow"
    state = initialised_state(function)
    parent = state.windows.get(integer(function, "window", window))
    left, width = integer(function, "x", x), integer(function, "width", width)
    top, height = integer(function, "y", y), integer(function, "height", height)
    if parent is None:
        return 0
    left, width = _span(left, width, parent.size[0])
    top, height = _span(top, height, parent.size[1])
    return open_subwindow(state, parent, (left, top), (width, height)).number


def _span(start: int, length: int, whole: int) -> tuple[int, int]:
    """Return where a subwindow begins and how long it is, as freeglut understands negative numbers."""
    if start < 0:
        start = whole + start - max(length, 0)
    if length < 0:
        length = whole - start + length
    return (start, length) if length >= 0 else (start + length, -length)


def glutDestroyWindow(window: Any, *_more: object) -> None:
    """Close the window and those inside it once this round of the main loop is over."""
    if (found := _numbered("glutDestroyWindow", window)) is not None:
        mark_closed(glut_state(), found)


def glutSetWindow(window: Any, *_more: object) -> None:
    """Make the window of that number current."""
    if (found := _numbered("glutSetWindow", window)) is not None:
        make_current(glut_state(), found)


def _numbered(function: str, window: Any) -> GlutWindow | None:
    """Return the window of that number; where there is none, warn in the function's name as freeglut does."""
    state = initialised_state(function)
    number = integer(function, "window", window)
    if number not in state.windows:
        state.warn(f"{function}(): window ID {number} not found!")
    return state.windows.get(number)


def glutGetWindow(*_more: object) -> int:
    """Return the current window's number, 0 where there is none."""
    current = glut_state().current
    return current.number if current else 0


def glutSetWindowTitle(title: Any, *_more: object) -> None:
    """Name the current window."""
    name = text("glutSetWindowTitle", "title", title)
    current_window("glutSetWindowTitle").surface.set_title(name)


def glutSetIconTitle(title: Any, *_more: object) -> None:
    """Do nothing but check: an icon is named as its window is."""
    text("glutSetIconTitle", "title", title)
    current_window("glutSetIconTitle")


def glutReshapeWindow(width: Any, height: Any, *_more: object) -> None:
    """Ask for another size of the current window; the reshape callback tells what came of it."""
    size = (integer("glutReshapeWindow", "width", width), integer("glutReshapeWindow", "height", height))
    window = current_window("glutReshapeWindow")
    _leave_full_screen(window)
    if min(size) < 1 or (sessions.current().window_size is not None and not window.parent):
        return
    if window.fixed:
        window.size = size
    if window.parent:
        window.surface.resize(*size)
        lay_out(glut_state(), window)
    elif window.fixed:
        window.surface.events.resized(*window.surface.size)
    else:
        window.surface.resize(*size)


def glutPositionWindow(x: Any, y: Any, *_more: object) -> None:
    """Put the current window's top left corner at (x, y) of the screen, or of the window around it."""
    place = (integer("glutPositionWindow", "x", x), integer("glutPositionWindow", "y", y))
    window = current_window("glutPositionWindow")
    _leave_full_screen(window)
    if window.parent:
        window.surface.move(*place)
        lay_out(glut_state(), window)
        uncovered(glut_state(), window)
    elif not window.fixed:
        window.surface.move(*place)


def glutFullScreen(*_more: object) -> None:
    """Cover the screen with the current window; where the frame's size is fixed, leave it as it is."""
    window = current_window("glutFullScreen")
    session = sessions.current()
    if window.parent:
        glut_state().warn("glutFullScreen called on a child window, ignoring...")
        return
    if window.full_screen or window.fixed or session.window_size is not None:
        return
    window.surface.set_full_screen(True)
    window.full_screen = True


def glutLeaveFullScreen(*_more: object) -> None:
    """Give the current window back the size and place that it had."""
    _leave_full_screen(current_window("glutLeaveFullScreen"))


def glutFullScreenToggle(*_more: object) -> None:
    """Cover the screen, or leave it again."""
    if current_window("glutFullScreenToggle").full_screen:
        glutLeaveFullScreen()
    else:
        glutFullScreen()


def _leave_full_screen(window: GlutWindow) -> None:
    if window.full_screen:
        window.surface.set_full_screen(False)
        window.full_screen = False


def glutShowWindow(*_more: object) -> None:
    """Show the current window."""
    current_window("glutShowWindow").surface.set_visible(True)


def glutHideWindow(*_more: object) -> None:
    """Hide the current window."""
    current_window("glutHideWindow").surface.set_visible(False)


def glutIconifyWindow(*_more: object) -> None:
    """Shrink the current window to an icon."""
    current_window("glutIconifyWindow").surface.iconify()


def glutPushWindow(*_more: object) -> None:
    """Put the current window under all others, one inside another under those beside it."""
    _order(current_window("glutPushWindow"), highest=False)


def glutPopWindow(*_more: object) -> None:
    """Put the current window over all others, one inside another over those beside it."""
    _order(current_window("glutPopWindow"), highest=True)


def _order(window: GlutWindow, *, highest: bool) -> None:
    state = glut_state()
    parent = state.windows.get(window.parent)
    if parent is None:
        if not window.surface.put(highest=highest):
            state.say_once("this screen does not let a program say which window lies over which")
        return
    parent.children.remove(window)
    parent.children.insert(len(parent.children) if highest else 0, window)
    outermost(state, window).stale = True


def glutSetCursor(cursor: Any, *_more: object) -> None:
    """Show a pointer of that GLUT_CURSOR_... shape over the current window."""
    number = integer("glutSetCursor", "cursor", cursor)
    window = current_window("glutSetCursor")
    window.cursor = number
    if pointed_window(outermost(glut_state(), window)) is window:
        show_cursor(glut_state(), window)


def glutWarpPointer(x: Any, y: Any, *_more: object) -> None:
    """Put the pointer at (x, y) of the current window, in the program's pixels."""
    place = (integer("glutWarpPointer", "x", x), integer("glutWarpPointer", "y", y))
    window = current_window("glutWarpPointer")
    window.surface.warp_pointer(*frame_pointer(window, *place))


def glutPostRedisplay(*_more: object) -> None:
    """Have the current window's display callback called in the next round of the main loop."""
    current_window("glutPostRedisplay").redisplay = True


def glutPostWindowRedisplay(window: Any, *_more: object) -> None:
    """Have that window's display callback called in the next round of the main loop."""
    if (found := _numbered("glutPostWindowRedisplay", window)) is not None:
        found.redisplay = True


def glutSetWindowData(data: Any) -> None:
    """Keep something of the program's with the current window."""
    current_window("glutSetWindowData").data = data


def glutGetWindowData(*_more: object) -> Any:
    """Return what the program kept with the current window, or None."""
    return current_window("glutGetWindowData").data
