"""What hangs in the virtual dome: one picture, a folder of them as a film, or a running program's."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from domeshim.errors import OptionError
from domeshim.live.shared import Board

Picture = NDArray[np.uint8]
SUFFIXES = (".png", ".tif", ".tiff", ".jpg", ".jpeg")


class Pictures(Protocol):
    """Where the virtual dome's pictures come from."""

    def at(self, seconds: float) -> Picture | None:
        """The picture of this time, (height, width, 3); None where it is still the last one."""

    @property
    def ended(self) -> bool:
        """The virtual dome shall close."""


class Files:
    """Picture files, shown one after the other, over and over."""

    ended = False

    def __init__(self, paths: Sequence[Path], fps: float) -> None:
        self._paths = paths
        self._fps = fps
        self._shown = -1

    def at(self, seconds: float) -> Picture | None:
        """As for Pictures.

        Raises OptionError for a file that is no picture.
        """
        number = int(seconds * self._fps) % len(self._paths)
        if number == self._shown:
            return None
        self._shown = number
        return read_picture(self._paths[number])


class Live:
    """Those of the program that started this process, from a board."""

    def __init__(self, name: str, program: int) -> None:
        """program: the number of that process. Raises FileNotFoundError where there is no such board."""
        self._board = Board(name)
        self._program = program

    @property
    def ended(self) -> bool:
        """The program has ended, in whatever way."""
        if os.getppid() != self._program:
            self._board.close()
        return self._board.ended

    def at(self, seconds: float) -> Picture | None:  # noqa: ARG002 - the newest
        """As for Pictures."""
        return self._board.take()


def read_picture(path: Path) -> Picture:
    """A picture file as (height, width, 3).

    Raises OptionError.
    """
    from PIL import Image  # noqa: PLC0415 - for those who look at files alone

    try:
        with Image.open(path) as image:
            return np.asarray(image.convert("RGB"))
    except OSError as error:
        raise OptionError(f"cannot show {path}: {error}") from None


def pictures_in(folder: Path) -> list[Path]:
    """The picture files of a folder, by name.

    Raises OptionError where there are none.
    """
    found = sorted(path for path in folder.iterdir() if path.suffix.lower() in SUFFIXES)
    if not found:
        raise OptionError(f"cannot show {folder}: no pictures in it; accepted: {', '.join(SUFFIXES)}")
    return found
