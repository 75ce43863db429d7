"""How a program's dome picture, seen as on the monitor, differs from its monitor picture; the verdict."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from domeshim.measure.displacement import Displacement, displacement
from domeshim.measure.match import BLUR, SHIFT, Mask, Match, Picture, match

WRONG_OF_PICTURE = 0.004
"""The share of wrong pixels of what both pictures see, up to which they are alike."""
WRONG_OF_CONTENT = 0.03
"""The same of what is no background."""
MOVED = 1.25
"""Pixels of the monitor's picture by which the dome's may be moved as a whole: a straight edge without
multisampling is already off by up to half a pixel."""
GROWN = 0.75
"""The same for what grows with the distance from the middle; a rounded edge here makes up for one there."""
UNCERTAIN = 1.0
"""The standard error, pixels, over which a movement is not believed."""
FEWEST_SEEN = 0.05
"""The share of the program's window that must lie on the dome for a verdict."""
BLANK = 3.0
"""The largest difference of a channel, of 255, within a picture that shows nothing."""
_MARGIN = 2 * SHIFT + 1
_SOLID = 9
"""Pixels: what is thinner than half of it is a line, a point or a letter."""
_AROUND = 16.0
"""Standard deviation, pixels, of how far around thin things are looked for."""
_FAINT = 4.0
"""Less of thin things, in levels of 255 on the average around, is no evidence."""
_FACTOR = 3.0
"""So many times more or less of them around a place are still the same."""

Verdict = Literal["alike", "different", "undecided"]
STATUS: dict[Verdict, int] = {"alike": 0, "different": 1, "undecided": 2}
"""Each verdict's exit status."""


@dataclass(frozen=True)
class Difference:
    """What two pictures of the same view have of each other."""

    verdict: Verdict
    reason: str
    seen: float
    """The share of the program's window that both see."""
    wrong: float
    """The share of that whose colour the other picture does not show within match.SHIFT pixels."""
    wrong_of_content: float
    """The same pixels as a share of those that are no background."""
    mean: float
    """The mean difference of a channel, of 255, after a slight blur."""
    moved: Displacement | None
    """How the dome's picture lies on the monitor's; None where too little tells."""
    loose: bool = False
    """Lines, points and text, as wide in pixels on the dome as on the monitor, were compared by amount."""
    finer: bool = False
    """Both pictures were taken twice as large and scaled down: details of a texture broke up before."""


def difference(monitor: Picture, dome: Picture, seen: Mask) -> Difference:
    """Hold the dome's picture, as the program's window would show it, against the monitor's.

    Raises ValueError where the shapes differ.
    """
    if monitor.shape != dome.shape:
        raise ValueError(f"the pictures differ in shape: {monitor.shape} and {dome.shape}")
    share = float(seen.mean())
    inside = _without_margin(seen)
    if share < FEWEST_SEEN or not inside.any():
        return Difference("undecided", "hardly anything of its window lies on the dome", share, 0, 0, 0, None)
    blank = [_is_blank(picture, inside) for picture in (monitor, dome)]
    found = match(monitor, dome, inside)
    wrong = found.wrong / int(inside.sum())
    mean = _mean(monitor, dome, inside)
    if all(blank):
        reason = "both pictures are blank" if wrong == 0 else "both pictures are blank, in unlike colours"
        return Difference("undecided", reason, share, wrong, found.share, mean, None)
    moved = displacement(monitor, dome, seen)
    if moved is not None and moved.error > UNCERTAIN:
        moved = None
    verdict, reason, loose = _judge(found, wrong, moved, (monitor, dome, inside))
    if verdict == "different" and any(blank):
        reason = f"the {'monitor' if blank[0] else 'dome'}'s picture is blank"
    return Difference(verdict, reason, share, wrong, found.share, mean, moved, loose)


def _judge(
    found: Match, wrong: float, moved: Displacement | None, pictures: tuple[Picture, Picture, Mask]
) -> tuple[Verdict, str, bool]:
    """The verdict, why, and whether thin things had to be compared loosely."""
    reason = _movement(moved)
    if reason:
        return "different", reason, False
    if wrong <= WRONG_OF_PICTURE and found.share <= WRONG_OF_CONTENT:
        return "alike", "", False
    reason = f"{wrong:.1%} of the pixels show what the other picture does not"
    if thin_things_explain(*pictures):
        return "alike", "", True
    return "different", reason, False


def _movement(moved: Displacement | None) -> str:
    """What is to be said against a movement, if anything."""
    if moved is None:
        return ""
    if moved.growth - 2 * moved.growth_error > GROWN:
        how = "larger" if moved.scale > 0 else "smaller"
        return f"the dome shows it {abs(moved.scale):.2%} {how}, {moved.growth:.1f} pixels at its edge"
    if moved.largest - 2 * moved.error > MOVED:
        right, down = moved.shift
        sideways, upright = "right" if right > 0 else "left", "down" if down > 0 else "up"
        middle = f"{abs(right):.1f} {sideways} and {abs(down):.1f} {upright} in the middle"
        return f"the dome shows it moved by up to {moved.largest:.1f} pixels, {middle}"
    return ""


def thin_things_explain(monitor: Picture, dome: Picture, inside: Mask) -> bool:
    """Everything solid is alike, and about as much of lines, points and letters lies around each place.

    Those have their width in pixels, wherever on the dome they are and however it is turned there.
    """
    from scipy import ndimage  # noqa: PLC0415 - needed for measuring alone

    solid = [ndimage.median_filter(picture, size=(_SOLID, _SOLID, 1)) for picture in (monitor, dome)]
    found = match(solid[0], solid[1], inside)
    if found.wrong > WRONG_OF_PICTURE * inside.sum():
        return False
    amounts = [
        ndimage.gaussian_filter(np.abs(picture.astype(float) - plain).max(-1) * inside, _AROUND)
        for picture, plain in zip((monitor, dome), solid, strict=True)
    ]
    there = [ndimage.maximum_filter(amount, size=2 * round(_AROUND) + 1) for amount in amounts]
    return not any(
        (amounts[i] > _FACTOR * np.maximum(there[1 - i], _FAINT / _FACTOR))[inside].any() for i in (0, 1)
    )


def unwarped(picture: Picture, places: NDArray[np.floating], seen: Mask) -> Picture:
    """The dome's picture as the program's window would show it; black where the dome does not reach.

    places: (h, w, 2), where in the picture each pixel of the window is, from its top left corner; or
    (3, h, w, 2), for each channel.
    """
    from scipy import ndimage  # noqa: PLC0415 - needed for measuring alone

    of_channels = np.broadcast_to(places, (3, *places.shape[-3:])) - 0.5
    channels = [
        ndimage.map_coordinates(
            picture[..., k].astype(np.float32), (each[..., 1], each[..., 0]), order=1, mode="nearest"
        )
        for k, each in enumerate(of_channels)
    ]
    return np.where(seen[..., None], np.rint(np.stack(channels, -1)), 0).astype(np.uint8)


def same_picture(first: Picture, second: Picture) -> bool:
    """Two runs of the same kind gave one picture, but for what a driver may round at a few edges."""
    if first.shape != second.shape:
        return False
    return bool((np.abs(first.astype(int) - second).max(-1) > 2).mean() < 0.0005)


def _is_blank(picture: Picture, inside: Mask) -> bool:
    shown = picture[inside]
    return bool((shown.max(0).astype(int) - shown.min(0)).max() <= BLANK)


def _without_margin(seen: Mask) -> Mask:
    """Without the pixels whose blurred surroundings lie outside."""
    from scipy import ndimage  # noqa: PLC0415 - as above

    return np.asarray(ndimage.binary_erosion(seen, iterations=_MARGIN), bool)


def _mean(first: Picture, second: Picture, inside: Mask) -> float:
    from scipy import ndimage  # noqa: PLC0415 - as above

    blurred: list[NDArray[np.float64]] = [
        ndimage.gaussian_filter(picture.astype(float), (BLUR, BLUR, 0)) for picture in (first, second)
    ]
    return float(np.abs(blurred[0] - blurred[1])[inside].mean())
