"""A program's own shader becomes one that ends on the dome: pure, and tested as text.

Its main() runs as it is, under another name; ours calls it and takes the gl_Position that it leaves onto the
dome. In a geometry shader each EmitVertex() does so instead.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

from domeshim.shading.own_text import Versioned, bare, opened
from domeshim.shading.recipe import RADIAL, Clip
from domeshim.shading.snippets import snippet

Stage = Literal["vertex", "evaluation", "geometry"]

Planes = Literal["kept", "clip vertex", "open", "legacy"]
"""What becomes of the first three clip distances: the shader's own, the program's clip planes by the shader's
gl_ClipVertex, or nothing is cut (without a gl_ClipVertex, GL leaves it open what clip planes do); legacy:
there are none."""

RIM_DISTANCE, EDGE_DISTANCES = 3, (4, 5, 6, 7)
"""The clip distances of the rim, and of the viewport's and scissor's edges; the lower are the program's."""

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
