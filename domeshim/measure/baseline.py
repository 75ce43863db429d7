"""Dome pictures that were found good once, in a folder, to hold later ones against."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from domeshim.errors import OptionError
from domeshim.measure.comparison import Compared
from domeshim.measure.difference import Difference, difference
from domeshim.measure.match import Picture


@dataclass(frozen=True)
class Baseline:
    """A folder of dome pictures: NAME-FRAME-WIDTHxHEIGHT.png, of the program's window."""

    folder: Path
    update: bool = False
    """Store pictures instead of comparing them."""

    def path(self, name: str, result: Compared) -> Path:
        """Where a picture's counterpart lies, or is to be."""
        width, height = result.size
        return self.folder / f"{name}-{result.frame}-{width}x{height}.png"

    @staticmethod
    def stored(path: Path) -> Picture:
        """A stored picture.

        Raises OSError, and PIL's UnidentifiedImageError where it is none.
        """
        from PIL import Image  # noqa: PLC0415 - only with a baseline

        return np.asarray(Image.open(path).convert("RGB"))

    def held(self, name: str, result: Compared) -> Difference | None:
        """The difference of a dome picture from the stored one; None where it was stored just now.

        Raises OptionError where the folder cannot be written or a stored file is no picture.
        """
        from PIL import Image, UnidentifiedImageError  # noqa: PLC0415 - only with a baseline

        path = self.path(name, result)
        if result.dome is None:
            return Difference("undecided", result.difference.reason, 0, 0, 0, 0, None)
        try:
            if self.update:
                self.folder.mkdir(parents=True, exist_ok=True)
                Image.fromarray(result.dome).save(path)
                return None
            if not path.exists():
                return Difference(
                    "undecided", f"no stored picture {path}; --update stores it", 0, 0, 0, 0, None
                )
            stored = self.stored(path)
        except UnidentifiedImageError:
            raise OptionError(
                f"--baseline={self.folder}: {path.name} is no picture; --update replaces it"
            ) from None
        except OSError as error:
            raise OptionError(
                f"--baseline={self.folder}: {error.strerror or error}; accepted: a folder"
            ) from None
        if stored.shape != result.dome.shape:
            sizes = " and ".join(f"{p.shape[1]}x{p.shape[0]}" for p in (stored, result.dome))
            return Difference("different", f"the stored picture has another size: {sizes}", 0, 0, 0, 0, None)
        return difference(stored, result.dome, np.ones(stored.shape[:2], bool))
