"""How far a rendering has come, its rate and the time left: a bar on a terminal, else a line at times."""

from __future__ import annotations

import sys
from typing import Any

from tqdm import tqdm


class Bar:
    """Shows the progress on stderr."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._bar: Any = None

    def begun(self, total: int, done: int) -> None:
        """There are so many pictures, and so many were made before."""
        every = 0.1 if sys.stderr.isatty() else 10.0
        self._bar = tqdm(desc=self._name, total=total, initial=done, unit="frame", mininterval=every)

    def made(self, count: int = 1) -> None:
        """So many pictures more are there."""
        if self._bar is not None:
            self._bar.update(count)

    def passing(self, frame: int) -> None:
        """The program has come to this picture, which is not wanted."""
        if self._bar is not None:
            self._bar.set_postfix_str(f"passing {frame}")

    def ended(self) -> None:
        """Nothing more comes."""
        if self._bar is not None:
            self._bar.close()
