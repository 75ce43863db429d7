"""Makes pictures of a plan one after the other, with the program kept alive between them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from domeshim.render.files import encode
from domeshim.render.hosted import Host, HostLostError, LooksBackError, Passing
from domeshim.render.plan import Part, Plan

TRIES = 3
"""So often a picture is tried; and so many pictures in a row may fail before the rest is given up."""
_Place = tuple[str, Part]
"""An eye, and a tile of its pictures."""


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
    again: bool = False
    """Only to be compared: another program makes this picture as well."""


@dataclass(frozen=True)
class _Drawn:
    """A picture of one program, whole or a tile, or why there is none."""

    frame: int
    size: tuple[int, int] = (0, 0)
    pixels: bytes = b""
    error: str = ""


class Maker:
    """Makes any pictures of a plan, in one process a program, eye and tile."""

    def __init__(self, plan: Plan, *, draws_all: bool = False, lasting: bool = True) -> None:
        """draws_all: pictures that are passed by are drawn as well; lasting: more will be wanted later."""
        self._plan = plan
        self._hosts: dict[_Place, Host] = {}
        self._draws_all = draws_all
        self._lasting = lasting
        self._given_up = False

    def make(self, frames: Sequence[int], passing: Passing = lambda _frame: None) -> Iterator[Made]:
        """Make these pictures, given by rising numbers, for each eye."""
        for eye in self._plan.eyes:
            rows = [self._row((eye, part), list(frames), passing) for part in self._plan.parts]
            for tiles in zip(*rows, strict=not self._given_up):
                yield self._made(eye, tiles)

    def close(self) -> None:
        """End the programs."""
        while self._hosts:
            self._hosts.popitem()[1].close()

    def give_up(self) -> None:
        """Let make() end early that runs in another thread, and its programs with it."""
        self._given_up = True
        for host in list(self._hosts.values()):
            host.kill()

    def _made(self, eye: str, tiles: Sequence[_Drawn]) -> Made:
        frame = tiles[0].frame
        error = next((tile.error for tile in tiles if tile.error), "")
        if error:
            return Made(frame, eye, error=error)
        return Made(frame, eye, *encode([(tile.size, tile.pixels) for tile in tiles], self._plan))

    def _row(self, place: _Place, frames: list[int], passing: Passing) -> Iterator[_Drawn]:
        """One for each of these pictures, in their order."""
        tries: Counter[int] = Counter()
        lost = 0
        while frames:
            host = self._host(place, frames[0])
            try:
                for header, pixels in host.pictures(tuple(frames), passing):
                    frames.remove(header.frame)
                    lost = 0
                    if not frames and not self._lasting:
                        self._end(place)  # before the next tile's program begins, which needs as much memory
                    yield _Drawn(header.frame, header.size, pixels)
            except LooksBackError:
                self._draws_all = True
                self._end(place)
            except HostLostError as error:
                self._end(place)
                if self._given_up:
                    return
                tries[frames[0]] += 1
                if tries[frames[0]] < TRIES and not error.final:
                    continue
                lost += 1
                given_up = len(frames) if error.final or lost == TRIES else 1
                for frame in frames[:given_up]:
                    yield _Drawn(frame, error=str(error))
                del frames[:given_up]

    def _host(self, place: _Place, frame: int) -> Host:
        """The place's program, at a picture before this one."""
        host = self._hosts.get(place)
        if host is None or host.reached >= frame:
            self._end(place)
            host = self._hosts[place] = Host(self._plan.reel_of(*place), draws_all=self._draws_all)
        return host

    def _end(self, place: _Place) -> None:
        host = self._hosts.pop(place, None)
        if host is not None:
            host.close()
