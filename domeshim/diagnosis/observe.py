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
from pathlib import Path
from typing import TYPE_CHECKING, Any

from domeshim.diagnosis.calls import Calls
from domeshim.measure.capture import Photographer
from domeshim.measure.exposures import Wanted, take_wanted
from domeshim.options import Options

if TYPE_CHECKING:
    from domeshim.driver import Driver
    from domeshim.session import Session
    from domeshim.state.context import DomeContext
    from domeshim.window.contract import Window

_IMPOSSIBLE = {
    "unbent": ["bending: it is drawn as on the monitor"],
}
"""What cannot be had in a way to draw of each kind."""
_seconds = time.perf_counter  # kept from before the pinning of the time module


class Observer(Photographer):
    """Looks on from the first call of GL on, and writes down what the wanted picture took."""

    def __init__(self, frame: int, folder: Path, timeout: float) -> None:
        super().__init__((frame,), self._write, timeout)
        self._folder = folder
        self._driver: Any = None
        self._passes: Any = None
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
            self._passes.begin_picture()
        self._calls.begin_picture()

    def _watched(self) -> Driver:
        from OpenGL import GL, GLU  # noqa: PLC0415 - the program has imported it by now

        from domeshim.diagnosis.passes import Passes  # noqa: PLC0415
        from domeshim.diagnosis.watch import WatchedDriver  # noqa: PLC0415

        self._driver = WatchedDriver(_seconds)
        self._driver.watch_module(GL)
        self._driver.watch_subdivision()
        self._passes = Passes(self._driver)
        self._passes.watch()
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
            recipes = {made.name: recipe for recipe, made in context.programs.items()}
            seen["draws"] = self._draws(recipes, context, session.options)
            seen |= self._passes.seen(session.options, context.canvas)
            main = context.placer.main.view
            seen["perspective"] = main.camera.tolist() if main is not None else None
        (self._folder / "seen.json").write_text(json.dumps(seen))

    def _draws(self, recipes: dict[int, Any], context: DomeContext, options: Options) -> list[dict[str, Any]]:
        """Each distinct way to draw."""
        from domeshim.diagnosis.needs import approximated, left_out, needs  # noqa: PLC0415 - as above

        found = []
        for program, tally in self._driver.tallies.items():
            recipe, made = recipes.get(program), self._driver.made[program]
            kind = self._kind(program, recipe, context)
            passes = len(context.canvas.views) if kind in ("draw", "own", "own pieces") else 1
            found.append(
                {
                    "kind": kind,
                    "passes": passes,
                    "draws": tally.draws // passes,
                    "vertices": tally.vertices // passes,
                    "primitives": tally.primitives // passes,
                    "generated": tally.generated,
                    "needs": needs(recipe) + (["cut on the CPU"] if tally.cut else []) if recipe else [],
                    "left_out": left_out(recipe) if recipe else [],
                    "approximated": approximated(recipe, options, cut=tally.cut) if recipe else [],
                    "impossible": _IMPOSSIBLE.get(kind, []) if not options.cubemap else [],
                    "shaders": made.shaders,
                    "characters": made.characters,
                    "seconds": made.seconds,
                }
            )
        return sorted(found, key=lambda each: -each["vertices"])

    def _kind(self, program: int, recipe: Any, context: DomeContext) -> str:
        """Whose program it is: the dome's for a draw or for a pass of that name, the program's, or none."""
        if recipe is not None:
            return "draw"
        if program in self._driver.owners:
            return str(self._driver.owners[program])
        if context.own.named(program) is not None:
            return "own"
        return "own pieces" if context.own.subdivides_by(program) else "unbent"


def main(arguments: Sequence[str]) -> None:
    """Run the program that the command line names, and end the process."""
    wanted = Wanted.from_json(Path(arguments[0]).read_text())
    [frame] = wanted.frames
    observer = Observer(frame, Path(wanted.folder).absolute(), wanted.timeout)
    take_wanted(wanted, observer, arguments[1:])


if __name__ == "__main__":
    main(sys.argv[1:])
