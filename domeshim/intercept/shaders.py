"""The intercepted calls on a program's own GLSL: it is linked to end on the dome, and noted as it is used."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from domeshim.intercept.dome import Dome

if TYPE_CHECKING:
    from domeshim.shading.exchange import OwnProgram

Call = Callable[..., Any]

_ACTIVE_UNIFORMS, _VERTEX_PROGRAM = 0x8B86, 0x8620


def link_program(dome: Dome, original: Call) -> Call:
    """glLinkProgram."""

    def call(program: Any) -> Any:
        if dome.context is None:
            return original(program)
        return dome.context.binding.linked(name_of(program), lambda: original(program))

    return call


def use_program(dome: Dome, original: Call) -> Call:
    """glUseProgram."""

    def call(program: Any) -> Any:
        if dome.context is None:
            return original(program)
        dome.context.undress()
        result = original(program)
        dome.context.binding.used(name_of(program))
        return result

    return call


def noting_assembly(make: Callable[[Dome, Call], Call], *, on: bool) -> Callable[[Dome, Call], Call]:
    """glEnable (on) and glDisable, which switch vertex programs in assembly language too."""

    def making(dome: Dome, original: Call) -> Call:
        switch = make(dome, original)

        def call(capability: Any, *args: Any) -> Any:
            if capability == _VERTEX_PROGRAM and dome.context is not None:
                dome.context.aside.bypass("assembly", on)
                if on:
                    dome.context.say_once(
                        "a vertex program in assembly language is not bent and draws as on the monitor"
                    )
            return switch(capability, *args)

        return call

    return making


def delete_program(dome: Dome, original: Call) -> Call:
    """glDeleteProgram and glDeleteObjectARB."""

    def call(program: Any) -> Any:
        if dome.context is not None:
            dome.context.undress()
            dome.context.own.forget(name_of(program))
        return original(program)

    return call


def uniform(dome: Dome, original: Call) -> Call:
    """glUniform of all kinds."""

    def call(*args: Any) -> Any:
        if dome.context is not None:
            dome.context.binding.uniform_sent()
        return original(*args)

    return call


def uniform_matrix(dome: Dome, original: Call) -> Call:
    """glUniformMatrix4fv: the perspective may be in there."""

    def call(location: Any, *args: Any) -> Any:
        if dome.context is not None:
            dome.context.binding.uniform_sent()
        result = original(location, *args)
        if dome.context is not None:
            dome.context.binding.matrix_sent(int(location))
        return result

    return call


def program_value(dome: Dome, original: Call) -> Call:
    """glGetProgramiv and glGetObjectParameterivARB: the dome's uniforms do not count."""

    def call(program: Any, pname: Any, *args: Any, **named: Any) -> Any:
        result = original(program, pname, *args, **named)
        own = _own(dome, program)
        if own is None or pname != _ACTIVE_UNIFORMS:
            return result
        for given in (*args, *named.values()):
            if hasattr(given, "value"):
                given.value -= own.hidden
            else:
                given[0] -= own.hidden
            return result
        return result - own.hidden

    return call


def active_uniform(dome: Dome, original: Call) -> Call:
    """glGetActiveUniform: by its number among the program's own uniforms."""

    def call(program: Any, index: Any, *args: Any, **named: Any) -> Any:
        own = _own(dome, program)
        if own is not None:
            number = name_of(index)
            index = own.visible[number] if number < len(own.visible) else number + own.hidden
        return original(program, index, *args, **named)

    return call


def _own(dome: Dome, program: Any) -> OwnProgram | None:
    return dome.context.own.named(name_of(program)) if dome.context is not None else None


def name_of(program: Any) -> int:
    """The number that a program is called by, given as any kind of integer."""
    return int(getattr(program, "value", program) or 0)
