"""pygame's timers on a clock that counts pictures: they post events as the program asks for those."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from domeshim.intercept.toolkits.timers import VirtualTimers

if TYPE_CHECKING:
    from domeshim.session import Session


class PygameTimers:
    """The timers of pygame.time.set_timer, by the event that each posts."""

    def __init__(self, session: Session, event_waits: Callable[[], bool]) -> None:
        """event_waits: whether an event is in pygame's queue."""
        self._session = session
        self._event_waits = event_waits
        self.event: Mapping[str, Any] = {}
        """pygame.event's own names."""
        self._timers = VirtualTimers(session.clock)
        self._timer_of: dict[Any, int] = {}
        self._last_frame = 0

    def set(self, event: Any, millis: int, loops: int = 0) -> None:
        """Post the event every so many milliseconds of the session's clock; 0 stops that."""
        kind = event if isinstance(event, int) else event.type
        if kind in self._timer_of:
            self._timers.stop(self._timer_of.pop(kind))
        left = [loops]

        def post() -> None:
            self.event["post"](self.event["Event"](kind) if isinstance(event, int) else event)
            left[0] -= 1
            if left[0] == 0:
                self._timers.stop(self._timer_of.pop(kind))

        if millis > 0:
            self._timer_of[kind] = self._timers.start(millis / 1000.0, post)

    def turn(self) -> None:
        """Post what is due; where neither an event nor a picture came, let time go on to the next timer."""
        frames = self._session.frames
        idle = not self._timers.fire() and frames == self._last_frame and not self._event_waits()
        if idle and self._timers.go_to_next():
            self._timers.fire()
        self._last_frame = frames
