"""The dome's own keys, which no program hears: Ctrl+Shift+P the test card, Ctrl+Shift+R a recording."""

from __future__ import annotations

CARD_KEY, RECORD_KEY = 80, 82
"""P and R, by glfw's numbers."""
DOME_KEYS = (CARD_KEY, RECORD_KEY)
_SHIFT, _CONTROL, _ALT, _SUPER = 1, 2, 4, 8


def is_dome_key(key: int, modifiers: int) -> bool:
    """This key with these modifiers, by glfw's numbers, is one of the dome's."""
    return key in DOME_KEYS and modifiers & (_SHIFT | _CONTROL | _ALT | _SUPER) == _SHIFT | _CONTROL
