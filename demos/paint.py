"""Noise, colours and textures of which the demos make what they show; and where to keep it."""

import os
from itertools import product
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray
from OpenGL.GL import *
from OpenGL.GLU import *

Values = NDArray[np.float32]
SIDES = {2: 256, 3: 32}
"""Of the random lattice, by its dimensions; the noise repeats after so many units."""


def noise(points: ArrayLike, seed: int = 0, period: int | None = None) -> Values:
    """Smooth value noise, -1 to 1, at points (..., 2) or (..., 3); about one hill a unit."""
    points = np.asarray(points, np.float32)
    dimensions = points.shape[-1]
    side = SIDES[dimensions]
    period = side if period is None else min(period, side)
    lattice = np.random.default_rng(seed).uniform(-1.0, 1.0, (side,) * dimensions).astype(np.float32)
    whole = np.floor(points)
    part = points - whole
    part = part * part * part * (part * (part * 6.0 - 15.0) + 10.0)
    first = whole.astype(np.int32)
    total = np.zeros(points.shape[:-1], np.float32)
    for corner in product((0, 1), repeat=dimensions):
        weight = np.prod([part[..., i] if c else 1.0 - part[..., i] for i, c in enumerate(corner)], axis=0)
        total += weight * lattice[tuple((first[..., i] + c) % period for i, c in enumerate(corner))]
    return total


def fractal(
    points: ArrayLike, octaves: int, seed: int = 0, *, ridged: bool = False, period: int | None = None
) -> Values:
    """Noise at many scales, each half as large and half as strong as the one before, about -1 to 1.

    ridged: folded at zero, so that it stands in sharp crests. period: whole units after which it repeats.
    """
    points = np.asarray(points, np.float32)
    total = np.zeros(points.shape[:-1], np.float32)
    for octave in range(octaves):
        scale = 2**octave
        layer = noise(points * scale, seed + octave, period * scale if period else None)
        total += (1.0 - 2.0 * np.abs(layer) if ridged else layer) * 0.5**octave
    return total / (2.0 - 0.5 ** (octaves - 1))


def between(share: ArrayLike, colours: ArrayLike) -> Values:
    """Colours (..., 3) along a row of them, (n, 3): share 0 is the first, 1 the last."""
    row = np.asarray(colours, np.float32)
    at = np.clip(np.asarray(share), 0.0, 1.0) * (len(row) - 1)
    places = np.arange(len(row))
    return np.stack([np.interp(at, places, row[:, channel]) for channel in range(3)], -1).astype(np.float32)


def bytes_of(colours: ArrayLike) -> NDArray[np.uint8]:
    """Colours of 0 to 1 as GL takes them for a texture."""
    return np.ascontiguousarray(np.clip(np.asarray(colours) * 255.0 + 0.5, 0, 255), np.uint8)


def texture(colours: ArrayLike) -> int:
    """A texture that repeats, from (rows, columns, 3 or 4), the first row at the bottom; bytes, or 0 to 1."""
    colours = np.asarray(colours)
    texels = np.ascontiguousarray(colours) if colours.dtype == np.uint8 else bytes_of(colours)
    layout = GL_RGBA if texels.shape[-1] == 4 else GL_RGB
    rows, columns = texels.shape[:2]
    name = glGenTextures(1)
    glBindTexture(GL_TEXTURE_2D, name)
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    gluBuild2DMipmaps(GL_TEXTURE_2D, layout, columns, rows, layout, GL_UNSIGNED_BYTE, texels)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR)
    return name


def kept(name: str) -> Path:
    """Where in the user's cache folder the demos keep what took long to make."""
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "opengl-demos" / name
