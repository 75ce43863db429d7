from __future__ import annotations

from domeshim.intercept.toolkits.timers import VirtualTimers
from domeshim.window.clock import VirtualClock


def test_each_fires_once_when_it_is_due_the_longest_due_first():
    clock = VirtualClock(fps=10)
    timers = VirtualTimers(clock)
    heard: list[str] = []
    timers.start(0.08, lambda: heard.append("late"))
    timers.start(0.05, lambda: heard.append("early"), repeats=False)
    assert not timers.fire()
    clock.frame_finished()
    assert timers.fire()
    assert heard == ["early", "late"]
    assert not timers.fire()  # the next is due at 0.16
    clock.frame_finished()
    assert timers.fire()
    assert heard == ["early", "late", "late"]


def test_one_that_another_stops_does_not_fire():
    clock = VirtualClock(fps=10)
    timers = VirtualTimers(clock)
    heard: list[str] = []
    timers.start(0.01, lambda: timers.stop(second), repeats=False)
    second = timers.start(0.02, lambda: heard.append("second"))
    clock.frame_finished()
    timers.fire()
    assert heard == []
    assert not timers.runs(second)
    assert not timers.go_to_next()


def test_the_clock_goes_on_to_the_next():
    clock = VirtualClock(fps=10)
    timers = VirtualTimers(clock)
    number = timers.start(7.5, lambda: None)
    assert timers.remaining(number) == 7.5
    assert timers.go_to_next()
    assert clock.now() == 7.5
    assert timers.fire()
