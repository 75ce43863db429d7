"""GLSL text becomes a program in the driver, and uniforms reach it, each only when it changed."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from ctypes import c_char_p, c_float, c_int, create_string_buffer
from typing import TYPE_CHECKING

from domeshim.errors import ShaderError

if TYPE_CHECKING:
    from domeshim.driver import Driver
    from domeshim.shading.draft import Source

_VERTEX, _FRAGMENT, _CONTROL, _EVALUATION, _GEOMETRY = 0x8B31, 0x8B30, 0x8E88, 0x8E87, 0x8DD9
_INTERLEAVED = 0x8C8C
_COMPILE_STATUS, _LINK_STATUS, _INFO_LOG_LENGTH = 0x8B81, 0x8B82, 0x8B84
_PLACE_IN_LOG = re.compile(r"\b0(?::(\d+)|\((\d+)\))")


class Uniforms:
    """The uniforms of a linked program of one GL context."""

    def __init__(self, driver: Driver, program: int) -> None:
        self._driver = driver
        self._locations: dict[str, int] = {}
        self._sent: dict[str, tuple[float, ...]] = {}
        self.name = program

    def set(self, uniform: str, values: Sequence[float]) -> None:
        """Give a uniform its value; the program must be bound. Unchanged values are not sent again.

        values: 1 to 4 floats for a float or vector; 9 or 16, column-major, for a mat3 or mat4; other numbers
        up to 16 for an array of float; more for one of vec4.
        """
        wanted = tuple(values)
        if self._sent.get(uniform) == wanted:
            return
        self._sent[uniform] = wanted
        location = self._locations.get(uniform)
        if location is None:
            location = self._locations[uniform] = self._driver.glGetUniformLocation(
                self.name, uniform.encode()
            )
        data = (c_float * len(wanted))(*wanted)
        match len(wanted):
            case 2:
                self._driver.glUniform2fv(location, 1, data)
            case 3:
                self._driver.glUniform3fv(location, 1, data)
            case 4:
                self._driver.glUniform4fv(location, 1, data)
            case 9:
                self._driver.glUniformMatrix3fv(location, 1, 0, data)
            case 16:
                self._driver.glUniformMatrix4fv(location, 1, 0, data)
            case count if count > 16:
                self._driver.glUniform4fv(location, count // 4, data)
            case count:
                self._driver.glUniform1fv(location, count, data)


class Program(Uniforms):
    """A linked program of one GL context.

    attached: compiled shader objects that go in beside the sources; attributes: the number of each generic
    vertex attribute, by its name in the vertex shader; caught: what of each vertex transform feedback takes.

    Raises ShaderError with the driver's words, each place in them named by our file and line.
    """

    def __init__(
        self,
        driver: Driver,
        vertex: Source,
        fragment: Source | None = None,
        control: Source | None = None,
        evaluation: Source | None = None,
        geometry: Source | None = None,
        attached: Sequence[int] = (),
        attributes: Mapping[str, int] | None = None,
        caught: Sequence[str] = (),
    ) -> None:
        super().__init__(driver, driver.glCreateProgram())
        stages = {
            _VERTEX: vertex,
            _CONTROL: control,
            _EVALUATION: evaluation,
            _GEOMETRY: geometry,
            _FRAGMENT: fragment,
        }
        for stage, source in stages.items():
            if source is None:
                continue
            shader = _compile(driver, stage, source)
            driver.glAttachShader(self.name, shader)
            driver.glDeleteShader(shader)  # goes with the program
        for shader in attached:
            driver.glAttachShader(self.name, shader)
        for name, number in (attributes or {}).items():
            driver.glBindAttribLocation(self.name, number, name.encode())
        if caught:
            names = (c_char_p * len(caught))(*(name.encode() for name in caught))
            driver.glTransformFeedbackVaryings(self.name, len(caught), names, _INTERLEAVED)
        driver.glLinkProgram(self.name)
        linked = c_int()
        driver.glGetProgramiv(self.name, _LINK_STATUS, linked)
        if not linked:
            log = _log(driver.glGetProgramiv, driver.glGetProgramInfoLog, self.name)
            raise ShaderError("the driver refused to link: " + explain(log, vertex))


def compiled_as_given(driver: Driver, stage: int, text: str) -> int:
    """A shader object of a text of the program's own, which the driver has taken before."""
    shader: int = driver.glCreateShader(stage)
    driver.glShaderSource(shader, 1, c_char_p(text.encode(errors="surrogateescape")), None)
    driver.glCompileShader(shader)
    return shader


def explain(log: str, source: Source) -> str:
    """A driver's log with its places named by our files; Mesa writes 0:7(5), NVIDIA 0(7)."""
    return _PLACE_IN_LOG.sub(lambda match: source.place(int(match[1] or match[2])), log)


def _compile(driver: Driver, stage: int, source: Source) -> int:
    shader: int = driver.glCreateShader(stage)
    text = source.text.encode()
    driver.glShaderSource(shader, 1, c_char_p(text), None)
    driver.glCompileShader(shader)
    compiled = c_int()
    driver.glGetShaderiv(shader, _COMPILE_STATUS, compiled)
    if not compiled:
        log = _log(driver.glGetShaderiv, driver.glGetShaderInfoLog, shader)
        raise ShaderError("the driver refused a shader: " + explain(log, source))
    return shader


def _log(get_size: Callable[..., None], get_log: Callable[..., None], name: int) -> str:
    size = c_int()
    get_size(name, _INFO_LOG_LENGTH, size)
    text = create_string_buffer(max(size.value, 1))
    get_log(name, len(text), None, text)
    return text.value.decode(errors="replace").strip()
