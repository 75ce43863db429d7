"""The intercepted names of OpenGL.GL: what each call means to the dome, before or after it goes on to GL."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from domeshim.intercept.dome import Dome
from domeshim.state.perspective import frustum, is_perspective, perspective_part
from domeshim.state.scene import GROUP_OF

if TYPE_CHECKING:
    from domeshim.session import Session

Call = Callable[..., Any]

_DRAWS = re.compile(
    r"gl(Begin|Rect(|[dfis]v?)|Draw(Arrays|Elements|RangeElements|Pixels)\w*|MultiDraw\w+|EvalMesh[12]|Bitmap|CopyPixels"
    r"|(Raster|Window)Pos\d?[dfis]?v?)(ARB|EXT)?"
)
_LIGHTING = re.compile(r"gl(Light(|[fi]v?)|LightModel(|[fi]v?)|ColorMaterial)")
_TEXTURES = re.compile(r"glTexGen(|[dfi]v?)")
_REST = re.compile(r"gl(Fog(|[fi]v?)|PointParameter(|[fi]v?))(ARB|EXT)?")
_LOADS = re.compile(r"gl(Load|Mult)(Transpose)?Matrix[df]?(ARB)?")
_GETS = re.compile(r"glGet(Boolean|Double|Float|Integer)(v|)|glIsEnabled")
_READS = re.compile(r"glReadPixels\w*|glCopyTex\w+|glAccum|glClear")

_TOUCHED = frozenset(
    (
        0x0BA2,  # GL_VIEWPORT
        0x0C10,  # GL_SCISSOR_BOX
        0x0C11,  # GL_SCISSOR_TEST
        0x8B8D,  # GL_CURRENT_PROGRAM
        0x8458,  # GL_COLOR_SUM
        0x8643,  # GL_VERTEX_PROGRAM_TWO_SIDE
        0x8642,  # GL_VERTEX_PROGRAM_POINT_SIZE
        0x8C89,  # GL_RASTERIZER_DISCARD
        *range(0x3000, 0x3008),  # GL_CLIP_PLANEi
    )
)
"""What the dome changes while it draws: before the program asks for one of these it is put back."""


def replacements(session: Session, module: ModuleType) -> dict[str, Call]:
    """Our function for each name of OpenGL.GL that means something to the session, or to its dome."""
    ours = _frame_calls(session, module)
    dome = session.dome
    if isinstance(dome, Dome):
        for name, original in vars(module).items():
            if name.startswith("gl") and callable(original):
                call = _dome_call(dome, name, ours.get(name, original))
                if call is not None:
                    ours[name] = call
    for name, call in ours.items():
        call.__name__ = name
        call.__doc__ = getattr(vars(module)[name], "__doc__", None)
    return ours


def _frame_calls(session: Session, module: ModuleType) -> dict[str, Call]:
    """The calls by which a picture begins and ends, on the monitor as on the dome."""
    gl_flush, gl_finish, gl_clear = module.glFlush, module.glFinish, module.glClear

    def flush() -> None:
        gl_flush()
        session.flushed()

    def finish() -> None:
        gl_finish()
        session.flushed()

    def clear(mask: int) -> None:
        session.clearing()
        gl_clear(mask)

    return {"glFlush": flush, "glFinish": finish, "glClear": clear}


def _dome_call(dome: Dome, name: str, original: Call) -> Call | None:
    """What the dome does around one name of GL; None where the call means nothing to it."""
    special = _SPECIAL.get(name)
    if special is not None:
        return special(dome, original)
    for pattern, make in _FAMILIES.items():
        if pattern.fullmatch(name):
            return make(dome, original)
    return None


def _draw(dome: Dome, original: Call) -> Call:
    def call(*args: Any, **named: Any) -> Any:
        if dome.context is not None:
            dome.context.dress()
        return original(*args, **named)

    return call


def _read(dome: Dome, original: Call) -> Call:
    def call(*args: Any, **named: Any) -> Any:
        if dome.context is not None:
            dome.context.undress()
        return original(*args, **named)

    return call


def _get(dome: Dome, original: Call) -> Call:
    def call(name: int, *args: Any) -> Any:
        if name in _TOUCHED and dome.context is not None:
            dome.context.undress()
        return original(name, *args)

    return call


def _staling(group: str) -> Callable[[Dome, Call], Call]:
    def make(dome: Dome, original: Call) -> Call:
        def call(*args: Any, **named: Any) -> Any:
            if dome.context is not None:
                dome.context.scene.stale.add(group)
            return original(*args, **named)

        return call

    return make


def _switch(dome: Dome, original: Call) -> Call:
    """glEnable and glDisable."""

    def call(capability: int, *args: Any) -> Any:
        group = GROUP_OF.get(capability)
        if group is not None and dome.context is not None:
            dome.context.undress()
            dome.context.scene.stale.add(group)
        return original(capability, *args)

    return call


def _active_texture(dome: Dome, original: Call) -> Call:
    def call(texture: int) -> Any:
        if dome.context is not None:
            scene = dome.context.scene
            scene.texture_units = max(scene.texture_units, int(texture) - 0x84C0 + 1)
        return original(texture)

    return call


def _viewport(dome: Dome, original: Call) -> Call:
    def call(*args: Any, **named: Any) -> Any:
        if dome.context is not None:
            dome.context.undress()
            dome.context.viewport_changed()
        return original(*args, **named)

    return call


def _matrix_mode(dome: Dome, original: Call) -> Call:
    def call(mode: int) -> Any:
        if dome.context is not None:
            dome.context.matrix_mode_changed(int(mode))
        return original(mode)

    return call


def _frustum(dome: Dome, original: Call) -> Call:
    def call(left: float, right: float, bottom: float, top: float, zNear: float, zFar: float) -> Any:
        if dome.context is not None:
            dome.context.perspective_set(frustum(left, right, bottom, top, zNear, zFar))
        return original(left, right, bottom, top, zNear, zFar)

    return call


def _load_matrix(transposed: bool) -> Callable[[Dome, Call], Call]:
    def make(dome: Dome, original: Call) -> Call:
        def call(m: Any) -> Any:
            context = dome.context
            if context is not None and context.on_projection:
                matrix = np.array(m, float).reshape(4, 4)
                matrix = matrix if transposed else matrix.T
                if is_perspective(matrix):
                    context.perspective_set(perspective_part(matrix))
            return original(m)

        return call

    return make


def _new_list(dome: Dome, original: Call) -> Call:
    def call(name: int, mode: int) -> Any:
        context = dome.context
        if context is not None:
            if mode == _COMPILE_AND_EXECUTE:
                context.dress()
            else:
                context.undress()
            context.compiling = True
        return original(name, mode)

    return call


def _end_list(dome: Dome, original: Call) -> Call:
    def call() -> Any:
        result = original()
        if dome.context is not None:
            dome.context.compiling = False
            dome.context.anything_changed()
        return result

    return call


def _call_list(dome: Dome, original: Call) -> Call:
    def call(*args: Any, **named: Any) -> Any:
        context = dome.context
        if context is None:
            return original(*args, **named)
        context.dress()
        result = original(*args, **named)
        if not context.compiling:
            context.anything_changed()
        return result

    return call


def _attributes(dome: Dome, original: Call) -> Call:
    """glPushAttrib and glPopAttrib: they must see the program's own state, and may change any."""

    def call(*args: Any) -> Any:
        context = dome.context
        if context is None:
            return original(*args)
        context.undress()
        result = original(*args)
        context.anything_changed()
        return result

    return call


def _use_program(dome: Dome, original: Call) -> Call:
    def call(program: Any) -> Any:
        context = dome.context
        if context is not None:
            context.bypass("program", bool(program))
            if program:
                context.say_once(
                    "the program's own GLSL shaders are not bent onto the dome; they draw as on the monitor"
                )
        return original(program)

    return call


def _render_mode(dome: Dome, original: Call) -> Call:
    """GL_SELECT and GL_FEEDBACK answer in the monitor's terms: the dome stays out of them."""

    def call(mode: int) -> Any:
        if dome.context is not None:
            dome.context.bypass("render mode", mode != _RENDER)
        return original(mode)

    return call


_COMPILE_AND_EXECUTE, _RENDER = 0x1301, 0x1C00

_SPECIAL: Mapping[str, Callable[[Dome, Call], Call]] = {
    "glEnable": _switch,
    "glDisable": _switch,
    "glActiveTexture": _active_texture,
    "glActiveTextureARB": _active_texture,
    "glViewport": _viewport,
    "glScissor": _viewport,
    "glMatrixMode": _matrix_mode,
    "glFrustum": _frustum,
    "glNewList": _new_list,
    "glEndList": _end_list,
    "glCallList": _call_list,
    "glCallLists": _call_list,
    "glPushAttrib": _attributes,
    "glPopAttrib": _attributes,
    "glUseProgram": _use_program,
    "glUseProgramObjectARB": _use_program,
    "glRenderMode": _render_mode,
    **{
        f"gl{what}TransposeMatrix{t}": _load_matrix(transposed=True)
        for what in ("Load", "Mult")
        for t in ("d", "f")
    },
}
_FAMILIES: Mapping[re.Pattern[str], Callable[[Dome, Call], Call]] = {
    _DRAWS: _draw,
    _LIGHTING: _staling("lighting"),
    _TEXTURES: _staling("textures"),
    _REST: _staling("rest"),
    _LOADS: _load_matrix(transposed=False),
    _GETS: _get,
    _READS: _read,
}
