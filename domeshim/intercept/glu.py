"""The intercepted names of OpenGL.GLU: perspectives are noted, and what draws from C is drawn on the dome."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from functools import cache
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from domeshim.intercept import evaluators, gl
from domeshim.intercept.dome import Dome
from domeshim.intercept.state_calls import draw, kept_in_lists, read
from domeshim.state.perspective import perspective

if TYPE_CHECKING:
    from domeshim.session import Session

Call = Callable[..., Any]


def replacements(session: Session, module: ModuleType) -> dict[str, Call]:
    """Our function for each name of OpenGL.GLU that means something to the dome."""
    dome = session.dome
    if not isinstance(dome, Dome):
        return gl.drawing_calls(session, module, _DRAWS)
    ours = {
        name: gl.after_recorded(dome, name, _CALLS[name](dome, original) if name in _CALLS else original)
        for name, original in vars(module).items()
        if name.startswith("glu") and callable(original) and name not in _UNSEEN
    }
    return ours | _quadrics(dome, dict(vars(module)), unseen=ours)


def _quadrics(dome: Dome, originals: Mapping[str, Call], unseen: Mapping[str, Call]) -> dict[str, Call]:
    """Our functions for the names of quadrics, made when the program calls the first."""

    @cache
    def made() -> dict[str, Call]:
        from domeshim.intercept.quadrics.calls import quadric_calls  # noqa: PLC0415 - only who draws them pays

        return quadric_calls(dome, originals, unseen)

    def late(name: str) -> Call:
        def call(*args: Any, **named: Any) -> Any:
            return made()[name](*args, **named)

        return call

    return {name: late(name) for name in originals if _OF_QUADRICS.fullmatch(name)}


def _perspective(dome: Dome, original: Call) -> Call:
    def call(fovy: float, aspect: float, zNear: float, zFar: float, *_more: object) -> Any:
        if dome.context is not None:
            dome.context.perspective_set(perspective(fovy, aspect, zNear, zFar))
        return original(fovy, aspect, zNear, zFar)

    return call


def _look_at(dome: Dome, original: Call) -> Call:
    def call(*args: float) -> Any:
        if dome.context is not None and len(args) == 9:
            dome.look(np.reshape(np.array(args, float), (3, 3)))
        return original(*args)

    return call


_OF_QUADRICS = re.compile(
    r"glu((New|Delete)Quadric|Quadric(DrawStyle|Normals|Orientation|Texture)|Sphere|Cylinder|Disk|PartialDisk)"
)
_DRAWS = re.compile(r"glu(Sphere|Cylinder|Disk|PartialDisk|EndCurve|EndSurface)")
_UNSEEN = frozenset(("gluErrorString", "gluGetString", "gluNewQuadric", "gluNewTess", "gluNewNurbsRenderer"))
_CALLS: Mapping[str, Callable[[Dome, Call], Call]] = {
    "gluPerspective": kept_in_lists(_perspective),
    "gluLookAt": kept_in_lists(_look_at),
    **dict.fromkeys(("gluSphere", "gluCylinder", "gluDisk", "gluPartialDisk"), draw),
    **dict.fromkeys(("gluBeginCurve", "gluBeginSurface"), evaluators.nurbs_begin),
    "gluNurbsCurve": evaluators.nurbs_whole(curve=True),
    "gluNurbsSurface": evaluators.nurbs_whole(curve=False),
    "gluEndCurve": evaluators.nurbs(curve=True),
    "gluEndSurface": evaluators.nurbs(curve=False),
    **dict.fromkeys(("gluProject", "gluUnProject", "gluUnProject4", "gluPickMatrix"), read),
}
