"""The user's settings: DOME* variables become one frozen Options. The only reader of os.environ."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass

Lens = tuple[str, tuple[float, ...]]
"""A lens model's name and its coefficients: ("equidistant", ()) or ("polynomial", (c1, .., c5))."""


@dataclass(frozen=True)
class Options:
    """What the user set, checked. Angles in degrees, sizes in pixels."""

    enabled: bool = False
    fov: float = 180.0
    tilt: float = 0.0
    lens: Lens = ("equidistant", ())
    method: str = "auto"
    hud: str = "panel"
    panel: float = 60.0
    fill: float | None = None
    frame: tuple[int, int] | None = None
    display: int | None = None
    keep_going: bool = False

    @classmethod
    def from_environment(cls, environ: Mapping[str, str] = os.environ) -> Options:
        """Read the DOME* variables.

        Raises OptionError for the first malformed one.
        """
        raise NotImplementedError
