"""The intercepted calls on a program's own GLSL: it is linked to end on the dome, and noted as it is used."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from domeshim.intercept.dome import Dome

Call = Callable[..., Any]


def link_program(dome: Dome, original: Call) -> Call:
    """glLinkProgram."""

    def call(program: Any) -> Any:
        if dome.context is None:
            return original(program)
        return dome.context.program_linked(name_of(program), lambda: original(program))

    return call


def use_program(dome: Dome, original: Call) -> Call:
    """glUseProgram."""

    def call(program: Any) -> Any:
        if dome.context is None:
            return original(program)
        dome.context.undress()
        result = original(program)
        dome.context.program_used(name_of(program))
        return result

    return call


def delete_program(dome: Dome, original: Call) -> Call:
    """glDeleteProgram and glDeleteObjectARB."""

    def call(program: Any) -> Any:
        if dome.context is not None:
            dome.context.own.forget(name_of(program))
        return original(program)

    return call


def uniform(dome: Dome, original: Call) -> Call:
    """glUniform of all kinds."""

    def call(*args: Any) -> Any:
        if dome.context is not None:
            dome.context.uniform_sent()
        return original(*args)

    return call


def uniform_matrix(dome: Dome, original: Call) -> Call:
    """glUniformMatrix4fv: the perspective may be in there."""

    def call(location: Any, *args: Any) -> Any:
        if dome.context is not None:
            dome.context.uniform_sent()
        result = original(location, *args)
        if dome.context is not None:
            dome.context.matrix_sent(int(location))
        return result

    return call


def name_of(program: Any) -> int:
    """The number that a program is called by, given as any kind of integer."""
    return int(getattr(program, "value", program) or 0)
