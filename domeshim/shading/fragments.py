"""A program of fragment shaders alone: the dome's own vertex shaders stand in for GL's fixed vertex stage.

The program stays as it was linked. For each recipe there is one more program, of the dome's vertex stage and
the same fragment shaders, that gets the values of the program's uniforms before it draws.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from ctypes import c_char_p, c_float, c_int, c_uint, create_string_buffer
from dataclasses import dataclass
from typing import Any

from domeshim.driver import Driver
from domeshim.shading.program import Program
from domeshim.shading.recipe import Recipe

_FRAGMENT, _ACTIVE_UNIFORMS = 0x8B30, 0x8B86
_COORDINATES = re.compile(r"\bgl_TexCoord\s*\[\s*(\d)\s*\]")

_FLOATS = {0x1406: "1f", 0x8B50: "2f", 0x8B51: "3f", 0x8B52: "4f"}
_INTEGERS = {0x1404: "1i", 0x8B53: "2i", 0x8B54: "3i", 0x8B55: "4i"}
_BOOLEANS = {0x8B56: "1i", 0x8B57: "2i", 0x8B58: "3i", 0x8B59: "4i"}
_SAMPLERS = dict.fromkeys((*range(0x8B5D, 0x8B65), *range(0x8DC0, 0x8DC6)), "1i")
_MATRICES = {0x8B5A: "Matrix2f", 0x8B5B: "Matrix3f", 0x8B5C: "Matrix4f"}
_KINDS: Mapping[int, str] = _FLOATS | _INTEGERS | _BOOLEANS | _SAMPLERS | _MATRICES
"""How a uniform of each type is set: the end of glUniform's name before its v."""


@dataclass(frozen=True)
class _Uniform:
    name: bytes
    location: int
    kind: str


class FragmentStage:
    """The fragment shaders of one linked program of the program's own."""

    def __init__(self, driver: Driver, name: int, texts: Sequence[str]) -> None:
        """texts: the fragment shaders' sources; they compile, as the program is linked from them."""
        self._driver = driver
        self.name = name
        self.programs: dict[Recipe, Program] = {}
        """One for each vertex stage that it has drawn with."""
        self.texture_units = frozenset(int(unit) for text in texts for unit in _COORDINATES.findall(text))
        """The units whose coordinates it reads, enabled or not."""
        self.shaders = tuple(self._copy(text) for text in texts)
        self._uniforms = tuple(self._own_uniforms())
        self._version = 0
        self._sent: dict[int, int] = {}

    @property
    def unknown(self) -> str | None:
        """The name of a uniform whose type is younger than GLSL 1.20: its value cannot be handed over."""
        return next((u.name.decode() for u in self._uniforms if not u.kind), None)

    def uniforms_changed(self) -> None:
        """The program has given a uniform another value."""
        self._version += 1

    def send_to(self, program: Program) -> None:
        """Give one of our programs, which is bound, the values of the program's uniforms."""
        if self._sent.get(program.name) == self._version:
            return
        self._sent[program.name] = self._version
        gl = self._driver
        for uniform in self._uniforms:
            location = gl.glGetUniformLocation(program.name, uniform.name)
            floats = uniform.kind.endswith("f")
            values: Any = (c_float * 16)() if floats else (c_int * 4)()
            (gl.glGetUniformfv if floats else gl.glGetUniformiv)(self.name, uniform.location, values)
            setter = getattr(gl, f"glUniform{uniform.kind}v")
            if uniform.kind.startswith("Matrix"):
                setter(location, 1, 0, values)
            else:
                setter(location, 1, values)

    def delete(self) -> None:
        """Free what was made for the program."""
        for program in self.programs.values():
            self._driver.glDeleteProgram(program.name)
        for shader in self.shaders:
            self._driver.glDeleteShader(shader)

    def _copy(self, text: str) -> int:
        gl = self._driver
        shader: int = gl.glCreateShader(_FRAGMENT)
        gl.glShaderSource(shader, 1, c_char_p(text.encode(errors="surrogateescape")), None)
        gl.glCompileShader(shader)
        return shader

    def _own_uniforms(self) -> list[_Uniform]:
        """Every element of every uniform that the program can set."""
        gl, count = self._driver, c_int()
        gl.glGetProgramiv(self.name, _ACTIVE_UNIFORMS, count)
        found = []
        for index in range(count.value):
            size, kind, name = c_int(), c_uint(), create_string_buffer(256)
            gl.glGetActiveUniform(self.name, index, len(name), None, size, kind, name)
            base = name.value.removesuffix(b"[0]")
            for element in range(size.value):
                one = base + b"[%d]" % element if name.value.endswith(b"[0]") or size.value > 1 else base
                location = gl.glGetUniformLocation(self.name, one)
                if location >= 0:  # GL's own, as gl_Fog, have none
                    found.append(_Uniform(one, location, _KINDS.get(kind.value, "")))
        return found
