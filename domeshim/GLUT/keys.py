"""From glfw's keys and buttons to GLUT's: what a special key's number is, and which byte a key types."""

from __future__ import annotations

import glfw

from domeshim.GLUT import constants as c

_SPECIAL = {
    **{glfw.KEY_F1 + i: c.GLUT_KEY_F1 + i for i in range(12)},
    glfw.KEY_LEFT: c.GLUT_KEY_LEFT,
    glfw.KEY_UP: c.GLUT_KEY_UP,
    glfw.KEY_RIGHT: c.GLUT_KEY_RIGHT,
    glfw.KEY_DOWN: c.GLUT_KEY_DOWN,
    glfw.KEY_PAGE_UP: c.GLUT_KEY_PAGE_UP,
    glfw.KEY_PAGE_DOWN: c.GLUT_KEY_PAGE_DOWN,
    glfw.KEY_HOME: c.GLUT_KEY_HOME,
    glfw.KEY_END: c.GLUT_KEY_END,
    glfw.KEY_INSERT: c.GLUT_KEY_INSERT,
    glfw.KEY_NUM_LOCK: 109,  # freeglut's own numbers; OpenGL.GLUT has 6 for it
    glfw.KEY_LEFT_SHIFT: c.GLUT_KEY_SHIFT_L,
    glfw.KEY_RIGHT_SHIFT: c.GLUT_KEY_SHIFT_R,
    glfw.KEY_LEFT_CONTROL: c.GLUT_KEY_CTRL_L,
    glfw.KEY_RIGHT_CONTROL: c.GLUT_KEY_CTRL_R,
    glfw.KEY_LEFT_ALT: c.GLUT_KEY_ALT_L,
    glfw.KEY_RIGHT_ALT: c.GLUT_KEY_ALT_R,
}
_CONTROL = {
    glfw.KEY_ESCAPE: 27,
    glfw.KEY_ENTER: 13,
    glfw.KEY_KP_ENTER: 13,
    glfw.KEY_BACKSPACE: 8,
    glfw.KEY_TAB: 9,
    glfw.KEY_DELETE: 127,
}
_WITH_CONTROL = {"[": 27, "\\": 28, "]": 29, "-": 31, " ": 0}


def special_number(key: int) -> int | None:
    """Return GLUT's number of a special key, or None for one that types."""
    return _SPECIAL.get(key)


def typed_without_character(key: int, modifiers: int) -> bytes | None:
    """Return the byte of a key for which the screen sends no character event.

    These are the control characters, and letters and signs pressed with Ctrl or Alt; None for all others.
    """
    if key in _CONTROL:
        return bytes([_CONTROL[key]])
    if not modifiers & (glfw.MOD_CONTROL | glfw.MOD_ALT) or not 32 <= key < 127:
        return None
    sign = chr(key)
    if modifiers & glfw.MOD_CONTROL:
        if sign.isalpha():
            return bytes([key - 64])
        if sign in _WITH_CONTROL:
            return bytes([_WITH_CONTROL[sign]])
    return (sign if modifiers & glfw.MOD_SHIFT else sign.lower()).encode()


def typed_by_character(codepoint: int) -> bytes | None:
    """Return the byte of a typed character; None for one beyond Latin-1, which GLUT cannot pass on."""
    return bytes([codepoint]) if codepoint < 256 else None


def glut_button(button: int) -> int:
    """Return GLUT's number of glfw's mouse button; those beyond the third follow the wheel's four."""
    return {0: c.GLUT_LEFT_BUTTON, 1: c.GLUT_RIGHT_BUTTON, 2: c.GLUT_MIDDLE_BUTTON}.get(button, button + 4)


def glut_modifiers(modifiers: int) -> int:
    """Return GLUT_ACTIVE_... of glfw's modifiers: shift, control, alt and super have the same bits."""
    return modifiers & 15
