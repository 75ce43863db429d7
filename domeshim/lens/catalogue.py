"""Every lens model by name: how it is written as a setting, and where it is. Light: it loads no numpy.

A new lens is one entry here, its class, and a snippet in glsl/lens.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

Numbers = tuple[float, ...]
LensName = tuple[str, Numbers]
"""A lens as the settings name it: its model, and the numbers that the model takes."""


@dataclass(frozen=True)
class Entry:
    """One lens model."""

    model: str
    """Module and class, under domeshim.lens."""
    numbers: str = ""
    """The numbers that it takes, as the user writes them."""
    fewest: int = 0
    most: int = 0

    def accepts(self, count: int) -> bool:
        """The model takes so many numbers."""
        return self.fewest <= count <= self.most


MODELS = {
    "equidistant": Entry("models:Equidistant"),
    "equisolid": Entry("models:Equisolid"),
    "stereographic": Entry("models:Stereographic"),
    "orthographic": Entry("models:Orthographic"),
    "polynomial": Entry("polynomials:Polynomial", "c1,..,c5", 1, 5),
    "opencv": Entry("polynomials:OpenCV", "k1,..,k4[,f]", 1, 5),
    "blender": Entry("blender:Blender", "k0,..,k4[,mm]", 5, 6),
}
MEASURED = Entry("measured:Measured")
"""The lens of a file of measured angles and radii; its name is "measured", its numbers are in the file."""

FILES = (".csv", ".toml")
"""How the names of such files end."""

ACCEPTED = (
    ", ".join(name + (f":{entry.numbers}" if entry.numbers else "") for name, entry in MODELS.items())
    + ", or a file of measured angles and radii (.csv, .toml)"
)
"""What DOME_LENS accepts, in words."""


def entry_of(name: str) -> Entry:
    """The model of this name."""
    return MEASURED if name == "measured" else MODELS[name]


def lens_named(text: str, folder: Path) -> LensName:
    """The lens that a setting names; a file's name is taken from the folder.

    Raises ValueError with the reason.
    """
    name, colon, after = (part.strip() for part in text.partition(":"))
    if text.strip().lower().endswith(FILES):
        from domeshim.lens.table import read_table  # noqa: PLC0415 - only a lens of a file needs it

        return "measured", read_table(folder / text.strip())
    entry = MODELS.get(name.lower())
    if entry is None:
        raise ValueError("not known" + _meant(name.lower()))
    numbers = tuple(map(_number, after.split(","))) if colon else ()
    if colon and not entry.most:
        raise ValueError(f"{name.lower()} takes no numbers")
    if not entry.accepts(len(numbers)):
        raise ValueError(f"{name.lower()} takes {entry.fewest} to {entry.most} numbers, not {len(numbers)}")
    return name.lower(), numbers


def _meant(name: str) -> str:
    from difflib import get_close_matches  # noqa: PLC0415 - hardly ever needed

    close = get_close_matches(name, MODELS, n=1, cutoff=0.6)
    return f"; probably meant: {close[0]}" if close else ""


def _number(text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        raise ValueError("not a number") from None
    if not abs(number) < float("inf"):
        raise ValueError("not a finite number")
    return number
