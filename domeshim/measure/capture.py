"""Takes one picture of a running program, off screen and on a clock that counts frames."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from domeshim import startup
from domeshim.errors import DomeError, OptionError, ProgramFinished
from domeshim.measure.pixels import read_pixels
from domeshim.options import Options
from domeshim.session import Session
from domeshim.window.clock import VirtualClock

if TYPE_CHECKING:
    from domeshim.window.contract import Backend, Window

GRACE = 5.0
"""Real seconds that a program may take to end once its picture is taken."""
_WITHOUT_A_DISPLAY = {
    "PYOPENGL_PLATFORM": "egl",
    "SDL_VIDEODRIVER": "dummy",
    "SDL_AUDIODRIVER": "dummy",
    "QT_QPA_PLATFORM": "offscreen",
}
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
    os.environ.update(_WITHOUT_A_DISPLAY)  # before anything imports OpenGL or a toolkit
    from domeshim.window.virtual_time import pin_time  # noqa: PLC0415 - only pictures have a time of their own

    clock = VirtualClock(shot.fps)
    session = Session(options, clock=clock, backend=_off_screen, window_size=shot.size)
    photographer = Photographer(shot.frame, _ready_to_write(shot.output))
    session.listeners.append(photographer)
    startup.run_under(session)
    photographer.watch(shot.timeout)
    pin_time(clock)
    status: object = None
    try:
        run()
    except SystemExit as ended:
        status = ended.code
    if photographer.taken:
        raise SystemExit(0)
    if status is not None and not isinstance(status, int):
        sys.stderr.write(f"{status}\n")  # as Python prints what it is told to exit with
    hint = "" if status or session.frames else NO_PICTURE
    progress = f"after {session.frames} pictures; picture {shot.frame} was wanted{hint}"
    raise DomeError(f"the program ended {progress}")


class Photographer:
    """Writes the wanted picture when it is finished and ends the program; watches that pictures come."""

    def __init__(self, frame: int, output: Path) -> None:
        self._frame = frame
        self._output = output
        self._frames = 0
        self._news = threading.Event()
        self.taken = False

    def frame_finished(self, window: Window, number: int) -> None:
        """Take the picture if it is the wanted one.

        Raises ProgramFinished once it is taken. A program that stops exceptions is ended at its next picture.
        """
        if self.taken:
            end_at_once(0)
        self._frames = number
        if number == self._frame:
            try:
                write_png(self._output, window.size, read_pixels(*window.size))
            except OSError as error:
                startup.say(f"cannot write {self._output}: {error.strerror or error}")
                end_at_once(1)
            self.taken = True
        self._news.set()
        if self.taken:
            raise ProgramFinished

    def watch(self, timeout: float) -> None:
        """From now on, end the process when no picture comes for so many real seconds."""
        threading.Thread(target=self._watch, args=(timeout,), name="domeshim watchdog", daemon=True).start()

    def _watch(self, timeout: float) -> None:
        # The operating system times the waiting for a lock: pinning the time module does not reach it.
        while self._news.wait(GRACE if self.taken else timeout):
            self._news.clear()
        if self.taken:
            end_at_once(0)
        hint = "" if self._frames else NO_PICTURE
        progress = f"after {self._frames} pictures; picture {self._frame} was wanted{hint}"
        startup.say(f"nothing came for {timeout:g} seconds {progress}")
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


def end_at_once(status: int) -> NoReturn:
    """End the process without asking the program; what it has printed is kept."""
    for stream in (sys.stdout, sys.stderr):
        with suppress(Exception):
            stream.flush()
    os._exit(status)


def _off_screen() -> Backend:
    # Imported with the first window: until then the program may set PyOpenGL's flags.
    from domeshim.window.offscreen import OffscreenBackend  # noqa: PLC0415

    return OffscreenBackend()


def _ready_to_write(output: Path) -> Path:
    """The output's full path, for the program may change the folder; makes the folder it lies in."""
    path = output.absolute()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OptionError(f"--output={output}: {error.strerror}; accepted: a file to write") from None
    return path
