"""The test card: rings, meridians and marks, where the dome's own directions and the program's land."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from domeshim.lens.chosen import lens_chosen
from domeshim.lens.landing import Floats, Lens
from domeshim.lens.orientation import Orientation
from domeshim.lens.radial import RadialLens
from domeshim.window.frame import Frame, Rectangle

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


def draw_card(frame: Frame, options: Options) -> Image.Image:
    """The test card of a dome or another screen, as large as the frame: one in each of its pictures."""
    size = frame.size
    scale = max(1, min(4, _LARGEST // max(size)))
    lens, orientation = lens_chosen(options), Orientation.of(options)
    image = Image.new("RGB", (size[0] * scale, size[1] * scale), _BACKGROUND)
    for square in frame.squares:
        canvas = _Canvas(image, frame, square, scale)
        canvas.outline(_FINE)
        card = _DomeCard if isinstance(lens, RadialLens) else _ScreenCard
        card(canvas, lens, orientation).draw()
        canvas.caption(_caption(options), _STRONG)
    return image.resize(size, Image.Resampling.BOX)


def _caption(options: Options) -> str:
    kind, numbers = options.surface
    lines = [f"{options.lens[0]}  fov {options.fov:g}"]
    if kind == "cylinder":
        lines = ["cylinder {:g}  from {:g} to {:g}".format(*numbers)]
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
    """One of a frame's pictures, several times as large as wanted, drawn on by places in it."""

    def __init__(self, image: Image.Image, frame: Frame, square: Rectangle, scale: int) -> None:
        self._image = image
        self._frame, self._square, self._scale = frame, square, scale
        side = min(square[2:])
        self.unit = np.array(square[2:]) / 2 * scale
        """Pixels from the middle to the sides."""
        self._draw = ImageDraw.Draw(image)
        self.pen = max(1.0, side / 1000) * scale
        self._font = ImageFont.load_default(max(9.0, side / 55) * scale)

    def pixels(self, disc: Floats) -> Floats:
        """(..., 2) on the disc -> (..., 2) of the picture, from its top left."""
        places = self._frame.place_of(disc, self._square) * self._scale
        return np.asarray(places * (1, -1) + (0, self._image.height), float)

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
class _Card(ABC):
    """What the cards of all screens have: the program's own directions."""

    canvas: _Canvas
    lens: Lens
    orientation: Orientation

    @abstractmethod
    def draw(self) -> None:
        """Draw all, from the back to the front."""

    @abstractmethod
    def shown(self, rays: Floats) -> Floats:
        """(n, 2) where rays land; nan where the picture does not show them."""

    def of_program(self, directions: Floats) -> Floats:
        """(n, 2) where directions of the program's view land."""
        return self.shown(self.orientation.aimed(directions))

    def curve(self, places: Floats, bold: bool) -> None:
        """Draw a line of the screen's own grid."""
        self.canvas.line(places, _STRONG if bold else _FINE, 1.5 if bold else 1.0)

    def planes(self) -> None:
        """The program's horizon, and its vertical from ahead to behind."""
        turn = np.linspace(-np.pi, np.pi, 1441)
        still = np.zeros_like(turn)
        for aside, up in ((np.sin(turn), still), (still, np.sin(turn))):
            self.canvas.line(self.of_program(np.stack([aside, up, -np.cos(turn)], -1)), _PROGRAM, 1.5)

    def centre(self, size: Floats) -> None:
        """A cross with a circle in the picture's middle; size: (2,), of the long arm each way."""
        turn = np.linspace(-np.pi, np.pi, 91)
        for cross in ([[-1, 0], [1, 0]], [[0, -1], [0, 1]]):
            self.canvas.line(np.array(cross) * size, _RIM, 2.0)
        self.canvas.line(np.stack([np.cos(turn), np.sin(turn)], -1) * size / 2, _RIM, 1.5)

    def ways(self, above: float) -> None:
        """The names of the program's directions, a little above them."""
        for name, direction in _WAYS.items():
            self.label(self.of_program(np.array([direction]))[0] + np.array((0.0, above)), name, _PROGRAM)

    @abstractmethod
    def label(self, place: Floats, text: str, color: tuple[int, int, int]) -> None:
        """Write at a place, (2,), if the picture shows it, and away from its edge."""


class _DomeCard(_Card):
    """Rings and meridians of a dome, where a fisheye puts them."""

    lens: RadialLens

    def draw(self) -> None:
        """As for _Card."""
        rings = range(_STEP, int(np.degrees(np.pi)) + 1, _STEP)
        around = np.linspace(-np.pi, np.pi, 721)
        for ring in rings:
            self.curve(self._of_dome(np.radians(ring), around), ring % (_BOLD * _STEP) == 0)
        for meridian in range(0, 360, _STEP):
            bold = meridian % (_BOLD * _STEP) == 0
            nearest = 0 if meridian % 90 == 0 else _STEP if bold else _BOLD * _STEP
            outward = np.radians(np.linspace(nearest, 179.9, 500))
            self.curve(self._of_dome(outward, np.radians(meridian)), bold)
        self.planes()
        self._edge()
        self._labels(rings)

    def _of_dome(self, phi: Floats | float, theta: Floats | float) -> Floats:
        """(n, 2) where points of the dome land, by their angle from its pole, and that on the disc."""
        phi, theta = np.broadcast_arrays(phi, theta)
        points = np.stack([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), -np.cos(phi)], -1)
        return self.shown(self.orientation.thrown(points))

    def shown(self, rays: Floats) -> Floats:
        """As for _Card: nan beyond the rim."""
        disc = self.lens.landed(rays)
        phi = np.arctan2(np.hypot(rays[..., 0], rays[..., 1]), -rays[..., 2])
        radius = np.hypot(disc[..., 0], disc[..., 1])
        beyond = (phi > self.lens.half + 1e-9) | (radius > self.lens.rim + 1e-9)
        return np.where(beyond[..., None], np.nan, disc)

    def _edge(self) -> None:
        rim, turn = self.lens.rim, np.linspace(-np.pi, np.pi, 1441)
        inset = self.canvas.pen / self.canvas.unit[0]
        self.canvas.line(np.stack([np.cos(turn), np.sin(turn)], -1) * (rim - inset), _RIM, 2.0)
        for angle in np.radians(np.arange(0, 360, 5)):
            long = 0.03 if round(np.degrees(angle)) % 90 == 0 else 0.015
            way = np.array([np.cos(angle), np.sin(angle)])
            self.canvas.line(np.stack([way * (rim - long), way * rim]), _RIM, 2.0)
        self.centre(np.array([0.03, 0.03]))

    def _labels(self, rings: range) -> None:
        for ring in rings:
            for theta in np.radians((45, 135, 225, 315)):
                place = self._of_dome(np.radians(ring), theta)
                if np.hypot(*place) < self.lens.rim - _MARGIN:
                    self.label(place, f"{ring}", _STRONG)
        for azimuth in range(0, 360, _BOLD * _STEP):
            # As in a dome master: 0 is the front, at the bottom; 90 is to the right.
            theta = np.radians(azimuth - 90)
            meridian = self._of_dome(np.linspace(0, np.pi, 1801), theta)
            seen = meridian[~np.isnan(meridian).any(-1)]
            if len(seen):
                self.label(seen[-1], f"{azimuth}\N{DEGREE SIGN}", _RIM)
        self.ways(0.03)

    def label(self, place: Floats, text: str, color: tuple[int, int, int]) -> None:
        """As for _Card: within the ticks of its rim."""
        if not np.isnan(place).any():
            inward = (self.lens.rim - _MARGIN) / max(float(np.hypot(*place)), 1e-9)
            self.canvas.words(place * min(1.0, inward), text, color)


class _ScreenCard(_Card):
    """Azimuths and elevations of an upright screen around the viewer."""

    def draw(self) -> None:
        """As for _Card."""
        along = np.linspace(-180, 180, 1441)
        azimuths = range(-180, 181, _STEP)
        elevations = range(-80, 81, _STEP)
        for azimuth in azimuths:
            self.curve(self._of_screen(azimuth, np.linspace(-85, 85, 171)), azimuth % (_BOLD * _STEP) == 0)
        for elevation in elevations:
            self.curve(self._of_screen(along, elevation), elevation % (_BOLD * _STEP) == 0)
        self.planes()
        inset = 1 - self.canvas.pen / self.canvas.unit
        self.canvas.line(np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]]) * inset, _RIM, 2.0)
        self.centre(0.03 * self.canvas.unit.min() / self.canvas.unit)
        for azimuth in azimuths:
            if azimuth % (_BOLD * _STEP) == 0:
                self.label(self._of_screen(azimuth, -_STEP / 2), f"{azimuth}\N{DEGREE SIGN}", _STRONG)
        for elevation in elevations:
            self.label(self._of_screen(_STEP / 2, elevation), f"{elevation}\N{DEGREE SIGN}", _STRONG)
        self.ways(0.06)

    def _of_screen(self, azimuth: Floats | float, elevation: Floats | float) -> Floats:
        """(n, 2) where places of the screen land, degrees."""
        azimuth, height = np.broadcast_arrays(np.radians(azimuth), np.tan(np.radians(elevation)))
        return self.shown(np.stack([np.sin(azimuth), height, -np.cos(azimuth)], -1))

    def shown(self, rays: Floats) -> Floats:
        """As for _Card: nan outside the frame."""
        places = self.lens.landed(rays)
        beyond = np.abs(places).max(-1, keepdims=True) > 1 + 1e-9
        return np.where(beyond, np.nan, places)

    def label(self, place: Floats, text: str, color: tuple[int, int, int]) -> None:
        """As for _Card."""
        if not np.isnan(place).any():
            margin = _MARGIN * self.canvas.unit.min() / self.canvas.unit
            self.canvas.words(np.clip(place, margin - 1, 1 - margin), text, color)


def _unbroken(disc: Floats) -> Iterator[Floats]:
    """The stretches of a line without nan, of two points or more."""
    shown = np.isfinite(disc).all(-1).reshape(-1)
    starts = np.flatnonzero(np.diff(shown, prepend=False).astype(bool) & shown)
    for start in starts:
        length = int(np.argmin(np.append(shown[start:], False)))
        if length > 1:
            yield disc[start : start + length]
