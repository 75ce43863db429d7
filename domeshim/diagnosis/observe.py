"""Runs a program on the dome, off screen, and writes what one of its pictures took.

    python -m domeshim.diagnosis.observe WANTED.json PROG [ARGS]

WANTED.json is as for domeshim.measure.exposures, for one picture; what was seen goes to its folder as
seen.json.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Sequence
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from domeshim import startup
from domeshim.diagnosis.calls import Calls
from domeshim.errors import DomeError
from domeshim.measure.capture import Photographer, photograph_by
from domeshim.measure.exposures import Wanted
from domeshim.measure.studio import Studio
from domeshim.options import Options
from domeshim.program import run_program

if TYPE_CHECKING:
    from domeshim.driver import Driver
    from domeshim.session import Session
    from domeshim.window.contract import Window

_seconds = time.perf_counter  # kept from before the pinning of the time module


class Observer(Photographer):
    """Looks on from the first call of GL on, and writes down what the wanted picture took."""

    def __init__(self, frame: int, folder: Path, timeout: float) -> None:
        super().__init__((frame,), self._write, timeout)
        self._folder = folder
        self._driver: Any = None
        self._calls = Calls()

    def follow(self, session: Session) -> Photographer:
        """Watch this session from now on."""
        session.make_driver = self._watched
        return super().follow(session)

    def frame_finished(self, window: Window, number: int) -> None:
        """Keep what is wanted of a picture, and begin the next."""
        super().frame_finished(window, number)
        if self._driver is not None:
            self._driver.begin_picture()
        self._calls.begin_picture()

    def _watched(self) -> Driver:
        from OpenGL import GL, GLU  # noqa: PLC0415 - the program has imported it by now

        from domeshim.diagnosis.watch import WatchedDriver  # noqa: PLC0415

        self._driver = WatchedDriver(_seconds)
        self._driver.watch_module(GL)
        self._calls.watch(GL, GLU)
        return self._driver  # type: ignore[no-any-return] # loaded late

    def _write(self, session: Session, window: Window, number: int) -> None:
        from domeshim.intercept.dome import Dome  # noqa: PLC0415 - as above

        seen: dict[str, Any] = {
            "frame": number,
            "size": window.size,
            "draws": [],
            "calls": self._calls.seen(),
        }
        context = session.dome.context_of(window) if isinstance(session.dome, Dome) else None
        if context is not None:
            seen["draws"] = self._draws({made.name: recipe for recipe, made in context.programs.items()})
            main = context.placer.main.view
            seen["perspective"] = main.camera.tolist() if main is not None else None
        (self._folder / "seen.json").write_text(json.dumps(seen))

    def _draws(self, recipes: dict[int, Any]) -> list[dict[str, Any]]:
        from domeshim.diagnosis.needs import left_out, needs  # noqa: PLC0415 - as above

        found = []
        for program, tally in self._driver.tallies.items():
            kind, recipe = self._kind(program, recipes.get(program)), recipes.get(program)
            made = self._driver.made[program]
            if recipe is not None and recipe.patch is not None:
                tally.primitives = tally.vertices // recipe.patch.corners
            found.append(
                {
                    **asdict(tally),
                    "needs": needs(recipe) if recipe else [],
                    "left_out": left_out(recipe) if recipe else [],
                    "kind": kind,
                    "characters": made.characters,
                    "seconds": made.seconds,
                }
            )
        return sorted(found, key=lambda each: -each["vertices"])

    def _kind(self, program: int, recipe: Any) -> str:
        """Whose program it is: the dome's for a draw, its own for the rim, the program's, or none."""
        if recipe is not None:
            return "draw"
        if program in self._driver.made:
            return "rim"
        return "own" if program else "unbent"


def main(arguments: Sequence[str]) -> None:
    """Run the program that the command line names, and end the process."""
    wanted = Wanted.from_json(Path(arguments[0]).read_text())
    prog, *rest = arguments[1:]
    [frame] = wanted.frames
    try:
        options = Options.from_environment(given={**wanted.settings, "enabled": "1"})
        photograph_by(
            Observer(frame, Path(wanted.folder).absolute(), wanted.timeout),
            options,
            partial(run_program, prog, rest, module=wanted.module),
            Studio(wanted.size, wanted.fps, wanted.timeout),
        )
    except DomeError as error:
        startup.say(str(error))
        sys.exit(error.exit_status)


if __name__ == "__main__":
    main(sys.argv[1:])
