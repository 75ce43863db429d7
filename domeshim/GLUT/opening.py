"""Opening windows, on the screen, off it, and inside others."""

from __future__ import annotations

from dataclasses import replace

from domeshim import session as sessions
from domeshim.errors import ScreenError
from domeshim.GLUT import constants as c
from domeshim.GLUT.complaints import fatal
from domeshim.GLUT.events import QueuedEvents
from domeshim.GLUT.families import inside, outermost
from domeshim.GLUT.state import GlutState, GlutWindow
from domeshim.window.contract import SurfaceFormat, Window, WindowEvents
from domeshim.window.frame import NO_QUAD
from domeshim.window.subwindow import SubWindow


def open_window(
    state: GlutState, title: str, size: tuple[int, int], position: tuple[int, int] | None
) -> GlutWindow:
    """Open a window of the current display mode and tell the session of it.

    Ends the program with one line where no window can be had.
    """
    session = sessions.current()
    options = session.options
    asked = max(size[0], 1), max(size[1], 1)
    size = session.window_size or asked
    frame = options.frame if options.enabled else None
    display = options.display if options.enabled else None
    events = QueuedEvents(state)
    wanted = _surface_format(state, on_dome=options.enabled)
    in_quad = options.enabled and options.stereo == "quad"
    try:
        surface = session.backend.open_window(
            title,
            frame or size,
            position,
            replace(wanted, stereo=wanted.stereo or in_quad),
            events,
            share=_shared(state),
        )
        if display is not None:
            surface.set_full_screen(True, display)
    except ScreenError as error:
        fatal(state.program, f"{NO_QUAD} ({error})" if in_quad else str(error))
    if in_quad and not surface.format.stereo:
        fatal(state.program, NO_QUAD)
    surface.asked = asked if size != asked else None
    window = GlutWindow(state.next_window, surface, size, state.display_mode)
    window.fixed = frame is not None or display is not None
    return _admit(state, window, events)


def open_subwindow(
    state: GlutState, parent: GlutWindow, place: tuple[int, int], size: tuple[int, int]
) -> GlutWindow:
    """Open a window of the current display mode inside another and tell the session of it.

    Ends the program with one line where no context can be had.
    """
    from domeshim.GLUT.composition import Composition  # noqa: PLC0415 - only with windows inside others

    session = sessions.current()
    outer = outermost(state, parent)
    on_dome = session.options.enabled
    size = (max(size[0], 1), max(size[1], 1))
    wanted = _surface_format(state, on_dome=on_dome)
    events = QueuedEvents(state)
    try:
        hidden = session.backend.open_window(
            "",
            outer.surface.size if on_dome else size,
            None,
            replace(wanted, double_buffer=True),
            WindowEvents(),
            share=_shared(state),
            shown=False,
        )
    except ScreenError as error:
        fatal(state.program, str(error))
    surface = SubWindow(hidden, outer.surface, events, wanted, on_dome=on_dome)
    surface.move(*place)
    window = GlutWindow(state.next_window, surface, size, state.display_mode, parent.number, fixed=True)
    session.parts = Composition(state)
    parent.children.append(window)
    outer.redisplay |= outer.picture is None
    surface.inside = inside(state, window)
    return _admit(state, window, events)


def _admit(state: GlutState, window: GlutWindow, events: QueuedEvents) -> GlutWindow:
    """Make an open window the current one, and tell the session and the program of it."""
    from OpenGL import GL  # noqa: PLC0415 - its functions as they are overlaid now

    window.redisplay = True
    events.window = window
    state.next_window += 1
    state.windows[window.number] = window
    state.current = window
    sessions.current().window_opened(window.surface, window.size)
    if window.size != window.surface.size:
        GL.glViewport(0, 0, *window.size)
    events.resized(*window.surface.size)
    if window.parent:
        state.events.appendleft(state.events.pop())  # a screen tells of what lies inside first
    events.visibility_changed(True)
    return window


def _shared(state: GlutState) -> Window | None:
    """Return the surface whose GL objects the next window shall share, where the program asks for that."""
    shares = state.options.get(c.GLUT_RENDERING_CONTEXT) == c.GLUT_USE_CURRENT_CONTEXT
    if not shares or state.current is None:
        return None
    surface = state.current.surface
    return surface.surface if isinstance(surface, SubWindow) else surface


def _surface_format(state: GlutState, *, on_dome: bool) -> SurfaceFormat:
    """Return what the program asked for and no more: without a depth buffer nothing is hidden, as there."""
    mode = state.display_mode
    samples = None if on_dome else 0
    return SurfaceFormat(
        double_buffer=bool(mode & c.GLUT_DOUBLE),
        depth=bool(mode & c.GLUT_DEPTH),
        stencil=bool(mode & c.GLUT_STENCIL),
        alpha=bool(mode & c.GLUT_ALPHA),
        accumulation=bool(mode & c.GLUT_ACCUM),
        stereo=bool(mode & c.GLUT_STEREO),
        samples=state.samples if mode & c.GLUT_MULTISAMPLE else samples,
    )
