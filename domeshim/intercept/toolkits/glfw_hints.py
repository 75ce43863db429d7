"""What a program asks of its glfw windows: the hints, as glfw keeps them for the next one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from domeshim.driver import Driver
from domeshim.window.contract import SurfaceFormat, suiting_samples


class Hints:
    """The hints of one process; glfw cannot be asked for them."""

    def __init__(self, glfw: Any) -> None:
        """glfw: its own functions."""
        self._glfw = glfw
        self._asked: dict[int, int] = {}

    def window_hint(self, hint: int, value: int) -> Any:
        """Remember what the program asks for, and pass it on."""
        self._asked[hint] = int(value)
        return self._glfw.window_hint(hint, value)

    def default_window_hints(self) -> Any:
        """Forget what the program asked for."""
        self._asked.clear()
        return self._glfw.default_window_hints()

    @property
    def without_gl(self) -> bool:
        """The next window shall have no GL."""
        return bool(self._asked.get(self._glfw.CLIENT_API) == self._glfw.NO_API)

    @property
    def without_fixed_function(self) -> bool:
        """The next window's GL shall be a core profile, forward-compatible, or OpenGL ES."""
        glfw, asked = self._glfw, self._asked
        version = (asked.get(glfw.CONTEXT_VERSION_MAJOR, 1), asked.get(glfw.CONTEXT_VERSION_MINOR, 0))
        return (
            asked.get(glfw.CLIENT_API, glfw.OPENGL_API) != glfw.OPENGL_API
            or (version >= (3, 2) and asked.get(glfw.OPENGL_PROFILE, 0) == glfw.OPENGL_CORE_PROFILE)
            or (version >= (3, 0) and bool(asked.get(glfw.OPENGL_FORWARD_COMPAT, 0)))
        )

    def surface(self, samples: int) -> SurfaceFormat:
        """What the next window's frame buffer shall hold; samples: where the program asks for none."""
        glfw, asked = self._glfw, self._asked
        accumulation = (glfw.ACCUM_RED_BITS, glfw.ACCUM_GREEN_BITS, glfw.ACCUM_BLUE_BITS)
        return SurfaceFormat(
            double_buffer=bool(asked.get(glfw.DOUBLEBUFFER, 1)),
            depth=asked.get(glfw.DEPTH_BITS, 24) != 0,
            stencil=asked.get(glfw.STENCIL_BITS, 8) != 0,
            alpha=asked.get(glfw.ALPHA_BITS, 8) != 0,
            accumulation=any(asked.get(name, 0) > 0 for name in accumulation),
            stereo=bool(asked.get(glfw.STEREO, 0)),
            samples=max(asked.get(glfw.SAMPLES, samples), 0),
        )

    def opened_with_samples(self, opening: Callable[[], Any], samples: int) -> Any:
        """Open a window that smooths edges if the program asks for none, the driver has it and it suits."""
        glfw = self._glfw
        if not samples or glfw.SAMPLES in self._asked:
            return opening()
        glfw.window_hint(glfw.SAMPLES, samples)
        try:
            handle = opening()
        finally:
            glfw.window_hint(glfw.SAMPLES, 0)
        if handle and not self._samples_suit(handle):
            glfw.destroy_window(handle)
            handle = None
        return handle or opening()

    def _samples_suit(self, handle: Any) -> bool:
        glfw = self._glfw
        current = glfw.get_current_context()
        glfw.make_context_current(handle)
        try:
            return suiting_samples(Driver().renderer) > 0
        finally:
            glfw.make_context_current(current or None)

    def opened_without_gl(self, opening: Callable[[], Any]) -> Any:
        """Open a window for its events alone."""
        glfw = self._glfw
        glfw.window_hint(glfw.CLIENT_API, glfw.NO_API)
        try:
            return opening()
        finally:
            glfw.window_hint(glfw.CLIENT_API, self._asked.get(glfw.CLIENT_API, glfw.OPENGL_API))
