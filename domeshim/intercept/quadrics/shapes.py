"""Sphere, cylinder and disk as the SGI and Mesa GLU (9.0) draws them, strip by strip and in its order.

What they draw was taken down from that library call by call. Where it reads memory that it never wrote (the
normals of flat-shaded points and silhouettes, and of the lower pole where there are more stacks than slices)
the values here are those of the nearest case that it defines.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from domeshim.intercept.quadrics.figure import (
    LINE_STRIP,
    POINTS,
    QUAD_STRIP,
    TRIANGLE_FAN,
    Numbers,
    Part,
    Surface,
    run_of,
)
from domeshim.record.runs import Run

POINT, LINE, FILL, SILHOUETTE = 100010, 100011, 100012, 100013
SMOOTH, FLAT, NONE = 100000, 100001, 100002
OUTSIDE, INSIDE = 100020, 100021
_MOST = 239
"""GLU's tables hold no more slices, nor a sphere's more stacks; larger numbers become this one."""


@dataclass(frozen=True)
class Settings:
    """What a quadric object is set to; at first as gluNewQuadric leaves it."""

    style: int = FILL
    normals: int = SMOOTH
    orientation: int = OUTSIDE
    texture: int = 0


def sphere(settings: Settings, radius: float, slices: int, stacks: int) -> Run | None:
    """A ball about the origin, its poles on z; None for numbers that GLU refuses."""
    if slices < 2 or stacks < 1 or radius < 0:
        return None
    slices, stacks = min(slices, _MOST), min(stacks, _MOST)
    outward = 1.0 if settings.orientation == OUTSIDE else -1.0

    def direction(u: Numbers, v: Numbers) -> Numbers:
        turn, down = 2 * np.pi * (u % slices) / slices, np.pi * v / stacks
        ring = np.sin(down) * (v != stacks)
        return _stacked(ring * np.sin(turn), ring * np.cos(turn), np.cos(down))

    surface = Surface(
        place=lambda u, v: radius * direction(u, v),
        normal=lambda u, v: outward * direction(u, v),
        texture=lambda u, v: _stacked(1 - u / slices, 1 - v / stacks),
    )
    return _run(settings, surface, list(_sphere_parts(settings, slices, stacks)))


def cylinder(
    settings: Settings, base: float, top: float, height: float, slices: int, stacks: int
) -> Run | None:
    """An open tube from z = 0 to z = height; None for numbers that GLU refuses."""
    length = float(np.hypot(base - top, height))
    if slices < 2 or stacks < 1 or base < 0 or top < 0 or height < 0 or length == 0:
        return None
    slices = min(slices, _MOST)
    outward = 1.0 if settings.orientation == OUTSIDE else -1.0

    def place(u: Numbers, v: Numbers) -> Numbers:
        turn, radius = 2 * np.pi * (u % slices) / slices, base - (base - top) * v / stacks
        return _stacked(radius * np.sin(turn), radius * np.cos(turn), height * v / stacks)

    def normal(u: Numbers, v: Numbers) -> Numbers:
        turn, across = 2 * np.pi * (u % slices) / slices, outward * height / length
        rise = np.full_like(turn, (base - top) / length)  # not turned round inside: so GLU has it
        return _stacked(across * np.sin(turn), across * np.cos(turn), rise + 0 * v)

    surface = Surface(place, normal, lambda u, v: _stacked(1 - u / slices, v / stacks))
    return _run(settings, surface, list(_cylinder_parts(settings, slices, stacks)))


def disk(
    settings: Settings,
    inner: float,
    outer: float,
    slices: int,
    loops: int,
    start: float = 0.0,
    sweep: float = 360.0,
) -> Run | None:
    """A disk on z = 0, or part of one, angles in degrees from +y towards +x; None for what GLU refuses."""
    if slices < 2 or loops < 1 or outer <= 0 or inner < 0 or inner > outer:
        return None
    slices = min(slices, _MOST)
    if not -360 <= sweep <= 360:
        sweep = 360.0
    if sweep < 0:
        start, sweep = start + sweep, -sweep
    whole = sweep == 360
    facing = 1.0 if settings.orientation == OUTSIDE else -1.0

    def flat(u: Numbers, v: Numbers) -> Numbers:
        turn = np.radians(start + sweep * (u % slices if whole else u) / slices)
        radius = outer - (outer - inner) * v / loops
        return _stacked(radius * np.sin(turn), radius * np.cos(turn))

    def place(u: Numbers, v: Numbers) -> Numbers:
        xy = flat(u, v)
        return np.concatenate([xy, np.zeros_like(xy[..., :1])], -1)

    surface = Surface(
        place,
        normal=lambda u, _: _stacked(0 * u, 0 * u, np.full_like(u, facing)),
        texture=lambda u, v: flat(u, v) / outer / 2 + 0.5,
    )
    parts = _disk_parts(settings, slices, loops, whole=whole, inner=inner, outer=outer)
    return _run(settings, surface, list(parts))


def _run(settings: Settings, surface: Surface, parts: list[Part]) -> Run:
    return run_of(surface, parts, normals=settings.normals != NONE, texture=bool(settings.texture))


def _sphere_parts(settings: Settings, slices: int, stacks: int) -> Iterator[Part]:
    around, along = np.arange(slices + 1.0), np.arange(stacks + 1.0)
    flat = settings.normals == FLAT
    if settings.style == FILL:
        if not settings.texture:
            yield _cap(settings, slices, pole=0.0, ring=1.0)
            yield _cap(settings, slices, pole=float(stacks), ring=stacks - 1.0)
        bands = along[:-1] if settings.texture else along[1:-2]
        outside = settings.orientation == OUTSIDE
        u = np.repeat(around, 2)
        v = bands[:, None] + np.tile([1.0, 0.0] if outside else [0.0, 1.0], slices + 1)
        late = np.tile([np.nan, 0.0], slices + 1)  # a flat normal is set before the second of two vertices
        yield Part.of(QUAD_STRIP, (u, v), (u - 0.5 + late, bands[:, None] + 0.5) if flat else None)
    elif settings.style == POINT:
        yield Part.of(POINTS, (around[:-1], along[:, None]))
    else:
        parallels, meridians = (around, along[1:-1, None]), (around[:-1, None], along)
        yield Part.of(LINE_STRIP, parallels, (around - 0.5, parallels[1]) if flat else None)
        yield Part.of(LINE_STRIP, meridians, (meridians[0], along - 0.5) if flat else None)


def _cap(settings: Settings, slices: int, pole: float, ring: float) -> Part:
    """The fan about a pole, its rim in the sense that shows the right side."""
    around = np.arange(slices + 1.0)
    upwards = (pole == 0) == (settings.orientation == INSIDE)
    rim = around if upwards else around[::-1]
    u = np.concatenate([[0.0], rim])[None]
    v = np.concatenate([[pole], np.full(slices + 1, ring)])[None]
    if settings.normals != FLAT:
        return Part.of(TRIANGLE_FAN, (u, v))
    faces = rim - 0.5 if upwards else np.concatenate([[np.nan], rim[1:] + 0.5])
    middles = np.concatenate([[np.nan], faces])[None]
    return Part.of(TRIANGLE_FAN, (u, v), (middles, np.array((pole + ring) / 2)))


def _cylinder_parts(settings: Settings, slices: int, stacks: int) -> Iterator[Part]:
    around, along = np.arange(slices + 1.0), np.arange(stacks + 1.0)
    flat = settings.normals == FLAT
    if settings.style == FILL:
        u = np.repeat(around, 2)
        step = [0.0, 1.0] if settings.orientation == OUTSIDE else [1.0, 0.0]
        v = along[:-1, None] + np.tile(step, slices + 1)
        yield Part.of(QUAD_STRIP, (u, v), (u - 0.5, v) if flat else None)
    elif settings.style == POINT:
        yield Part.of(POINTS, (around[:-1, None], along))
    else:
        rings = np.concatenate([along[1:-1] if settings.style == LINE else [], along[[0, -1]]])[:, None]
        yield Part.of(LINE_STRIP, (around, rings), (around - 0.5, rings) if flat else None)
        yield Part.of(LINE_STRIP, (around[:-1, None], along), level=True)


def _disk_parts(
    settings: Settings, slices: int, loops: int, *, whole: bool, inner: float, outer: float
) -> Iterator[Part]:
    around, across = np.arange(slices + 1.0), np.arange(loops + 1.0)
    spokes = around[:-1, None] if whole else around[:, None]
    outside = settings.orientation == OUTSIDE
    if settings.style == FILL:
        if inner == 0:
            rim = around[::-1] if outside else around
            v = np.concatenate([across[-1:], np.full(slices + 1, loops - 1.0)])
            yield Part.of(TRIANGLE_FAN, (np.concatenate([[0.0], rim])[None], v))
        bands = across[:-2] if inner == 0 else across[:-1]
        v = bands[:, None] + np.tile([0.0, 1.0] if outside else [1.0, 0.0], slices + 1)
        yield Part.of(QUAD_STRIP, (np.repeat(around, 2), v))
    elif settings.style == POINT:
        yield Part.of(POINTS, (spokes, across))
    elif settings.style == LINE:
        yield Part.of(LINE_STRIP, (around, across[:1, None] if inner == outer else across[:, None]))
        if inner != outer:
            yield Part.of(LINE_STRIP, (spokes, across))
    else:
        if not whole:
            yield Part.of(LINE_STRIP, (spokes[[0, -1]], across))
        yield Part.of(LINE_STRIP, (around, across[:1, None] if inner == outer else across[[0, -1], None]))


def _stacked(*coordinates: Numbers) -> Numbers:
    return np.stack(np.broadcast_arrays(*coordinates), -1)
