"""Runs a program for several of its pictures, each kept with where the program's window lay in it.

    python -m domeshim.measure.exposures WANTED.json PROG [ARGS]

The comparison's side in the program's own process; domeshim.measure.comparison is the other.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from domeshim import startup
from domeshim.errors import DomeError
from domeshim.measure.capture import Photographer, photograph_by
from domeshim.measure.pixels import read_pixels
from domeshim.measure.studio import Studio, end_at_once
from domeshim.options import Options
from domeshim.program import run_program

if TYPE_CHECKING:
    from domeshim.driver import Driver
    from domeshim.measure.perspectives import Perspectives
    from domeshim.session import Session
    from domeshim.state.pointer import Sight
    from domeshim.window.contract import Window


@dataclass(frozen=True)
class Wanted:
    """Which pictures of a program, of what size, on the dome (with what settings) or as on the monitor."""

    folder: str
    """Each picture goes there as NUMBER.npz."""
    frames: tuple[int, ...]
    size: tuple[int, int]
    """The program's window, pixels."""
    dome: bool
    settings: dict[str, str] = field(default_factory=dict)
    """DOME_* settings by field name; they win over the environment."""
    module: bool = False
    fps: float = 60.0
    timeout: float = 60.0

    def to_json(self) -> str:
        """As from_json reads it."""
        return json.dumps(asdict(self))

    @classmethod
    def from_json(cls, text: str) -> Wanted:
        """As to_json wrote it."""
        read = json.loads(text)
        return cls(**(read | {"frames": tuple(read["frames"]), "size": tuple(read["size"])}))


@dataclass(frozen=True)
class Exposure:
    """One finished picture of a program."""

    picture: NDArray[np.uint8]
    """(height, width, 3), RGB, the top row first."""
    places: NDArray[np.float32] | None = None
    """(h, w, 2): where in the picture each pixel of the program's window is, the top row first; pixels from
    the picture's top left corner, a pixel's middle at a half. None: the picture is as on the monitor."""
    seen: NDArray[np.bool_] | None = None
    """(h, w): which of them lie on the dome and in the program's main view."""
    perspective: bool = False
    """The program has drawn in perspective; otherwise its window is a panel."""
    renderer: str = ""
    channels: NDArray[np.float32] | None = None
    """(3, h, w, 2): places of red, green and blue, where the program drew them in unlike perspectives."""
    overlaid: bool = False
    """Some channel was drawn in several perspectives, one over the other."""

    def save(self, path: Path) -> None:
        """Write it for load.

        Raises OSError.
        """
        arrays = {name: value for name, value in vars(self).items() if value is not None}
        with path.open("wb") as file:
            np.savez(file, **arrays)

    @classmethod
    def load(cls, path: Path) -> Exposure:
        """Read what save wrote.

        Raises OSError.
        """
        with np.load(path) as saved:
            return cls(
                saved["picture"],
                saved.get("places"),
                saved.get("seen"),
                bool(saved["perspective"]),
                str(saved["renderer"]),
                saved.get("channels"),
                bool(saved["overlaid"]),
            )


class Portraitist(Photographer):
    """Keeps pictures with the perspectives that they were drawn in."""

    def __init__(self, wanted: Wanted) -> None:
        super().__init__(
            wanted.frames, partial(self._keep_exposure, Path(wanted.folder).absolute()), wanted.timeout
        )
        self._perspectives: Perspectives | None = None

    def follow(self, session: Session) -> Photographer:
        """Watch this session from now on."""
        session.make_driver = partial(self._driver, session)
        return super().follow(session)

    def frame_finished(self, window: Window, number: int) -> None:
        """Keep the picture if it is a wanted one, and begin the next."""
        super().frame_finished(window, number)
        if self._perspectives is not None:
            self._perspectives.begin_picture()

    def _driver(self, session: Session) -> Driver:
        from domeshim.driver import Driver  # noqa: PLC0415 - only once the program has a window
        from domeshim.measure.perspectives import Perspectives  # noqa: PLC0415

        driver = Driver()
        self._perspectives = Perspectives(driver)
        self._perspectives.watch(session)
        return driver

    def _keep_exposure(self, folder: Path, session: Session, window: Window, number: int) -> None:
        """Write the picture that stands in the window's back buffer."""
        try:
            exposed(session, window, self._perspectives).save(folder / f"{number}.npz")
        except OSError as error:
            startup.say(f"cannot write {folder / str(number)}.npz: {error.strerror or error}")
            end_at_once(1)


def main(arguments: Sequence[str]) -> None:
    """Run the program that the command line names, and end the process."""
    wanted = Wanted.from_json(Path(arguments[0]).read_text())
    take_wanted(wanted, Portraitist(wanted), arguments[1:])


def take_wanted(wanted: Wanted, photographer: Photographer, command: Sequence[str]) -> None:
    """Run a program, by its command line, for what a photographer wants of it, and end the process."""
    prog, *rest = command
    try:
        options = Options.from_environment(given={**wanted.settings, "enabled": str(int(wanted.dome))})
        photograph_by(
            photographer,
            options,
            partial(run_program, prog, rest, module=wanted.module),
            Studio(wanted.size, wanted.fps, wanted.timeout),
        )
    except DomeError as error:
        startup.say(str(error))
        sys.exit(error.exit_status)


def exposed(session: Session, window: Window, perspectives: Perspectives | None) -> Exposure:
    """The picture that stands in the window's back buffer."""
    width, height = window.size
    picture = np.frombuffer(read_pixels(width, height), np.uint8).reshape(height, width, 3)
    from domeshim.intercept.dome import Dome  # noqa: PLC0415 - asks for PyOpenGL, which the program is to import first

    exposure = Exposure(picture, renderer=_renderer())
    context = session.dome.context_of(window) if isinstance(session.dome, Dome) else None
    if context is None:
        return exposure
    sight = context.pixels.sight
    main = _places(sight)
    exposure = replace(exposure, perspective=context.placer.has_perspective, **main)
    views = perspectives.of(context) if perspectives is not None else []
    x, y, _, _ = context.frame.outer
    sights = [replace(sight, view=each[-1].moved(x, y)) if each else sight for each in views]
    exposure = replace(exposure, overlaid=any(len(each) > 1 for each in views))
    places = [_places(each) for each in sights]
    if all(np.array_equal(each["places"], main["places"]) for each in places):
        return exposure
    seen = np.logical_and.reduce([each["seen"] for each in places])
    return replace(exposure, channels=np.stack([each["places"] for each in places]), seen=seen)


def _places(sight: Sight) -> dict[str, Any]:
    """The exposure's places and seen."""
    width, height = sight.frame.program_size
    columns, rows = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    window = np.stack([columns, height - rows], -1)
    frame = sight.to_frame(window)
    x, y, w, h = sight.view.viewport
    in_view = (abs(window[..., 0] - x - w / 2) < w / 2) & (abs(window[..., 1] - y - h / 2) < h / 2)
    seen = in_view & sight.within(frame)
    places = np.where(seen[..., None], frame * (1, -1) + (0, sight.frame.size[1]), 0)
    return {"places": places.astype(np.float32), "seen": seen}


def _renderer() -> str:
    from domeshim.driver import Driver  # noqa: PLC0415 - only once the program has a window

    return (Driver().glGetString(0x1F01) or b"").decode(errors="replace")


if __name__ == "__main__":
    main(sys.argv[1:])
