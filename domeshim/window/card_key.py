"""Ctrl+Shift+P: the key that shows the test card, and which no program hears."""

from __future__ import annotations

CARD_KEY = 80
"""P, by glfw's number."""
_SHIFT, _CONTROL, _ALT, _SUPER = 1, 2, 4, 8


def is_card_key(key: int, modifiers: int) -> bool:
    """This key with these modifiers, by glfw's numbers, is the test card's."""
    return key == CARD_KEY and modifiers & (_SHIFT | _CONTROL | _ALT | _SUPER) == _SHIFT | _CONTROL
