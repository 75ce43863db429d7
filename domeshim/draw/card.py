"""The test card over a running program's pictures, shown and taken away by a key."""

from __future__ import annotations

from typing import TYPE_CHECKING

from domeshim.draw.paste import paste
from domeshim.driver import Driver
from domeshim.options import Options
from domeshim.window.frame import Frame

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class TestCard:
    """The test card of one window."""

    __test__ = False  # no test, whatever pytest takes its name for

    def __init__(self, driver: Driver, options: Options) -> None:
        self._driver = driver
        self._options = options
        self._drawn: tuple[Frame, NDArray[np.uint8]] | None = None
        self._shown = False

    def toggle(self) -> None:
        """Show it over the next picture, or no longer."""
        self._shown = not self._shown

    def draw(self, frame: Frame) -> None:
        """Lay it over a finished picture, while it is shown."""
        if not self._shown:
            return
        if self._drawn is None or self._drawn[0] != frame:
            import numpy as np  # noqa: PLC0415 - with Pillow, for those who look at a card

            from domeshim.lens.card import draw_card  # noqa: PLC0415

            self._drawn = frame, np.asarray(draw_card(frame, self._options))
        paste(self._driver, self._drawn[1])
