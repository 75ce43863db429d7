"""glut...Func: which of the program's functions hears of what, window by window.

None takes a callback back. Spaceballs, dials, button boxes and tablets can be registered for as ever; they
are not served, and glutDeviceGet says that there are none.
"""

from __future__ import annotations

from typing import Any

from domeshim.GLUT.arguments import callback, integer
from domeshim.GLUT.state import current_window, initialised_state


def _register(function: str, name: str, wanted: Any) -> Any:
    """Note the current window's callback, or take it back; return what was given, as PyOpenGL does."""
    called = callback(function, wanted)
    window = current_window(function)
    if called is None:
        window.callbacks.pop(name, None)
    else:
        window.callbacks[name] = called
    return wanted


def glutDisplayFunc(function: Any) -> Any:
    """Have function() draw the current window."""
    if callback("glutDisplayFunc", function) is None:
        initialised_state("glutDisplayFunc").fail("glutDisplayFunc needs a function: a window must be drawn.")
    return _register("glutDisplayFunc", "display", function)


def glutReshapeFunc(function: Any) -> Any:
    """Tell function(width, height) of the current window's size; without one, glViewport is set to it."""
    return _register("glutReshapeFunc", "reshape", function)


def glutKeyboardFunc(function: Any) -> Any:
    """Tell function(key, x, y) of each key that types; key is one byte."""
    return _register("glutKeyboardFunc", "keyboard", function)


def glutKeyboardUpFunc(function: Any) -> Any:
    """Tell function(key, x, y) of each such key let go."""
    return _register("glutKeyboardUpFunc", "keyboard_up", function)


def glutSpecialFunc(function: Any) -> Any:
    """Tell function(key, x, y) of arrows, function keys and the like; key is a GLUT_KEY_... number."""
    return _register("glutSpecialFunc", "special", function)


def glutSpecialUpFunc(function: Any) -> Any:
    """Tell function(key, x, y) of each such key let go."""
    return _register("glutSpecialUpFunc", "special_up", function)


def glutMouseFunc(function: Any) -> Any:
    """Tell function(button, state, x, y) of mouse buttons, and of the wheel as buttons 3 to 6."""
    return _register("glutMouseFunc", "mouse", function)


def glutMouseWheelFunc(function: Any) -> Any:
    """Tell function(wheel, direction, x, y) of the wheel, instead of glutMouseFunc's."""
    return _register("glutMouseWheelFunc", "wheel", function)


def glutMotionFunc(function: Any) -> Any:
    """Tell function(x, y) of the pointer moving with a button held."""
    return _register("glutMotionFunc", "motion", function)


def glutPassiveMotionFunc(function: Any) -> Any:
    """Tell function(x, y) of the pointer moving with no button held."""
    return _register("glutPassiveMotionFunc", "passive_motion", function)


def glutEntryFunc(function: Any) -> Any:
    """Tell function(state) of the pointer coming in (GLUT_ENTERED) and leaving (GLUT_LEFT)."""
    return _register("glutEntryFunc", "entry", function)


def glutVisibilityFunc(function: Any) -> Any:
    """Tell function(state) whether the window is GLUT_VISIBLE or GLUT_NOT_VISIBLE."""
    return _register("glutVisibilityFunc", "visibility", function)


def glutWindowStatusFunc(function: Any) -> Any:
    """Tell function(state) whether the window is GLUT_FULLY_RETAINED or GLUT_HIDDEN."""
    return _register("glutWindowStatusFunc", "window_status", function)


def glutPositionFunc(function: Any) -> Any:
    """Tell function(x, y) of the window's place on the screen."""
    return _register("glutPositionFunc", "position", function)


def glutCloseFunc(function: Any) -> Any:
    """Tell function() that the window is about to be gone."""
    return _register("glutCloseFunc", "close", function)


def glutWMCloseFunc(function: Any) -> Any:
    """Tell function() that the window is about to be gone; freeglut's other name for glutCloseFunc."""
    return _register("glutWMCloseFunc", "close", function)


def glutOverlayDisplayFunc(function: Any) -> Any:
    """Register a function for the overlay; there are no overlays, so it is never called."""
    return _register("glutOverlayDisplayFunc", "overlay_display", function)


def glutSpaceballMotionFunc(function: Any) -> Any:
    """Register a function for a spaceball; never called, see above."""
    return _register("glutSpaceballMotionFunc", "spaceball_motion", function)


def glutSpaceballRotateFunc(function: Any) -> Any:
    """Register a function for a spaceball; never called, see above."""
    return _register("glutSpaceballRotateFunc", "spaceball_rotate", function)


def glutSpaceballButtonFunc(function: Any) -> Any:
    """Register a function for a spaceball; never called, see above."""
    return _register("glutSpaceballButtonFunc", "spaceball_button", function)


def glutButtonBoxFunc(function: Any) -> Any:
    """Register a function for a button box; never called, see above."""
    return _register("glutButtonBoxFunc", "button_box", function)


def glutDialsFunc(function: Any) -> Any:
    """Register a function for dials; never called, see above."""
    return _register("glutDialsFunc", "dials", function)


def glutTabletMotionFunc(function: Any) -> Any:
    """Register a function for a tablet; never called, see above."""
    return _register("glutTabletMotionFunc", "tablet_motion", function)


def glutTabletButtonFunc(function: Any) -> Any:
    """Register a function for a tablet; never called, see above."""
    return _register("glutTabletButtonFunc", "tablet_button", function)


def glutIgnoreKeyRepeat(ignore: Any, *_more: object) -> None:
    """Say whether the current window shall not hear of keys that repeat while they are held."""
    ignored = bool(integer("glutIgnoreKeyRepeat", "ignore", ignore))
    current_window("glutIgnoreKeyRepeat").ignore_repeat = ignored


def glutSetKeyRepeat(repeatMode: Any, *_more: object) -> None:
    """Say the same for all windows: GLUT_KEY_REPEAT_OFF, _ON or _DEFAULT."""
    state = initialised_state("glutSetKeyRepeat")
    state.key_repeat = integer("glutSetKeyRepeat", "repeatMode", repeatMode)
