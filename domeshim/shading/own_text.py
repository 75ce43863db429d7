"""The text of a program's own shader: its version, what it says of itself, and where more may stand in it."""

from __future__ import annotations

import re
from dataclasses import dataclass

_RAISED = "#version 150 compatibility"
"""What an older shader becomes."""
_RAISED_LEGACY = "#version 120"
"""The same on OpenGL 2."""
_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
_VERSION = re.compile(r"[ \t]*#[ \t]*version[ \t]+(\d+)[ \t]*(\w*)")
_DIRECTIVE = re.compile(r"\s*#\s*(if|endif|extension)?")
_PROJECTION = re.compile(r"\b(ftransform|gl_(ModelView)?Projection\w*)\b")
_FIXED_PLACES = {
    "ftransform",
    "gl_ModelViewProjectionMatrix*gl_Vertex",
    "gl_ProjectionMatrix*gl_ModelViewMatrix*gl_Vertex",
}
"""What puts a vertex where the fixed pipeline does, without its spaces and brackets."""
_POSITION = re.compile(r"\bgl_Position\s*=\s*([^;=]+);")
_LOCAL = re.compile(r"\bvec4\s+(\w+)\s*=\s*([^;{}]+);")
_GIVES_BACK = re.compile(r"\b(in)?out\s+\w+\s+\w+\s*[,)]")
_MAIN = re.compile(r"\bmain\s*\(")
_PLACE = re.compile(r"\bgl_FragCoord\b")
_PLACE_REDECLARED = re.compile(r"\b(in|vec4)\s+gl_FragCoord\b")


@dataclass(frozen=True)
class Versioned:
    """A shader's text without its version, and that."""

    text: str
    """With as many lines as before."""
    line: str
    number: int
    profile: str

    @classmethod
    def of(cls, text: str) -> Versioned:
        """Take a text apart."""
        version = _VERSION.search(bare(text))
        if version is None:
            return cls(text, "#version 110", 110, "")
        # A directive may stand below comments; the text keeps its lines.
        whole = text[: version.start()] + text[version.end() :]
        return cls(whole, version[0].strip(), int(version[1]), version[2])

    @property
    def embedded(self) -> bool:
        """It is of OpenGL ES."""
        return self.profile == "es" or self.number == 100

    def raised(self, *, legacy: bool = False) -> str:
        """The version that has clip distances, or on OpenGL 2 the dome's; its own where that is later."""
        older, newer = (120, _RAISED_LEGACY) if legacy else (150, _RAISED)
        return newer if self.number < older else self.line


def uses_projection(text: str) -> bool:
    """The shader takes its projection from GL's own matrix, not from a uniform of the program's."""
    return bool(_PROJECTION.search(bare(text)))


def leaves_fixed_place(text: str) -> bool:
    """The shader surely puts each vertex where the fixed pipeline would."""
    code = bare(text)
    position = _POSITION.search(code)
    if position is None or code.count("gl_Position") > 1:
        return False
    formula = position[1]
    if not _GIVES_BACK.search(code):  # else a function may change what a name stands for
        for name, value in reversed(_LOCAL.findall(code)):
            assigned = re.findall(rf"\b{name}\b\s*(?:\.\w+\s*|\[[^\]]*\]\s*)*[-+*/]?=(?!=)", code)
            if len(assigned) == 1:
                formula = f"({value})".join(re.split(rf"\b{name}\b", formula))
    return re.sub(r"[\s()]", "", formula) in _FIXED_PLACES


def has_main(text: str) -> bool:
    """The shader is the one of its stage that GL calls."""
    return bool(_MAIN.search(bare(text)))


def asks_place(text: str) -> bool:
    """The fragment shader reads gl_FragCoord, and can be told where the monitor would show a fragment."""
    code = bare(text)
    known = not Versioned.of(text).embedded
    return known and bool(_PLACE.search(code)) and not _PLACE_REDECLARED.search(code)


def opened(text: str, before: str) -> str:
    """A shader's text, without its version, with more before its first declaration."""
    lines, first = text.split("\n"), _top(text)
    return "\n".join([*lines[:first], before, *lines[first:]])


def bare(text: str) -> str:
    """The text with its comments blanked, every line where it was."""
    return _COMMENT.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), text)


def _top(text: str) -> int:
    """The first line that declarations may stand on: below every #extension, and in no #if."""
    top, opened, extension, continued = 0, list[int](), False, False
    for number, line in enumerate(bare(text).split("\n")):
        directive = None if continued else _DIRECTIVE.match(line)
        if directive is None and line.strip() and not continued:
            break
        match directive and directive[1]:
            case "if":
                opened.append(number)
            case "endif" if opened:
                opened.pop()
            case "extension":
                extension = True
        if extension and not opened:
            top, extension = number + 1, False
        continued = (continued or directive is not None) and line.endswith("\\")
    return opened[0] if extension else top
