"""Pictures handed to another process through a mapped file: the newest only, and nobody waits for anybody."""

from __future__ import annotations

import math
import tempfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

LARGEST = 1536
"""Pixels a side of a picture that is handed on; of larger ones every second, third .. pixel."""
_SLOTS = 3
_SLOT = 3 * LARGEST * LARGEST
_HEAD = 64
_SERIAL, _ENDED, _SIZES = 0, 1, 2
"""Places in the head, each 8 bytes: the number of pictures so far, whether more come, each slot's size."""


class Board:
    """One mapped file; who makes it writes, and who is told its name reads."""

    def __init__(self, name: str | None = None) -> None:
        """Raises FileNotFoundError where there is none of that name."""
        size = _HEAD + _SLOTS * _SLOT
        self._owned = name is None
        if name is None:
            with tempfile.NamedTemporaryFile(prefix="domeshim-", delete=False) as file:
                file.truncate(size)
                name = file.name
        self.name = name
        buffer: NDArray[np.uint8] = np.memmap(name, np.uint8, "r+", shape=(size,))
        self._head = buffer[:_HEAD].view(np.int64)
        self._slots = buffer[_HEAD : _HEAD + _SLOTS * _SLOT].reshape(_SLOTS, _SLOT)
        self._seen = 0

    @property
    def ended(self) -> bool:
        """The writer has closed it."""
        return bool(self._head[_ENDED])

    def put(self, picture: NDArray[np.uint8]) -> None:
        """Hand on (height, width, 3)."""
        step = math.ceil(max(picture.shape[:2]) / LARGEST)
        small = picture[::step, ::step]
        height, width = small.shape[:2]
        number = int(self._head[_SERIAL]) + 1
        slot = number % _SLOTS
        np.copyto(self._slots[slot, : small.size].reshape(small.shape), small)
        self._head[_SIZES + slot] = width << 32 | height
        self._head[_SERIAL] = number

    def take(self) -> NDArray[np.uint8] | None:
        """The newest picture, (height, width, 3); None where it has been taken."""
        while (number := int(self._head[_SERIAL])) != self._seen:
            slot = number % _SLOTS
            size = int(self._head[_SIZES + slot])
            width, height = size >> 32, size & 0xFFFFFFFF
            picture = self._slots[slot, : 3 * width * height].reshape(height, width, 3).copy()
            if int(self._head[_SERIAL]) - number < _SLOTS - 1:  # else it may have been written over meanwhile
                self._seen = number
                return picture
        return None

    def close(self) -> None:
        """End it, for both; the file is gone."""
        self._head[_ENDED] = 1
        Path(self.name).unlink(missing_ok=True)
