"""The colours of DOME_DEBUG=levels, and the legend that says what they mean."""

from __future__ import annotations

from typing import TYPE_CHECKING

from domeshim.draw.paste import paste
from domeshim.driver import Driver
from domeshim.window.frame import Frame

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

_WHOLE = 0x808080
"""Of what is not subdivided."""
_PIECES = {1: 0x440154, 2: 0x3B528B, 4: 0x21918C, 8: 0x5EC962, 16: 0xFDE725}
"""Of so many pieces an edge: viridis at five even steps (Nathaniel Smith, Stefan van der Walt; CC0)."""
_BACKGROUND, _INK = 0x000000, 0xFFFFFF
_ROWS_OF_FRAME, _LEAST_ROW = 44, 10
"""A row is so small a part of the frame's side, and at least so many pixels high."""


def _rgb(colour: int) -> tuple[int, int, int]:
    return colour >> 16, colour >> 8 & 255, colour & 255


RAMP = tuple(
    channel for colour in (_WHOLE, *_PIECES.values()) for channel in (*(c / 255 for c in _rgb(colour)), 1.0)
)
"""The uniform domeRamp: red, green, blue and alpha of each, that of what is whole first."""


def draw_legend(driver: Driver, frame: Frame) -> None:
    """Lay the legend over the top left corner of the current window's finished picture."""
    legend = legend_of(min(frame.size))
    paste(driver, legend, (0, frame.size[1] - legend.shape[0]))


def legend_of(side: int) -> NDArray[np.uint8]:
    """(height, width, 3): numbers of pieces beside their colours, for a picture so many pixels across."""
    import numpy as np  # noqa: PLC0415 - with Pillow, for those who look at levels
    from PIL import Image, ImageDraw, ImageFont  # noqa: PLC0415

    row = max(side // _ROWS_OF_FRAME, _LEAST_ROW)
    font = ImageFont.load_default(row)
    rows = [("pieces", _BACKGROUND), ("whole", _WHOLE), *((str(n), c) for n, c in _PIECES.items())]
    width = max(font.getlength(words) for words, _ in rows)
    step, gap = row * 5 // 4, row // 2
    image = Image.new("RGB", (int(width) + row + 3 * gap, step * len(rows) + 2 * gap), _rgb(_BACKGROUND))
    draw = ImageDraw.Draw(image)
    for number, (words, colour) in enumerate(rows):
        top = gap + number * step
        draw.rectangle((gap, top, gap + row, top + row), _rgb(colour))
        draw.text((row + 2 * gap, top + row / 2), words, _rgb(_INK), font, "lm")
    return np.asarray(image)
