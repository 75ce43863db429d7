"""What is to be rendered: which program, which pictures of it, how large, and where they go."""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path

from domeshim import __version__
from domeshim.errors import OptionError
from domeshim.options import Options

SUFFIXES = ("png", "tif")
Part = tuple[int, int, int, int] | None
"""A tile: x and y from the picture's bottom left, width, height; None: all of the picture."""


@dataclass(frozen=True)
class Reel:
    """What one process can make: a program on the dome, seen by one eye, as a row of pictures."""

    program: str
    arguments: tuple[str, ...] = ()
    module: bool = False
    """program is a module's name, as for python -m."""
    settings: dict[str, str] = field(default_factory=dict)
    """DOME_* settings as texts, by the field of Options."""
    side: int = 1024
    """Of the square picture that is drawn, pixels."""
    fps: float = 60.0
    timeout: float = 60.0
    """Real seconds that a picture may take."""
    part: Part = None

    def to_json(self) -> str:
        """As from_json reads it, on one line."""
        return json.dumps(asdict(self), sort_keys=True)

    @classmethod
    def from_json(cls, text: str) -> Reel:
        """As to_json wrote it."""
        read = json.loads(text)
        part = tuple(read["part"]) if read["part"] else None
        return cls(**read | {"arguments": tuple(read["arguments"]), "part": part})


@dataclass(frozen=True)
class Plan:
    """A row of pictures and their files: OUTPUT/NAME_000001.png, in OUTPUT/L and OUTPUT/R for two eyes."""

    reel: Reel
    first: int
    last: int
    size: int
    """Of the square picture that is written, pixels."""
    output: Path
    name: str
    suffix: str = "png"
    offset: int = 0
    """Added to a picture's number for its file's."""
    eyes: tuple[str, ...] = ("",)
    """("",), or ("left", "right")."""
    tile: int = 0
    """Pixels a side of the tiles that a picture is drawn in, as they are drawn; 0: it is drawn whole."""

    @property
    def frames(self) -> range:
        """The numbers of the pictures; 1 is the program's first."""
        return range(self.first, self.last + 1)

    def path(self, frame: int, eye: str = "") -> Path:
        """The file of a picture."""
        return self.folder(eye) / f"{self.name}_{frame + self.offset:06d}.{self.suffix}"

    def folder(self, eye: str = "") -> Path:
        """Where an eye's pictures go."""
        return self.output / {"": "", "left": "L", "right": "R"}[eye]

    @property
    def parts(self) -> tuple[Part, ...]:
        """The tiles that a picture is drawn in."""
        if not self.tile:
            return (None,)
        side = self.reel.side
        starts = range(0, side, self.tile)
        return tuple(
            (x, y, min(self.tile, side - x), min(self.tile, side - y)) for y in starts for x in starts
        )

    def reel_of(self, eye: str, part: Part) -> Reel:
        """What a process makes: one eye's pictures, or a tile of each."""
        seen = {"stereo": eye} if eye else {}
        return replace(self.reel, settings={**self.reel.settings, **seen}, part=part)

    @property
    def fingerprint(self) -> str:
        """The same for all that gives the same pictures; a file of another plan does not count as made."""
        reel = self.reel
        options = repr(Options.from_environment({}, reel.settings))
        said = (reel.program, reel.arguments, reel.module, options, reel.side, reel.fps)
        digest = hashlib.sha256(json.dumps([__version__, self.size, self.suffix, self.tile, *said]).encode())
        if not reel.module and Path(reel.program).is_file():
            digest.update(Path(reel.program).read_bytes())
        return digest.hexdigest()[:16]


def parse_frames(text: str) -> tuple[int, int]:
    """First and last picture from "A:B"; a single number is that picture alone.

    Raises OptionError.
    """
    first, colon, last = (part.strip() for part in text.partition(":"))
    if not first.isdecimal() or not (last.isdecimal() if colon else True):
        raise _malformed(text, "not two numbers of pictures")
    a, b = int(first), int(last or first)
    if not 1 <= a <= b:
        raise _malformed(text, "picture 1 is the first, and the last does not come before it")
    return a, b


def _malformed(text: str, reason: str) -> OptionError:
    return OptionError(f"--frames={text}: {reason}; accepted: A:B, from picture A up to and with picture B")
