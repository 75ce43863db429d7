"""glfw's own windows, by their handles: how one is made, and what glfw says where it is not."""

from __future__ import annotations

import re
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import glfw
from OpenGL.platform import PLATFORM

from domeshim.driver import Driver
from domeshim.window.contract import SurfaceFormat, suiting_samples

_ACCUMULATION = (glfw.ACCUM_RED_BITS, glfw.ACCUM_GREEN_BITS, glfw.ACCUM_BLUE_BITS, glfw.ACCUM_ALPHA_BITS)


def attempts(wanted: SurfaceFormat) -> Iterator[tuple[SurfaceFormat, bool]]:
    """Yield formats from the wish downwards, each with whether the context shall have two colour buffers."""
    samples = wanted.samples or 0
    while True:
        attempt = replace(wanted, samples=samples)
        yield attempt, wanted.double_buffer
        if not wanted.double_buffer:
            yield attempt, True
        if samples == 0:
            return
        samples = samples // 2 if samples > 2 else 0


def create(
    title: str,
    size: tuple[int, int],
    surface: SurfaceFormat,
    double: bool,
    shared: Any,
    *,
    shown: bool,
) -> Any:
    """A window's handle, or None; shared: the handle of the window whose objects it shares, or None."""
    glfw.default_window_hints()
    # PyOpenGL asks its own platform which context is current: glfw must make it through the same one.
    through_egl = type(PLATFORM).__name__ == "EGLPlatform"
    hints = {
        glfw.CONTEXT_CREATION_API: glfw.EGL_CONTEXT_API if through_egl else glfw.NATIVE_CONTEXT_API,
        glfw.SCALE_TO_MONITOR: False,
        glfw.SCALE_FRAMEBUFFER: False,
        glfw.VISIBLE: shown,
        glfw.DOUBLEBUFFER: double,
        glfw.DEPTH_BITS: 24 if surface.depth else 0,
        glfw.STENCIL_BITS: 8 if surface.stencil else 0,
        glfw.ALPHA_BITS: 8 if surface.alpha else 0,
        glfw.STEREO: surface.stereo,
        glfw.SAMPLES: surface.samples or 0,
    }
    if surface.accumulation:
        hints |= dict.fromkeys(_ACCUMULATION, 16)
    for hint, value in hints.items():
        glfw.window_hint(hint, int(value))
    return glfw.create_window(*size, title, None, shared)


def dome_samples(handle: Any) -> int:
    """As many samples as suit the dome on this window's driver."""
    glfw.make_context_current(handle)
    return suiting_samples(Driver().renderer)


@contextmanager
def complaints() -> Iterator[list[str]]:
    """Collect what glfw warns of, in its own words, instead of letting it reach the user."""
    said: list[str] = []
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        yield said
    said += [_words(str(warning.message)) for warning in caught]


def _words(warning: str) -> str:
    """Return glfw's own sentence from a warning such as "(65550) b'X11: Failed to open display'"."""
    found = re.fullmatch(r"\(\d+\) b(['\"])(.*)\1", warning)
    return found[2] if found else warning
