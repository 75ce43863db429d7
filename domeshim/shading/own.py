"""A program's own shader becomes one that ends on the dome: pure, and tested as text.

Its main() runs as it is, under another name; ours calls it and takes the gl_Position that it leaves onto the
dome. In a geometry shader each EmitVertex() does so instead.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

from domeshim.shading.recipe import RADIAL, Clip
from domeshim.shading.snippets import snippet

Stage = Literal["vertex", "evaluation", "geometry"]

Planes = Literal["kept", "clip vertex", "open", "legacy"]
"""What becomes of the first three clip distances: the shader's own, the program's clip planes by the shader's
gl_ClipVertex, or nothing is cut (without a gl_ClipVertex, GL leaves it open what clip planes do); legacy:
there are none."""

RIM_DISTANCE, EDGE_DISTANCES = 3, (4, 5, 6, 7)
"""The clip distances of the rim, and of the viewport's and scissor's edges; the lower are the program's."""

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
_MAIN_AROUND = """\
#undef main
void main() {
    domeProgramMain();
    domeLand();
}
"""
_EMIT_AROUND = """\
void domeEmit() {
    domeLand();
    EmitVertex();
}
#define EmitVertex domeEmit
"""
_PLACE = re.compile(r"\bgl_FragCoord\b")
_PLACE_REDECLARED = re.compile(r"\b(in|vec4)\s+gl_FragCoord\b")
_CLIP_VERTEX = "vec4 domeClipVertex;\n#define gl_ClipVertex domeClipVertex\n"
"""What is above it keeps GL's own."""
_NAMES = re.compile(
    r"\b(beside|bent|landed|onFace|lensRadius|aimed|inFront|insideViewport|onSurface|onGrid)\b"
)


@dataclass(frozen=True)
class Landing:
    """How a session's dome takes a position: what is the same for all of a program's draws."""

    lens: tuple[str, ...] = RADIAL
    aim: Literal["straight", "turned", "seated"] = "straight"
    clip: Clip = "behind"
    face: bool = False
    """Onto the faces of a cube."""
    beside: bool = False
    """As an eye sees it that stands beside the viewer's middle."""
    keystone: bool = False
    """The disc's square goes to four corners."""
    grid: bool = False
    """Vertices are brought onto the driver's own steps within a pixel."""
    legacy: bool = False
    """OpenGL 2: parts of gl_ClipVertex stand in for clip distances."""


@dataclass(frozen=True)
class Rewritten:
    """A shader's text that ends on the dome."""

    text: str
    cut: bool
    """It cuts at the dome's rim and the panel's edges, by RIM_DISTANCE and EDGE_DISTANCES.

    On OpenGL 2 gl_ClipVertex.x is the rim's, or all of it are the panel's four edges'.
    """
    by_planes: bool
    """The program's first clip planes, or distances, cut by the ones below those."""


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


def rewritten(text: str, stage: Stage, landing: Landing, *, tells: bool = False) -> tuple[Rewritten, ...]:
    """The shader's text ending on the dome, best first: what a driver refuses of one, the next does without.

    The first is raised to a GLSL with clip distances, if there is any; the last stays at the program's.
    tells: fragment shaders want to know the clip coordinates that it leaves.
    """
    own = Versioned.of(text)
    if own.embedded:
        return (_joined(own.line, own.text, stage, landing, cut=False),)
    return (
        _joined(own.raised(legacy=landing.legacy), own.text, stage, landing, cut=True, tells=tells),
        _joined(own.line, own.text, stage, landing, cut=False, tells=tells),
    )


def asks_place(text: str) -> bool:
    """The fragment shader reads gl_FragCoord, and can be told where the monitor would show a fragment."""
    code = bare(text)
    known = not Versioned.of(text).embedded
    return known and bool(_PLACE.search(code)) and not _PLACE_REDECLARED.search(code)


def placed(text: str) -> str:
    """A fragment shader's text whose gl_FragCoord is a place in the program's window."""
    own = Versioned.of(text)
    told = f"{'varying' if own.number < 130 else 'in'} vec4 domeClip;\n"
    before = told + snippet("own/window") + "#define gl_FragCoord domeFragCoord()\n"
    return f"{own.line}\n{opened(own.text, before)}"


def _joined(
    version: str, text: str, stage: Stage, landing: Landing, *, cut: bool, tells: bool = False
) -> Rewritten:
    planes = planes_of(text, version, landing, cut=cut)
    around = _EMIT_AROUND if stage == "geometry" else "#define main domeProgramMain\n"
    before = landing_text(landing, cut=cut, planes=planes, tells=tells) + around
    if tells:
        before = f"{'varying' if Versioned.of(version).number < 130 else 'out'} vec4 domeClip;\n{before}"
    after = "" if stage == "geometry" else _MAIN_AROUND
    return Rewritten(
        version + "\n" + opened(text, before) + "\n" + after,
        cut,
        by_planes=cut and planes in ("kept", "clip vertex"),
    )


def planes_of(text: str, version: str, landing: Landing, *, cut: bool) -> Planes:
    """What becomes of the first clip distances of a shader; cut: as in Rewritten."""
    code = bare(text)
    if cut and landing.legacy:
        return "legacy"
    if not cut or "gl_ClipDistance" in code:
        return "kept"
    return "clip vertex" if "compatibility" in version and "gl_ClipVertex" in code else "open"


def opened(text: str, before: str) -> str:
    """A shader's text, without its version, with more before its first declaration."""
    lines, first = text.split("\n"), _top(text)
    return "\n".join([*lines[:first], before, *lines[first:]])


def landing_text(landing: Landing, *, cut: bool, planes: Planes, tells: bool = False) -> str:
    """domeLand(), which takes gl_Position onto the dome, and all that it needs."""
    names = ["own/land", *landing.lens, "bend/vertex", "bend/panel"]
    if landing.face:
        names = ["own/land", "bend/face", "bend/face_point", "bend/face_panel"]
    if landing.beside:
        names.append("eye/beside")
    if landing.aim != "straight":
        names.append(f"aim/{landing.aim}")
    if landing.keystone:
        names.append("surface/keystone")
    if landing.grid:
        names.append("surface/grid")
    if cut:
        names += ["clip/panel"] if landing.face else [f"clip/{landing.clip}", "clip/panel"]
    if planes == "clip vertex":
        names.append("own/planes")
    parts = [_NAMES.sub(lambda m: f"dome{m[0][0].upper()}{m[0][1:]}", snippet(name)) for name in names]
    if planes == "clip vertex":
        parts.append(_CLIP_VERTEX)
    parts.append(_land(landing, cut=cut, planes=planes, tells=tells))
    if planes == "legacy":
        parts.append(_CLIP_VERTEX)
    return "".join(parts)


def _land(landing: Landing, *, cut: bool, planes: Planes, tells: bool) -> str:
    """The function that takes gl_Position onto the dome."""
    lines = ["vec4 clip = gl_Position;", *(["domeClip = clip;"] if tells else [])]
    aimed = [] if landing.aim == "straight" else ["    place = domeAimed(place);"]
    if planes == "clip vertex":
        lines.append("vec3 planes = domePlanesOf(domeClipVertex);")
        lines += [f"gl_ClipDistance[{i}] = planes.{axis};" for i, axis in enumerate("xyz")]
    elif planes == "open":
        lines += [f"gl_ClipDistance[{i}] = 1.0;" for i in range(RIM_DISTANCE)]
    elif planes == "legacy":
        lines.append("gl_ClipVertex = vec4(1.0);")
    if cut and planes != "legacy":
        lines.append("vec4 inside = domeInsideViewport(clip);")
        edges = zip(EDGE_DISTANCES, "xyzw", strict=True)
        lines += [f"gl_ClipDistance[{i}] = inside.{axis};" for i, axis in edges]
    lines += ["if (domeMode > 1.5) {", "    vec4 place = domeFromClip * clip;"]
    lines += aimed
    lines.append("    gl_Position = domeBent(place, clip.z / clip.w);")
    lines += ["    gl_ClipVertex = domeInsideViewport(clip);"] if planes == "legacy" else []
    lines += ["} else if (domeMode > 0.5) {", "    vec4 place = domePlace(clip);"]
    lines += ["    place = domeBeside(place);"] if landing.beside else []
    lines += aimed
    lines.append("    gl_Position = domeBent(place);")
    if cut:
        # A face has no rim. But Mesa's llvmpipe cuts by all distances that are written where none is enabled.
        rim = "1.0" if landing.face else "domeInFront(place)"
        written = "gl_ClipVertex.x" if planes == "legacy" else f"gl_ClipDistance[{RIM_DISTANCE}]"
        lines.append(f"    {written} = {rim};")
    lines.append("}")
    if landing.keystone:
        lines.append("if (domeMode > 0.5) gl_Position = domeOnSurface(gl_Position);")
    if landing.grid:
        lines.append("if (domeMode > 0.5) gl_Position = domeOnGrid(gl_Position);")
    return "\n".join(["void domeLand() {", *(f"    {line}" for line in lines), "}", ""])


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
