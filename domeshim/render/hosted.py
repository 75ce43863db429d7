"""The owner's side of a render host: start it, order pictures, end it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress

from domeshim.errors import DomeError
from domeshim.measure.piped import Piped
from domeshim.render.plan import Reel
from domeshim.render.wire import Header, order, receive


class HostLostError(DomeError):
    """The process that a program ran in ended before it delivered what was ordered; says why, if it did."""

    def __init__(self, text: str, *, final: bool = False) -> None:
        super().__init__(text)
        self.final = final
        """It would end so again: the program has no more pictures."""


class LooksBackError(DomeError):
    """The program read a picture that was passed by undrawn: none of its pictures may be."""


Passing = Callable[[int], None]
"""Hears the number of a picture that was passed by."""


class Host:
    """One program in a process of its own. It only goes forward: pictures are ordered by rising numbers."""

    def __init__(self, reel: Reel, *, draws_all: bool = False) -> None:
        """draws_all: pictures that are passed by are drawn as well."""
        self.reached = 0
        """The last picture that was delivered."""
        # In a session of its own: Ctrl+C is for the owner, who ends it.
        self._child = Piped(
            "domeshim.render.host", str(int(draws_all)), reel.to_json(), start_new_session=True
        )

    def pictures(self, frames: Sequence[int], passing: Passing) -> Iterator[tuple[Header, bytes]]:
        """Deliver these pictures, each after the last one reached, in rising order.

        Raises HostLostError where the process ended before, LooksBackError where no picture of this program
        may be passed by.
        """
        with suppress(BrokenPipeError):
            order(self._child.orders, tuple(frames))
        for frame in frames:
            while (reply := receive(self._child.replies)) is not None and reply[0].kind == "passing":
                passing(reply[0].frame)
            header = reply[0] if reply is not None else Header("gone")
            if header.kind == "looked-back":
                raise LooksBackError(f"the program looked back at its picture {header.frame}")
            if header.kind == "failed":
                raise HostLostError(header.text, final=True)
            if reply is None or header.kind != "picture":
                raise HostLostError(f"the program ended before its picture {frame}{self._status()}")
            self.reached = frame
            yield reply

    def close(self) -> None:
        """End the process."""
        self._child.close()

    def kill(self) -> None:
        """End it from another thread: who waits for its pictures hears that it ended."""
        self._child.kill()

    def _status(self) -> str:
        status = self._child.wait()
        return f" (signal {-status})" if status < 0 else f" (exit status {status})" if status else ""
