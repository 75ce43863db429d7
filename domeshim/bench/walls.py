"""Textured surroundings, and the colour that a ray from the eye meets in them: float64, by geometry alone."""

from __future__ import annotations

import numpy as np

from domeshim.bench.meshes import Bytes, Floats, Mesh, grid
from domeshim.measure.room import FACES, cast

TEXELS = 512
_FACETS, _ROWS, _RADIUS, _HEIGHT = 50, 50, 10.0, 12.0
"""The panorama: quads around and up, the distance of their corners from the axis, half the height."""


def colours(surface: int, s: Floats, t: Floats) -> Floats:
    """(..., 3), 0 to 1: what is painted at texture coordinates: waves many texels long."""
    waves = np.stack([np.sin(2 * np.pi * k * x) for k, x in ((5, s), (6, t), (4, s + t))], -1)
    return np.asarray(0.5 + 0.4 * waves + 0.1 * np.cos(surface + np.arange(3)))


def painted(surface: int) -> Bytes:
    """A surface's texture."""
    across = (np.arange(TEXELS) + 0.5) / TEXELS
    return np.rint(255 * colours(surface, *np.meshgrid(across, across))).astype(np.uint8)


def room() -> list[Mesh]:
    """Six quads around the eye, one wall each."""
    square = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], np.float32)
    quad = np.arange(4, dtype=np.uint32)[None]
    return [
        Mesh(corners.astype(np.float32), quad, texcoords=square, texture=painted(face))
        for face, corners in enumerate(FACES)
    ]


def look_in_room(directions: Floats) -> Floats:
    """(..., 3) directions -> (..., 3) colours, 0 to 1, of the room's walls."""
    return cast(directions, colours)


def panorama() -> Mesh:
    """A cylinder of 50 x 50 flat quads around the eye, open above and below."""
    s, t = np.meshgrid(np.linspace(0, 1, _FACETS + 1), np.linspace(0, 1, _ROWS + 1))
    around = 2 * np.pi * s
    points = np.stack([_RADIUS * np.cos(around), _HEIGHT * (2 * t - 1), _RADIUS * np.sin(around)], -1)
    return Mesh(
        points.reshape(-1, 3).astype(np.float32),
        grid(_FACETS, _ROWS),
        texcoords=np.stack([s, t], -1).reshape(-1, 2).astype(np.float32),
        texture=painted(0),
    )


def look_at_panorama(directions: Floats) -> Floats:
    """(..., 3) directions -> (..., 3) colours, 0 to 1, of the panorama's facets; black where it is open."""
    x, y, z = np.moveaxis(np.asarray(directions, float), -1, 0)
    step = 2 * np.pi / _FACETS
    turn = np.mod(np.arctan2(z, x), 2 * np.pi)
    facet = np.floor(turn / step)
    off = turn - (facet + 0.5) * step
    middle = _RADIUS * np.cos(step / 2)
    with np.errstate(divide="ignore", invalid="ignore"):
        height = y * middle / (np.cos(off) * np.hypot(x, z))
    s = (facet + 0.5 + np.tan(off) / np.tan(step / 2) / 2) / _FACETS
    t = (height / _HEIGHT + 1) / 2
    return np.where((np.abs(height) <= _HEIGHT)[..., None], colours(0, s, np.nan_to_num(t)), 0.0)
