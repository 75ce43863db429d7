"""The intercepted names of OpenGL.GL: what each call means to the dome, before it goes on to GL.

Vertices and their attributes are recorded. Every other call first lets GL see what was recorded. Calls
that the dome must know of do their part; within glNewList they are kept for when the list is called.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from types import ModuleType
from typing import TYPE_CHECKING, Any

from domeshim.draw.accumulation import BUFFER_BIT as ACCUMULATION_BIT
from domeshim.draw.accumulation import Accumulation
from domeshim.driver import Driver
from domeshim.intercept import evaluators, pixels, raster, reading, recorded, shaders
from domeshim.intercept.arrays import draw_arrays, draw_elements, draw_range_elements, writes_buffer
from domeshim.intercept.blitting import blit_framebuffer
from domeshim.intercept.copying import COPIES, copy_texture
from domeshim.intercept.dome import Dome
from domeshim.intercept.lists import (
    call_list,
    call_lists,
    delete_lists,
    end_list,
    new_list,
    written_list,
    written_lists,
)
from domeshim.intercept.matrix_calls import frustum, load_matrix, matrix_mode
from domeshim.intercept.state_calls import (
    active_texture,
    attributes,
    bare,
    binds_framebuffer,
    clip_plane,
    color_material,
    draw,
    kept_in_lists,
    read,
    read_picture,
    render_mode,
    staling,
    switch,
    viewport,
)
from domeshim.record.attributes import setter
from domeshim.record.calls import recording

if TYPE_CHECKING:
    from domeshim.session import Session

Call = Callable[..., Any]
Maker = Callable[[Dome, Call], Call]

_DRAWS = re.compile(r"gl(Draw(Arrays|Elements|RangeElements)\w*|MultiDraw\w+)")
_BEGINS_DRAWING = re.compile(
    r"gl(Begin|Rect[dfis]v?|Draw(Arrays|Elements|RangeElements|Pixels)\w*|MultiDraw\w+|EvalMesh[12]|CallLists?"
    r"|Bitmap|CopyPixels)"
)
_AT_RASTER = re.compile(r"gl(Bitmap|DrawPixels\w*)")
_RASTER_POSITIONS = re.compile(r"glRasterPos\d?[dfis]?v?")
_WINDOW_POSITIONS = re.compile(r"glWindowPos\d[dfis]v?")
_LIGHTING = re.compile(r"gl(Light(|[fi]v?)|LightModel(|[fi]v?))")
_TEXTURES = re.compile(r"glTexGen(|[dfi]v?)")
_REST = re.compile(r"gl(Fog(|[fi]v?)|PointParameter(|[fi]v?)|ShadeModel)")
_LOADS = re.compile(r"gl(Load|Mult)(Transpose)?Matrix[df]?")
_GETS = re.compile(r"glGet(Boolean|Double|Float|Integer)(v|)|glIsEnabled")
_READ_PIXELS = re.compile(r"glReadPixels(b|d|f|i|s|ub|ui|us)?")
_READS = re.compile(r"glReadPixels\w*|glCopyTex\w+")
_BINDS_FRAMEBUFFER = re.compile(r"gl(Bind|Delete)Framebuffers?")
_OF_FRAMEBUFFER = re.compile(r"gl(Draw|Read)Buffers?|gl(?!Blit)\w*Framebuffer\w*")
_UNIFORMS = re.compile(r"gl(Program)?Uniform\w+")
_RECTS = re.compile(r"glRect[dfis](v?)")
_COLOR_BUFFER_BIT, _RENDER_MODE, _RENDER = 0x4000, 0x0C40, 0x1C00
_UNSEEN = re.compile(r"glGetError|glGetString\w*|glCheckError|glInit\w+")
"""Neither changes anything nor depends on what was drawn."""


def replacements(session: Session, module: ModuleType) -> dict[str, Call]:
    """Our function for each name of OpenGL.GL that means something to the session, or to its dome."""
    ours = _frame_calls(session, module)
    dome = session.dome
    if not isinstance(dome, Dome):
        ours |= drawing_calls(session, module, _BEGINS_DRAWING)
    else:
        for name, original in vars(module).items():
            if name.startswith("gl") and callable(original) and not _UNSEEN.fullmatch(name):
                ours[name] = _dome_call(dome, name, ours.get(name, original))
    for name, call in ours.items():
        call.__name__ = call.__qualname__ = name  # which Python's own errors tell of
        call.__doc__ = getattr(vars(module)[name], "__doc__", None)
    return ours


def _frame_calls(session: Session, module: ModuleType) -> dict[str, Call]:
    """The calls by which a picture begins and ends, on the monitor as on the dome."""
    originals = {
        name: vars(module)[name]
        for name in ("glFlush", "glFinish", "glClear", "glAccum")
        if name in vars(module)
    }

    driver = Driver()

    def draws() -> bool:
        """Selection and feedback leave the picture as it is."""
        window = session.window
        bent = window is not None and session.bends(window)  # elsewhere GL need not know of them
        return not bent or driver.integer(_RENDER_MODE) == _RENDER

    def ending(original: Call) -> Call:
        def call(*_more: object) -> None:
            original()
            if draws():
                session.flushed()

        return call

    accumulation = Accumulation(driver)

    def clearing(original: Call) -> Call:
        def call(mask: int, *_more: object) -> None:
            if session.window is not None or driver.current:  # without a context nothing is cleared
                session.clearing(colour=bool(mask & _COLOR_BUFFER_BIT))
            original(mask)
            if mask & ACCUMULATION_BIT and session.window is not None and accumulation.needed:
                accumulation.clear(session.window, session.window.size)

        return call

    def accumulating(original: Call) -> Call:
        def call(op: int, value: float) -> None:
            window = session.window
            session.reading()
            if window is None or not accumulation.needed:
                original(op, value)
            else:
                accumulation.operate(window, window.size, int(op), float(value))

        return call

    makers = {"glClear": clearing, "glAccum": accumulating}
    return {name: makers.get(name, ending)(original) for name, original in originals.items()}


def drawing_calls(session: Session, module: ModuleType, names: re.Pattern[str]) -> dict[str, Call]:
    """The calls that draw, where there is no dome which would tell the session of them."""

    def drawing(original: Call) -> Call:
        def call(*args: Any, **named: Any) -> Any:
            session.drawing()
            return original(*args, **named)

        return call

    return {name: drawing(call) for name, call in vars(module).items() if names.fullmatch(name)}


def _dome_call(dome: Dome, name: str, original: Call) -> Call:
    """What happens instead of one name of GL."""
    plain_name = name.removesuffix("ARB").removesuffix("EXT")
    attribute = setter(plain_name)
    if attribute is not None:
        return recording(dome.recorder, attribute)
    if plain_name in ("glBegin", "glEnd"):
        return (recorded.begin if plain_name == "glBegin" else recorded.end)(dome, original)
    rectangle = _RECTS.fullmatch(plain_name)
    if rectangle:
        return recorded.rectangle(dome, vector=bool(rectangle[1]))
    call = after_recorded(dome, plain_name, _meaning(dome, plain_name, original))
    adding = _ADDING.get(plain_name)
    return adding(dome, call) if adding is not None else call


def _meaning(dome: Dome, name: str, original: Call) -> Call:
    """The call with what it means to the dome; the original where it means nothing."""
    make = copy_texture(name) if COPIES.fullmatch(name) else _SPECIAL.get(name)
    if make is None and _IN_A_FAMILY.fullmatch(name):
        make = next(make for pattern, make in _FAMILIES if pattern.fullmatch(name))
    return make(dome, original) if make is not None else original


def after_recorded(dome: Dome, name: str, call: Call) -> Call:
    """The call, once GL has seen what was recorded before it."""
    pending, listed = dome.recorder.pending, name != "glEndList"

    def after(*args: Any, **named: Any) -> Any:
        if pending():
            if dome.recorder.block is not None:
                return recorded.within(dome, name, call, *args, **named)
            dome.flush()
        if listed and dome.building is not None:
            dome.building.used = True
        return call(*args, **named)

    return after


_SPECIAL: Mapping[str, Maker] = {
    "glDrawArrays": draw_arrays,
    "glDrawElements": draw_elements,
    "glDrawRangeElements": draw_range_elements,
    "glEnable": shaders.noting_assembly(switch, on=True),
    "glDisable": shaders.noting_assembly(switch, on=False),
    "glActiveTexture": active_texture,
    "glColorMaterial": kept_in_lists(color_material),
    "glViewport": kept_in_lists(viewport),
    "glScissor": kept_in_lists(viewport),
    "glMatrixMode": matrix_mode,
    "glFrustum": kept_in_lists(frustum),
    "glNewList": new_list,
    "glEndList": end_list,
    "glCallList": kept_in_lists(call_list),
    "glCallLists": kept_in_lists(call_lists),
    "glDeleteLists": delete_lists,
    "glPushAttrib": kept_in_lists(attributes),
    "glPopAttrib": kept_in_lists(attributes),
    "glLinkProgram": shaders.link_program,
    "glUseProgram": kept_in_lists(shaders.use_program),
    "glUseProgramObject": kept_in_lists(shaders.use_program),
    "glDeleteProgram": shaders.delete_program,
    "glDeleteObject": shaders.delete_program,
    "glGetProgramiv": shaders.program_value,
    "glGetObjectParameteriv": shaders.program_value,
    "glGetActiveUniform": shaders.active_uniform,
    "glUniformMatrix4fv": shaders.uniform_matrix,
    "glRenderMode": render_mode,
    "glEvalMesh1": kept_in_lists(evaluators.mesh),
    "glEvalMesh2": kept_in_lists(evaluators.mesh),
    "glClipPlane": clip_plane,
    "glGetClipPlane": bare,
    "glClear": kept_in_lists(pixels.clear),
    "glDrawPixels": pixels.image,
    "glCopyPixels": pixels.copied,
    "glAccum": kept_in_lists(read),
    "glBlitFramebuffer": blit_framebuffer,
    "glGetHandle": read,
}
_ADDING: Mapping[str, Maker] = {
    "glBitmap": pixels.bitmap,
    "glCallList": written_list,
    "glCallLists": written_lists,
}
"""Calls that may add to the bitmaps recorded before them; else they are like any other."""
_WRITES_BUFFER = re.compile(
    r"gl(Named)?(BufferData|BufferSubData|BufferStorage)\w*|gl(Unm|M)ap\w*Buffer\w*|glCopy\w*BufferSubData"
    r"|glDeleteBuffers|glClear\w*Buffer(Sub)?Data"
)
_FAMILIES: tuple[tuple[re.Pattern[str], Maker], ...] = (
    (_WRITES_BUFFER, writes_buffer),
    (_BINDS_FRAMEBUFFER, binds_framebuffer),
    (_OF_FRAMEBUFFER, bare),
    (_DRAWS, draw),
    (_AT_RASTER, pixels.at_raster),
    (_RASTER_POSITIONS, kept_in_lists(pixels.raster_position)),
    (_WINDOW_POSITIONS, kept_in_lists(pixels.window_position)),
    (_UNIFORMS, shaders.uniform),
    (_LIGHTING, kept_in_lists(staling("lighting"))),
    (_TEXTURES, kept_in_lists(staling("textures"))),
    (_REST, kept_in_lists(staling("rest"))),
    (_LOADS, load_matrix),
    (_GETS, raster.get),
    (_READ_PIXELS, reading.read_pixels),
    (_READS, read_picture),
)
_IN_A_FAMILY = re.compile("|".join(pattern.pattern for pattern, _ in _FAMILIES))
"""Most names are in none."""
