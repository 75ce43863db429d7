"""Plots of a lens: radius against angle, its slope, and what a fit leaves over. Needs matplotlib."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from domeshim.errors import DomeError, OptionError

if TYPE_CHECKING:
    from domeshim.lens.fit import Fit
    from domeshim.lens.radial import RadialLens


def plot_lens(lens: RadialLens, title: str, output: Path) -> None:
    """Write a plot of the lens's radius and slope against the angle.

    Raises DomeError where matplotlib is missing or the file cannot be written.
    """
    figure, (above, below) = _figure(title, 2)
    phi = np.linspace(0.0, np.radians(lens.fov / 2), 1001)
    _draw(above, phi, lens.radius(phi), "radius (1: the rim)")
    _draw(below, phi, np.radians(lens.slope(phi)), "radius a degree")
    below.axhline(2 / lens.fov, color="0.6", linewidth=0.8)  # equidistant
    _from_zero(below)
    _save(figure, output)


def plot_fit(found: Fit, pixels: float, title: str, output: Path) -> None:
    """Write a plot of a fit: the curve among the pairs, its slope, the residuals; pixels: the disc's radius.

    Raises DomeError where matplotlib is missing or the file cannot be written.
    """
    figure, (above, middle, below) = _figure(title, 3)
    angles = [pair.angle for pair in found.pairs]
    phi = np.linspace(0.0, np.radians(max(angles)), 1001)
    above.plot(angles, [pixels * pair.radius for pair in found.pairs], "k.", markersize=4)
    _draw(above, phi, pixels * found.radius(phi), "radius, pixels")
    _draw(middle, phi, pixels * np.gradient(found.radius(phi), np.degrees(phi)), "pixels a degree")
    _from_zero(middle)
    below.plot(angles, pixels * found.residuals, "k.", markersize=4)
    below.axhline(0.0, color="0.6", linewidth=0.8)
    below.set_ylabel("measured less fitted,\npixels")
    _save(figure, output)


def _figure(title: str, rows: int) -> tuple[Any, Any]:
    try:
        from matplotlib.figure import Figure  # noqa: PLC0415 - large, and an extra
    except ImportError:
        raise DomeError("--plot needs matplotlib: pip install 'domeshim[plot]'") from None
    figure = Figure(figsize=(7, 1.5 + 2.5 * rows), layout="constrained")
    axes = figure.subplots(rows, 1, sharex=True)
    axes[0].set_title(title, fontsize="medium", wrap=True)
    axes[-1].set_xlabel("angle from the axis, degrees")
    for each in axes:
        each.grid(visible=True, alpha=0.3)
    return figure, axes


def _draw(axes: Any, phi: Any, values: Any, label: str) -> None:
    axes.plot(np.degrees(phi), values)
    axes.set_ylabel(label)


def _from_zero(axes: Any) -> None:
    axes.set_ylim(0.0, 1.05 * axes.get_ylim()[1])


def _save(figure: Any, output: Path) -> None:
    try:
        output.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(output)
    except OSError as error:
        raise OptionError(f"--plot={output}: {error.strerror}; accepted: a file to write") from None
    except ValueError:
        raise OptionError(f"--plot={output}: not known; accepted: a .png, .svg or .pdf file") from None
