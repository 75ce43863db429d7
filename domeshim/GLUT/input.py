"""Keyboard and mouse, as GLUT tells the program of them."""

from __future__ import annotations

import math

from domeshim import session as sessions
from domeshim.GLUT import constants as c
from domeshim.GLUT import keys
from domeshim.GLUT.dispatch import call_input, call_window
from domeshim.GLUT.families import enter, point, pointed_window
from domeshim.GLUT.popup import menu_takes_button, menu_takes_motion
from domeshim.GLUT.state import GlutState, GlutWindow
from domeshim.window.dome_keys import is_dome_key

_REPEATED = -1  # stands for the key whose automatic repetition is being ignored


def program_pointer(window: GlutWindow, x: float, y: float) -> tuple[int, int]:
    """Return where the program believes the pointer to be, in its own pixels, for a place in the frame.

    On the dome: where the monitor would show what is in the middle of the pixel under the pointer.
    """
    dome = sessions.current().dome
    if dome is not None:
        x, y = dome.program_place(window.surface, math.floor(x) + 0.5, math.floor(y) + 0.5)
        return math.floor(x), math.floor(y)
    width, height = window.surface.size
    return math.floor(x * window.size[0] / max(width, 1)), math.floor(y * window.size[1] / max(height, 1))


def frame_pointer(window: GlutWindow, x: int, y: int) -> tuple[float, float]:
    """Return the place in the frame of a pixel of the program's window: program_pointer's way back."""
    width, height = window.surface.size
    dome = sessions.current().dome
    if dome is None:
        return x * width / window.size[0], y * height / window.size[1]
    x_found, y_found = dome.frame_place(window.surface, x + 0.5, y + 0.5)
    return max(0, min(math.floor(x_found), width - 1)), max(0, min(math.floor(y_found), height - 1))


# The screen tells an outermost window of all that happens to it and to those inside it. Which keys are held
# is noted there; who hears of it is where the pointer is.


def key(state: GlutState, window: GlutWindow, key: int, pressed: bool, modifiers: int) -> None:
    """Tell of a key, unless its character is still to come, or it is the dome's."""
    if pressed and is_dome_key(key, modifiers) and _is_taken(window, key):
        return
    heard = pointed_window(window)
    window.typing = None
    heard.modifiers = keys.glut_modifiers(modifiers)
    if not pressed:
        if key in window.keys:
            family, value = window.keys.pop(key)
            call_input(state, heard, heard.modifiers, family + "_up", value)
        return
    if key in window.keys and (heard.ignore_repeat or state.key_repeat == c.GLUT_KEY_REPEAT_OFF):
        window.typing = _REPEATED
        return
    special = keys.special_number(key)
    typed = keys.typed_without_character(key, modifiers)
    if special is not None:
        _press(state, window, key, "special", special)
    elif typed is not None:
        _press(state, window, key, "keyboard", typed)
    else:
        window.typing = key


def _is_taken(window: GlutWindow, key: int) -> bool:
    """Let the dome have its key; False where there is no dome."""
    if key in window.keys:
        return True  # its automatic repetition
    if not sessions.current().takes_key(window.surface, key):
        return False
    window.keys[key] = ("dome", 0)  # its release is not the program's either
    window.redisplay = True
    return True


def character(state: GlutState, window: GlutWindow, codepoint: int) -> None:
    """Pass a typed character on; it belongs to the key whose event came just before."""
    typed = keys.typed_by_character(codepoint)
    if typed is None or window.typing == _REPEATED:
        return
    if window.typing is None:
        heard = pointed_window(window)
        call_input(state, heard, heard.modifiers, "keyboard", typed)
    else:
        _press(state, window, window.typing, "keyboard", typed)


def _press(state: GlutState, window: GlutWindow, key: int, family: str, value: bytes | int) -> None:
    window.keys[key] = (family, value)
    heard = pointed_window(window)
    call_input(state, heard, heard.modifiers, family, value)


def pointer_moved(state: GlutState, window: GlutWindow, x: float, y: float) -> None:
    """Tell of the pointer, in the program's pixels."""
    window.pixel = math.floor(x), math.floor(y)
    heard = point(state, window, *program_pointer(window, x, y))
    if menu_takes_motion(state, window):
        return
    call_window(state, heard, "motion" if heard.buttons else "passive_motion", *heard.pointer)


def pointer_entered(state: GlutState, window: GlutWindow, inside: bool) -> None:
    """Tell of the pointer coming and leaving."""
    if window.children:
        enter(state, window, window if inside else None)
    else:
        call_window(state, window, "entry", c.GLUT_ENTERED if inside else c.GLUT_LEFT)


def button(state: GlutState, window: GlutWindow, button: int, pressed: bool, modifiers: int) -> None:
    """Tell of a mouse button, unless it opens a menu."""
    heard = pointed_window(window)
    number = keys.glut_button(button)
    (heard.buttons.add if pressed else heard.buttons.discard)(number)
    if menu_takes_button(state, heard, number, pressed):
        return
    heard.modifiers = keys.glut_modifiers(modifiers)
    call_input(state, heard, heard.modifiers, "mouse", number, c.GLUT_DOWN if pressed else c.GLUT_UP)
    if window.children and not heard.buttons:
        point(state, window, *window.pointer)  # it may have been let go over another window


def wheel(state: GlutState, window: GlutWindow, dx: float, dy: float) -> None:
    """Turn by whole notches: up is button 3, down 4, left 5, right 6, or a wheel and a direction."""
    heard = pointed_window(window)
    for wheel, turned in ((0, dy), (1, dx)):
        part, whole = math.modf(heard.turned[wheel] + turned)
        heard.turned[wheel] = part
        direction = 1 if whole > 0 else -1
        for _ in range(abs(int(whole))):
            if "wheel" in heard.callbacks:
                call_input(state, heard, heard.modifiers, "wheel", wheel, direction)
            else:
                button = 3 + 2 * wheel + (direction < 0)
                call_input(state, heard, heard.modifiers, "mouse", button, c.GLUT_DOWN)
                call_input(state, heard, heard.modifiers, "mouse", button, c.GLUT_UP)
