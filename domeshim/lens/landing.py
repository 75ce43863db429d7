"""Where a ray lands in the picture: what every lens and every screen says."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]
Clip = Literal["behind", "cone", "wedge"]


class Lens(ABC):
    """Where a ray lands in the picture, and back; hashable, so that what follows from it is found once.

    In the wide sense: a fisheye, or what a screen of another shape wants instead. Rays are (..., 3) in the
    dome's space, its axis along -z; places are (..., 2), 1 at the sides of the picture's square or frame.
    """

    cells: ClassVar[str]
    """The snippet with a grid over the picture, giving rayAt()."""
    singular: ClassVar[bool] = True
    """What is straight behind has no place, and around it all edges bend without bound."""

    @property
    @abstractmethod
    def snippets(self) -> tuple[str, ...]:
        """Of glsl, giving landed(); with the uniform domeLens."""

    @property
    @abstractmethod
    def uniform(self) -> tuple[float, ...]:
        """The values of the snippets' domeLens."""

    @property
    @abstractmethod
    def rim(self) -> float | None:
        """The radius at which the picture ends; None where its sides are the rectangle's own."""

    @abstractmethod
    def landed(self, rays: Floats) -> Floats:
        """(..., 3) of any length -> (..., 2)."""

    @abstractmethod
    def ray(self, places: Floats) -> Floats:
        """The inverse of landed: (..., 2) -> (..., 3) of some length; nan where nothing lands."""

    @abstractmethod
    def within(self, places: Floats) -> Bools:
        """(..., 2) -> (...): which places belong to the picture."""

    @abstractmethod
    def nearest(self, places: Floats) -> Floats:
        """(..., 2) -> (..., 2): the nearest place of the picture."""

    @abstractmethod
    def spread(self, around: bool) -> Floats:
        """(..., 3) rays all over the picture; around: also where all ways from the axis are alike."""

    @abstractmethod
    def clip(self, exact: bool) -> Clip:
        """The snippet of glsl/clip that cuts off what is behind; exact: just behind the picture's end."""

    @abstractmethod
    def left_out(self, detail: float) -> float:
        """Half the angle of what that leaves out behind, radians.

        detail: pieces an arc of one radian is cut into; inf where edges are not cut.
        """

    @property
    def least_detail(self) -> float:
        """At least so many pieces an arc of one radian needs, that none reaches round behind."""
        return 0.0
