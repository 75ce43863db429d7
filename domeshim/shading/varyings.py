"""What a program's own vertex shader hands on, found in its text: pure, and tested as text.

Each of its declarations becomes an interface block, in place: the names stay those of its statements, and two
more stages can take the same names in and out.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from domeshim.errors import ShaderError

_QUALIFIER = r"(?:invariant|flat|smooth|noperspective|centroid|sample|highp|mediump|lowp|layout\s*\([^)]*\))"
_QUALIFIERS = rf"(?:{_QUALIFIER}\s*\b\s*)*"
_DECLARATION = re.compile(
    rf"(?P<before>{_QUALIFIERS})\b(?P<keyword>varying|out)\s+(?P<after>{_QUALIFIERS})"
    r"(?P<type>\w+)\s*(?P<size>\[[^\]]*\])?\s*(?P<names>\b[^;{}()=]+);"
)
_BLOCK = re.compile(
    rf"(?P<before>{_QUALIFIERS})\bout\s+(?P<name>\w+)\s*\{{(?P<members>[^{{}}]*)\}}"
    r"\s*(?P<instance>\w+)?\s*(?P<array>\[[^\]]*\])?\s*;"
)
_MEMBER = re.compile(rf"(?P<before>{_QUALIFIERS})(?P<type>\w+)\s*(?P<size>\[[^\]]*\])?\s*(?P<names>\b[^;]+);")
_INTERPOLATION = re.compile(r"\b(flat|noperspective|centroid|sample)\b")
_SMOOTH = re.compile(r"float|vec[234]|mat[234](x[234])?")
_WHOLE = re.compile(r"u?int|[iu]vec[234]|double|dvec[234]|dmat[234](x[234])?")
_COORDINATES = re.compile(r"\bgl_TexCoord\s*\[\s*(\d*)")
_DISTANCES = re.compile(r"\bgl_ClipDistance\s*\[\s*(\d*)")
_PLAIN = (
    *("gl_FrontColor", "gl_BackColor", "gl_FrontSecondaryColor", "gl_BackSecondaryColor"),
    *("gl_FogFragCoord", "gl_PointSize"),
)


@dataclass(frozen=True)
class Member:
    """One value that is handed on."""

    qualifiers: str
    """How it is interpolated, as in "flat centroid"."""
    type: str
    name: str
    size: str
    """As in "[4]"; empty where it is no array."""

    @property
    def flat(self) -> bool:
        """One corner of each primitive gives it."""
        return "flat" in self.qualifiers or _WHOLE.fullmatch(self.type) is not None

    @property
    def declaration(self) -> str:
        """As it stands in a block."""
        return f"{self.qualifiers} {self.type} {self.name}{self.size};".lstrip()


@dataclass(frozen=True)
class Block:
    """Values that are handed on together."""

    name: str
    members: tuple[Member, ...]
    instance: str = ""
    """Its name in the program's statements, if it has one there."""
    given: bool = False
    """The program itself has them in a block."""


@dataclass(frozen=True)
class Handed:
    """A vertex shader whose declarations are blocks, and all that it hands on beside gl_Position."""

    text: str
    """With as many lines as before."""
    blocks: tuple[Block, ...]
    built_in: tuple[str, ...]
    """As in gl_TexCoord[1]."""


def handed_on(text: str, bare: str) -> Handed:
    """What a vertex shader hands on; bare: its text with the comments blanked, every character where it was.

    Raises ShaderError where that cannot be taken through two more stages.
    """
    code = re.sub(r"(?m)^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda m: re.sub(r"[^\n]", " ", m[0]), bare)
    parts, done = list[str](), 0
    blocks = dict[str, Block]()
    sizes = dict[str, str]()
    for match in _top_level(code):
        found = _block(match) if match.re is _BLOCK else _declared(match)
        if all(member.name.startswith("gl_") for member in found.members):
            sizes |= {member.name: member.size for member in found.members}
            continue
        blocks[found.name] = found
        if not found.given:
            members = " ".join(member.declaration for member in found.members)
            whole = f"out {found.name} {{ {members} }};" + "\n" * match[0].count("\n")
            parts += [text[done : match.start()], whole]
            done = match.end()
    return Handed("".join([*parts, text[done:]]), tuple(blocks.values()), tuple(_built_in(code, sizes)))


def _top_level(code: str) -> list[re.Match[str]]:
    """The declarations that stand in no function and in no list of parameters."""
    found = sorted(
        [*_DECLARATION.finditer(code), *_BLOCK.finditer(code)], key=lambda match: match.start("before")
    )
    depth, done, top = 0, 0, list[re.Match[str]]()
    for match in found:
        between = code[done : match.start()]
        depth += sum(between.count(c) for c in "({") - sum(between.count(c) for c in ")}")
        done = match.start()
        if depth == 0:
            top.append(match)
    return top


def _declared(match: re.Match[str]) -> Block:
    qualifiers = " ".join(_INTERPOLATION.findall(match["before"] + " " + match["after"]))
    members = _members(qualifiers, match)
    return Block("DomeOut_" + "_".join(member.name for member in members), members)


def _block(match: re.Match[str]) -> Block:
    if match["array"]:
        raise ShaderError(f"it hands on an array of blocks, {match['name']}")
    members = list[Member]()
    for member in _MEMBER.finditer(match["members"]):
        members += _members(
            " ".join(_INTERPOLATION.findall(match["before"] + " " + member["before"])), member
        )
    return Block(match["name"], tuple(members), match["instance"] or "", given=True)


def _members(qualifiers: str, match: re.Match[str]) -> tuple[Member, ...]:
    kind = match["type"]
    if not _SMOOTH.fullmatch(kind) and not _WHOLE.fullmatch(kind):
        raise ShaderError(f"it hands on a value of type {kind}")
    members = []
    for each in match["names"].split(","):
        name, bracket, size = "".join(each.split()).partition("[")
        members.append(Member(qualifiers, kind, name, bracket + size + (match["size"] or "")))
    return tuple(members)


def _built_in(code: str, sizes: dict[str, str]) -> list[str]:
    """GL's own outputs that are written, or may be."""
    found = [name for name in _PLAIN if re.search(rf"\b{name}\b", code)]
    for name, indices in (("gl_TexCoord", _COORDINATES), ("gl_ClipDistance", _DISTANCES)):
        numbers = set(indices.findall(code.replace(name + sizes.get(name, "["), name + "[", 1)))
        if "" in numbers:
            size = sizes.get(name, "").strip("[]")
            if not size.isdigit():
                raise ShaderError(f"which of {name} it hands on cannot be told")
            numbers = {str(i) for i in range(int(size))}
        found += [f"{name}[{number}]" for number in sorted(numbers, key=int)]
    return found
