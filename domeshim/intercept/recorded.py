"""glBegin, glEnd, and what the program calls between them that is no plain attribute."""

from __future__ import annotations

import copy
import re
from collections.abc import Callable
from typing import Any

from domeshim.intercept.dome import Dome
from domeshim.record.attributes import material as material_parts

Call = Callable[..., Any]

_QUADS = 7
_LEGAL = re.compile(r"gl(EvalCoord|EvalPoint|ArrayElement|CallLists?|VertexAttrib|Index)\w*")


def begin(dome: Dome, _original: Call) -> Call:
    """glBegin."""
    recorder = dome.recorder

    def call(mode: int) -> None:
        if recorder.block is None:
            recorder.begin(mode)
        else:
            refuse(dome)

    return call


def end(dome: Dome, original: Call) -> Call:
    """glEnd."""
    recorder = dome.recorder

    def call() -> None:
        if recorder.block is None:
            original()  # GL's own error
            return
        recorder.end()
        if recorder.blocks and recorder.blocks[-1].extras:
            dome.flush()  # what they read, arrays say, may be another soon

    return call


def rectangle(dome: Dome, *, vector: bool) -> Call:
    """glRect."""
    recorder = dome.recorder

    def corners(x1: float, y1: float, x2: float, y2: float, *_more: object) -> None:
        if recorder.block is not None:
            refuse(dome)
            return
        recorder.begin(_QUADS)
        recorder.positions.extend((x1, y1, 0.0, x2, y1, 0.0, x2, y2, 0.0, x1, y2, 0.0))
        recorder.end()

    def vectors(v1: Any, v2: Any) -> None:
        corners(v1[0], v1[1], v2[0], v2[1])

    return vectors if vector else corners


def within(dome: Dome, name: str, call: Call, /, *args: Any, **named: Any) -> Any:
    """Make a call of this name between glBegin and glEnd; GL refuses most of them there."""
    if name.startswith("glMaterial"):
        return _material(dome, name, call, *args, **named)
    if _LEGAL.fullmatch(name):
        kept = copy.deepcopy(args)  # arrays may hold other numbers by glEnd
        return dome.recorder.inside(lambda: call(*kept, **named), evaluates=name.startswith("glEval"))
    if name.startswith("gl") and not name.startswith("glu"):
        return refuse(dome)
    return call(*args, **named)


def refuse(dome: Dome) -> None:
    """Leave the error in GL that a call between glBegin and glEnd leaves there: GL_INVALID_OPERATION."""
    if dome.context is not None:
        dome.context.driver.glEnd()  # GL itself is outside glBegin..glEnd, where glEnd is as wrong


def _material(dome: Dome, name: str, call: Call, /, face: int, pname: int, *params: Any) -> None:
    recorder = dome.recorder
    block = recorder.block
    assert block is not None
    if recorder.on_border:
        recorder.end()
        dome.flush()
        if dome.building is not None:
            dome.building.used = True
        call(face, pname, *params)
        recorder.begin(block.mode)
        return
    values = params[0] if len(params) == 1 and hasattr(params[0], "__getitem__") else params
    recorder.material(material_parts(name, int(face), int(pname), values))
