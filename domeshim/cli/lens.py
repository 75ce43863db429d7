"""domeshim lens: fit a lens to measurements, show one, draw a test card through it."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click
import numpy as np
from numpy.typing import NDArray

from domeshim.cli.settings import FIELDS, dome_options, options_given, size
from domeshim.errors import OptionError, ScreenError
from domeshim.lens.models import lens_of
from domeshim.lens.pairs import ORDERS, Pair, read_pairs
from domeshim.measure.studio import WITHOUT_A_DISPLAY
from domeshim.window.frame import Frame

if TYPE_CHECKING:
    from PIL.Image import Image

    from domeshim.driver import Driver
    from domeshim.lens.fit import Fit
    from domeshim.options import Options

_LARGEST_FRACTION = 2.0
"""Without --size radii are fractions of the disc's: none is larger."""
_USUAL = 1024
"""Residuals are told for a disc of so many pixels where the file has fractions."""
_FILE = click.Path(path_type=Path, dir_okay=False)


@click.group()
def lens() -> None:
    """Fit a lens to measurements, show one, draw a test card through it."""


@lens.command()
@click.argument("data", type=_FILE)
@click.option(
    "--direction",
    type=click.Choice(list(ORDERS)),
    default="angle-to-radius",
    show_default=True,
    help="What the columns of DATA are where its first line does not name them.",
)
@click.option(
    "--size",
    metavar="PIXELS",
    type=click.IntRange(min=2),
    help="Radii are pixels of a disc with this diameter; without it, fractions of its radius.",
)
@click.option("--plot", metavar="FILE", type=_FILE, help="Draw the fit; needs matplotlib.")
@click.option("--output", metavar="FILE", type=_FILE, help="Write a dome.toml with the lens.")
def fit(data: Path, direction: str, size: int | None, plot: Path | None, output: Path | None) -> None:
    """Find C1 to C5 of a lens from measured pairs of an angle (degrees) and a radius."""
    from domeshim.lens.fit import FitError  # noqa: PLC0415 - show has no use for it
    from domeshim.lens.fit import fit as fitted  # noqa: PLC0415

    try:
        found = fitted(_fractions(read_pairs(data, direction), size))
    except FitError as error:
        raise OptionError(f"{data}: {error}") from None
    except ValueError as error:
        raise OptionError(f"{data}: {error}; accepted: two columns, angle in degrees and radius") from None
    pixels = (size or _USUAL) / 2
    click.echo(f"DOME_LENS={found.setting}")
    click.echo(f"DOME_FOV={found.fov:g}")
    click.echo(_summary(found, pixels))
    if output is not None:
        _write(output, f"# {data.name}: {_summary(found, pixels)}\n{_settings(found)}")
    if plot is not None:
        from domeshim.lens.plot import plot_fit  # noqa: PLC0415 - matplotlib, where it is wanted

        plot_fit(found, pixels, f"{data.name}: {_summary(found, pixels)}", plot)


def _fractions(pairs: list[Pair], size: int | None) -> list[Pair]:
    if size is not None:
        return [replace(pair, radius=pair.radius / (size / 2)) for pair in pairs]
    for pair in pairs:
        if pair.radius > _LARGEST_FRACTION:
            raise ValueError(f"{pair.place}: a radius of {pair.radius:g}; if it is in pixels, give --size")
    return pairs


def _summary(found: Fit, pixels: float) -> str:
    mean = pixels * float(np.sqrt(np.mean(found.residuals**2)))
    largest = pixels * float(np.abs(found.residuals).max())
    return (
        f"{len(found.pairs)} pairs, off by {mean:.3g} pixels (root mean square) and {largest:.3g} at most "
        f"(disc of {2 * pixels:g})"
    )


def _settings(found: Fit) -> str:
    return f'lens = "{found.setting}"\nfov = {found.fov:g}\n'


def _write(output: Path, text: str) -> None:
    try:
        output.parent.mkdir(parents=True, exist_ok=True)
        output.write_text(text, "utf-8")
    except OSError as error:
        raise OptionError(f"--output={output}: {error.strerror}; accepted: a file to write") from None


@lens.command()
@click.argument("model", metavar="[LENS]", required=False)
@dome_options(("fov", "config", "preset"))
@click.option("--plot", metavar="FILE", type=_FILE, help="Draw radius and slope; needs matplotlib.")
def show(model: str | None, plot: Path | None, **given: str | None) -> None:
    """Show a lens: the radius of each angle, and its slope. LENS is written as in DOME_LENS."""
    options = options_given(False, {**given, "lens": model})
    chosen = lens_of(*options.lens, options.fov)
    angles = np.append(np.arange(0.0, options.fov / 2, 5.0 if options.fov <= 120 else 10.0), options.fov / 2)
    radii, slopes = chosen.radius(np.radians(angles)), np.radians(chosen.slope(np.radians(angles)))
    even = 2 / options.fov
    click.echo("  angle   radius   a degree   of equidistant")
    for angle, radius, slope in zip(angles, radii, slopes, strict=True):
        click.echo(f"{angle:7.2f}{radius:9.5f}{slope:11.6f}{slope / even:17.3f}")
    if plot is not None:
        from domeshim.lens.plot import plot_lens  # noqa: PLC0415 - matplotlib, where it is wanted

        plot_lens(chosen, f"{options.lens[0]}, {options.fov:g} degrees", plot)


@lens.command()
@dome_options(
    tuple(field for field in FIELDS if field not in ("method", "tolerance", "hud", "panel", "fill"))
)
@click.option("--size", default="1024", show_default=True, callback=size, help="S or WxH in pixels.")
@click.option("--output", metavar="FILE", type=_FILE, help="A picture file, such as a .png; else a window.")
def pattern(size: tuple[int, int], output: Path | None, **given: str | None) -> None:
    """Draw a test card through the lens: rings each 10 degrees, meridians, marks.

    In a window, Escape or q ends it; --display covers a display.
    """
    options = options_given(False, given)
    wanted = options.frame or size
    if output is None:
        _show(options, wanted)
        return
    try:
        output.parent.mkdir(parents=True, exist_ok=True)
        _card(wanted, options).save(output)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else error
        raise OptionError(f"--output={output}: {reason}; accepted: a picture file, such as a .png") from None


def _card(size: tuple[int, int], options: Options) -> Image:
    """The card as the projector gets it."""
    from PIL.Image import fromarray  # noqa: PLC0415 - where a picture is wanted

    from domeshim.lens.card import draw_card  # noqa: PLC0415

    frame = Frame.of(options, size, size)
    card = draw_card(frame, options)
    if not options.finishes:
        return card
    os.environ.update(WITHOUT_A_DISPLAY)
    from domeshim.draw.finished import finished  # noqa: PLC0415 - GL, where it is needed

    return fromarray(finished(np.asarray(card), frame, options))


def _show(options: Options, wanted: tuple[int, int]) -> None:
    from domeshim.draw.finished import finish_now  # noqa: PLC0415 - GL, where there is a window
    from domeshim.lens.card import draw_card  # noqa: PLC0415
    from domeshim.window.show import show as show_window  # noqa: PLC0415 - GL, where there is a window

    def card(size: tuple[int, int]) -> NDArray[np.uint8]:
        return np.asarray(draw_card(Frame.of(options, size, size), options))

    def finish(driver: Driver, size: tuple[int, int]) -> None:
        finish_now(driver, Frame.of(options, size, size), options)

    try:
        show_window(
            card, "domeshim: test card", wanted, options.display, finish if options.finishes else None
        )
    except ScreenError as error:
        raise ScreenError(f"{error}; --output FILE writes the card without one") from None
