"""Pinned time: a program's clocks go by the session's, and its random numbers start from a seed.

Patched: time.time, perf_counter, monotonic, their _ns twins and sleep; pygame.time; glfw.get_time; the seeds
of random and numpy.random. Modules that come later are patched as they are imported. Left alone: datetime,
which C code reads, and process_time and thread_time, which measure work and not the day.
"""

from __future__ import annotations

import importlib.util
import random
import sys
import time
from collections.abc import Callable, Sequence
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType, TracebackType
from typing import Any

from domeshim.window.clock import Clock

EPOCH = 1_700_000_000.0
"""What time.time() says when the clock begins, seconds since 1970."""
BILLION = 1_000_000_000


def pin_time(clock: Clock, seed: int = 0) -> PinnedTime:
    """Pin time and chance from now on; undo() or the end of a with block puts back what was there."""
    return PinnedTime(clock, seed)


class PinnedTime:
    """The patches in force, each with what puts it back."""

    def __init__(self, clock: Clock, seed: int) -> None:
        self._clock = clock
        self._seed = seed
        self._undo: list[Callable[[], None]] = []
        self._late: dict[str, Callable[[ModuleType], None]] = {
            "pygame.time": self._patch_pygame,
            "glfw": self._patch_glfw,
            "numpy.random": self._seed_numpy,
        }
        self._patch_time()
        self._seed_random()
        self._finder = _PatchOnImport(self._late)
        for name, patch in self._late.items():
            if name in sys.modules:
                patch(sys.modules[name])
        sys.meta_path.insert(0, self._finder)

    def undo(self) -> None:
        """Put back what was there; a second call does nothing."""
        if self._finder in sys.meta_path:
            sys.meta_path.remove(self._finder)
        while self._undo:
            self._undo.pop()()

    def __enter__(self) -> PinnedTime:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.undo()

    def _replace(self, module: ModuleType, name: str, value: Any) -> None:
        original = getattr(module, name)
        self._undo.append(lambda: setattr(module, name, original))
        setattr(module, name, value)

    def _patch_time(self) -> None:
        # Bound methods: a class that keeps one of these would make a method of its own of a plain function.
        self._replace(time, "time", self._time)
        self._replace(time, "time_ns", self._time_ns)
        for name in ("perf_counter", "monotonic"):
            self._replace(time, name, self._clock.read)
            self._replace(time, f"{name}_ns", self._nanoseconds)
        self._replace(time, "sleep", self._sleep)

    def _time(self) -> float:
        return EPOCH + self._clock.read()

    def _time_ns(self) -> int:
        return int(EPOCH) * BILLION + self._nanoseconds()

    def _nanoseconds(self) -> int:
        return round(self._clock.read() * BILLION)

    def _milliseconds(self) -> int:
        return int(self._clock.read() * 1000.0 + 1e-6)

    def _sleep(self, seconds: float) -> None:
        """Return at once: nobody waits on a clock that goes by pictures."""
        if seconds < 0:
            raise ValueError("sleep length must be non-negative")

    def _sleep_milliseconds(self, milliseconds: int) -> int:
        """Return at once the milliseconds asked for, as pygame does after as many."""
        return max(int(milliseconds), 0)

    def _patch_pygame(self, module: ModuleType) -> None:
        clock = self._clock
        self._replace(module, "get_ticks", self._milliseconds)
        self._replace(module, "wait", self._sleep_milliseconds)
        self._replace(module, "delay", self._sleep_milliseconds)
        self._replace(module, "Clock", lambda: PygameClock(clock))

    def _patch_glfw(self, module: ModuleType) -> None:
        self._replace(module, "get_time", self._clock.read)

    def _seed_random(self) -> None:
        before = random.getstate()
        self._undo.append(lambda: random.setstate(before))
        random.seed(self._seed)

    def _seed_numpy(self, module: ModuleType) -> None:
        before = module.get_state()
        self._undo.append(lambda: module.set_state(before))
        module.seed(self._seed)


class PygameClock:
    """What pygame.time.Clock() makes: times the program's rounds by the session's clock, and never waits."""

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._last = clock.now()
        self._passed = 0

    def tick(self, framerate: float = 0) -> int:  # noqa: ARG002 - pygame's own signature
        """Return the milliseconds since the last call."""
        now = self._clock.read()
        self._passed = round((now - self._last) * 1000.0)
        self._last = now
        return self._passed

    tick_busy_loop = tick

    def get_time(self) -> int:
        """Return the milliseconds between the last two calls of tick."""
        return self._passed

    get_rawtime = get_time

    def get_fps(self) -> float:
        """Return the rounds a second that the last two calls of tick make; 0 before them."""
        return 1000.0 / self._passed if self._passed else 0.0


class _PatchOnImport(MetaPathFinder):
    """Lets the other finders find the modules that wait for a patch, and patches them once executed."""

    def __init__(self, patches: dict[str, Callable[[ModuleType], None]]) -> None:
        self._patches = patches
        self._searching = False

    def find_spec(
        self,
        fullname: str,
        path: Sequence[str] | None,  # noqa: ARG002 - the import system's signature
        target: ModuleType | None = None,  # noqa: ARG002 - as above
    ) -> ModuleSpec | None:
        """Return the module's own spec with a loader that patches, or None for all other modules."""
        if self._searching or fullname not in self._patches:
            return None
        self._searching = True
        try:
            spec = importlib.util.find_spec(fullname)
        finally:
            self._searching = False
        if spec is None or spec.loader is None:
            return spec
        execute, patch = spec.loader.exec_module, self._patches[fullname]

        def execute_and_patch(module: ModuleType) -> None:
            execute(module)
            patch(module)

        spec.loader.exec_module = execute_and_patch  # type: ignore[method-assign]
        return spec
