"""How far two pictures of the same view are apart, where a shift of a pixel or two does not count."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

SHIFT = 2
"""Pixels, along each axis, within which a colour may be found in the other picture."""
TOLERANCE = 30.0
"""The largest difference of a channel, of 255, that goes for the same colour."""
BLUR = 1.5
"""Standard deviation, in pixels, of the blur that evens out how thin details alias."""
BACKGROUND = 12.0
"""The largest difference of a channel, of 255, from the background that still belongs to it."""
INNER = 0.97
"""The share of the disc's radius that is looked at: each renderer cuts the rim its own way."""

Picture = NDArray[np.uint8]
"""(height, width, 3), RGB, the top row first."""
Mask = NDArray[np.bool_]
"""(height, width), the top row first."""


@dataclass(frozen=True)
class Match:
    """How many pixels show something in either picture, and how many of those are wrong."""

    content: int
    wrong: int

    @property
    def share(self) -> float:
        """The wrong ones as a share of the content, 0 to 1; 0 where neither picture shows anything."""
        return self.wrong / self.content if self.content else 0.0


def match_discs(reference: Picture, picture: Picture) -> Match:
    """Compare two dome pictures of one shape inside INNER of the disc that fills their centre square.

    Raises ValueError where the shapes differ.
    """
    height, width = reference.shape[:2]
    y, x = np.ogrid[:height, :width]
    from_centre = np.hypot(x + 0.5 - width / 2, y + 0.5 - height / 2)
    return match(reference, picture, from_centre < INNER * min(width, height) / 2)


def match(reference: Picture, picture: Picture, where: Mask | None = None) -> Match:
    """Compare two pictures of one shape, inside the mask if there is one.

    A pixel is wrong when its colour lies outside of what the other picture shows within SHIFT pixels of it,
    whichever of the two is asked. Content is what differs from the background, the median of the reference.

    Raises ValueError where the shapes differ.
    """
    if reference.shape != picture.shape:
        raise ValueError(f"the pictures differ in shape: {reference.shape} and {picture.shape}")
    inside = np.ones(reference.shape[:2], bool) if where is None else where
    if not inside.any():
        return Match(0, 0)
    first, second = _blurred(reference), _blurred(picture)
    background = np.median(first[inside], axis=0)
    shown = np.maximum(_largest(first - background), _largest(second - background)) > BACKGROUND
    wrong = _missing(first, second) | _missing(second, first)
    return Match(int(np.sum(shown & inside)), int(np.sum(wrong & inside)))


def _blurred(picture: Picture) -> NDArray[np.float64]:
    from scipy import ndimage  # noqa: PLC0415 - needed for measuring alone, and not installed with the package

    blurred: NDArray[np.float64] = ndimage.gaussian_filter(picture.astype(np.float64), (BLUR, BLUR, 0.0))
    return blurred


def _largest(difference: NDArray[np.float64]) -> NDArray[np.float64]:
    """The largest absolute difference of a pixel's channels."""
    largest: NDArray[np.float64] = np.abs(difference).max(axis=-1)
    return largest


def _missing(asked: NDArray[np.float64], shown: NDArray[np.float64]) -> Mask:
    """Where a colour of the one picture lies outside of the range that the other shows nearby."""
    from scipy import ndimage  # noqa: PLC0415 - as above

    window = (2 * SHIFT + 1, 2 * SHIFT + 1, 1)
    darkest = ndimage.minimum_filter(shown, size=window)
    brightest = ndimage.maximum_filter(shown, size=window)
    return _largest(asked - np.clip(asked, darkest, brightest)) > TOLERANCE
