"""While a program's own GLSL is linked, the shader that leaves gl_Position stands exchanged for one of ours.

The shader objects keep the program's text, before and after, and so do all logs: only what is linked is ours.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from ctypes import c_char_p, c_int, c_uint, create_string_buffer
from dataclasses import dataclass

from domeshim.driver import Driver
from domeshim.shading.own import RIM_DISTANCE, Landing, Rewritten, Stage, placed, rewritten
from domeshim.shading.own_subdivided import Subdivided
from domeshim.shading.own_text import asks_place, has_main, leaves_fixed_place, uses_projection
from domeshim.shading.program import Uniforms
from domeshim.state.perspective import Matrix

_STAGES: Mapping[int, Stage] = {0x8DD9: "geometry", 0x8E87: "evaluation", 0x8B31: "vertex"}
"""The stages that can leave gl_Position, the last first."""
_KINDS: Mapping[Stage, int] = {stage: kind for kind, stage in _STAGES.items()}
_FRAGMENT, _SHADER_TYPE, _COMPILE_STATUS, _LINK_STATUS = 0x8B30, 0x8B4F, 0x8B81, 0x8B82
_ATTACHED_SHADERS, _ACTIVE_UNIFORMS, _SOURCE_LENGTH = 0x8B85, 0x8B86, 0x8B88
_OURS = {
    *("domeMode", "domeFromClip", "domeLens", "domeDepth", "domeFace", "domeEye", "domeRim", "domeEdges"),
    *("domeTurn", "domeSeat", "domeProjector", "domeWindow"),
    "gl_ClipPlane",
}


class OwnProgram(Uniforms):
    """A linked program of the program's own whose positions end on the dome."""

    def __init__(
        self,
        driver: Driver,
        name: int,
        text: str,
        landing: Rewritten,
        subdivided: Subdivided,
        *,
        own_matrices: bool,
    ) -> None:
        """text: of the program's shader that was exchanged; landing: what took its place.

        subdivided: what draws in its place what has to be subdivided.
        """
        super().__init__(driver, name)
        self.cut = landing.cut
        """It cuts by RIM_DISTANCE and EDGE_DISTANCES."""
        self.planes = RIM_DISTANCE if landing.by_planes else 0
        """So many of the program's clip planes cut what it draws."""
        self.own_matrices = own_matrices
        """Its projection, if any, is in a uniform of its own."""
        self.fixed_place = leaves_fixed_place(text)
        """It surely puts each vertex where the fixed pipeline would."""
        self.subdivided = subdivided
        """What draws in its place what has to be subdivided."""
        self.perspective: Matrix | None = None
        """The perspective last seen in such a uniform."""
        self.visible = tuple(i for i, u in enumerate(_uniforms(driver, name)) if u not in _OURS or u in text)
        """Which active uniforms are the program's own, by GL's index."""
        self.hidden = _program_value(driver, name, _ACTIVE_UNIFORMS) - len(self.visible)


@dataclass(frozen=True)
class Linked:
    """What became of a link: the program on the dome, or why it is not there."""

    program: OwnProgram | None
    complaint: str | None = None
    fragments: tuple[str, ...] = ()
    """The texts of its fragment shaders, where it has no others."""


@dataclass(frozen=True)
class _Shader:
    name: int
    stage: Stage
    text: str


def link(driver: Driver, program: int, landing: Landing, original: Callable[[], object]) -> Linked:
    """Link the program with its positions ending on the dome, or as it is where that cannot be.

    original: the program's own call of glLinkProgram; always made, and made last where ours does not link.
    """
    attached = _attached(driver, program)
    shaders = [
        _Shader(name, _STAGES[kind], _text(driver, name)) for name, kind in attached if kind in _STAGES
    ]
    mains = [s for stage in _STAGES.values() for s in shaders if s.stage == stage and has_main(s.text)]
    last = next(iter(mains), None)
    if last is None or not all(_shader_value(driver, s.name, _COMPILE_STATUS) for s in shaders):
        original()
        alone = not shaders and _program_value(driver, program, _LINK_STATUS)
        texts = (_text(driver, name) for name, kind in attached if alone and kind == _FRAGMENT)
        return Linked(None, fragments=tuple(texts))
    own_matrices = not any(uses_projection(s.text) for s in shaders)
    told = _asking(driver, attached) if last.stage != "geometry" else {}
    attempts = [(candidate, told) for candidate in rewritten(last.text, last.stage, landing)]
    if told:
        window = {name: placed(text) for name, text in told.items()}
        tells = rewritten(last.text, last.stage, landing, tells=True)
        attempts = [*((candidate, window) for candidate in tells), *attempts]
    try:
        for candidate, fragments in attempts:
            if _links(driver, program, {last.name: candidate.text, **fragments}):
                others = tuple((kind, _text(driver, name)) for name, kind in attached if name != last.name)
                stages = ((_KINDS[last.stage], last.text), *others)
                pieces = Subdivided(driver, program, last.text, stages, tells=fragments is not told)
                return Linked(
                    OwnProgram(driver, program, last.text, candidate, pieces, own_matrices=own_matrices)
                )
    finally:
        for name, text in ((last.name, last.text), *told.items()):
            _compile(driver, name, text)
    original()
    linked = _program_value(driver, program, _LINK_STATUS)
    return Linked(None, "the driver refuses it with the dome's lines" if linked else None)


def _asking(driver: Driver, attached: list[tuple[int, int]]) -> dict[int, str]:
    """The texts of the fragment shaders that ask for a fragment's place in the window, by name."""
    texts = {name: _text(driver, name) for name, kind in attached if kind == _FRAGMENT}
    return {name: text for name, text in texts.items() if asks_place(text)}


def _links(driver: Driver, program: int, texts: Mapping[int, str]) -> bool:
    """The program links with these texts in some of its shaders."""
    for name, text in texts.items():
        _compile(driver, name, text)
        if not _shader_value(driver, name, _COMPILE_STATUS):
            return False
    driver.glLinkProgram(program)
    return bool(_program_value(driver, program, _LINK_STATUS))


def _attached(driver: Driver, program: int) -> list[tuple[int, int]]:
    """(name, GL's type) of each attached shader."""
    count = _program_value(driver, program, _ATTACHED_SHADERS)
    names = (c_uint * max(count, 1))()
    driver.glGetAttachedShaders(program, count, None, names)
    return [(name, _shader_value(driver, name, _SHADER_TYPE)) for name in names[:count]]


def _uniforms(driver: Driver, program: int) -> Iterator[str]:
    """The names of the active uniforms, by index."""
    name = create_string_buffer(256)
    for index in range(_program_value(driver, program, _ACTIVE_UNIFORMS)):
        driver.glGetActiveUniform(program, index, len(name), None, c_int(), c_uint(), name)
        yield name.value.decode(errors="replace").removesuffix("[0]")


def _text(driver: Driver, shader: int) -> str:
    text = create_string_buffer(max(_shader_value(driver, shader, _SOURCE_LENGTH), 1))
    driver.glGetShaderSource(shader, len(text), None, text)
    return text.value.decode(errors="surrogateescape")


def _compile(driver: Driver, shader: int, text: str) -> None:
    driver.glShaderSource(shader, 1, c_char_p(text.encode(errors="surrogateescape")), None)
    driver.glCompileShader(shader)


def _shader_value(driver: Driver, shader: int, name: int) -> int:
    value = c_int()
    driver.glGetShaderiv(shader, name, value)
    return value.value


def _program_value(driver: Driver, program: int, name: int) -> int:
    value = c_int()
    driver.glGetProgramiv(program, name, value)
    return value.value
