"""What a program asks for that means something else on a dome, and how sure that is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from domeshim.diagnosis.watching import Seen, watched
from domeshim.measure.apart import Program
from domeshim.state.perspective import depth_range
from domeshim.wording import counted

SIZES = ((256, 256), (320, 320))
_TAKEN = ("glCopyTexImage2D", "glCopyTexSubImage2D")


Sure = Literal["surely", "perhaps"]


@dataclass(frozen=True)
class Finding:
    """One thing about a program."""

    sure: Sure
    words: str


def findings(program: Program, frame: int, settings: Mapping[str, str]) -> list[Finding]:
    """What was found by running the program in windows of two sizes.

    Raises NoExposureError where a picture never came.
    """
    small, large = (watched(program, frame, size, settings) for size in SIZES)
    found = [Finding("surely", note) for note in small.notes]
    found += _viewports(small, large)
    found += _reading(small)
    found += _perspective(small)
    return found


def _viewports(small: Seen, large: Seen) -> list[Finding]:
    of_small, of_large = ({tuple(v) for v in seen.calls["viewports"]} for seen in (small, large))
    fixed = (of_small & of_large) - {(0, 0, *SIZES[0]), (0, 0, *SIZES[1])}
    return [
        Finding(
            "surely",
            f"it sets a viewport of {w}x{h} at {x},{y} whatever the window's size; over half of the window"
            " that fills the dome, else it is placed where it stood",
        )
        for x, y, w, h in sorted(fixed)
        if w > 0 and h > 0
    ]


def _reading(seen: Seen) -> list[Finding]:
    counts = seen.calls["counts"]
    reads, taken = counts.get("glReadPixels", 0), sum(counts.get(name, 0) for name in _TAKEN)
    asked = min(counts.get("MODELVIEW", 0), counts.get("PROJECTION", 0))
    told: tuple[tuple[int, Sure, str], ...] = (
        (reads, "perhaps", "it reads pixels {} a picture: few are the monitor's, areas the dome's"),
        (taken, "perhaps", "it makes textures of its window {} a picture: as fine as the dome shows it"),
        (
            counts.get("glCopyPixels", 0),
            "surely",
            "it copies within its window {} a picture: in the dome's frame",
        ),
        (counts.get("glBindFramebuffer", 0), "perhaps", "it draws into framebuffers of its own"),
        (
            asked,
            "perhaps",
            "it asks for both matrices {} a picture: if that is to leave out what its own view does not"
            " show, that is missing beside the view on the dome",
        ),
    )
    return [Finding(sure, words.format(counted(count, "time"))) for count, sure, words in told if count]


def _perspective(seen: Seen) -> list[Finding]:
    if seen.perspective is None:
        return [Finding("surely", "it sets no perspective: its window is a panel DOME_PANEL degrees high")]
    p = np.array(seen.perspective)
    fovy, depths = 2 * np.degrees(np.arctan(abs(p[3, 2] / p[1, 1]))), depth_range(p)
    found = []
    if fovy < 60:
        words = f"its view is {fovy:.0f} degrees high and looks small on a dome: DOME_FILL widens it"
        found.append(Finding("surely", words))
    if depths.near > 0.05 * depths.far:
        words = (
            f"its near plane, {depths.near:g}, is close to its far plane, {depths.far:g}: what is nearer is"
            " cut off, and beside and below the viewer a dome shows more of that"
        )
        found.append(Finding("perhaps", words))
    return found
