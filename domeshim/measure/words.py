"""What a program said last before it ended."""

from __future__ import annotations


def last_words(said: bytes, status: int) -> str:
    """The error that a program's last traceback ends in, or its last line; without one, its exit status."""
    lines = [line.rstrip() for line in said.decode(errors="replace").splitlines() if line.strip()]
    starts = [number for number, line in enumerate(lines) if line.startswith("Traceback (most recent")]
    errors = [line for line in lines[starts[-1] + 1 :] if not line.startswith(" ")] if starts else lines[-1:]
    return errors[0].strip() if errors else f"it ended with status {status} and without a word"
