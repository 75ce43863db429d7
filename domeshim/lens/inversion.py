"""The inverse of a rising curve, and where a polynomial stops rising."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Curve = Callable[[Floats], Floats]

_CELLS = 2048
_STEPS = 12


def inverse(curve: Curve, slope: Curve, end: float, values: Floats) -> Floats:
    """values: (...) that a rising curve takes over 0..end -> (...) where; values beyond give 0 or end.

    Newton's steps inside a bracket, halved where a step would leave it.
    """
    grid = np.linspace(0.0, end, _CELLS + 1)
    known = curve(grid)
    values = np.asarray(values, float)
    cell = np.clip(np.searchsorted(known, values) - 1, 0, _CELLS - 1)
    low, high = grid[cell], grid[cell + 1]
    found = np.clip(np.interp(values, known, grid), low, high)
    for _ in range(_STEPS):
        off = curve(found) - values
        low, high = np.where(off < 0, found, low), np.where(off > 0, found, high)
        with np.errstate(divide="ignore", invalid="ignore"):
            step = found - off / slope(found)
        found = np.where((step >= low) & (step <= high), step, (low + high) / 2)
    return found


def stops_rising(coefficients: tuple[float, ...], end: float) -> float | None:
    """The first place in 0..end where sum c_i x^i, i from 1, no longer rises; None where it always does."""
    largest = max(map(abs, coefficients))
    if coefficients[0] <= 0:
        return 0.0
    slope = np.polynomial.Polynomial([i * (c / largest) for i, c in enumerate(coefficients, 1)])
    zeros = slope.roots()
    real = zeros.real[(abs(zeros.imag) < 1e-9) & (zeros.real > 0) & (zeros.real <= end)]
    return float(real.min()) if real.size else None
