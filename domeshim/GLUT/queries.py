"""glutGet and the other questions a program may ask."""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Callable
from typing import Any

from domeshim import session as sessions
from domeshim.GLUT import constants as c
from domeshim.GLUT.arguments import integer, text
from domeshim.GLUT.joystick import joysticks
from domeshim.GLUT.state import GlutState, GlutWindow, glut_state, initialised_state

_GL_SIZES = {
    c.GLUT_WINDOW_DEPTH_SIZE: "GL_DEPTH_BITS",
    c.GLUT_WINDOW_STENCIL_SIZE: "GL_STENCIL_BITS",
    c.GLUT_WINDOW_RED_SIZE: "GL_RED_BITS",
    c.GLUT_WINDOW_GREEN_SIZE: "GL_GREEN_BITS",
    c.GLUT_WINDOW_BLUE_SIZE: "GL_BLUE_BITS",
    c.GLUT_WINDOW_ALPHA_SIZE: "GL_ALPHA_BITS",
    c.GLUT_WINDOW_ACCUM_RED_SIZE: "GL_ACCUM_RED_BITS",
    c.GLUT_WINDOW_ACCUM_GREEN_SIZE: "GL_ACCUM_GREEN_BITS",
    c.GLUT_WINDOW_ACCUM_BLUE_SIZE: "GL_ACCUM_BLUE_BITS",
    c.GLUT_WINDOW_ACCUM_ALPHA_SIZE: "GL_ACCUM_ALPHA_BITS",
    c.GLUT_WINDOW_NUM_SAMPLES: "GL_SAMPLES",
}
_COLOUR_BITS = ("GL_RED_BITS", "GL_GREEN_BITS", "GL_BLUE_BITS", "GL_ALPHA_BITS")
_OF_WINDOW: dict[int, Callable[[GlutState, GlutWindow], int]] = {
    c.GLUT_WINDOW_X: lambda _, window: window.surface.position[0],
    c.GLUT_WINDOW_Y: lambda _, window: window.surface.position[1],
    c.GLUT_WINDOW_WIDTH: lambda _, window: window.size[0],
    c.GLUT_WINDOW_HEIGHT: lambda _, window: window.size[1],
    c.GLUT_WINDOW_BUFFER_SIZE: lambda _, __: sum(map(_gl, _COLOUR_BITS)),
    c.GLUT_WINDOW_DOUBLEBUFFER: lambda _, window: int(bool(window.asked_mode & c.GLUT_DOUBLE)),
    c.GLUT_WINDOW_RGBA: lambda _, __: 1,
    c.GLUT_WINDOW_STEREO: lambda _, window: int(window.surface.format.stereo),
    c.GLUT_WINDOW_PARENT: lambda _, window: window.parent,
    c.GLUT_WINDOW_NUM_CHILDREN: lambda state, window: sum(
        other.parent == window.number for other in state.windows.values()
    ),
    c.GLUT_WINDOW_CURSOR: lambda _, window: window.cursor,
    c.GLUT_WINDOW_COLORMAP_SIZE: lambda _, __: 0,
    c.GLUT_WINDOW_FORMAT_ID: lambda _, __: 0,
    c.GLUT_WINDOW_BORDER_WIDTH: lambda _, __: 0,
    c.GLUT_WINDOW_HEADER_HEIGHT: lambda _, __: 0,
    **{query: lambda _, __, name=name: _gl(name) for query, name in _GL_SIZES.items()},  # type: ignore[misc]
}
_OF_STATE: dict[int, Callable[[GlutState], int]] = {
    c.GLUT_SCREEN_WIDTH: lambda _: sessions.current().backend.screen_size[0],
    c.GLUT_SCREEN_HEIGHT: lambda _: sessions.current().backend.screen_size[1],
    c.GLUT_SCREEN_WIDTH_MM: lambda _: sessions.current().backend.screen_size_mm[0],
    c.GLUT_SCREEN_HEIGHT_MM: lambda _: sessions.current().backend.screen_size_mm[1],
    c.GLUT_INIT_STATE: lambda state: int(state.initialised),
    c.GLUT_INIT_WINDOW_X: lambda state: state.init_position[0],
    c.GLUT_INIT_WINDOW_Y: lambda state: state.init_position[1],
    c.GLUT_INIT_WINDOW_WIDTH: lambda state: state.init_size[0],
    c.GLUT_INIT_WINDOW_HEIGHT: lambda state: state.init_size[1],
    c.GLUT_INIT_DISPLAY_MODE: lambda state: state.display_mode,
    c.GLUT_INIT_MAJOR_VERSION: lambda state: state.context["major"],
    c.GLUT_INIT_MINOR_VERSION: lambda state: state.context["minor"],
    c.GLUT_INIT_FLAGS: lambda state: state.context["flags"],
    c.GLUT_INIT_PROFILE: lambda state: state.context["profile"],
    c.GLUT_DISPLAY_MODE_POSSIBLE: lambda state: int(not state.display_mode & c.GLUT_INDEX),
    c.GLUT_MENU_NUM_ITEMS: lambda state: len(state.menu.items) if state.menu else 0,
    c.GLUT_ACTION_ON_WINDOW_CLOSE: lambda state: state.options.get(c.GLUT_ACTION_ON_WINDOW_CLOSE, 0),
    c.GLUT_RENDERING_CONTEXT: lambda state: state.options.get(c.GLUT_RENDERING_CONTEXT, 0),
    c.GLUT_MULTISAMPLE: lambda state: state.samples,
    c.GLUT_VERSION: lambda _: 30400,
}
_DEVICES = {
    c.GLUT_HAS_KEYBOARD: 1,
    c.GLUT_HAS_MOUSE: 1,
    c.GLUT_HAS_SPACEBALL: 0,
    c.GLUT_HAS_DIAL_AND_BUTTON_BOX: 0,
    c.GLUT_HAS_TABLET: 0,
    c.GLUT_NUM_MOUSE_BUTTONS: 8,  # as many as glfw tells apart
    c.GLUT_NUM_SPACEBALL_BUTTONS: 0,
    c.GLUT_NUM_BUTTON_BOX_BUTTONS: 0,
    c.GLUT_NUM_DIALS: 0,
    c.GLUT_NUM_TABLET_BUTTONS: 0,
}
_DEVICES_NOW: dict[int, Callable[[GlutState], int]] = {
    c.GLUT_DEVICE_KEY_REPEAT: lambda state: state.key_repeat,
    c.GLUT_DEVICE_IGNORE_KEY_REPEAT: lambda state: int(state.current.ignore_repeat) if state.current else 0,
    c.GLUT_HAS_JOYSTICK: lambda _: int(bool(joysticks())),
    c.GLUT_OWNS_JOYSTICK: lambda state: int(state.owns_joystick),
    c.GLUT_JOYSTICK_BUTTONS: lambda _: max((len(j.buttons) for j in joysticks()), default=0),
    c.GLUT_JOYSTICK_AXES: lambda _: max((len(j.axes) for j in joysticks()), default=0),
    c.GLUT_JOYSTICK_POLL_RATE: lambda state: (
        round(1000 * state.current.joystick_interval) if state.current else 0
    ),
}
_LAYERS = {
    c.GLUT_OVERLAY_POSSIBLE: 0,
    c.GLUT_LAYER_IN_USE: c.GLUT_NORMAL,
    c.GLUT_HAS_OVERLAY: 0,
    c.GLUT_TRANSPARENT_INDEX: 0,
    c.GLUT_NORMAL_DAMAGED: 0,
    c.GLUT_OVERLAY_DAMAGED: -1,
}


def glutGet(query: Any, *_more: object) -> int:
    """Return a number about GLUT, the screen or the current window; 0 for a window where there is none.

    An unknown query is told of on stderr and answered with -1.
    """
    number = integer("glutGet", "query", query)
    if number == c.GLUT_ELAPSED_TIME:
        return _elapsed(glut_state())
    state = glut_state() if number == c.GLUT_INIT_STATE else initialised_state("glutGet")
    if number in _OF_STATE:
        return _OF_STATE[number](state)
    if number in _OF_WINDOW:
        return _OF_WINDOW[number](state, state.current) if state.current else 0
    state.warn(f"glutGet(): missing enum handle {number}")
    return -1


def _elapsed(state: GlutState) -> int:
    # 1e-6: thirds of a second counted in frames must not lose their last millisecond to rounding.
    return int((sessions.current().clock.read() - state.began) * 1000.0 + 1e-6)


def _gl(name: str) -> int:
    from OpenGL import GL  # noqa: PLC0415 - its functions as they are overlaid now

    return int(GL.glGetIntegerv(getattr(GL, name)))


def glutSetOption(option_flag: Any, value: Any, *_more: object) -> None:
    """Set GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_RENDERING_CONTEXT or what glutInit... functions set."""
    state = glut_state()
    number = integer("glutSetOption", "option_flag", option_flag)
    setting = integer("glutSetOption", "value", value)
    if number == c.GLUT_INIT_WINDOW_X:
        state.init_position = (setting, state.init_position[1])
    elif number == c.GLUT_INIT_WINDOW_Y:
        state.init_position = (state.init_position[0], setting)
    elif number == c.GLUT_INIT_WINDOW_WIDTH:
        state.init_size = (setting, state.init_size[1])
    elif number == c.GLUT_INIT_WINDOW_HEIGHT:
        state.init_size = (state.init_size[0], setting)
    elif number == c.GLUT_INIT_DISPLAY_MODE:
        state.display_mode = setting
    elif number == c.GLUT_MULTISAMPLE:
        state.samples = setting
    elif number == c.GLUT_WINDOW_CURSOR and state.current is not None:
        state.current.cursor = setting
    else:
        state.options[number] = setting


def glutDeviceGet(query: Any, *_more: object) -> int:
    """Return what there is of keyboards, mice and rarer things; -1 for an unknown query."""
    state = initialised_state("glutDeviceGet")
    number = integer("glutDeviceGet", "query", query)
    if number in _DEVICES_NOW:
        return _DEVICES_NOW[number](state)
    if number in _DEVICES:
        return _DEVICES[number]
    state.warn(f"glutDeviceGet(): missing enum handle {number}")
    return -1


def glutLayerGet(query: Any, *_more: object) -> int:
    """Return that there is a normal layer only; -1 for an unknown query."""
    state = initialised_state("glutLayerGet")
    number = integer("glutLayerGet", "query", query)
    if number in _LAYERS:
        return _LAYERS[number]
    state.warn(f"glutLayerGet(): missing enum handle {number}")
    return -1


def glutGetModifiers(*_more: object) -> int:
    """Return GLUT_ACTIVE_... of the keyboard or mouse event whose callback runs; -1 outside of those."""
    state = initialised_state("glutGetModifiers")
    if state.modifiers is None:
        state.warn("glutGetModifiers() called outside an input callback")
        return -1
    return state.modifiers


def glutGetModeValues(mode: Any, size: Any, *_more: object) -> list[int]:
    """Return the sample counts that may be asked for (GLUT_MULTISAMPLE), also their number in size."""
    number = integer("glutGetModeValues", "mode", mode)
    values = [2, 4, 8] if number == c.GLUT_MULTISAMPLE else []
    if size is not None:
        (size.contents if isinstance(size, ctypes._Pointer) else size).value = len(values)
    return values


def glutExtensionSupported(extension: Any, *_more: object) -> int:
    """Return 1 where the current context has the GL extension of that name, else 0."""
    from OpenGL import GL  # noqa: PLC0415 - its functions as they are overlaid now

    name = text("glutExtensionSupported", "extension", extension)
    if initialised_state("glutExtensionSupported").current is None:
        return 0
    return int(name.encode() in (GL.glGetString(GL.GL_EXTENSIONS) or b"").split())


def glutGetProcAddress(procName: Any, *_more: object) -> int | None:
    """Return the address of the GL function of that name, or None."""
    from OpenGL.platform import PLATFORM  # noqa: PLC0415 - the program's imports of OpenGL come first

    name = text("glutGetProcAddress", "procName", procName)
    found = PLATFORM.getExtensionProcedure(name.encode())
    return int(found) if found else None


def glutReportErrors(*_more: object) -> None:
    """Print each GL error that is waiting on stderr."""
    from OpenGL import GL, GLU  # noqa: PLC0415 - their functions as they are overlaid now

    initialised_state("glutReportErrors")
    while error := GL.glGetError():
        words = GLU.gluErrorString(error)
        print(f"GLUT: GL error: {words.decode() if isinstance(words, bytes) else words}", file=sys.stderr)
