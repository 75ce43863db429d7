"""A program's own vertex shader, subdivided: three stages in its place. Pure, and tested as text.

Its vertex shader leaves its own clip coordinates; a control shader finds the pieces of each edge by its
angle, as method tessellate does, and an evaluation shader blends all that it hands on and takes the new
vertex onto the dome, as the exchanged shader does with the program's own vertices (shading/own.py).
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import NamedTuple

from domeshim.draw.patches import Edged
from domeshim.errors import ShaderError
from domeshim.shading.own import Landing, landing_text, planes_of
from domeshim.shading.own_text import Versioned, bare, opened
from domeshim.shading.snippets import snippet
from domeshim.shading.varyings import Block, Handed, Member, handed_on

_OLDEST = 400
"""The GLSL that has tessellation shaders."""
_CORNERS = {"lines": 2, "triangles": 3}
_FUNCTION = re.compile(r"^(?:void|bool|int|float|vec[234]) (\w+)\(", re.MULTILINE)
_CLIP_VERTEX = "#define gl_ClipVertex domeClipVertex\n"
_CLIP_BLOCK = Block("DomeOut_domeClipVertex", (Member("", "vec4", "domeClipVertex", ""),))


@dataclass(frozen=True)
class Judging:
    """How a session's dome finds an edge's pieces."""

    near_behind: bool = False
    """What comes near to straight behind is cut finer."""


class Pieces(NamedTuple):
    """The texts of the stages that stand in for a vertex shader."""

    vertex: str
    control: str
    evaluation: str


def subdivided(text: str, kind: Edged, landing: Landing, judging: Judging, *, tells: bool = False) -> Pieces:
    """The stages for one of a program's vertex shaders, the one that has main().

    tells: as in shading/own.py.
    Raises ShaderError where what it hands on cannot be blended.
    """
    own = Versioned.of(text)
    if own.embedded:
        raise ShaderError("it is written for OpenGL ES")
    version = own.raised()
    planes = planes_of(own.text, version, landing, cut=True)
    handed = handed_on(own.text, bare(own.text))
    vertex, blocks = handed.text, list(handed.blocks)
    if planes == "clip vertex":
        vertex = opened(vertex, _CLIP_VERTEX + f"out {_CLIP_BLOCK.name} {{ vec4 domeClipVertex; }};\n")
        blocks.append(_CLIP_BLOCK)
    core = own.number >= 150 and own.profile != "compatibility"
    later = f"#version {max(own.number, _OLDEST)} {'core' if core else 'compatibility'}\n"
    handed = Handed(vertex, tuple(blocks), handed.built_in)
    told = "out vec4 domeClip;\n" if tells else ""
    evaluation = _evaluation(handed, kind, told + landing_text(landing, cut=True, planes=planes, tells=tells))
    return Pieces(
        f"{version}\n{vertex}", later + _control(handed, kind, landing, judging), later + evaluation
    )


def handing_on(text: str) -> str:
    """Another vertex shader of the same program, with its declarations in the same form."""
    own = Versioned.of(text)
    return f"{own.raised()}\n{handed_on(own.text, bare(own.text)).text}"


def _control(handed: Handed, kind: Edged, landing: Landing, judging: Judging) -> str:
    shape = kind.removesuffix("s")
    names = ["own/land", "own/place", "tessellate/direction", "tessellate/angle"]
    if landing.aim != "straight":
        names.append(f"aim/{landing.aim}")
    names.append(f"clip/{landing.clip}")
    reach = {"straight": "dome", "turned": "turned", "seated": "all"}[landing.aim]
    names += [f"tessellate/reach_{reach}", f"tessellate/need{'_behind' if judging.near_behind else ''}"]
    names += ["tessellate/pieces", f"tessellate/{shape}_edges", "tessellate/edge_weights", "own/halves"]
    names += [f"tessellate/{shape}_levels", f"own/{shape}.tesc"]
    parts = ["#define DOME_MOST_PIECES 64.0\n", *(snippet(name) for name in names)]
    here, statements = "gl_InvocationID", list[str]()
    for number, block in enumerate(handed.blocks):
        parts.append(_block("in", block, block.name, f"domeIn{number}[]"))
        parts.append(_block("out", block, f"DomePatch{number}", f"domeOut{number}[]"))
        statements += [
            f"domeOut{number}[{here}].{m.name} = domeIn{number}[{here}].{m.name};" for m in block.members
        ]
    statements += [
        f"gl_out[{here}].{name} = gl_in[{here}].{name};" for name in ("gl_Position", *handed.built_in)
    ]
    statements.append(f"if ({here} == 0) subdivide();")
    return "".join(parts) + _main(statements)


def _evaluation(handed: Handed, kind: Edged, landing: str) -> str:
    shape, corners = kind.removesuffix("s"), _CORNERS[kind]
    names = ["tessellate/edge_weights", *(["tessellate/triangle_weights"] if corners == 3 else [])]
    names += [f"tessellate/{shape}.tese", f"own/{shape}.tese", "own/flat"]
    parts = [landing, _renamed("".join(snippet(name) for name in names))]
    statements = [
        f"vec{corners} domeB = domeShare();",
        f"precise vec4 domeAt = {_blend('gl_in[{}].gl_Position', corners)};",
    ]
    last = corners - 1
    for name in handed.built_in:
        blend = _blend(f"gl_in[{{}}].{name}", corners)
        flat = f"domeFlat > 0.5 ? gl_in[{last}].{name} : " if "Color" in name else ""
        statements.append(f"{name} = {flat}{blend};")
    for number, block in enumerate(handed.blocks):
        parts.append(_block("in", block, f"DomePatch{number}", f"domeIn{number}[]"))
        if block.given:
            parts.append(_block("out", block, block.name, block.instance))
        elif block is not _CLIP_BLOCK:  # domeLand() has that one itself
            parts += [_alone(member) for member in block.members]
        for member in block.members:
            to = f"{block.instance}.{member.name}" if block.instance else member.name
            statements.append(_handing(member, to, f"domeIn{number}[{{}}].{member.name}", corners))
    statements += ["gl_Position = domeAt;", "domeLand();"]
    return "".join(parts) + _main(statements)


def _handing(member: Member, to: str, corner: str, corners: int) -> str:
    """The statement that gives a vertex its value."""
    if member.flat:
        return f"{to} = {corner.format(corners - 1)};"
    if not member.size:
        return f"{to} = {_blend(corner, corners)};"
    each = _blend(f"{corner}[domeI]", corners)
    return f"for (int domeI = 0; domeI < {to}.length(); ++domeI) {to}[domeI] = {each};"


def _blend(of_corner: str, corners: int) -> str:
    return " + ".join(f"domeB.{'xyz'[i]} * {of_corner.format(i)}" for i in range(corners))


def _alone(member: Member) -> str:
    """The declaration of a value that goes to the fragment shader by its own name."""
    flat = "" if "flat" in member.qualifiers or not member.flat else "flat "
    qualifiers = f"{flat}{member.qualifiers}".strip()
    return f"{qualifiers} out {member.type} {member.name}{member.size};\n".lstrip()


def _block(way: str, block: Block, name: str, instance: str) -> str:
    members = " ".join(member.declaration for member in block.members)
    return f"{way} {name} {{ {members} }} {instance};\n" if instance else f"{way} {name} {{ {members} }};\n"


def _main(statements: list[str]) -> str:
    return "\n".join(["void main() {", *(f"    {statement}" for statement in statements), "}", ""])


def _renamed(text: str) -> str:
    """Snippets whose functions have names that no program's values have: place becomes domePlace."""
    names = {name for name in _FUNCTION.findall(text) if not name.startswith("dome")}
    return re.sub(
        r"\b(" + "|".join(sorted(names)) + r")\b", lambda m: f"dome{m[0][0].upper()}{m[0][1:]}", text
    )
