"""The intercepted names of GLU's quadrics.

The objects stay GLU's own. What each is set to is noted as the calls pass, since GLU cannot be asked.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from ctypes import addressof
from dataclasses import replace
from functools import lru_cache
from operator import index
from typing import Any

from domeshim.draw.extent import Extent
from domeshim.draw.primitives import extent_of
from domeshim.intercept.dome import Dome
from domeshim.intercept.quadrics import shapes
from domeshim.intercept.quadrics.shapes import Settings
from domeshim.record.runs import Run

Call = Callable[..., Any]
Shape = Callable[..., Run | None]
Known = dict[int, Settings]
"""What each quadric object is set to, by its address."""

_SHAPES: Mapping[str, tuple[Shape, tuple[Callable[[Any], float], ...]]] = {
    "gluSphere": (shapes.sphere, (float, index, index)),
    "gluCylinder": (shapes.cylinder, (float, float, float, index, index)),
    "gluDisk": (shapes.disk, (float, float, index, index)),
    "gluPartialDisk": (shapes.disk, (float, float, index, index, float, float)),
}
"""What each call draws, and the kinds of its numbers."""

_SETTINGS: Mapping[str, tuple[str, range]] = {
    "gluQuadricDrawStyle": ("style", range(shapes.POINT, shapes.SILHOUETTE + 1)),
    "gluQuadricNormals": ("normals", range(shapes.SMOOTH, shapes.NONE + 1)),
    "gluQuadricOrientation": ("orientation", range(shapes.OUTSIDE, shapes.INSIDE + 1)),
    "gluQuadricTexture": ("texture", range(256)),
}
"""What each call sets, and what GLU takes; it leaves the setting as it was at anything else."""


def quadric_calls(dome: Dome, originals: Mapping[str, Call], unseen: Mapping[str, Call]) -> dict[str, Call]:
    """Our functions for the names of quadrics.

    unseen: how each is drawn that we know nothing of, because its object was made before ours were there.
    """
    known: Known = {}
    return {
        "gluNewQuadric": _new(originals["gluNewQuadric"], known),
        "gluDeleteQuadric": _delete(originals["gluDeleteQuadric"], known),
        **{name: _setting(name, originals[name], known) for name in _SETTINGS},
        **{name: _drawing(dome, name, originals[name], unseen[name], known) for name in _SHAPES},
    }


def _drawing(dome: Dome, name: str, original: Call, unseen: Call, known: Known) -> Call:
    shape, kinds = _SHAPES[name]

    @lru_cache(maxsize=64)
    def drawn(settings: Settings, *numbers: float) -> tuple[Run, Extent | None] | None:
        run = shape(settings, *numbers)
        return (run, extent_of(run)) if run is not None else None

    def call(quadric: Any, *numbers: Any) -> Any:
        settings = known.get(_address(quadric))
        if settings is None or dome.context is None:
            return unseen(quadric, *numbers)
        try:
            given = [kind(number) for kind, number in zip(kinds, numbers, strict=True)]
        except (TypeError, ValueError):
            return original(quadric, *numbers)  # which says what is wrong with them
        found = drawn(settings, *given)
        if found is None:
            return original(quadric, *numbers)  # which draws nothing, and calls the program's GLU_ERROR
        dome.draw_run(*found)
        return None

    return call


def _new(original: Call, known: Known) -> Call:
    def call(*_more: object) -> Any:
        quadric = original()
        known[_address(quadric)] = Settings()
        return quadric

    return call


def _delete(original: Call, known: Known) -> Call:
    def call(quadric: Any, *_more: object) -> Any:
        address = _address(quadric)
        result = original(quadric)
        known.pop(address, None)
        return result

    return call


def _setting(name: str, original: Call, known: Known) -> Call:
    field, taken = _SETTINGS[name]

    def call(quadric: Any, value: Any, *_more: object) -> Any:
        result = original(quadric, value)
        address = _address(quadric)
        settings = known.get(address)
        if settings is not None and value in taken:
            known[address] = replace(settings, **{field: int(value)})
        return result

    return call


def _address(quadric: Any) -> int:
    """Where GLU keeps the object: a pointer to it is given, or itself; 0 for anything else."""
    try:
        return addressof(getattr(quadric, "contents", quadric))
    except (TypeError, ValueError):
        return 0
