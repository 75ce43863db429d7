"""Takes pictures of a running program, off screen and on a clock that counts frames."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Collection
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from domeshim import startup
from domeshim.errors import DomeError, OptionError, ProgramFinished
from domeshim.measure.pixels import read_pixels
from domeshim.measure.studio import Studio, Watch, end_at_once, run_off_screen
from domeshim.options import Options
from domeshim.session import Session
from domeshim.wording import counted

if TYPE_CHECKING:
    from domeshim.window.contract import Window

Keep = Callable[[Session, "Window", int], None]
"""What is done with a finished picture in the window's back buffer, by its number, 1 the first."""
GRACE = 5.0
"""Real seconds that a program may take to end once its picture is taken."""
NO_PICTURE = ": it opened no GL window, or never swapped its buffers nor flushed"
"""What usually keeps a program from finishing any picture."""


@dataclass(frozen=True)
class Shot:
    """What is to be taken: picture number frame (1 the first) of so many pixels, and where it goes."""

    frame: int
    size: tuple[int, int]
    output: Path
    fps: float = 60.0
    timeout: float = 60.0


def take(shot: Shot, options: Options, run: Callable[[], None]) -> NoReturn:
    """Run the program by run() until its picture is written, and end the process with status 0.

    What the program prints and raises passes through. Raises DomeError where no picture came of it.
    """
    output = _ready_to_write(shot.output)

    def keep(_session: Session, window: Window, _number: int) -> None:
        try:
            write_png(output, window.size, read_pixels(*window.size))
        except OSError as error:
            startup.say(f"cannot write {output}: {error.strerror or error}")
            end_at_once(1)

    photograph((shot.frame,), keep, options, run, Studio(shot.size, shot.fps, shot.timeout))


def photograph(
    frames: Collection[int], keep: Keep, options: Options, run: Callable[[], None], studio: Studio
) -> NoReturn:
    """Run the program by run() until its pictures of these numbers are kept, and end the process, status 0.

    Raises DomeError where the program ended before.
    """
    photograph_by(Photographer(frames, keep, studio.timeout), options, run, studio)


def photograph_by(
    photographer: Photographer, options: Options, run: Callable[[], None], studio: Studio
) -> NoReturn:
    """The same by a photographer who wants to do more."""
    session, status = run_off_screen(run, options, studio, photographer.follow)
    if photographer.taken:
        raise SystemExit(0)
    if status is not None and not isinstance(status, int):
        sys.stderr.write(f"{status}\n")  # as Python prints what it is told to exit with
    hint = "" if status or session.frames else NO_PICTURE
    progress = f"after {counted(session.frames, 'picture')}; picture {photographer.last} was wanted{hint}"
    raise DomeError(f"the program ended {progress}")


class Photographer:
    """Keeps the wanted pictures as they are finished, then ends the program; watches that pictures come."""

    def __init__(self, frames: Collection[int], keep: Keep, timeout: float) -> None:
        self.last = max(frames)
        self.taken = False
        self._wanted = frozenset(frames)
        self._keep = keep
        self._session: Session | None = None
        self._watch = Watch(timeout, self._silent)

    def follow(self, session: Session) -> Photographer:
        """Watch this session from now on."""
        self._session = session
        self._watch.start()
        return self

    def frame_finished(self, window: Window, number: int) -> None:
        """Keep the picture if it is a wanted one.

        Raises ProgramFinished after the last. A program that stops exceptions is ended at its next picture.
        """
        if self.taken:
            end_at_once(0)
        if number in self._wanted:
            assert self._session is not None
            self._keep(self._session, window, number)
            if number == self.last:
                self.taken = True
                self._watch.timeout = GRACE
        self._watch.heard()
        if self.taken:
            raise ProgramFinished

    def _silent(self) -> None:
        """No picture came for too long."""
        if self.taken:
            end_at_once(0)
        frames = self._session.frames if self._session is not None else 0
        hint = "" if frames else NO_PICTURE
        progress = f"after {counted(frames, 'picture')}; picture {self.last} was wanted{hint}"
        startup.say(f"nothing came for {counted(self._watch.timeout, 'second')} {progress}")
        end_at_once(1)


def write_png(path: Path, size: tuple[int, int], pixels: bytes) -> None:
    """Write RGB pixels, the top row first, as a PNG file that appears under its name only when it is whole.

    Raises OSError.
    """
    from PIL import Image  # noqa: PLC0415 - late, so that the program is the first to import what it wants

    unfinished = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        Image.frombytes("RGB", size, pixels).save(unfinished, format="PNG")
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)


def _ready_to_write(output: Path) -> Path:
    """The output's full path, for the program may change the folder; makes the folder it lies in."""
    path = output.absolute()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OptionError(f"--output={output}: {error.strerror}; accepted: a file to write") from None
    return path
