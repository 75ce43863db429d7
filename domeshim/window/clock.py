"""The time that a program lives in: the real one, or frames counted off at a fixed rate."""

from __future__ import annotations

import time
from abc import ABC, abstractmethod

_real_seconds = time.perf_counter  # kept from before any pinning of the time module
PATIENCE = 10_000
"""How often a program may read a virtual clock within one picture before it is taken to be waiting."""


class Clock(ABC):
    """Seconds for glutGet(GLUT_ELAPSED_TIME), timers and the main loop's waiting."""

    virtual: bool

    @abstractmethod
    def now(self) -> float:
        """Seconds since the clock began."""

    def read(self) -> float:
        """Seconds since the clock began, for a program: a virtual clock lets no one wait for ever."""
        return self.now()

    @abstractmethod
    def advance_to(self, moment: float) -> None:
        """Virtual: nothing happens before this moment, so go there. Real: does nothing."""

    @abstractmethod
    def frame_finished(self) -> None:
        """A picture was finished; a virtual clock goes on by one frame."""


class RealClock(Clock):
    """The machine's own time."""

    virtual = False

    def __init__(self) -> None:
        self._began = _real_seconds()

    def now(self) -> float:
        """Seconds since the clock was made."""
        return _real_seconds() - self._began

    def advance_to(self, moment: float) -> None:
        """Do nothing: real time goes by itself."""

    def frame_finished(self) -> None:
        """Do nothing: real time goes by itself."""


class VirtualClock(Clock):
    """Pictures counted off at so many a second: it reads (n - 1) / fps while picture n is drawn.

    A jump of advance_to counts towards the picture that it is made in, so that a program whose timer fires
    every 1/fps seconds still sees picture n at (n - 1) / fps. A longer jump puts all later pictures off.
    """

    virtual = True

    def __init__(self, fps: float = 60.0) -> None:
        if not fps > 0:
            raise ValueError(f"fps must be greater than 0, not {fps}")
        self.fps = fps
        self._put_off = 0.0
        self._frames = 0
        self._ahead = 0.0
        self._reads = 0

    def now(self) -> float:
        """Seconds since the first picture began."""
        return self._put_off + self._frames / self.fps + self._ahead

    def read(self) -> float:
        """Seconds since the first picture began; 1 ms more at each reading beyond PATIENCE in a picture."""
        self._reads += 1
        if self._reads > PATIENCE:
            self._ahead += 0.001
        return self.now()

    def advance_to(self, moment: float) -> None:
        """Go to this moment; never back."""
        self._ahead = max(self._ahead, moment - self._put_off - self._frames / self.fps)

    def frame_finished(self) -> None:
        """Go on by one picture."""
        if self._ahead <= 1.0 / self.fps:
            self._frames += 1
        else:
            self._put_off += self._ahead
        self._ahead = 0.0
        self._reads = 0
