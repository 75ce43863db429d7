"""A toolkit's timers on a clock that counts pictures: they fire as the clock passes, and can push it on."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from domeshim.window.clock import Clock

SHORTEST = 0.001
"""Seconds between two firings of a timer that shall fire as often as it can."""


@dataclass
class _Timer:
    due: float
    interval: float
    call: Callable[[], object]
    repeats: bool


class VirtualTimers:
    """Functions to be called at moments of the clock, once or again and again."""

    def __init__(self, clock: Clock) -> None:
        self.clock = clock
        self._timers: dict[int, _Timer] = {}
        self._made = 0

    def start(self, seconds: float, call: Callable[[], object], *, repeats: bool = True) -> int:
        """Call the function in so many seconds, and then every so many; returns the timer's number."""
        self._made += 1
        self._timers[self._made] = _Timer(self.clock.now() + seconds, max(seconds, SHORTEST), call, repeats)
        return self._made

    def stop(self, number: int) -> None:
        """Forget the timer of that number; one that is gone already is no mistake."""
        self._timers.pop(number, None)

    def runs(self, number: int) -> bool:
        """The timer of that number will fire, again or for the first time."""
        return number in self._timers

    def remaining(self, number: int) -> float:
        """Seconds until the timer fires; 0 where it is late."""
        return max(self._timers[number].due - self.clock.now(), 0.0)

    def fire(self) -> bool:
        """Call what is due, each once, the longest due first; whether there was any."""
        now = self.clock.now()
        due = sorted((timer.due, number) for number, timer in self._timers.items() if timer.due <= now + 1e-9)
        for _, number in due:
            timer = self._timers.get(number)
            if timer is None:
                continue  # stopped by one of the others
            if timer.repeats:
                timer.due = max(timer.due + timer.interval, now)
            else:
                del self._timers[number]
            timer.call()
        return bool(due)

    def go_to_next(self) -> bool:
        """Let the clock go on to the next timer; False where there is none."""
        if self._timers:
            self.clock.advance_to(min(timer.due for timer in self._timers.values()))
        return bool(self._timers)
