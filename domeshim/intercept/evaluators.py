"""The intercepted calls that draw what GL or GLU evaluates: glEvalMesh1 and 2, the ends of NURBS."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from ctypes import c_float
from functools import partial
from typing import TYPE_CHECKING, Any

from domeshim.intercept.dome import Dome

if TYPE_CHECKING:
    from domeshim.draw.evaluated import Evaluated

Call = Callable[..., Any]
Maker = Callable[[Dome, Call], Call]

_KINDS: Mapping[int, Evaluated] = {0x1B01: "lines", 0x1B02: "triangles"}
"""What GL_LINE and GL_FILL make of a mesh; GL_POINT has no edges."""
_NURBS_MODE, _TESSELLATOR, _DISPLAY_MODE, _FILL = 100160, 100161, 100204, 100012


def mesh(dome: Dome, original: Call) -> Call:
    """glEvalMesh1 and glEvalMesh2."""

    def call(mode: int, *limits: int) -> Any:
        drawn = partial(original, mode, *limits)
        evaluated = dome.evaluated
        if evaluated is None:
            return drawn()
        return evaluated.draw_mesh(drawn, _KINDS.get(int(mode)), [int(limit) for limit in limits])

    return call


def nurbs(*, curve: bool) -> Maker:
    """gluEndCurve and gluEndSurface: they draw what was begun, and end it."""

    def make(dome: Dome, original: Call) -> Call:
        def call(nurb: Any, *more: Any) -> Any:
            drawn = partial(original, nurb, *more)
            if _asked(nurb, _NURBS_MODE) == _TESSELLATOR:
                return drawn()  # the program's own callbacks draw
            evaluated = dome.evaluated
            if evaluated is None:
                return drawn()
            evaluated.nurbs_begun = False
            surface: Evaluated = "triangles" if _asked(nurb, _DISPLAY_MODE) == _FILL else "outlines"
            return evaluated.draw_once(drawn, "lines" if curve else surface)

        return call

    return make


def nurbs_begin(dome: Dome, original: Call) -> Call:
    """gluBeginCurve and gluBeginSurface: nothing is drawn before the end."""

    def call(nurb: Any, *more: Any) -> Any:
        evaluated = dome.evaluated
        if evaluated is not None:
            evaluated.nurbs_begun = True
        return original(nurb, *more)

    return call


def nurbs_whole(*, curve: bool) -> Maker:
    """gluNurbsCurve and gluNurbsSurface: what is given before a beginning is begun and ended by GLU."""

    def make(dome: Dome, original: Call) -> Call:
        drawing = nurbs(curve=curve)(dome, original)

        def call(nurb: Any, *more: Any) -> Any:
            evaluated = dome.evaluated
            begun = evaluated is None or evaluated.nurbs_begun
            return (original if begun else drawing)(nurb, *more)

        return call

    return make


def _asked(nurb: Any, name: int) -> int:
    from OpenGL.raw.GLU import gluGetNurbsProperty  # noqa: PLC0415 - once the program has imported it

    value = c_float()
    gluGetNurbsProperty(nurb, name, value)
    return int(value.value)
