"""Watches that pictures come: a program that stops for ever must not stop whoever waits for it."""

from __future__ import annotations

import threading
from collections.abc import Callable


class Watch:
    """Calls silent() in a thread of its own when nothing was heard for so many real seconds."""

    def __init__(self, timeout: float, silent: Callable[[], None]) -> None:
        self.timeout = timeout
        self.waiting = False
        """The program is being kept waiting: its silence means nothing."""
        self._silent = silent
        self._news = threading.Event()

    def start(self) -> None:
        """Begin to watch, until the process ends."""
        threading.Thread(target=self._watch, name="domeshim watchdog", daemon=True).start()

    def heard(self) -> None:
        """A picture came."""
        self._news.set()

    def _watch(self) -> None:
        # The operating system times the waiting for a lock: pinning the time module does not reach it.
        while self._news.wait(self.timeout) or self.waiting:
            self._news.clear()
        self._silent()
