from __future__ import annotations

import random
import subprocess
import sys
import time
from collections.abc import Iterator

import numpy as np
import pytest

from domeshim.window.clock import VirtualClock
from domeshim.window.virtual_time import EPOCH, pin_time
from tests.waiting import LONGEST


@pytest.fixture
def clock() -> Iterator[VirtualClock]:
    clock = VirtualClock(fps=50)
    with pin_time(clock):
        yield clock


def test_all_clocks_go_by_frames(clock: VirtualClock) -> None:
    clock.frame_finished()
    assert time.time() == EPOCH + 0.02
    assert time.time_ns() == int(EPOCH) * 10**9 + 20_000_000
    assert time.perf_counter() == time.monotonic() == 0.02
    assert time.perf_counter_ns() == time.monotonic_ns() == 20_000_000


def test_sleep_returns_at_once_and_moves_nothing(clock: VirtualClock) -> None:
    time.sleep(1000)
    assert clock.now() == 0
    with pytest.raises(ValueError, match="non-negative"):
        time.sleep(-1)


def test_a_program_that_waits_by_reading_the_clock_gets_there(clock: VirtualClock) -> None:
    until = time.time() + 0.1
    rounds = 0
    while time.time() < until:
        rounds += 1
    assert 10_000 <= rounds <= 10_200


def test_a_class_may_keep_a_clock_as_it_may_the_builtin(clock: VirtualClock) -> None:
    class Stopwatch:
        read = time.perf_counter
        wall = time.time

    assert Stopwatch().read() == 0
    assert Stopwatch().wall() == EPOCH


def test_random_numbers_start_from_the_seed() -> None:
    np.random.seed(77)
    before = np.random.get_state()[1].copy()
    state = random.getstate()
    with pin_time(VirtualClock(), seed=3):
        drawn = random.random(), np.random.random()
    assert drawn == (random.Random(3).random(), np.random.RandomState(3).random_sample())
    assert random.getstate() == state
    assert (np.random.get_state()[1] == before).all()


def test_undo_puts_everything_back() -> None:
    names = ["time", "time_ns", "perf_counter", "perf_counter_ns", "monotonic", "monotonic_ns", "sleep"]
    originals = [getattr(time, name) for name in names]
    finders = list(sys.meta_path)
    pinned = pin_time(VirtualClock())
    assert all(getattr(time, name) is not original for name, original in zip(names, originals, strict=True))
    pinned.undo()
    pinned.undo()
    assert [getattr(time, name) for name in names] == originals
    assert sys.meta_path == finders


LATE = """
import sys, os
os.environ["PYGAME_HIDE_SUPPORT_PROMPT"] = "1"
from domeshim.window.clock import VirtualClock
from domeshim.window.virtual_time import pin_time
assert not {"pygame", "glfw", "numpy"} & set(sys.modules)
clock = VirtualClock(fps=10)
pinned = pin_time(clock)
import pygame, glfw, numpy
ticker = pygame.time.Clock()
for _ in range(3):
    clock.frame_finished()
assert pygame.time.get_ticks() == 300, pygame.time.get_ticks()
assert glfw.get_time() == 0.3, glfw.get_time()
assert ticker.tick(60) == ticker.get_time() == 300
clock.frame_finished()
assert ticker.tick() == 100 and ticker.get_fps() == 10
assert pygame.time.wait(5000) == pygame.time.delay(5000) == 5000
assert numpy.random.random() == numpy.random.RandomState(0).random_sample()
pinned.undo()
assert pygame.time.Clock is not type(ticker) and "VirtualClock" not in repr(glfw.get_time)
"""


def test_modules_that_come_later_are_patched_as_they_are_imported() -> None:
    pytest.importorskip("pygame")
    command = [sys.executable, "-c", LATE]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=LONGEST)
    assert done.returncode == 0, done.stderr
