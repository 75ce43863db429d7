"""The time that a program lives in: the real one, or frames counted off at a fixed rate."""

from __future__ import annotations

from abc import ABC, abstractmethod


class Clock(ABC):
    """Seconds for glutGet(GLUT_ELAPSED_TIME), timers and the main loop's waiting."""

    virtual: bool

    @abstractmethod
    def now(self) -> float:
        """Seconds since the clock began."""

    @abstractmethod
    def advance_to(self, moment: float) -> None:
        """Virtual: nothing happens before this moment, so go there. Real: does nothing."""

    @abstractmethod
    def frame_finished(self) -> None:
        """A picture was finished; a virtual clock goes on by one frame."""


class RealClock(Clock):
    """The machine's own time."""

    virtual = False
