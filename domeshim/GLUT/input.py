"""Keyboard and mouse, as GLUT tells the program of them."""

from __future__ import annotations

import math

from domeshim import session as sessions
from domeshim.GLUT import constants as c
from domeshim.GLUT import keys
from domeshim.GLUT.dispatch import call_input, call_window
from domeshim.GLUT.popup import menu_takes_button, menu_takes_motion
from domeshim.GLUT.state import GlutState, GlutWindow

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


def key(state: GlutState, window: GlutWindow, key: int, pressed: bool, modifiers: int) -> None:
    """Tell of a key, unless its character is still to come."""
    window.typing = None
    window.modifiers = keys.glut_modifiers(modifiers)
    if not pressed:
        if key in window.keys:
            family, value = window.keys.pop(key)
            call_input(state, window, window.modifiers, family + "_up", value)
        return
    if key in window.keys and (window.ignore_repeat or state.key_repeat == c.GLUT_KEY_REPEAT_OFF):
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


def character(state: GlutState, window: GlutWindow, codepoint: int) -> None:
    """Pass a typed character on; it belongs to the key whose event came just before."""
    typed = keys.typed_by_character(codepoint)
    if typed is None or window.typing == _REPEATED:
        return
    if window.typing is None:
        call_input(state, window, window.modifiers, "keyboard", typed)
    else:
        _press(state, window, window.typing, "keyboard", typed)


def _press(state: GlutState, window: GlutWindow, key: int, family: str, value: bytes | int) -> None:
    window.keys[key] = (family, value)
    call_input(state, window, window.modifiers, family, value)


def pointer_moved(state: GlutState, window: GlutWindow, x: float, y: float) -> None:
    """Tell of the pointer, in the program's pixels."""
    window.pointer = program_pointer(window, x, y)
    if menu_takes_motion(state, window):
        return
    call_window(state, window, "motion" if window.buttons else "passive_motion", *window.pointer)


def pointer_entered(state: GlutState, window: GlutWindow, inside: bool) -> None:
    """Tell of the pointer coming and leaving."""
    call_window(state, window, "entry", c.GLUT_ENTERED if inside else c.GLUT_LEFT)


def button(state: GlutState, window: GlutWindow, button: int, pressed: bool, modifiers: int) -> None:
    """Tell of a mouse button, unless it opens a menu."""
    number = keys.glut_button(button)
    (window.buttons.add if pressed else window.buttons.discard)(number)
    if menu_takes_button(state, window, number, pressed):
        return
    window.modifiers = keys.glut_modifiers(modifiers)
    call_input(state, window, window.modifiers, "mouse", number, c.GLUT_DOWN if pressed else c.GLUT_UP)


def wheel(state: GlutState, window: GlutWindow, dx: float, dy: float) -> None:
    """Turn by whole notches: up is button 3, down 4, left 5, right 6, or a wheel and a direction."""
    for wheel, turned in ((0, dy), (1, dx)):
        part, whole = math.modf(window.turned[wheel] + turned)
        window.turned[wheel] = part
        direction = 1 if whole > 0 else -1
        for _ in range(abs(int(whole))):
            if "wheel" in window.callbacks:
                call_input(state, window, window.modifiers, "wheel", wheel, direction)
            else:
                button = 3 + 2 * wheel + (direction < 0)
                call_input(state, window, window.modifiers, "mouse", button, c.GLUT_DOWN)
                call_input(state, window, window.modifiers, "mouse", button, c.GLUT_UP)
