"""The values of a program's own uniforms go to programs that the dome draws by in its place."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from ctypes import c_float, c_int, c_uint, create_string_buffer
from dataclasses import dataclass
from typing import Any

from domeshim.driver import Driver

_ACTIVE_UNIFORMS, _ACTIVE_BLOCKS, _BLOCK_BINDING = 0x8B86, 0x8A36, 0x8A3F
_NO_BLOCK = 0xFFFFFFFF

_FLOATS = {0x1406: "1f", 0x8B50: "2f", 0x8B51: "3f", 0x8B52: "4f"}
_INTEGERS = {0x1404: "1i", 0x8B53: "2i", 0x8B54: "3i", 0x8B55: "4i"}
_NATURALS = {0x1405: "1ui", 0x8DC6: "2ui", 0x8DC7: "3ui", 0x8DC8: "4ui"}
_BOOLEANS = {0x8B56: "1i", 0x8B57: "2i", 0x8B58: "3i", 0x8B59: "4i"}
_SAMPLERS = dict.fromkeys((*range(0x8B5D, 0x8B65), *range(0x8DC0, 0x8DC6), *range(0x8DC9, 0x8DD9)), "1i")
_MATRICES = {0x8B5A: "Matrix2f", 0x8B5B: "Matrix3f", 0x8B5C: "Matrix4f"}
_OBLONG = {0x8B65 + i: f"Matrix{size}f" for i, size in enumerate(("2x3", "2x4", "3x2", "3x4", "4x2", "4x3"))}
_KINDS: Mapping[int, str] = _FLOATS | _INTEGERS | _NATURALS | _BOOLEANS | _SAMPLERS | _MATRICES | _OBLONG
"""How a uniform of each type is set: the end of glUniform's name before its v."""


@dataclass(frozen=True)
class _Uniform:
    name: bytes
    location: int
    kind: str


class Handover:
    """The uniforms of one linked program of the program's own, and who has got which of their values."""

    def __init__(self, driver: Driver, name: int) -> None:
        self._driver = driver
        self._name = name
        self._uniforms = tuple(self._own_uniforms())
        self._version = 0
        self._sent: dict[int, int] = {}
        self._places: dict[int, tuple[int, ...]] = {}
        """By program: where each of the uniforms is there."""

    @property
    def unknown(self) -> str | None:
        """The name of a uniform of a type that cannot be handed over, if there is one."""
        return next((u.name.decode() for u in self._uniforms if not u.kind), None)

    def changed(self) -> None:
        """The program has given a uniform another value."""
        self._version += 1

    def send_to(self, program: int) -> None:
        """Give one of our programs, which is bound, the values of the program's uniforms."""
        if self._sent.get(program) == self._version:
            return
        gl = self._driver
        if program not in self._places:
            found = (gl.glGetUniformLocation(program, uniform.name) for uniform in self._uniforms)
            self._places[program] = tuple(found)
        self._sent[program] = self._version
        for uniform, location in zip(self._uniforms, self._places[program], strict=True):
            if location < 0:
                continue
            values, ask = self._value(uniform.kind)
            ask(self._name, uniform.location, values)
            setter = getattr(gl, f"glUniform{uniform.kind}v")
            if uniform.kind.startswith("Matrix"):
                setter(location, 1, 0, values)
            else:
                setter(location, 1, values)
        self._bind_blocks(program)

    def _value(self, kind: str) -> tuple[Any, Any]:
        """Room for a value of that kind, and the call that asks for it."""
        gl = self._driver
        if kind.endswith("f"):
            return (c_float * 16)(), gl.glGetUniformfv
        if kind.endswith("ui"):
            return (c_uint * 4)(), gl.glGetUniformuiv
        return (c_int * 4)(), gl.glGetUniformiv

    def _bind_blocks(self, program: int) -> None:
        """Let uniform blocks read the buffers that the program's own read."""
        gl = self._driver
        if gl.version < (3, 1):
            return
        count, name, binding = c_int(), create_string_buffer(256), c_int()
        gl.glGetProgramiv(self._name, _ACTIVE_BLOCKS, count)
        for block in range(count.value):
            gl.glGetActiveUniformBlockName(self._name, block, len(name), None, name)
            gl.glGetActiveUniformBlockiv(self._name, block, _BLOCK_BINDING, binding)
            there = gl.glGetUniformBlockIndex(program, name.value)
            if there != _NO_BLOCK:
                gl.glUniformBlockBinding(program, there, binding.value)

    def _own_uniforms(self) -> Iterator[_Uniform]:
        """Every element of every uniform that the program can set."""
        gl, count = self._driver, c_int()
        gl.glGetProgramiv(self._name, _ACTIVE_UNIFORMS, count)
        for index in range(count.value):
            size, kind, name = c_int(), c_uint(), create_string_buffer(256)
            gl.glGetActiveUniform(self._name, index, len(name), None, size, kind, name)
            base = name.value.removesuffix(b"[0]")
            if base.startswith(b"dome"):
                continue  # the dome's own
            for element in range(size.value):
                one = base + b"[%d]" % element if name.value.endswith(b"[0]") or size.value > 1 else base
                location = gl.glGetUniformLocation(self._name, one)
                if location >= 0:  # GL's own, as gl_Fog, have none
                    yield _Uniform(one, location, _KINDS.get(kind.value, ""))
