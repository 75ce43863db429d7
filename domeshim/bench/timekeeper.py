"""The process that a program runs in while its pictures are timed.

    python -m domeshim.bench.timekeeper ORDERS REPLIES ERRAND

ORDERS and REPLIES are the numbers of open pipes, ERRAND the JSON of an Errand. The program lives off screen,
on a clock that counts pictures, and stops at each until an order comes, a line for a picture. The reply is a
line of JSON: what the picture took.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from functools import partial
from time import perf_counter, process_time  # by name: a program's own clocks are pinned later
from typing import IO, TYPE_CHECKING, NoReturn

from domeshim.errors import DomeError
from domeshim.measure.studio import Studio, Watch, end_at_once, run_off_screen
from domeshim.options import Options
from domeshim.program import run_program
from domeshim.wording import counted

if TYPE_CHECKING:
    from domeshim.session import Session
    from domeshim.window.contract import Window


@dataclass(frozen=True)
class Errand:
    """Which program, and how: settings by the names of Options' fields, or None as on the monitor."""

    program: str
    arguments: tuple[str, ...] = ()
    module: bool = False
    size: tuple[int, int] = (1024, 1024)
    settings: Mapping[str, str] | None = field(default=None)
    timeout: float = 60.0

    def to_json(self) -> str:
        """As from_json reads it."""
        return json.dumps(asdict(self))

    @classmethod
    def from_json(cls, text: str) -> Errand:
        """As to_json wrote it."""
        read = json.loads(text)
        return cls(**(read | {"arguments": tuple(read["arguments"]), "size": tuple(read["size"])}))


class Timekeeper:
    """Hears of each finished picture, says what it took, and lets the next begin when it is ordered."""

    def __init__(self, _session: Session, orders: IO[bytes], replies: IO[bytes], watch: Watch) -> None:
        self._orders = orders
        self._replies = replies
        self._watch = watch
        self._wait()
        watch.start()

    def frame_finished(self, _window: Window, number: int) -> None:
        """The picture is in the back buffer, as far as the processor knows."""
        from OpenGL.platform import PLATFORM  # noqa: PLC0415 - the program may still set PyOpenGL's flags

        PLATFORM.GL.glFinish()
        took = perf_counter() - self._begun[0], process_time() - self._begun[1]
        self._watch.heard()
        tell(self._replies, {"picture": number, "wall": took[0], "processor": took[1]})
        self._wait()

    def _wait(self) -> None:
        self._watch.waiting = True
        ordered = self._orders.readline()
        self._watch.waiting = False
        self._watch.heard()
        if not ordered:
            end_at_once(0)
        self._begun = perf_counter(), process_time()


def tell(replies: IO[bytes], words: Mapping[str, object]) -> None:
    """Send a line of JSON."""
    replies.write(json.dumps(words).encode() + b"\n")
    replies.flush()


def main(arguments: Sequence[str]) -> None:
    """Run the program until nothing more is ordered, and end the process."""
    orders, replies = os.fdopen(int(arguments[0]), "rb"), os.fdopen(int(arguments[1]), "wb")
    errand = Errand.from_json(arguments[2])

    def fail(text: str) -> NoReturn:
        tell(replies, {"failed": text})
        end_at_once(1)

    watch = Watch(errand.timeout, lambda: fail(f"no picture came for {counted(errand.timeout, 'second')}"))
    on_dome = errand.settings is not None
    given = {**(errand.settings or {}), "enabled": str(int(on_dome))}
    try:
        session, _ = run_off_screen(
            partial(run_program, errand.program, errand.arguments, module=errand.module),
            Options.from_environment({}, given),
            Studio(errand.size, timeout=errand.timeout),
            lambda session: Timekeeper(session, orders, replies, watch),
        )
    except DomeError as error:
        fail(str(error))
    fail(f"the program ended after {counted(session.frames, 'picture')}")


if __name__ == "__main__":
    main(sys.argv[1:])
