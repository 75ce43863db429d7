"""The test card: rings, meridians and marks, where the dome's own directions and the program's land."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from domeshim.lens.models import Floats, Lens, lens_of, rim_radius
from domeshim.lens.orientation import Orientation
from domeshim.lens.projection import disc_of

if TYPE_CHECKING:
    from domeshim.options import Options

_STEP = 10
"""Degrees from ring to ring, and from meridian to meridian."""
_BOLD = 3
"""Each third of them is drawn stronger."""
_BACKGROUND = (0, 0, 0)
_FINE, _STRONG, _RIM = (70, 80, 100), (150, 165, 190), (255, 255, 255)
_MARGIN = 0.055
"""Words keep so far from the rim."""
_PROGRAM = (255, 150, 40)
"""What belongs to the program's view and not to the dome."""
_WAYS = {
    "AHEAD": (0.0, 0.0, -1.0),
    "BEHIND": (0.0, 0.0, 1.0),
    "RIGHT": (1.0, 0.0, 0.0),
    "LEFT": (-1.0, 0.0, 0.0),
    "UP": (0.0, 1.0, 0.0),
    "DOWN": (0.0, -1.0, 0.0),
}
_LARGEST = 8192
"""The card is drawn larger and scaled down, to at most so many pixels a side where it is smaller itself."""

Rectangle = tuple[int, int, int, int]


def draw_card(size: tuple[int, int], squares: Sequence[Rectangle], options: Options) -> Image.Image:
    """The test card of a dome, size pixels (width, height), a disc in each of a frame's squares.

    squares: x, y, width, height, the origin at the bottom left as in glViewport.
    """
    scale = max(1, min(4, _LARGEST // max(size)))
    lens = lens_of(*options.lens, options.fov)
    image = Image.new("RGB", (size[0] * scale, size[1] * scale), _BACKGROUND)
    for square in squares:
        canvas = _Canvas(image, square, scale)
        canvas.outline(_FINE)
        _Card(canvas, lens, rim_radius(lens, options.fov), Orientation.of(options)).draw()
        canvas.caption(_caption(options), _STRONG)
    return image.resize(size, Image.Resampling.BOX)


def _caption(options: Options) -> str:
    lines = [f"{options.lens[0]}  fov {options.fov:g}"]
    turned = [
        f"{name} {value:g}"
        for name, value in (("tilt", options.tilt), ("heading", options.heading), ("roll", options.roll))
        if value
    ]
    placed = [
        f"{name} {','.join(f'{x:g}' for x in place)} of {options.radius:g}"
        for name, place in (("seat", options.seat), ("projector", options.projector))
        if place is not None
    ]
    return "\n".join([*placed, *([" ".join(turned)] if turned else []), *lines])


class _Canvas:
    """A disc of a picture several times as large as wanted, drawn on in the disc's coordinates."""

    def __init__(self, image: Image.Image, square: Rectangle, scale: int) -> None:
        x, y, side, _ = square
        self._image = image
        self.radius = side / 2 * scale
        self._centre = ((x + side / 2) * scale, image.height - (y + side / 2) * scale)
        self._draw = ImageDraw.Draw(image)
        self.pen = max(1.0, side / 1000) * scale
        self._font = ImageFont.load_default(max(9.0, side / 55) * scale)

    def pixels(self, disc: Floats) -> Floats:
        """(..., 2) on the disc -> (..., 2) of the picture."""
        return np.asarray(disc * (self.radius, -self.radius) + self._centre, float)

    def line(self, disc: Floats, color: tuple[int, int, int], width: float = 1.0) -> None:
        """Draw through places of the disc, (n, 2), leaving out those that are nan."""
        for part in _unbroken(disc):
            points = [(float(x), float(y)) for x, y in self.pixels(part)]
            self._draw.line(points, color, round(width * self.pen), joint="curve")

    def words(self, disc: Floats, text: str, color: tuple[int, int, int]) -> None:
        """Write around a place of the disc, on a dark ground."""
        x, y = self.pixels(disc)
        place = (float(x), float(y))
        self._draw.rectangle(self._draw.textbbox(place, text, self._font, anchor="mm"), _BACKGROUND)
        self._draw.text(place, text, color, self._font, anchor="mm")

    def caption(self, text: str, color: tuple[int, int, int]) -> None:
        """Write into the picture's lower left corner."""
        _, _, _, bottom = self._draw.multiline_textbbox((0, 0), text, self._font)
        margin = 12 * self.pen
        self._draw.multiline_text((margin, self._image.height - bottom - margin), text, color, self._font)

    def outline(self, color: tuple[int, int, int]) -> None:
        """Draw along the picture's edge."""
        width, height = self._image.size
        self._draw.rectangle((0, 0, width - 1, height - 1), None, color, round(self.pen))


@dataclass(frozen=True)
class _Card:
    canvas: _Canvas
    lens: Lens
    rim: float
    orientation: Orientation

    def draw(self) -> None:
        """Draw all, from the back to the front."""
        rings = range(_STEP, int(np.degrees(np.pi)) + 1, _STEP)
        for ring in rings:
            self._curve(np.radians(ring), np.linspace(-np.pi, np.pi, 721), ring % (_BOLD * _STEP) == 0)
        for meridian in range(0, 360, _STEP):
            bold = meridian % (_BOLD * _STEP) == 0
            nearest = 0 if meridian % 90 == 0 else _STEP if bold else _BOLD * _STEP
            self._curve(np.radians(np.linspace(nearest, 179.9, 500)), np.radians(meridian), bold)
        self._planes()
        self._edge()
        self._labels(rings)

    def _curve(self, phi: Floats | float, theta: Floats | float, bold: bool) -> None:
        disc = self._of_dome(phi, theta)
        self.canvas.line(disc, _STRONG if bold else _FINE, 1.5 if bold else 1.0)

    def _of_dome(self, phi: Floats | float, theta: Floats | float) -> Floats:
        """(n, 2) where points of the dome land, by their angle from its pole, and that on the disc."""
        phi, theta = np.broadcast_arrays(phi, theta)
        points = np.stack([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), -np.cos(phi)], -1)
        return self._shown(self.orientation.thrown(points))

    def _of_program(self, directions: Floats) -> Floats:
        """(n, 2) where directions of the program's view land."""
        return self._shown(self.orientation.aimed(directions))

    def _shown(self, rays: Floats) -> Floats:
        """Where rays land on the disc; nan beyond the rim."""
        disc = disc_of(rays, self.lens)
        phi = np.arctan2(np.hypot(rays[..., 0], rays[..., 1]), -rays[..., 2])
        radius = np.hypot(disc[..., 0], disc[..., 1])
        beyond = (phi > np.radians(self.lens.fov / 2) + 1e-9) | (radius > self.rim + 1e-9)
        return np.where(beyond[..., None], np.nan, disc)

    def _planes(self) -> None:
        """The program's horizon, and its vertical from ahead to behind."""
        turn = np.linspace(-np.pi, np.pi, 1441)
        still = np.zeros_like(turn)
        for aside, up in ((np.sin(turn), still), (still, np.sin(turn))):
            self.canvas.line(self._of_program(np.stack([aside, up, -np.cos(turn)], -1)), _PROGRAM, 1.5)

    def _edge(self) -> None:
        turn = np.linspace(-np.pi, np.pi, 1441)
        circle = np.stack([np.cos(turn), np.sin(turn)], -1)
        inset = self.canvas.pen / self.canvas.radius
        self.canvas.line(circle * (self.rim - inset), _RIM, 2.0)
        for angle in np.radians(np.arange(0, 360, 5)):
            long = 0.03 if round(np.degrees(angle)) % 90 == 0 else 0.015
            way = np.array([np.cos(angle), np.sin(angle)])
            self.canvas.line(np.stack([way * (self.rim - long), way * self.rim]), _RIM, 2.0)
        for cross in ([[-0.03, 0], [0.03, 0]], [[0, -0.03], [0, 0.03]]):
            self.canvas.line(np.array(cross), _RIM, 2.0)
        self.canvas.line(circle * 0.015, _RIM, 1.5)

    def _labels(self, rings: range) -> None:
        for ring in rings:
            for theta in np.radians((45, 135, 225, 315)):
                place = self._of_dome(np.radians(ring), theta)
                if np.hypot(*place) < self.rim - _MARGIN:
                    self._label(place, f"{ring}", _STRONG)
        for azimuth in range(0, 360, _BOLD * _STEP):
            # As in a dome master: 0 is the front, at the bottom; 90 is to the right.
            theta = np.radians(azimuth - 90)
            meridian = self._of_dome(np.linspace(0, np.pi, 1801), theta)
            shown = meridian[~np.isnan(meridian).any(-1)]
            if len(shown):
                self._label(shown[-1], f"{azimuth}\N{DEGREE SIGN}", _RIM)
        for name, direction in _WAYS.items():
            self._label(self._of_program(np.array(direction)) + np.array((0.0, 0.03)), name, _PROGRAM)

    def _label(self, disc: Floats, text: str, color: tuple[int, int, int]) -> None:
        """Write at a place of the disc, if it shows it, and within the ticks of its edge."""
        if not np.isnan(disc).any():
            inward = (self.rim - _MARGIN) / max(float(np.hypot(*disc)), 1e-9)
            self.canvas.words(disc * min(1.0, inward), text, color)


def _unbroken(disc: Floats) -> Iterator[Floats]:
    """The stretches of a line without nan, of two points or more."""
    shown = np.isfinite(disc).all(-1).reshape(-1)
    starts = np.flatnonzero(np.diff(shown, prepend=False).astype(bool) & shown)
    for start in starts:
        length = int(np.argmin(np.append(shown[start:], False)))
        if length > 1:
            yield disc[start : start + length]
