"""Qt's timers on the session's clock, and the pace at which pictures are asked for without a display."""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType
from typing import TYPE_CHECKING, Any, Protocol

from domeshim.intercept.toolkits.timers import VirtualTimers

if TYPE_CHECKING:
    from domeshim.intercept.toolkits.qt import QtToolkit

PATIENCE = 1.0
"""Seconds of the clock without a picture after which one is asked for."""


class Paced(Protocol):
    """One GL surface."""

    asked: bool
    """The program wants a new picture of it."""

    def visible(self) -> bool:
        """It is on the screen that is not there."""

    def paint(self) -> None:
        """Draw its picture now."""


class Pacer:
    """Acts whenever Qt has nothing else to do: on a picture that is asked for, else on the next timer."""

    def __init__(self, toolkit: QtToolkit) -> None:
        self._toolkit = toolkit
        self._clock = toolkit.session.clock
        self.timers = VirtualTimers(self._clock)
        self.surfaces: list[Paced] = []
        self._wheel: Any = None
        self._last_frame = (0, 0.0)
        self._real_timer: Any = None

    def begin(self, real_timer: type | None = None) -> None:
        """Turn from now on, if Qt's event loop can be had already; real_timer: Qt's own QTimer."""
        core = self._toolkit.part("QtCore")
        self._real_timer = real_timer or self._real_timer or core.QTimer
        if self._wheel is None and core.QCoreApplication.instance() is not None:
            self._wheel = self._real_timer()
            self._wheel.timeout.connect(self._turn)
            self._wheel.start(0)

    def _turn(self) -> None:
        if self._paint_asked():
            return
        frames = self._toolkit.session.frames
        if frames != self._last_frame[0]:
            self._last_frame = (frames, self._clock.now())
        waited = self._clock.now() - self._last_frame[1] >= PATIENCE
        if waited or not (self.timers.fire() or self.timers.go_to_next()):
            self._last_frame = (self._last_frame[0], self._clock.now())
            for surface in self.surfaces:
                surface.asked = True

    def _paint_asked(self) -> bool:
        asked = [surface for surface in self.surfaces if surface.asked and surface.visible()]
        for surface in asked:
            surface.paint()
        return bool(asked)


def time_classes(pacer: Pacer, core: ModuleType) -> dict[str, Any]:
    """QTimer and QElapsedTimer on the session's clock."""
    from domeshim.intercept.toolkits.qt import under_the_name_of  # noqa: PLC0415 - which imports this

    pacer.begin(core.QTimer)
    ours = (_timer_class(pacer, core), _elapsed_class(pacer, core))
    return {
        name: under_the_name_of(vars(core)[name], cls)
        for name, cls in zip(("QTimer", "QElapsedTimer"), ours, strict=True)
    }


def _timer_class(pacer: Pacer, core: ModuleType) -> type:
    signal = getattr(core, "Signal", None) or core.pyqtSignal
    original: Any = core.QTimer

    class Timer(original):  # type: ignore[misc]
        timeout = signal()
        _number = 0

        def start(self, *interval: int) -> None:
            if interval:
                self.setInterval(*interval)
            self.stop()
            self._number = pacer.timers.start(
                self.interval() / 1000.0, self._fire, repeats=not self.isSingleShot()
            )
            pacer.begin()

        def stop(self) -> None:
            pacer.timers.stop(self._number)

        def isActive(self) -> bool:
            return pacer.timers.runs(self._number)

        def remainingTime(self) -> int:
            return round(pacer.timers.remaining(self._number) * 1000.0) if self.isActive() else -1

        def _fire(self) -> None:
            try:
                self.timeout.emit()
            except RuntimeError:  # its parent has taken the C++ part with it
                self.stop()

        @staticmethod
        def singleShot(milliseconds: int, *rest: Any) -> None:
            call: Callable[[], object] = rest[-1]
            if callable(call):
                pacer.timers.start(milliseconds / 1000.0, call, repeats=False)
                pacer.begin()
            else:
                original.singleShot(milliseconds, *rest)

    return Timer


def _elapsed_class(pacer: Pacer, core: ModuleType) -> type:
    clock = pacer.timers.clock

    class ElapsedTimer(core.QElapsedTimer):  # type: ignore[misc,name-defined]
        _began: float | None = None

        def start(self) -> None:
            self._began = clock.read()

        def restart(self) -> int:
            passed = self.elapsed()
            self.start()
            return passed

        def elapsed(self) -> int:
            return self.nsecsElapsed() // 1_000_000

        def nsecsElapsed(self) -> int:
            return round((clock.read() - (self._began or 0.0)) * 1e9)

        def hasExpired(self, timeout: int) -> bool:
            return 0 <= timeout < self.elapsed()

        def isValid(self) -> bool:
            return self._began is not None

        def invalidate(self) -> None:
            self._began = None

    return ElapsedTimer
