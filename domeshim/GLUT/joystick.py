"""Joysticks: each window that listens is told of all of them, as often as it asked to be."""

from __future__ import annotations

from typing import Any

from domeshim import session as sessions
from domeshim.GLUT.arguments import callback, integer
from domeshim.GLUT.dispatch import call_window
from domeshim.GLUT.state import GlutState, GlutWindow, current_window, glut_state, initialised_state
from domeshim.window.contract import Joystick

_FULL = 1000
"""What GLUT says of an axis at its end."""


def glutJoystickFunc(function: Any, pollInterval: Any = 0) -> Any:
    """Tell function(buttons, x, y, z) of each joystick every pollInterval milliseconds; 0: only when forced.

    buttons: a bit for each that is held, the first the lowest; x, y, z: the first three axes, -1000 to 1000.
    """
    interval = integer("glutJoystickFunc", "pollInterval", pollInterval)
    called = callback("glutJoystickFunc", function)
    window = current_window("glutJoystickFunc")
    glut_state().owns_joystick = True
    window.callbacks.pop("joystick", None)
    if called is not None:
        window.callbacks["joystick"] = called
    window.joystick_interval = max(interval, 0) / 1000
    window.joystick_due = sessions.current().clock.now()
    return function


def glutForceJoystickFunc() -> None:
    """Tell the current window of the joysticks now."""
    initialised_state("glutForceJoystickFunc").owns_joystick = True
    _tell(glut_state(), current_window("glutForceJoystickFunc"))


def joysticks() -> tuple[Joystick, ...]:
    """Return those that are plugged in."""
    return sessions.current().backend.joysticks


def tell_of_joysticks(state: GlutState) -> None:
    """Tell each window whose time has come."""
    now = sessions.current().clock.now()
    for window in _listening(state):
        if window.joystick_due <= now:
            window.joystick_due = now + window.joystick_interval
            _tell(state, window)


def next_joystick_time(state: GlutState) -> float | None:
    """Return the moment of the session's clock when a window wants to be told, or None."""
    moments = [window.joystick_due for window in _listening(state)]
    return min(moments) if moments and joysticks() else None


def _listening(state: GlutState) -> list[GlutWindow]:
    windows = state.windows.values()
    return [w for w in windows if "joystick" in w.callbacks and w.joystick_interval > 0]


def _tell(state: GlutState, window: GlutWindow) -> None:
    for joystick in joysticks() if "joystick" in window.callbacks else ():
        buttons = sum(1 << k for k, held in enumerate(joystick.buttons) if held)
        axes = [round(_FULL * axis) for axis in (*joystick.axes, 0.0, 0.0, 0.0)[:3]]
        call_window(state, window, "joystick", buttons, *axes)
