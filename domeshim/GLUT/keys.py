"""From glfw's keys and buttons to GLUT's: what a special key's number is, and which byte a key types.

glfw's numbers are written out: it is loaded for windows on a display alone, and takes long to load.
"""

from __future__ import annotations

from domeshim.GLUT import constants as c

_SPECIAL = {
    **{290 + i: c.GLUT_KEY_F1 + i for i in range(12)},
    263: c.GLUT_KEY_LEFT,
    265: c.GLUT_KEY_UP,
    262: c.GLUT_KEY_RIGHT,
    264: c.GLUT_KEY_DOWN,
    266: c.GLUT_KEY_PAGE_UP,
    267: c.GLUT_KEY_PAGE_DOWN,
    268: c.GLUT_KEY_HOME,
    269: c.GLUT_KEY_END,
    260: c.GLUT_KEY_INSERT,
    282: 109,  # Num Lock; freeglut's own numbers: OpenGL.GLUT has 6 for it
    340: c.GLUT_KEY_SHIFT_L,
    344: c.GLUT_KEY_SHIFT_R,
    341: c.GLUT_KEY_CTRL_L,
    345: c.GLUT_KEY_CTRL_R,
    342: c.GLUT_KEY_ALT_L,
    346: c.GLUT_KEY_ALT_R,
}
_ESCAPE, _ENTER, _KEYPAD_ENTER, _BACKSPACE, _TAB, _DELETE = 256, 257, 335, 259, 258, 261
_CONTROL = {_ESCAPE: 27, _ENTER: 13, _KEYPAD_ENTER: 13, _BACKSPACE: 8, _TAB: 9, _DELETE: 127}
_WITH_SHIFT, _WITH_CONTROL, _WITH_ALT = 1, 2, 4
_SIGNS_WITH_CONTROL = {"[": 27, "\\": 28, "]": 29, "-": 31, " ": 0}


def special_number(key: int) -> int | None:
    """Return GLUT's number of a special key, or None for one that types."""
    return _SPECIAL.get(key)


def typed_without_character(key: int, modifiers: int) -> bytes | None:
    """Return the byte of a key for which the screen sends no character event.

    These are the control characters, and letters and signs pressed with Ctrl or Alt; None for all others.
    """
    if key in _CONTROL:
        return bytes([_CONTROL[key]])
    if not modifiers & (_WITH_CONTROL | _WITH_ALT) or not 32 <= key < 127:
        return None
    sign = chr(key)
    if modifiers & _WITH_CONTROL:
        if sign.isalpha():
            return bytes([key - 64])
        if sign in _SIGNS_WITH_CONTROL:
            return bytes([_SIGNS_WITH_CONTROL[sign]])
    return (sign if modifiers & _WITH_SHIFT else sign.lower()).encode()


def typed_by_character(codepoint: int) -> bytes | None:
    """Return the byte of a typed character; None for one beyond Latin-1, which GLUT cannot pass on."""
    return bytes([codepoint]) if codepoint < 256 else None


def glut_button(button: int) -> int:
    """Return GLUT's number of glfw's mouse button; those beyond the third follow the wheel's four."""
    return {0: c.GLUT_LEFT_BUTTON, 1: c.GLUT_RIGHT_BUTTON, 2: c.GLUT_MIDDLE_BUTTON}.get(button, button + 4)


def glut_modifiers(modifiers: int) -> int:
    """Return GLUT_ACTIVE_... of glfw's modifiers: shift, control, alt and super have the same bits."""
    return modifiers & 15
