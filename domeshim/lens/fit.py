"""C1 to C5 of a measured lens, by least squares in a basis in which the problem is a good one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import Legendre, Polynomial, legendre
from numpy.typing import NDArray

from domeshim.lens.inversion import stops_rising
from domeshim.lens.pairs import Pair

Floats = NDArray[np.float64]

_TERMS = 5
_FEWEST = 6
_WORST = 5.0
"""An error of one pixel in the measurement may move the curve by so many pixels at most."""
_CONTRADICTION = 0.02
"""Points so far, in the disc's radii, from each other or from the curve are no measuring errors."""
_FINE = 500


class FitError(ValueError):
    """Measured pairs that give no lens; says why."""


@dataclass(frozen=True)
class Fit:
    """A fitted lens: radius = c1 phi + .. + c5 phi^5, phi in radians, 1 at the disc's rim."""

    coefficients: tuple[float, ...]
    fov: float
    """Full angle, degrees: to the outermost pair, or to the rim where that is nearer."""
    pairs: tuple[Pair, ...]
    """Radii as fractions of the disc's."""
    residuals: Floats
    """(n,): each pair's radius less the fitted one, in the disc's radii."""
    sharpness: float
    """By how many pixels the curve moves, at most, for an error of one pixel in the measurement."""

    @property
    def setting(self) -> str:
        """The lens as DOME_LENS takes it."""
        return "polynomial:" + ",".join(f"{c:.10g}" for c in self.coefficients)

    def radius(self, phi: Floats) -> Floats:
        """phi: (...) radians -> (...) radius."""
        return np.asarray(Polynomial((0.0, *self.coefficients))(phi), float)


def fit(pairs: Sequence[Pair]) -> Fit:
    """The lens through measured pairs: angles in degrees, radii as fractions of the disc's radius.

    Raises FitError where there are too few, where they lie too close together or contradict each other, or
    where the curve through them does not rise.
    """
    phi = np.radians([pair.angle for pair in pairs])
    radius = np.array([pair.radius for pair in pairs])
    _must_agree(pairs)
    if len({pair.angle for pair in pairs if pair.angle > 0}) < _FEWEST:
        found = len({pair.angle for pair in pairs if pair.angle > 0})
        raise FitError(f"too few: {found} different angles off the axis, where {_FEWEST} are needed")
    outermost = float(phi.max())
    basis = _basis(phi / outermost)
    orthogonal, triangle = np.linalg.qr(basis)
    sharpness, where = _sharpness(triangle, outermost)
    if sharpness > _WORST:
        raise FitError(
            "ill-conditioned: an error of 1 pixel in the measurement would move the curve by "
            f"{sharpness:.3g} pixels at {where:.3g} degrees; measure there as well"
        )
    weights = np.linalg.solve(triangle, orthogonal.T @ radius)
    residuals = radius - basis @ weights
    worst = int(np.abs(residuals).argmax())
    if abs(residuals[worst]) > _CONTRADICTION:
        raise FitError(
            f"contradictory: {pairs[worst].place} lies {100 * abs(residuals[worst]):.3g} % "
            "of the disc's radius off the best curve"
        )
    coefficients = _powers(weights, outermost)
    stop = stops_rising(coefficients, outermost)
    if stop is not None:
        raise FitError(f"the best curve stops rising {np.degrees(stop):.4g} degrees from the axis")
    return Fit(coefficients, _fov(coefficients, outermost), tuple(pairs), residuals, sharpness)


def _basis(x: Floats) -> Floats:
    """(n, 5): x times Legendre's polynomials on 0..1: they vanish on the axis, and are nearly independent."""
    return np.asarray(x[:, None] * legendre.legvander(2 * x - 1, _TERMS - 1), float)


def _powers(weights: Floats, outermost: float) -> tuple[float, ...]:
    converted = Legendre(weights, domain=[0.0, 1.0]).convert(kind=Polynomial, domain=[-1.0, 1.0])
    in_x = np.zeros(_TERMS)
    in_x[: len(converted.coef)] = converted.coef
    return tuple(float(c / outermost**i) for i, c in enumerate(in_x, 1))


def _sharpness(triangle: Floats, outermost: float) -> tuple[float, float]:
    """By how much the curve moves at most, in the mean, for errors of 1 in each pair; where, in degrees."""
    x = np.linspace(0.0, 1.0, _FINE)
    if np.abs(np.diag(triangle)).min() < 1e-9 * np.abs(triangle).max():
        return np.inf, 0.0
    moved = np.linalg.norm(np.linalg.solve(triangle.T, _basis(x).T), axis=0)
    return float(moved.max()), float(np.degrees(x[moved.argmax()] * outermost))


def _must_agree(pairs: Sequence[Pair]) -> None:
    first: dict[float, Pair] = {}
    for pair in pairs:
        other = first.setdefault(pair.angle, pair)
        if abs(pair.radius - other.radius) > _CONTRADICTION:
            raise FitError(
                f"contradictory: {other.place} and {pair.place} have the radii {other.radius:.4g} and "
                f"{pair.radius:.4g} of the disc's at {pair.angle:g} degrees"
            )


def _fov(coefficients: tuple[float, ...], outermost: float) -> float:
    grid = np.linspace(0.0, outermost, 10_001)
    radius = Polynomial((0.0, *coefficients))(grid)
    # Rounded down: DOME_FOV must not reach beyond what was measured.
    return float(np.floor(200 * np.degrees(grid[radius <= 1].max())) / 100)
