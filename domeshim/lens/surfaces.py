"""What the picture falls on, by the name that the user gives it; light enough for every start of Python."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Literal

from domeshim.wording import counted

ACCEPTED = (
    "dome, keystone:x0,y0,..,x3,y3 (the picture's lower left, lower right, upper right and upper left "
    "corner, each 0 to 1), cylinder:ANGLE[,BOTTOM,TOP] (degrees: over 0 to 340; elevations of its edges, -75 "
    "to 75), or the file of a warp mesh: Paul Bourke's kind, or .obj"
)

WIDEST, STEEPEST = 340.0, 75.0
"""Of a cylindrical screen, degrees: a gap is left behind, and towards the poles it would be ever higher."""
_USUAL_EDGES = (-30.0, 30.0)

SurfaceName = tuple[Literal["dome", "keystone", "cylinder", "mesh"], tuple[float, ...] | str]
"""A surface's kind, and its corners, its angles or its file."""
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
    if kind.lower() == "cylinder":
        return "cylinder", _angles(numbers)
    path = folder / text
    if path.is_file():
        return "mesh", str(path)
    raise ValueError("not known, and no file of that name")


def _angles(text: str) -> tuple[float, float, float]:
    try:
        angles = [float(number) for number in text.split(",")]
    except ValueError:
        raise ValueError("not numbers") from None
    if len(angles) not in (1, 3):
        raise ValueError(f"{counted(len(angles), 'number')}, not one or three")
    angle, bottom, top = angles if len(angles) == 3 else (*angles, *_USUAL_EDGES)
    if not 0 < angle <= WIDEST:
        raise ValueError(f"an angle that is not over 0 to {WIDEST:g} degrees")
    if bottom >= top:
        raise ValueError("its lower edge is not below its upper one")
    if not (bottom >= -STEEPEST and top <= STEEPEST):
        raise ValueError(f"an edge beyond {STEEPEST:g} degrees")
    return angle, bottom, top


def _corners(text: str) -> tuple[float, ...]:
    try:
        corners = tuple(float(number) for number in text.split(","))
    except ValueError:
        raise ValueError("not eight numbers") from None
    if len(corners) != 8:
        raise ValueError(f"{counted(len(corners), 'number')}, not eight")
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
