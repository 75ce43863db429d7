"""What the GPU makes of a draw: the final vertices, caught by transform feedback before they are rasterised.

A driver of this kind stands where the dome's own does, and the pipeline notices nothing.
"""

from __future__ import annotations

from ctypes import c_char_p, c_int
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.catcher import Catcher
from domeshim.driver import Driver

_INTERLEAVED, _CURRENT_PROGRAM, _LINK_STATUS = 0x8C8C, 0x8B8D, 0x8B82
_PATCHES, _PATCH_VERTICES = 0x000E, 0x8E72
_POSITION, _DISTANCE = b"gl_Position", b"gl_ClipDistance[0]"


@dataclass(frozen=True)
class Caught:
    """Primitives of one kind as they go to the rasteriser."""

    positions: NDArray[np.float32]
    """(n, corners, 4): gl_Position; corners: 1, 2 or 3."""
    distances: NDArray[np.float32]
    """(n, corners): the dome's own clip distance, else the near plane's; negative where it cuts."""


class CatchingDriver(Driver):
    """GL whose draws, made through this driver, are caught and not rasterised.

    Needs a current context of GL 3.0 or later; its programs must be linked through it.
    """

    def __init__(self) -> None:
        self._plain = Driver()
        self._catcher = Catcher(self._plain)
        self._cuts: dict[int, bool] = {}
        self.caught: list[Caught] = []
        """All that was drawn since this was last emptied."""

    def glLinkProgram(self, program: int) -> None:  # noqa: N802 - GL's own name
        """Link a program so that its vertices can be caught."""
        self._cuts[program] = self._link(program, (_POSITION, _DISTANCE))
        if not self._cuts[program]:
            self._link(program, (_POSITION,))

    def _link(self, program: int, names: tuple[bytes, ...]) -> bool:
        self._plain.glTransformFeedbackVaryings(
            program, len(names), (c_char_p * len(names))(*names), _INTERLEAVED
        )
        self._plain.glLinkProgram(program)
        linked = c_int()
        self._plain.glGetProgramiv(program, _LINK_STATUS, linked)
        return bool(linked.value)

    def glDrawArrays(self, mode: int, first: int, count: int) -> None:  # noqa: N802 - GL's own name
        """Draw, and keep what comes out."""
        corners = self._corners(mode)
        cuts = self._cuts[self.integer(_CURRENT_PROGRAM)]
        numbers = 5 if cuts else 4
        data = self._catcher.catch(lambda: self._plain.glDrawArrays(mode, first, count), corners, numbers)
        distances = data[..., 4] if cuts else data[..., 2] + data[..., 3]
        self.caught.append(Caught(data[..., :4], distances))

    def glMultiDrawArrays(self, mode: int, firsts: Any, counts: Any, draws: int) -> None:  # noqa: N802
        """Draw, and keep what comes out."""
        for first, count in zip(firsts[:draws], counts[:draws], strict=True):
            self.glDrawArrays(mode, first, count)

    def _corners(self, mode: int) -> int:
        if mode == _PATCHES:
            return min(self.integer(_PATCH_VERTICES), 3)  # a quad comes out as triangles
        return 1 if mode == 0 else 2 if mode <= 3 else 3
