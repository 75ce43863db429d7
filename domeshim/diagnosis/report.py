"""domeshim explain's text."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from typing import Any

from domeshim.diagnosis.watching import Seen
from domeshim.wording import counted

_WIDTH = 100
_OTHERS = {
    "own": "the program's own GLSL, taken onto the dome",
    "own pieces": "the program's own GLSL, taken onto the dome and subdivided",
    "unbent": "as on the monitor: no program of the dome's was bound",
}
_SCENE = ("draw", *_OTHERS)
"""Kinds of draws that are the program's; the others are named by the pass that they belong to."""


def explained(name: str, seen: Seen) -> str:
    """All that is known: the passes, then the draws, those with the most vertices first."""
    total = sum(draw["vertices"] for draw in seen.draws if draw["kind"] in _SCENE)
    ways = sum(draw["kind"] in _SCENE for draw in seen.draws)
    size = "{}x{}".format(*seen.size)
    head = f"{name}, picture {seen.frame}, {size}: {counted(ways, 'way')} to draw, {_vertices(total)}"
    if seen.perspective is None:
        head += "; it sets no perspective"
    lines = [head, *_passes(seen)]
    for number, draw in enumerate(seen.draws, 1):
        lines += ["", *_draw(number, draw)]
    if seen.notes:
        lines += ["", "said of what is not exact or not possible:"]
        lines += [line for note in seen.notes for line in _wrapped("  - ", note)]
    return "\n".join(lines)


def _passes(seen: Seen) -> Iterator[str]:
    scene, *others = seen.passes
    told = [f"the scene into {scene['into']}"]
    told += [each["name"] + (f" ({each['times']} times)" if each["times"] > 1 else "") for each in others]
    yield from _wrapped("passes        ", "; ".join(told))
    yield from _wrapped("not needed    ", ", ".join(seen.spared))


def _draw(number: int, draw: dict[str, Any]) -> Iterator[str]:
    passes = f"{counted(draw['draws'], 'draw')} in {counted(draw['passes'], 'pass', 'passes')}"
    into = f"{counted(draw['primitives'], 'primitive')} in, {draw['generated']} out"
    yield f"{number}. {passes}, {_vertices(draw['vertices'])}, {into}"
    kind = draw["kind"]
    needs = ", ".join(draw["needs"]) or _OTHERS.get(kind, f"the dome's own: {kind}")
    yield from _wrapped("   needs         ", needs)
    for lead, key in (
        ("left out", "left_out"),
        ("approximated", "approximated"),
        ("not possible", "impossible"),
    ):
        yield from _wrapped(f"   {lead:<13} ", ("; " if key == "approximated" else ", ").join(draw[key]))
    if draw["characters"]:
        yield (
            f"   shader        {draw['characters']} characters in {counted(draw['shaders'], 'stage')},"
            f" {1000 * draw['seconds']:.1f} ms to compile and link"
        )


def _vertices(number: int) -> str:
    return counted(number, "vertex", "vertices")


def _wrapped(lead: str, text: str) -> list[str]:
    """The text after its lead, in as many lines as it takes; none where there is no text."""
    return textwrap.wrap(text, _WIDTH, initial_indent=lead, subsequent_indent=" " * len(lead)) if text else []
