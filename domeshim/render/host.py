"""The process that a program runs in while its pictures are rendered.

    python -m domeshim.render.host ORDERS REPLIES DRAWS_ALL REEL

ORDERS and REPLIES are the numbers of open pipes (see wire.py), DRAWS_ALL is 1 if pictures that are passed
by are drawn, REEL the JSON of a Reel. The program lives on the virtual clock, off screen, and stops at a
finished picture until it is known which one is wanted next.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from contextlib import suppress
from functools import partial
from typing import IO, TYPE_CHECKING, NoReturn

from domeshim.errors import DomeError, ProgramFinished
from domeshim.measure.pixels import read_pixels
from domeshim.measure.studio import Studio, Watch, end_at_once, run_off_screen
from domeshim.options import Options
from domeshim.program import run_program
from domeshim.render.plan import Reel
from domeshim.render.wire import Header, next_order, send
from domeshim.wording import counted

if TYPE_CHECKING:
    from domeshim.session import Session
    from domeshim.window.contract import Window
    from domeshim.window.frame import Rectangle

_MARGIN, _SQUARE = 8, 64
_NEWS_EVERY = 100
"""So many pictures are passed by before the owner hears of it."""


class Camera:
    """Hears of each finished picture, delivers the ordered ones and lets the others pass."""

    def __init__(
        self,
        session: Session,
        orders: IO[bytes],
        replies: IO[bytes],
        watch: Watch,
        part: Rectangle,
        *,
        draws_all: bool,
    ) -> None:
        """part: what is delivered of the pixels that there are."""
        self._part = part
        self._session = session
        session.on_grid = True
        self._orders = orders
        self._replies = replies
        self._watch = watch
        self._draws_all = draws_all
        self._wanted: list[int] = []
        self._hear()
        watch.start()
        self._prepare(1)

    def frame_finished(self, window: Window, number: int) -> None:  # noqa: ARG002 - the contract's own
        """Deliver the picture if it is wanted; wait for the next order once none is.

        Raises ProgramFinished when nothing more is wanted. A program that stops exceptions ends there.
        """
        if not self._wanted:
            end_at_once(0)
        self._watch.heard()
        if self._session.looked_back:
            self._tell(Header("looked-back", number))
            end_at_once(0)
        if number == self._wanted[0]:
            left, bottom, *size = self._part
            pixels = read_pixels(*size, corner=(left, bottom))
            self._tell(Header("picture", number, (size[0], size[1])), pixels)
            self._wanted.pop(0)
            self._hear()
            if not self._wanted:
                raise ProgramFinished
        elif number % _NEWS_EVERY == 0:
            self._tell(Header("passing", number))
        self._prepare(number + 1)

    def _tell(self, header: Header, pixels: bytes = b"") -> None:
        try:
            send(self._replies, header, pixels)
        except BrokenPipeError:  # the owner has gone, and its program goes too
            end_at_once(1)

    def _hear(self) -> None:
        """Wait for the next order if there is nothing left to do."""
        if not self._wanted:
            self._watch.waiting = True
            self._wanted = list(next_order(self._orders))
            self._watch.waiting = False
            self._watch.heard()

    def _prepare(self, number: int) -> None:
        """Let the next picture pass undrawn if it is not wanted."""
        self._session.passing = number < self._wanted[0] and not self._draws_all


def _with_margin(part: Rectangle, side: int) -> tuple[Rectangle, Rectangle]:
    """What is drawn for a part of a picture, and where the part lies in it.

    Mesa leaves out pixels of wide lines at the border of what it draws to, and at those of the squares that
    it draws by, which it counts from the top left: so both have the same squares.
    """
    x, y, width, height = part
    left, bottom = max((x - _MARGIN) // _SQUARE * _SQUARE, 0), max(y - _MARGIN, 0)
    above = max((side - y - height - _MARGIN) // _SQUARE * _SQUARE, 0)
    right, top = min(x + width + _MARGIN, side), side - above
    return (left, bottom, right - left, top - bottom), (x - left, y - bottom, width, height)


def main(arguments: Sequence[str]) -> None:
    """Run the program until nothing more is ordered, and end the process."""
    orders, replies = os.fdopen(int(arguments[0]), "rb"), os.fdopen(int(arguments[1]), "wb")
    draws_all, reel = bool(int(arguments[2])), Reel.from_json(arguments[3])

    def fail(text: str) -> NoReturn:
        with suppress(BrokenPipeError):
            send(replies, Header("failed", text=text))
        end_at_once(1)

    side = reel.side
    drawn, delivered = _with_margin(reel.part or (0, 0, side, side), side)
    watch = Watch(reel.timeout, lambda: fail(f"no picture came for {counted(reel.timeout, 'second')}"))
    try:
        session, _ = run_off_screen(
            partial(run_program, reel.program, reel.arguments, module=reel.module),
            Options.from_environment({}, {**reel.settings, "enabled": "1"}),
            Studio((side, side), reel.fps, reel.timeout, drawn if reel.part else None),
            lambda session: Camera(session, orders, replies, watch, delivered, draws_all=draws_all),
        )
    except DomeError as error:
        fail(str(error))
    fail(f"the program ended after {counted(session.frames, 'picture')}")


if __name__ == "__main__":
    main(sys.argv[1:])
