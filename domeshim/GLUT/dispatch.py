"""Calling the program: its callbacks, in the right window, and what becomes of an exception."""

from __future__ import annotations

import sys
from typing import Any

from domeshim import session as sessions
from domeshim.errors import DomeError
from domeshim.GLUT.arguments import Callback
from domeshim.GLUT.complaints import print_program_traceback
from domeshim.GLUT.state import GlutState, GlutWindow


def call(state: GlutState, function: Callback, *args: Any) -> None:
    """Call the program's function.

    An exception's traceback is printed and ends the program with status 1, or is passed over with
    DOME_KEEP_GOING. SystemExit and KeyboardInterrupt pass through.
    """
    try:
        function(*args)
    except DomeError as error:
        print(f"domeshim: {error}", file=sys.stderr)
        close_surfaces(state)
        raise SystemExit(error.exit_status) from None
    except Exception as error:  # whatever a program raises
        print_program_traceback(error)
        if not sessions.current().options.keep_going:
            close_surfaces(state)
            raise SystemExit(1) from None


def call_window(state: GlutState, window: GlutWindow, name: str, *args: Any) -> None:
    """Call the window's callback of that name, where it has one, with the window current."""
    function = window.callbacks.get(name)
    if function is not None:
        make_current(state, window)
        call(state, function, *args)


def call_input(state: GlutState, window: GlutWindow, modifiers: int, name: str, *args: Any) -> None:
    """Call a callback for the keyboard or the mouse, which may ask for the modifier keys."""
    state.modifiers = modifiers
    try:
        call_window(state, window, name, *args, *window.pointer)
    finally:
        state.modifiers = None


def make_current(state: GlutState, window: GlutWindow) -> None:
    """Direct the program's GL calls to the window."""
    if state.current is not window:
        session = sessions.current()
        if session.dome is not None:
            session.dome.flush()  # what was recorded belongs to the window before
        window.surface.make_current()
        state.current = window
        session.window_current(window.surface)


def close_surface(state: GlutState, window: GlutWindow) -> None:
    """Destroy the window's context, and forget it where it was current."""
    sessions.current().window_closed(window.surface)
    window.surface.close()
    if state.current is window:
        state.current = None


def close_surfaces(state: GlutState) -> None:
    """Destroy all windows at once, without a word to the program."""
    for window in (*state.closing, *state.windows.values()):
        close_surface(state, window)
    state.closing.clear()
    state.windows.clear()
