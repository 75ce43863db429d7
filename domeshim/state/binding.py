"""What a call means that binds or changes the program's own GLSL."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from domeshim.state.context import DomeContext

_CURRENT_PROGRAM = 0x8B8D


class Binding:
    """The program's own GLSL as one context hears of it."""

    def __init__(self, context: DomeContext) -> None:
        self._context = context

    def used(self, name: int) -> None:
        """The program has bound a GLSL program of its own, or 0."""
        context = self._context
        before = context.own.source
        context.own.use(name)
        if context.own.source is not before:
            context.viewport_changed()
        self._bypass(name)

    def linked(self, name: int, original: Callable[[], object]) -> None:
        """The program links one of its own; original: its own call."""
        context = self._context
        context.undress()
        context.own.link(name, original)
        if context.driver.integer(_CURRENT_PROGRAM) == name:
            context.viewport_changed()
            self._bypass(name)

    def uniform_sent(self) -> None:
        """The program is about to give a uniform of its own a value."""
        own = self._context.own
        if own.hands_over:
            worn = self._context.worn.dressing
            if worn is not None and worn.program:
                self._context.undress()  # the program's own takes the value
            own.uniforms_changed()

    def matrix_sent(self, location: int) -> None:
        """The program has sent a matrix to a uniform of its own."""
        context = self._context
        _, _, width, height = context.frame.outer
        p = context.own.matrix_sent(location, width / height)
        if p is not None:
            context.placer.perspective_set(p, on_modelview=False)
            context.viewport_changed()

    def _bypass(self, name: int) -> None:
        """Stay out of the draws of a program that cannot end on the dome, and say why."""
        context, own = self._context, self._context.own
        out = name != 0 and own.current is None and own.fragments is None
        context.aside.bypass("program", on=out)
        units = own.fragments.texture_units if own.fragments else frozenset()
        if units != context.scene.read_units:
            context.scene.read_units = units
            context.scene.stale.add("textures")
        if out:
            why = own.complaints.get(name, "not linked from GLSL that could be seen")
            context.say_once(f"the program's own GLSL is not bent and draws as on the monitor: {why}")
