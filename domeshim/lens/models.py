"""Lens models: where on the disc an angle from the dome's axis lands. Numpy twins of glsl/lens."""

from __future__ import annotations

import importlib
import math
from abc import abstractmethod
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from domeshim.lens.catalogue import Numbers, entry_of
from domeshim.lens.landing import Floats
from domeshim.lens.radial import RadialLens


class LensError(ValueError):
    """A lens cannot be what was asked of it; says why."""


@dataclass(frozen=True)
class Equidistant(RadialLens):
    """The radius grows evenly with the angle and is 1 at half the field of view."""

    fov: float
    name: ClassVar[str] = "equidistant"

    @classmethod
    def of(cls, numbers: Numbers, fov: float) -> Equidistant:  # noqa: ARG003 - it takes none
        """The lens of this field of view."""
        return cls(fov)

    @property
    def uniform(self) -> tuple[float, ...]:
        """1 / (fov / 2), radians."""
        return (1.0 / self.end,)

    def _radius(self, phi: Floats) -> Floats:
        return phi / self.end

    def _slope(self, phi: Floats) -> Floats:
        return np.full_like(phi, 1.0 / self.end)

    def _angle(self, radius: Floats) -> Floats:
        return radius * self.end


class _Formula(RadialLens):
    """A lens by one trigonometric function, scaled to reach the radius 1 at half the field of view."""

    widest: ClassVar[float]
    """Up to this field of view, degrees, the function rises to something finite."""
    why: ClassVar[str]

    def __init__(self, fov: float) -> None:
        raise NotImplementedError

    @classmethod
    def of(cls, numbers: Numbers, fov: float) -> RadialLens:  # noqa: ARG003 - it takes none
        """The lens of this field of view.

        Raises LensError where the function does not reach that far.
        """
        if fov > cls.widest:
            raise LensError(f"{cls.why}: it can show {cls.widest:g} degrees at most, DOME_FOV is {fov:g}")
        return cls(fov)

    @property
    def uniform(self) -> tuple[float, ...]:
        """(end, slope there, scale)."""
        return *self._edge, self._scale

    @property
    @abstractmethod
    def _scale(self) -> float:
        """1 / the function at half the field of view."""


@dataclass(frozen=True)
class Equisolid(_Formula):
    """radius = sin(phi / 2) / sin(fov / 4): equal solid angles have equal areas."""

    fov: float
    name: ClassVar[str] = "equisolid"
    widest: ClassVar[float] = 360.0
    why: ClassVar[str] = "an equisolid lens rises to straight behind"

    @property
    def _scale(self) -> float:
        return 1.0 / math.sin(self.end / 2)

    def _radius(self, phi: Floats) -> Floats:
        return self._scale * np.sin(phi / 2)

    def _slope(self, phi: Floats) -> Floats:
        return self._scale / 2 * np.cos(phi / 2)

    def _angle(self, radius: Floats) -> Floats:
        return 2 * np.arcsin(np.minimum(radius / self._scale, 1.0))


@dataclass(frozen=True)
class Stereographic(_Formula):
    """radius = tan(phi / 2) / tan(fov / 4): circles on the dome are circles on the disc."""

    fov: float
    name: ClassVar[str] = "stereographic"
    widest: ClassVar[float] = 359.0
    why: ClassVar[str] = "a stereographic lens puts what is straight behind infinitely far out"

    @property
    def snippets(self) -> tuple[str, ...]:
        """As for Lens: by the ray itself, which stays exact near straight behind."""
        return f"lens/{self.name}", "bend/stereographic"

    @property
    def _scale(self) -> float:
        return 1.0 / math.tan(self.end / 2)

    def _radius(self, phi: Floats) -> Floats:
        return self._scale * np.tan(phi / 2)

    def _slope(self, phi: Floats) -> Floats:
        return self._scale / 2 / np.cos(phi / 2) ** 2

    def _angle(self, radius: Floats) -> Floats:
        return 2 * np.arctan(radius / self._scale)


@dataclass(frozen=True)
class Orthographic(_Formula):
    """radius = sin(phi) / sin(fov / 2): the dome as seen from far below."""

    fov: float
    name: ClassVar[str] = "orthographic"
    widest: ClassVar[float] = 180.0
    why: ClassVar[str] = "an orthographic lens folds back beyond 90 degrees from its axis"

    @property
    def _scale(self) -> float:
        return 1.0 / math.sin(self.end)

    def _radius(self, phi: Floats) -> Floats:
        return self._scale * np.sin(phi)

    def _slope(self, phi: Floats) -> Floats:
        return self._scale * np.cos(phi)

    def _angle(self, radius: Floats) -> Floats:
        return np.arcsin(np.minimum(radius / self._scale, 1.0))


def lens_of(name: str, numbers: Numbers, fov: float) -> RadialLens:
    """The lens of this name in the catalogue; fov in degrees.

    Raises LensError where there is none such.
    """
    module, _, kind = entry_of(name).model.partition(":")
    model: type[RadialLens] = getattr(importlib.import_module(f"domeshim.lens.{module}"), kind)
    return model.of(numbers, fov)
