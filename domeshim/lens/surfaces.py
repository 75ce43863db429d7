"""What the picture falls on, by the name that the user gives it; light enough for every start of Python."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Literal

ACCEPTED = (
    "dome, keystone:x0,y0,..,x3,y3 (the picture's lower left, lower right, upper right and upper left "
    "corner, each 0 to 1), or the file of a warp mesh: Paul Bourke's kind, or .obj"
)

SurfaceName = tuple[Literal["dome", "keystone", "mesh"], tuple[float, ...] | str]
"""A surface's kind, and its corners or its file."""
DOME: SurfaceName = ("dome", ())


def surface_named(text: str, folder: Path) -> SurfaceName:
    """The surface that a user names; folder: where a mesh's file is looked for.

    Raises ValueError with the reason.
    """
    kind, colon, numbers = (part.strip() for part in text.partition(":"))
    if kind.lower() == "dome" and not colon:
        return DOME
    if kind.lower() == "keystone":
        return "keystone", _corners(numbers)
    path = folder / text
    if path.is_file():
        return "mesh", str(path)
    raise ValueError("not known, and no file of that name")


def _corners(text: str) -> tuple[float, ...]:
    try:
        corners = tuple(float(number) for number in text.split(","))
    except ValueError:
        raise ValueError("not eight numbers") from None
    if len(corners) != 8:
        raise ValueError(f"{len(corners)} numbers, not eight")
    if not all(math.isfinite(number) and 0 <= number <= 1 for number in corners):
        raise ValueError("a corner outside of 0 to 1")
    turns = (_turn(corners, i) for i in range(4))
    if min(turns) < 1e-6:
        raise ValueError("the corners do not go round to the left, each one outward")
    return corners


def _turn(corners: tuple[float, ...], i: int) -> float:
    """By how much the figure turns to the left at its corner i + 1."""
    (ax, ay), (bx, by), (cx, cy) = (corners[2 * (k % 4) : 2 * (k % 4) + 2] for k in (i, i + 1, i + 2))
    return (bx - ax) * (cy - by) - (by - ay) * (cx - bx)
