"""GL, looked on as programs are made: of how many shaders and how much text, and how long it takes."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from ctypes import c_int, c_uint

from domeshim.diagnosis.tally import Made
from domeshim.driver import Driver

_SOURCE_LENGTH, _MOST_SHADERS = 0x8B88, 16


class WatchedMaking(Driver):
    """GL's entry points, of which those that make programs are timed."""

    def __init__(self, seconds: Callable[[], float]) -> None:
        """seconds: the real time, which the program's may not be."""
        self._gl = Driver()
        self._seconds = seconds
        self.made: defaultdict[int, Made] = defaultdict(Made)
        """By the program's name."""
        self._compiling: defaultdict[int, float] = defaultdict(float)
        """Seconds, by the shader's name."""

    def glCompileShader(self, shader: int) -> None:
        """Note how long it took."""
        began = self._seconds()
        self._gl.glCompileShader(shader)
        self._compiling[int(shader)] = self._seconds() - began

    def glLinkProgram(self, program: int) -> None:
        """Note how long it took, with the time of its shaders."""
        began = self._seconds()
        self._gl.glLinkProgram(program)
        seconds, shaders = self._seconds() - began, self._attached(program)
        self.made[int(program)] = Made(
            len(shaders),
            sum(self._length(shader) for shader in shaders),
            seconds + sum(self._compiling[shader] for shader in shaders),
        )

    def _attached(self, program: int) -> list[int]:
        count, names = c_int(), (c_uint * _MOST_SHADERS)()
        self._gl.glGetAttachedShaders(program, _MOST_SHADERS, count, names)
        return list(names[: count.value])

    def _length(self, shader: int) -> int:
        """Of a shader's text, without GL's zero behind it."""
        length = c_int()
        self._gl.glGetShaderiv(shader, _SOURCE_LENGTH, length)
        return max(length.value - 1, 0)
