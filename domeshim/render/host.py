"""The process that a program runs in while its pictures are rendered.

    python -m domeshim.render.host ORDERS REPLIES REEL

ORDERS and REPLIES are the numbers of open pipes (see wire.py), REEL the JSON of a Reel. The program lives on
the virtual clock, off screen, and stops at each finished picture until it is known which one is wanted next.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from functools import partial
from typing import IO, TYPE_CHECKING

from domeshim.errors import DomeError, ProgramFinished
from domeshim.measure.capture import Studio, end_at_once, run_off_screen
from domeshim.measure.pixels import read_pixels
from domeshim.options import Options
from domeshim.program import run_program
from domeshim.render.plan import Reel
from domeshim.render.wire import Header, next_order, send

if TYPE_CHECKING:
    from domeshim.session import Session
    from domeshim.window.contract import Window

_NEWS_EVERY = 100
"""So many pictures are passed by before the owner hears of it."""


class Camera:
    """Hears of each finished picture, delivers the ordered ones and lets the others pass."""

    def __init__(self, session: Session, orders: IO[bytes], replies: IO[bytes]) -> None:
        self._session = session
        self._orders = orders
        self._replies = replies
        self._wanted = list(next_order(orders))
        self._plan_next(1)

    def frame_finished(self, window: Window, number: int) -> None:
        """Deliver the picture if it is wanted; wait for the next order once nothing is.

        Raises ProgramFinished when nothing more is wanted. A program that stops exceptions ends there.
        """
        if not self._wanted:
            end_at_once(0)
        if self._session.looked_back:
            send(self._replies, Header("looked-back", number))
            end_at_once(0)
        if number == self._wanted[0]:
            send(self._replies, Header("picture", number, window.size), read_pixels(*window.size))
            self._wanted.pop(0)
            if not self._wanted:
                self._wanted = list(next_order(self._orders))
            if not self._wanted:
                raise ProgramFinished
        elif number % _NEWS_EVERY == 0:
            send(self._replies, Header("passing", number))
        self._plan_next(number + 1)

    def _plan_next(self, number: int) -> None:
        self._session.passing = bool(self._wanted) and number < self._wanted[0]


def main(arguments: Sequence[str]) -> None:
    """Run the program until nothing more is ordered, and end the process."""
    orders = os.fdopen(int(arguments[0]), "rb")
    replies = os.fdopen(int(arguments[1]), "wb")
    reel = Reel.from_json(arguments[2])
    try:
        options = Options.from_environment({}, {**reel.settings, "enabled": "1"})
        run_off_screen(
            lambda session: Camera(session, orders, replies),
            options,
            partial(run_program, reel.program, reel.arguments, module=reel.module),
            Studio((reel.side, reel.side), reel.fps, reel.timeout),
        )
    except DomeError as error:
        send(replies, Header("failed", text=str(error)))
        sys.exit(error.exit_status)


if __name__ == "__main__":
    main(sys.argv[1:])
