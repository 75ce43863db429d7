"""The intercepted calls that change what a draw needs to know, or that ask for it."""

from __future__ import annotations

import copy
from collections.abc import Callable
from functools import partial
from typing import Any

from domeshim.intercept.dome import Dome
from domeshim.state.scene import GROUP_OF

Call = Callable[..., Any]
Maker = Callable[[Dome, Call], Call]

_TOUCHED = frozenset(
    (
        0x0BA2,  # GL_VIEWPORT
        0x0C10,  # GL_SCISSOR_BOX
        0x0C11,  # GL_SCISSOR_TEST
        0x8B8D,  # GL_CURRENT_PROGRAM
        0x8CA6,  # GL_DRAW_FRAMEBUFFER_BINDING
        0x0C01,  # GL_DRAW_BUFFER
        *range(0x0D52, 0x0D58),  # GL_RED_BITS .. GL_STENCIL_BITS
        *(0x80A8, 0x80A9),  # GL_SAMPLE_BUFFERS, GL_SAMPLES
        0x8458,  # GL_COLOR_SUM
        0x8643,  # GL_VERTEX_PROGRAM_TWO_SIDE
        0x8642,  # GL_VERTEX_PROGRAM_POINT_SIZE
        0x8C89,  # GL_RASTERIZER_DISCARD
        *range(0x3000, 0x3008),  # GL_CLIP_PLANEi
    )
)
"""What the dome changes while it draws: before the program asks for one of these it is put back."""
_SCISSOR_TEST = 0x0C11
_SEEN = {**GROUP_OF, _SCISSOR_TEST: ""}
"""Capabilities that mean something to the dome, with their groups."""
_CURRENT_COLOR, _RENDER, _TEXTURE0 = 0x0B00, 0x1C00, 0x84C0


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


def draw(dome: Dome, original: Call) -> Call:
    """A call that draws at once."""

    def call(*args: Any, **named: Any) -> Any:
        if dome.context is None:
            return original(*args, **named)
        dome.drawing()
        drawn = partial(original, *args, **named)
        return None if dome.listed(drawn) else dome.context.draw(drawn)

    return call


def read(dome: Dome, original: Call) -> Call:
    """A call that must find the window's picture, and GL as the program left it."""

    def call(*args: Any, **named: Any) -> Any:
        if dome.context is not None:
            dome.context.settle()
        return original(*args, **named)

    return call


def bare(dome: Dome, original: Call) -> Call:
    """A call that must find GL as the program left it."""

    def call(*args: Any, **named: Any) -> Any:
        if dome.context is not None:
            dome.context.undress()
        return original(*args, **named)

    return call


def clip_plane(dome: Dome, original: Call) -> Call:
    """glClipPlane: on OpenGL 2 the dome has equations of its own in GL's planes while it draws."""
    undressed = kept_in_lists(bare)(dome, original)

    def call(*args: Any, **named: Any) -> Any:
        taken = dome.context is not None and dome.context.driver.legacy
        return (undressed if taken else original)(*args, **named)

    return call


def read_picture(dome: Dome, original: Call) -> Call:
    """A call that reads pixels of what was drawn."""
    call = read(dome, original)

    def reading(*args: Any, **named: Any) -> Any:
        dome.reading()
        return call(*args, **named)

    return reading


def binds_framebuffer(dome: Dome, original: Call) -> Call:
    """A call after which draws may go to a framebuffer of the program's own, or to the window again."""

    def call(*args: Any, **named: Any) -> Any:
        if dome.context is None:
            return original(*args, **named)
        dome.context.undress()
        result = original(*args, **named)
        dome.context.framebuffer_bound()
        return result

    return call


def get(dome: Dome, original: Call) -> Call:
    """glGet and glIsEnabled."""

    def call(name: int, *args: Any) -> Any:
        if name in _TOUCHED and dome.context is not None:
            dome.context.undress()
        return original(name, *args)

    return call


def color_material(dome: Dome, original: Call) -> Call:
    """glColorMaterial: the material keeps the colour that it followed, also one set since the last draw."""

    def call(*args: Any) -> Any:
        context = dome.context
        if context is not None:
            context.driver.integers(_CURRENT_COLOR, 4)  # Mesa hands colours on when it is asked for them
            context.scene.stale.add("lighting")
        return original(*args)

    return call


def staling(group: str) -> Maker:
    """A call that changes one group of what the scene is asked for."""

    def make(dome: Dome, original: Call) -> Call:
        def call(*args: Any, **named: Any) -> Any:
            if dome.context is not None:
                dome.context.scene.stale.add(group)
            return original(*args, **named)

        return call

    return make


def switch(dome: Dome, original: Call) -> Call:
    """glEnable and glDisable."""

    def switch(capability: int) -> Any:
        context = dome.context
        if context is not None:
            if capability in _TOUCHED:
                context.undress()
            if capability == _SCISSOR_TEST:
                context.viewport_changed()
            else:
                context.scene.stale.add(_SEEN[capability])
        return original(capability)

    kept = kept_in_lists(lambda _dome, _original: switch)(dome, original)

    def call(capability: int, *args: Any) -> Any:
        if capability not in _SEEN:
            return original(capability, *args)
        return switch(capability) if dome.building is None else kept(capability)

    return call


def active_texture(dome: Dome, original: Call) -> Call:
    """glActiveTexture."""

    def call(texture: int) -> Any:
        if dome.context is not None:
            scene = dome.context.scene
            scene.texture_units = max(scene.texture_units, int(texture) - _TEXTURE0 + 1)
        return original(texture)

    return call


def viewport(dome: Dome, original: Call) -> Call:
    """glViewport and glScissor."""

    def call(*args: Any, **named: Any) -> Any:
        if dome.context is not None:
            dome.context.undress()
            dome.context.viewport_changed()
        return original(*args, **named)

    return call


def attributes(dome: Dome, original: Call) -> Call:
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


def render_mode(dome: Dome, original: Call) -> Call:
    """GL_SELECT and GL_FEEDBACK answer in the monitor's terms: the dome stays out of them."""

    def call(mode: int) -> Any:
        if dome.context is not None:
            dome.context.aside.bypass("render mode", on=mode != _RENDER)
        return original(mode)

    return call
