"""Makes pictures of a plan one after the other, with the program kept alive between them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from domeshim.render.files import encode
from domeshim.render.hosted import Host, HostLostError, LooksBackError, Passing
from domeshim.render.plan import Plan

TRIES = 3
"""So often a picture is tried; and so many pictures in a row may fail before the rest is given up."""


@dataclass(frozen=True)
class Made:
    """One picture, or why there is none."""

    frame: int
    eye: str
    content: bytes = b""
    """The file's; none where the file has been written."""
    digest: str = ""
    """SHA-256 of the pixels as they are in the file."""
    error: str = ""


class Maker:
    """Makes any pictures of a plan, in one process a program and eye."""

    def __init__(self, plan: Plan, *, draws_all: bool = False) -> None:
        """draws_all: pictures that are passed by are drawn as well."""
        self._plan = plan
        self._hosts: dict[str, Host] = {}
        self._draws_all = draws_all

    def make(self, frames: Sequence[int], passing: Passing = lambda _frame: None) -> Iterator[Made]:
        """Make these pictures, given by rising numbers, for each eye."""
        for eye in self._plan.eyes:
            yield from self._make(eye, list(frames), passing)

    def close(self) -> None:
        """End the programs."""
        while self._hosts:
            self._hosts.popitem()[1].close()

    def _make(self, eye: str, frames: list[int], passing: Passing) -> Iterator[Made]:
        tries: Counter[int] = Counter()
        lost = 0
        while frames:
            host = self._host(eye, frames[0])
            try:
                for header, pixels in host.pictures(tuple(frames), passing):
                    frames.remove(header.frame)
                    lost = 0
                    yield self._made(eye, header.frame, header.size[0], pixels)
            except LooksBackError:
                self._draws_all = True
                self._end(eye)
            except HostLostError as error:
                self._end(eye)
                tries[frames[0]] += 1
                if tries[frames[0]] < TRIES and not error.final:
                    continue
                lost += 1
                given_up = len(frames) if error.final or lost == TRIES else 1
                for frame in frames[:given_up]:
                    yield Made(frame, eye, error=str(error))
                del frames[:given_up]

    def _host(self, eye: str, frame: int) -> Host:
        """The eye's program, at a picture before this one."""
        host = self._hosts.get(eye)
        if host is None or host.reached >= frame:
            self._end(eye)
            host = self._hosts[eye] = Host(self._plan.reel_of(eye), draws_all=self._draws_all)
        return host

    def _end(self, eye: str) -> None:
        host = self._hosts.pop(eye, None)
        if host is not None:
            host.close()

    def _made(self, eye: str, frame: int, side: int, pixels: bytes) -> Made:
        return Made(frame, eye, *encode(pixels, side, self._plan))
