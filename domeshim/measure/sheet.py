"""The comparison's picture: the monitor, the dome seen as on the monitor, and what differs, in a row."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from domeshim.measure.comparison import Compared
from domeshim.measure.match import Picture

AMPLIFIED = 4
"""So many times the difference is shown."""
_GAP = 8
_PAPER, _INK = (32, 32, 32), (230, 230, 230)


def write_sheet(path: Path, result: Compared, title: str) -> None:
    """Write the sheet as a PNG file; makes its folder.

    Raises OSError, and ValueError where the result has no pictures.
    """
    if result.monitor is None:
        raise ValueError("there is no picture to show")
    path.parent.mkdir(parents=True, exist_ok=True)
    sheet(result, title).save(path)


def sheet(result: Compared, title: str) -> Image.Image:
    """The sheet, with the title above."""
    monitor, dome = result.monitor, result.seen_as_monitor
    assert monitor is not None
    shown: list[tuple[str, Picture]] = [("monitor", monitor)]
    if dome is not None:
        apart = np.abs(monitor.astype(int) - dome) * AMPLIFIED
        shown.append(("dome, seen as on the monitor", dome))
        shown.append((f"difference x {AMPLIFIED}", np.clip(apart, 0, 255).astype(np.uint8)))
    else:
        assert result.dome is not None
        shown.append(("dome", result.dome))
    return in_a_row(shown, title)


def compared_with(stored: Picture, dome: Picture, title: str) -> Image.Image:
    """A stored picture, one of now, and what differs where they have one size."""
    shown: list[tuple[str, Picture]] = [("stored", stored), ("now", dome)]
    if stored.shape == dome.shape:
        apart = np.abs(stored.astype(int) - dome) * AMPLIFIED
        shown.append((f"difference x {AMPLIFIED}", np.clip(apart, 0, 255).astype(np.uint8)))
    return in_a_row(shown, title)


def in_a_row(shown: list[tuple[str, Picture]], title: str) -> Image.Image:
    """The pictures in a row, each of the first one's height, its caption below."""
    letters = max(12, shown[0][1].shape[0] // 32)
    height = shown[0][1].shape[0]
    images = [Image.fromarray(picture) for _, picture in shown]
    images = [image.resize((round(image.width * height / image.height), height)) for image in images]
    font = ImageFont.load_default(size=letters)
    band = 2 * letters
    whole = (sum(image.width + _GAP for image in images) + _GAP, 2 * band + height)
    laid = Image.new("RGB", whole, _PAPER)
    draw = ImageDraw.Draw(laid)
    draw.text((_GAP, letters // 2), title, fill=_INK, font=font)
    x = _GAP
    for (caption, _), image in zip(shown, images, strict=True):
        laid.paste(image, (x, band))
        draw.text((x, band + height + letters // 2), caption, fill=_INK, font=font)
        x += image.width + _GAP
    return laid
