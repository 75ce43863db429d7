"""A program of fragment shaders alone: the dome's own vertex shaders stand in for GL's fixed vertex stage.

The program stays as it was linked. For each recipe there is one more program, of the dome's vertex stage and
the same fragment shaders, that gets the values of the program's uniforms before it draws.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from domeshim.driver import Driver
from domeshim.shading.handover import Handover
from domeshim.shading.program import Program, compiled_as_given
from domeshim.shading.recipe import Recipe

_FRAGMENT = 0x8B30
_COORDINATES = re.compile(r"\bgl_TexCoord\s*\[\s*(\d)\s*\]")


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
        self.shaders = tuple(compiled_as_given(driver, _FRAGMENT, text) for text in texts)
        self._handover = Handover(driver, name)

    @property
    def unknown(self) -> str | None:
        """The name of a uniform of a type that cannot be handed over, if there is one."""
        return self._handover.unknown

    def uniforms_changed(self) -> None:
        """The program has given a uniform another value."""
        self._handover.changed()

    def send_to(self, program: Program) -> None:
        """Give one of our programs, which is bound, the values of the program's uniforms."""
        self._handover.send_to(program.name)

    def delete(self) -> None:
        """Free what was made for the program."""
        for program in self.programs.values():
            self._driver.glDeleteProgram(program.name)
        for shader in self.shaders:
            self._driver.glDeleteShader(shader)
