"""Waiting for what a program does: as long as a busy machine takes, and no longer than a quiet one does.

The programs that tests run import it as well: it needs nothing but Python.
"""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Generator

PATIENCE = 120.0
"""Seconds after which what has not come is taken never to come."""
LONGEST = 600.0
"""Seconds after which a process is taken never to end."""
Wanted = Callable[[], object]
"""True once what is waited for has come."""


def wait_for(wanted: Wanted, pause: float = 0.02) -> None:
    """Return as soon as it has come.

    Raises TimeoutError where it never does.
    """
    until = time.monotonic() + PATIENCE
    while not wanted():
        if time.monotonic() > until:
            raise TimeoutError(f"it did not come in {PATIENCE:g} seconds")
        time.sleep(pause)


class Steps:
    """What is done to a running program, each step as soon as the one before has shown its effect."""

    def __init__(self, steps: Generator[Wanted, None, None]) -> None:
        """steps: does one thing after the other, and yields after each what shall come before the next."""
        self._steps = steps
        self._wanted: Wanted = lambda: True
        self._until = 0.0

    def ended(self) -> bool:
        """Go on as far as it goes now; whether that was all.

        Ends the process with status 3, naming the line, where something never comes.
        """
        while self._wanted():
            try:
                self._wanted = next(self._steps)
            except StopIteration:
                return True
            self._until = time.monotonic() + PATIENCE
        if time.monotonic() > self._until:
            line = self._steps.gi_frame.f_lineno
            print(f"what line {line} waits for did not come", file=sys.stderr, flush=True)
            os._exit(3)
        return False
