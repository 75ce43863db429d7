"""domeshim explain's text."""

from __future__ import annotations

import textwrap
from typing import Any

from domeshim.diagnosis.watching import Seen
from domeshim.wording import counted

_WIDTH = 100
_OTHERS = {
    "rim": "the dome's own: the rim, or the background",
    "own": "the program's own GLSL, taken onto the dome",
    "unbent": "as on the monitor: no program of the dome's was bound",
}


def explained(name: str, seen: Seen) -> str:
    """All that is known, the draws with the most vertices first."""
    total = sum(draw["vertices"] for draw in seen.draws)
    head = f"{name}, picture {seen.frame}: {counted(len(seen.draws), 'way')} to draw, {total} vertices"
    if seen.perspective is None:
        head += "; it sets no perspective"
    lines = [head]
    for number, draw in enumerate(seen.draws, 1):
        lines += ["", *_draw(number, draw)]
    if seen.notes:
        lines += ["", "said of what is not exact:"]
        lines += [line for note in seen.notes for line in _wrapped("  - ", note)]
    return "\n".join(lines)


def _draw(number: int, draw: dict[str, Any]) -> list[str]:
    into = f"{draw['primitives']} primitives in, {draw['generated']} out"
    lines = [f"{number}. {counted(draw['draws'], 'draw')}, {draw['vertices']} vertices, {into}"]
    needs = ", ".join(draw["needs"]) or _OTHERS[draw["kind"]]
    lines += _wrapped("   needs     ", needs)
    if draw["left_out"]:
        lines += _wrapped("   left out  ", ", ".join(draw["left_out"]))
    if draw["characters"]:
        took = f"{1000 * draw['seconds']:.1f} ms to compile and link"
        lines.append(f"   shader    {draw['characters']} characters, {took}")
    return lines


def _wrapped(lead: str, text: str) -> list[str]:
    return textwrap.wrap(text, _WIDTH, initial_indent=lead, subsequent_indent=" " * len(lead))
