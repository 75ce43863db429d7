"""A dome master that tells its directions by colours."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image


@pytest.fixture
def master(tmp_path: Path) -> Path:
    """Red at the front, green at the right, blue at the back, white at the zenith."""
    y, x = (np.mgrid[:200, :200] - 99.5) / 100
    picture = np.zeros((200, 200, 3), np.uint8)
    picture[(y > abs(x)), 0] = 255
    picture[(x > abs(y)), 1] = 255
    picture[(-y > abs(x)), 2] = 255
    picture[np.hypot(x, y) < 0.15] = 255
    path = tmp_path / "master" / "show_000001.png"
    path.parent.mkdir()
    Image.fromarray(picture).save(path)
    return path
