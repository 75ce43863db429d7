"""How messages are worded: a number with its noun."""

from __future__ import annotations


def counted(number: float, thing: str, things: str = "") -> str:
    """A number of things as it is said: 0 pictures, 1 picture, 0.5 seconds.

    thing: the noun for one; things: for several, where an s at the end does not do.
    """
    text = str(number) if isinstance(number, int) else f"{number:g}"
    return f"{text} {thing}" if number == 1 else f"{text} {things or thing + 's'}"
