"""glutCreateWindow and what a program can do to its windows."""

from __future__ import annotations

from typing import Any

from domeshim import session as sessions
from domeshim.errors import ScreenError
from domeshim.GLUT import constants as c
from domeshim.GLUT.arguments import integer, text
from domeshim.GLUT.closing import mark_closed
from domeshim.GLUT.complaints import fatal
from domeshim.GLUT.dispatch import make_current
from domeshim.GLUT.events import QueuedEvents
from domeshim.GLUT.input import frame_pointer
from domeshim.GLUT.state import GlutState, GlutWindow, current_window, glut_state, initialised_state
from domeshim.window.contract import SurfaceFormat

_CURSORS = {
    c.GLUT_CURSOR_INFO: "hand",
    c.GLUT_CURSOR_TEXT: "ibeam",
    c.GLUT_CURSOR_CROSSHAIR: "crosshair",
    c.GLUT_CURSOR_FULL_CROSSHAIR: "crosshair",
    c.GLUT_CURSOR_UP_DOWN: "vresize",
    c.GLUT_CURSOR_TOP_SIDE: "vresize",
    c.GLUT_CURSOR_BOTTOM_SIDE: "vresize",
    c.GLUT_CURSOR_LEFT_RIGHT: "hresize",
    c.GLUT_CURSOR_LEFT_SIDE: "hresize",
    c.GLUT_CURSOR_RIGHT_SIDE: "hresize",
    c.GLUT_CURSOR_NONE: "none",
}
"""The contract's shape for each of GLUT's cursors; an arrow for the others."""


def glutCreateWindow(title: Any) -> int:
    """Open a window with a context of its own, make it current and return its number."""
    name = text("glutCreateWindow", "title", title)
    state = initialised_state("glutCreateWindow")
    x, y = state.init_position
    window = open_window(state, name, state.init_size, (x, y) if x >= 0 and y >= 0 else None)
    if state.iconic:
        window.surface.iconify()
    return window.number


def glutCreateSubWindow(window: Any, x: Any, y: Any, width: Any, height: Any) -> int:
    """Open a window of its own in the place where GLUT would put one inside another; says so once."""
    function = "glutCreateSubWindow"
    state = initialised_state(function)
    parent = state.windows.get(integer(function, "window", window))
    if parent is None:
        return 0
    state.say_once("a subwindow is opened as a window of its own: nothing can be opened inside another here")
    left, top = parent.surface.position
    size = (integer(function, "width", width), integer(function, "height", height))
    place = (left + integer(function, "x", x), top + integer(function, "y", y))
    return open_window(state, "subwindow", size, place, parent.number).number


def open_window(
    state: GlutState, title: str, size: tuple[int, int], position: tuple[int, int] | None, parent: int = 0
) -> GlutWindow:
    """Open a window of the current display mode and tell the session of it.

    Ends the program with one line where no window can be had.
    """
    session = sessions.current()
    options = session.options
    size = session.window_size or (max(size[0], 1), max(size[1], 1))
    frame = options.frame if options.enabled else None
    display = options.display if options.enabled else None
    shares = state.options.get(c.GLUT_RENDERING_CONTEXT) == c.GLUT_USE_CURRENT_CONTEXT and state.current
    events = QueuedEvents(state)
    try:
        surface = session.backend.open_window(
            title,
            frame or size,
            position,
            _surface_format(state, session.backend.dome_samples if options.enabled else 0),
            events,
            share=shares.surface if shares else None,
        )
        if display is not None:
            surface.set_full_screen(True, display)
    except ScreenError as error:
        fatal(state.program, str(error))
    fixed = frame is not None or display is not None
    window = GlutWindow(state.next_window, surface, size, state.display_mode, parent, fixed, redisplay=True)
    events.window = window
    state.next_window += 1
    state.windows[window.number] = window
    state.current = window
    session.window_opened(surface, size)
    events.resized(*surface.size)
    events.visibility_changed(True)
    return window


def _surface_format(state: GlutState, dome_samples: int) -> SurfaceFormat:
    """Return what the program asked for and no more: without a depth buffer nothing is hidden, as there."""
    mode = state.display_mode
    multisampled = mode & c.GLUT_MULTISAMPLE
    return SurfaceFormat(
        double_buffer=bool(mode & c.GLUT_DOUBLE),
        depth=bool(mode & c.GLUT_DEPTH),
        stencil=bool(mode & c.GLUT_STENCIL),
        alpha=bool(mode & c.GLUT_ALPHA),
        accumulation=bool(mode & c.GLUT_ACCUM),
        stereo=bool(mode & c.GLUT_STEREO),
        samples=state.samples if multisampled else dome_samples,
    )


def glutDestroyWindow(window: Any) -> None:
    """Close the window and those inside it once this round of the main loop is over."""
    state = initialised_state("glutDestroyWindow")
    number = integer("glutDestroyWindow", "window", window)
    if number in state.windows:
        mark_closed(state, state.windows[number])
    else:
        state.warn(f"glutDestroyWindow(): window ID {number} not found!")


def glutSetWindow(window: Any) -> None:
    """Make the window of that number current."""
    state = initialised_state("glutSetWindow")
    number = integer("glutSetWindow", "window", window)
    if number in state.windows:
        make_current(state, state.windows[number])
    else:
        state.warn(f"glutSetWindow(): window ID {number} not found!")


def glutGetWindow() -> int:
    """Return the current window's number, 0 where there is none."""
    current = glut_state().current
    return current.number if current else 0


def glutSetWindowTitle(title: Any) -> None:
    """Name the current window."""
    name = text("glutSetWindowTitle", "title", title)
    current_window("glutSetWindowTitle").surface.set_title(name)


def glutSetIconTitle(title: Any) -> None:
    """Do nothing but check: an icon is named as its window is."""
    text("glutSetIconTitle", "title", title)
    current_window("glutSetIconTitle")


def glutReshapeWindow(width: Any, height: Any) -> None:
    """Ask for another size of the current window; the reshape callback tells what came of it."""
    size = (integer("glutReshapeWindow", "width", width), integer("glutReshapeWindow", "height", height))
    window = current_window("glutReshapeWindow")
    _leave_full_screen(window)
    if sessions.current().window_size is not None or min(size) < 1:
        return
    if window.fixed:
        window.size = size
        window.surface.events.resized(*window.surface.size)
    else:
        window.surface.resize(*size)


def glutPositionWindow(x: Any, y: Any) -> None:
    """Put the current window's top left corner at (x, y) of the screen."""
    place = (integer("glutPositionWindow", "x", x), integer("glutPositionWindow", "y", y))
    window = current_window("glutPositionWindow")
    _leave_full_screen(window)
    if not window.fixed:
        window.surface.move(*place)


def glutFullScreen() -> None:
    """Cover the screen with the current window; where the frame's size is fixed, leave it as it is."""
    window = current_window("glutFullScreen")
    session = sessions.current()
    if window.full_screen or window.fixed or session.window_size is not None:
        return
    window.surface.set_full_screen(True)
    window.full_screen = True


def glutLeaveFullScreen() -> None:
    """Give the current window back the size and place that it had."""
    _leave_full_screen(current_window("glutLeaveFullScreen"))


def glutFullScreenToggle() -> None:
    """Cover the screen, or leave it again."""
    if current_window("glutFullScreenToggle").full_screen:
        glutLeaveFullScreen()
    else:
        glutFullScreen()


def _leave_full_screen(window: GlutWindow) -> None:
    if window.full_screen:
        window.surface.set_full_screen(False)
        window.full_screen = False


def glutShowWindow() -> None:
    """Show the current window."""
    current_window("glutShowWindow").surface.set_visible(True)


def glutHideWindow() -> None:
    """Hide the current window."""
    current_window("glutHideWindow").surface.set_visible(False)


def glutIconifyWindow() -> None:
    """Shrink the current window to an icon."""
    current_window("glutIconifyWindow").surface.iconify()


def glutPushWindow() -> None:
    """Do nothing: no screen that we open windows on lets a program order them."""
    current_window("glutPushWindow")


def glutPopWindow() -> None:
    """Do nothing: no screen that we open windows on lets a program order them."""
    current_window("glutPopWindow")


def glutSetCursor(cursor: Any) -> None:
    """Show a pointer of that GLUT_CURSOR_... shape over the current window."""
    number = integer("glutSetCursor", "cursor", cursor)
    window = current_window("glutSetCursor")
    window.cursor = number
    window.surface.set_cursor(_CURSORS.get(number, "arrow"))


def glutWarpPointer(x: Any, y: Any) -> None:
    """Put the pointer at (x, y) of the current window, in the program's pixels."""
    place = (integer("glutWarpPointer", "x", x), integer("glutWarpPointer", "y", y))
    window = current_window("glutWarpPointer")
    window.surface.warp_pointer(*frame_pointer(window, *place))


def glutPostRedisplay() -> None:
    """Have the current window's display callback called in the next round of the main loop."""
    current_window("glutPostRedisplay").redisplay = True


def glutPostWindowRedisplay(window: Any) -> None:
    """Have that window's display callback called in the next round of the main loop."""
    state = initialised_state("glutPostWindowRedisplay")
    number = integer("glutPostWindowRedisplay", "window", window)
    if number in state.windows:
        state.windows[number].redisplay = True
    else:
        state.warn(f"glutPostWindowRedisplay(): window ID {number} not found!")


def glutSetWindowData(data: Any) -> None:
    """Keep something of the program's with the current window."""
    current_window("glutSetWindowData").data = data


def glutGetWindowData() -> Any:
    """Return what the program kept with the current window, or None."""
    return current_window("glutGetWindowData").data
