"""The intercepted names of OpenGL.GL: what each call means to the dome, before it goes on to GL.

Vertices and their attributes are recorded. Every other call first lets GL see what was recorded. Calls
that the dome must know of do their part; within glNewList they are kept for when the list is called.
"""

from __future__ import annotations

import copy
import re
from collections.abc import Callable, Mapping
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from domeshim.draw.accumulation import BUFFER_BIT as ACCUMULATION_BIT
from domeshim.draw.accumulation import Accumulation
from domeshim.driver import Driver
from domeshim.intercept import pixels, reading, recorded, shaders
from domeshim.intercept.arrays import draw_arrays, draw_elements, draw_range_elements, writes_buffer
from domeshim.intercept.dome import Dome
from domeshim.intercept.lists import call_list, call_lists, delete_lists, end_list, new_list
from domeshim.record.attributes import setter
from domeshim.state.perspective import frustum, is_perspective, perspective_part
from domeshim.state.scene import GROUP_OF

if TYPE_CHECKING:
    from domeshim.session import Session

Call = Callable[..., Any]
Maker = Callable[[Dome, Call], Call]

_DRAWS = re.compile(
    r"gl(Draw(Arrays|Elements|RangeElements)\w*|MultiDraw\w+|EvalMesh[12])"
)
_AT_RASTER = re.compile(r"gl(Bitmap|DrawPixels\w*|CopyPixels)")
_RASTER_POSITIONS = re.compile(r"glRasterPos\d?[dfis]?v?")
_WINDOW_POSITIONS = re.compile(r"glWindowPos\d[dfis]v?")
_LIGHTING = re.compile(r"gl(Light(|[fi]v?)|LightModel(|[fi]v?))")
_TEXTURES = re.compile(r"glTexGen(|[dfi]v?)")
_REST = re.compile(r"gl(Fog(|[fi]v?)|PointParameter(|[fi]v?))")
_LOADS = re.compile(r"gl(Load|Mult)(Transpose)?Matrix[df]?")
_GETS = re.compile(r"glGet(Boolean|Double|Float|Integer)(v|)|glIsEnabled")
_READ_PIXELS = re.compile(r"glReadPixels(b|d|f|i|s|ub|ui|us)?")
_READS = re.compile(r"glGetHandle|glReadPixels\w*|glCopyTex\w+")
_UNIFORMS = re.compile(r"glUniform\w+")
_RECTS = re.compile(r"glRect[dfis](v?)")
_UNSEEN = re.compile(r"glGetError|glGetString\w*|glCheckError|glInit\w+")
"""Neither changes anything nor depends on what was drawn."""

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
_SCISSOR_TEST = 0x0C11
_CURRENT_COLOR, _RENDER, _TEXTURE0, _PROJECTION = 0x0B00, 0x1C00, 0x84C0, 0x1701


def replacements(session: Session, module: ModuleType) -> dict[str, Call]:
    """Our function for each name of OpenGL.GL that means something to the session, or to its dome."""
    ours = _frame_calls(session, module)
    dome = session.dome
    if isinstance(dome, Dome):
        for name, original in vars(module).items():
            if name.startswith("gl") and callable(original) and not _UNSEEN.fullmatch(name):
                ours[name] = _dome_call(dome, name, ours.get(name, original))
    for name, call in ours.items():
        call.__name__ = name
        call.__doc__ = getattr(vars(module)[name], "__doc__", None)
    return ours


def _frame_calls(session: Session, module: ModuleType) -> dict[str, Call]:
    """The calls by which a picture begins and ends, on the monitor as on the dome."""
    originals = {
        name: vars(module)[name]
        for name in ("glFlush", "glFinish", "glClear", "glAccum")
        if name in vars(module)
    }

    def ending(original: Call) -> Call:
        def call() -> None:
            original()
            session.flushed()

        return call

    accumulation = Accumulation(Driver())

    def clearing(original: Call) -> Call:
        def call(mask: int) -> None:
            session.clearing()
            original(mask)
            if mask & ACCUMULATION_BIT and session.window is not None and accumulation.needed:
                accumulation.clear(session.window, session.window.size)

        return call

    def accumulating(original: Call) -> Call:
        def call(op: int, value: float) -> None:
            window = session.window
            if window is None or not accumulation.needed:
                original(op, value)
            else:
                accumulation.operate(window, window.size, int(op), float(value))

        return call

    makers = {"glClear": clearing, "glAccum": accumulating}
    return {name: makers.get(name, ending)(original) for name, original in originals.items()}


def _dome_call(dome: Dome, name: str, original: Call) -> Call:
    """What happens instead of one name of GL."""
    plain_name = name.removesuffix("ARB").removesuffix("EXT")
    recorder = dome.recorder
    attribute = setter(plain_name)
    if attribute is not None:
        return recorder.recording(attribute)
    if plain_name in ("glBegin", "glEnd"):
        return (recorded.begin if plain_name == "glBegin" else recorded.end)(dome, original)
    rectangle = _RECTS.fullmatch(plain_name)
    if rectangle:
        return recorded.rectangle(dome, vector=bool(rectangle[1]))
    return after_recorded(dome, plain_name, _meaning(dome, plain_name, original))


def _meaning(dome: Dome, name: str, original: Call) -> Call:
    """The call with what it means to the dome; the original where it means nothing."""
    make = _SPECIAL.get(name) or next((make for pattern, make in _FAMILIES if pattern.fullmatch(name)), None)
    return make(dome, original) if make is not None else original


def after_recorded(dome: Dome, name: str, call: Call) -> Call:
    """The call, once GL has seen what was recorded before it."""
    recorder, pending = dome.recorder, dome.recorder.pending()
    within = recorded.within(dome, name, call)
    listed = name != "glEndList"

    def after(*args: Any, **named: Any) -> Any:
        if pending():
            if recorder.block is not None:
                return within(*args, **named)
            dome.flush()
        if listed and dome.building is not None:
            dome.building.used = True
        return call(*args, **named)

    return after


# Passed on.


def kept_in_lists(make: Maker) -> Maker:
    """The call acts on the dome: while a display list is built it is kept in the list instead."""

    def making(dome: Dome, original: Call) -> Call:
        call = make(dome, original)

        def maybe_kept(*args: Any, **named: Any) -> Any:
            if dome.building is not None and dome.lists is not None:
                kept = copy.deepcopy(args)
                return dome.lists.keep(lambda: call(*kept, **named))
            return call(*args, **named)

        return maybe_kept

    return making


def _draw(dome: Dome, original: Call) -> Call:
    def call(*args: Any, **named: Any) -> Any:
        if dome.context is not None:
            dome.drawing()
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


def _color_material(dome: Dome, original: Call) -> Call:
    """glColorMaterial: the material keeps the colour that it followed, also one set since the last draw."""

    def call(*args: Any) -> Any:
        context = dome.context
        if context is not None:
            context.driver.integers(_CURRENT_COLOR, 4)  # Mesa hands colours on when it is asked for them
            context.scene.stale.add("lighting")
        return original(*args)

    return call


def _staling(group: str) -> Maker:
    def make(dome: Dome, original: Call) -> Call:
        def call(*args: Any, **named: Any) -> Any:
            if dome.context is not None:
                dome.context.scene.stale.add(group)
            return original(*args, **named)

        return call

    return make


def _switch(dome: Dome, original: Call) -> Call:
    """glEnable and glDisable."""

    def switch(capability: int) -> Any:
        context = dome.context
        if context is not None:
            if capability in _TOUCHED:
                context.undress()
            if capability == _SCISSOR_TEST:
                context.viewport_changed()
            else:
                context.scene.stale.add(GROUP_OF[capability])
        return original(capability)

    kept = kept_in_lists(lambda _dome, _original: switch)(dome, original)

    def call(capability: int, *args: Any) -> Any:
        seen = capability in GROUP_OF or capability == _SCISSOR_TEST
        return kept(capability) if seen else original(capability, *args)

    return call


def _active_texture(dome: Dome, original: Call) -> Call:
    def call(texture: int) -> Any:
        if dome.context is not None:
            scene = dome.context.scene
            scene.texture_units = max(scene.texture_units, int(texture) - _TEXTURE0 + 1)
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
    def set_mode(mode: int) -> Any:
        if dome.context is not None:
            dome.context.matrix_mode_changed(int(mode))
        return original(mode)

    kept = kept_in_lists(lambda _dome, _original: set_mode)(dome, original)

    def call(mode: int) -> Any:
        if dome.building is not None:
            dome.building.matrix_mode = int(mode)
        return kept(mode)

    return call


def _frustum(dome: Dome, original: Call) -> Call:
    def call(*planes: float) -> Any:
        if dome.context is not None and len(planes) == 6:
            dome.context.perspective_set(frustum(*planes))
        return original(*planes)

    return call


def _load_matrix(dome: Dome, original: Call) -> Call:
    transposed = "Transpose" in getattr(original, "__name__", "")

    def load(m: Any) -> Any:
        context = dome.context
        if context is not None and context.on_projection:
            matrix = np.array(m, float).reshape(4, 4)
            matrix = matrix if transposed else matrix.T
            if is_perspective(matrix):
                context.perspective_set(perspective_part(matrix))
        return original(m)

    kept = kept_in_lists(lambda _dome, _original: load)(dome, original)

    def call(m: Any) -> Any:
        building = dome.building
        return kept(m) if building is None or building.matrix_mode == _PROJECTION else original(m)

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


def _render_mode(dome: Dome, original: Call) -> Call:
    """GL_SELECT and GL_FEEDBACK answer in the monitor's terms: the dome stays out of them."""

    def call(mode: int) -> Any:
        if dome.context is not None:
            dome.context.bypass("render mode", on=mode != _RENDER)
        return original(mode)

    return call


_SPECIAL: Mapping[str, Maker] = {
    "glDrawArrays": draw_arrays,
    "glDrawElements": draw_elements,
    "glDrawRangeElements": draw_range_elements,
    "glEnable": shaders.noting_assembly(_switch, on=True),
    "glDisable": shaders.noting_assembly(_switch, on=False),
    "glActiveTexture": _active_texture,
    "glColorMaterial": kept_in_lists(_color_material),
    "glViewport": kept_in_lists(_viewport),
    "glScissor": kept_in_lists(_viewport),
    "glMatrixMode": _matrix_mode,
    "glFrustum": kept_in_lists(_frustum),
    "glNewList": new_list,
    "glEndList": end_list,
    "glCallList": kept_in_lists(call_list),
    "glCallLists": kept_in_lists(call_lists),
    "glDeleteLists": delete_lists,
    "glPushAttrib": kept_in_lists(_attributes),
    "glPopAttrib": kept_in_lists(_attributes),
    "glLinkProgram": shaders.link_program,
    "glUseProgram": kept_in_lists(shaders.use_program),
    "glUseProgramObject": kept_in_lists(shaders.use_program),
    "glDeleteProgram": shaders.delete_program,
    "glDeleteObject": shaders.delete_program,
    "glGetProgramiv": shaders.program_value,
    "glGetObjectParameteriv": shaders.program_value,
    "glGetActiveUniform": shaders.active_uniform,
    "glUniformMatrix4fv": shaders.uniform_matrix,
    "glRenderMode": _render_mode,
    "glClear": kept_in_lists(pixels.clear),
    "glAccum": kept_in_lists(_read),
}
_WRITES_BUFFER = re.compile(
    r"gl(Named)?(BufferData|BufferSubData|BufferStorage)\w*|gl(Unm|M)ap\w*Buffer\w*|glCopy\w*BufferSubData"
    r"|glDeleteBuffers|glClear\w*Buffer(Sub)?Data"
)
_FAMILIES: tuple[tuple[re.Pattern[str], Maker], ...] = (
    (_WRITES_BUFFER, writes_buffer),
    (_DRAWS, _draw),
    (_AT_RASTER, pixels.at_raster),
    (_RASTER_POSITIONS, kept_in_lists(pixels.at_raster)),
    (_WINDOW_POSITIONS, kept_in_lists(pixels.window_position)),
    (_UNIFORMS, shaders.uniform),
    (_LIGHTING, kept_in_lists(_staling("lighting"))),
    (_TEXTURES, kept_in_lists(_staling("textures"))),
    (_REST, kept_in_lists(_staling("rest"))),
    (_LOADS, _load_matrix),
    (_GETS, _get),
    (_READ_PIXELS, reading.read_pixels),
    (_READS, _read),
)
