"""Beside a linked program of the program's own: those that subdivide what it draws, made once needed.

The program stays as it was linked, and all questions go to it. A second one has the stages of
shading/own_pieces.py for its vertex shader and the same fragment shaders, its attributes and outputs where
the program has them, and gets the values of the program's uniforms before it draws.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from ctypes import c_char_p, c_int, c_uint, create_string_buffer
from functools import cached_property

from domeshim.draw.patches import Edged
from domeshim.driver import Driver
from domeshim.errors import ShaderError
from domeshim.shading.handover import Handover
from domeshim.shading.own import Landing
from domeshim.shading.own_pieces import Judging, handing_on, subdivided
from domeshim.shading.own_text import bare
from domeshim.shading.program import Uniforms, compiled_as_given

_VERTEX, _FRAGMENT, _CONTROL, _EVALUATION = 0x8B31, 0x8B30, 0x8E88, 0x8E87
_COMPILE_STATUS, _LINK_STATUS, _ACTIVE_ATTRIBUTES = 0x8B81, 0x8B82, 0x8B89
_OUTPUT = re.compile(r"\bout\s+(?:\w+\s+)*?\w+\s+(\w+)\s*(?:\[[^\]]*\])?\s*;")


class Subdivided:
    """The programs that subdivide what one program of the program's own draws."""

    def __init__(
        self,
        driver: Driver,
        name: int,
        text: str,
        stages: Sequence[tuple[int, str]],
        *,
        tells: bool = False,
    ) -> None:
        """text: of its vertex shader that has main(); stages: GL's kind and text of all of its shaders.

        tells: the fragment shaders want to know the clip coordinates that it leaves.
        """
        self._driver = driver
        self._name = name
        self._text = text
        self._stages = tuple(stages)
        self._tells = tells
        self._programs: dict[Edged, Uniforms] = {}
        self.complaint: str | None = None
        """Why there are none, once that has been tried."""
        if any(kind not in (_VERTEX, _FRAGMENT) for kind, _ in stages):
            self.complaint = "it has geometry or tessellation shaders of its own"
        elif any("subroutine" in text for _, text in stages):
            self.complaint = "it has subroutines"
        elif any("gl_PrimitiveID" in text for _, text in stages):
            self.complaint = "it asks for gl_PrimitiveID"

    @property
    def made(self) -> bool:
        """There is one already."""
        return bool(self._programs)

    def has(self, name: int) -> bool:
        """The program of this name is one of them."""
        return any(program.name == name for program in self._programs.values())

    @cached_property
    def _handover(self) -> Handover:
        return Handover(self._driver, self._name)

    def program(self, kind: Edged, landing: Landing, judging: Judging) -> Uniforms | None:
        """The one for these primitives; None where there can be none: complaint says why."""
        if self.complaint is None and kind not in self._programs:
            try:
                self._programs[kind] = self._link(kind, landing, judging)
            except ShaderError as error:
                self.complaint = str(error)
        return None if self.complaint is not None else self._programs[kind]

    def uniforms_changed(self) -> None:
        """The program has given a uniform another value."""
        if self._programs:
            self._handover.changed()

    def send_to(self, program: Uniforms) -> None:
        """Give one of them, which is bound, the values of the program's uniforms."""
        self._handover.send_to(program.name)

    def delete(self) -> None:
        """Free them."""
        for program in self._programs.values():
            self._driver.glDeleteProgram(program.name)
        self._programs.clear()

    def _link(self, kind: Edged, landing: Landing, judging: Judging) -> Uniforms:
        unknown = self._handover.unknown
        if unknown is not None:
            raise ShaderError(f"its uniform {unknown} cannot be handed over")
        gl, program = self._driver, self._driver.glCreateProgram()
        try:
            for stage, text in self._texts(kind, landing, judging):
                shader = compiled_as_given(gl, stage, text)
                gl.glAttachShader(program, shader)
                gl.glDeleteShader(shader)  # goes with the program
                self._require(gl.glGetShaderiv, shader, _COMPILE_STATUS)
            self._bind_names(program)
            gl.glLinkProgram(program)
            self._require(gl.glGetProgramiv, program, _LINK_STATUS)
        except ShaderError:
            gl.glDeleteProgram(program)
            raise
        return Uniforms(gl, program)

    def _texts(self, kind: Edged, landing: Landing, judging: Judging) -> Iterator[tuple[int, str]]:
        """GL's kind and text of each shader of the second program."""
        pieces = subdivided(self._text, kind, landing, judging, tells=self._tells)
        yield from zip((_VERTEX, _CONTROL, _EVALUATION), pieces, strict=True)
        for stage, text in self._stages[1:]:
            yield stage, handing_on(text) if stage == _VERTEX else text

    def _require(self, ask: object, name: int, status: int) -> None:
        done = c_int()
        ask(name, status, done)  # type: ignore[operator]
        if not done:
            raise ShaderError("the driver refuses it with tessellation shaders")

    def _bind_names(self, program: int) -> None:
        """Let attributes and the fragment shader's outputs have the numbers that they have in the program."""
        gl, count = self._driver, c_int()
        gl.glGetProgramiv(self._name, _ACTIVE_ATTRIBUTES, count)
        name = create_string_buffer(256)
        for index in range(count.value):
            gl.glGetActiveAttrib(self._name, index, len(name), None, c_int(), c_uint(), name)
            number = gl.glGetAttribLocation(self._name, name.value)
            if number >= 0:
                gl.glBindAttribLocation(program, number, c_char_p(name.value.removesuffix(b"[0]")))
        outputs = (_OUTPUT.findall(bare(text)) for stage, text in self._stages if stage == _FRAGMENT)
        for output in (found for each in outputs for found in each):
            number = gl.glGetFragDataLocation(self._name, output.encode())
            if number >= 0:
                gl.glBindFragDataLocation(program, number, output.encode())
