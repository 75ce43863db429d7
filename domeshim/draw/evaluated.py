"""What GL or GLU evaluates becomes a run: curves, surfaces, and single points of them in a glBegin block."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.catcher import Catcher
from domeshim.draw.numbered import source
from domeshim.draw.patches import LINE_STRIP, POINTS, TRIANGLES, Edged
from domeshim.draw.replay import replay
from domeshim.driver import Driver
from domeshim.record.immediate import Immediate
from domeshim.record.runs import Block, Run
from domeshim.shading.program import Program

Evaluated = Literal["lines", "triangles", "outlines"]
"""What is drawn of a curve or a surface; outlines: GLU's, of lines and of triangles whose edges show."""

_CURRENT_PROGRAM = 0x8B8D
_CAUGHT = {"caughtVertex": 4, "caughtNormal": 3, "caughtColor": 4, "caughtTexture": 4}
"""What glsl/caught/evaluated.vert.glsl hands out, and how many numbers each has."""
_ATTRIBUTES = ("vertex", "normal", "color", "texture0")
"""Which attributes these are; evaluators make no others."""


class Evaluator:
    """Asks GL what it evaluates, in one context of GL 3.0 or later.

    A program of its own hands each vertex on as it comes, so that maps, grids, sampling and trimming are GL's
    and GLU's own.
    """

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._catcher = Catcher(driver)

    def run(self, draw: Callable[[], object], kind: Edged) -> Run:
        """The lines, or the triangles, of what a call draws, which may be made more than once."""
        corners = 2 if kind == "lines" else 3
        vertices = self._caught(draw, corners)
        if kind == "lines":
            return _strips(vertices)
        flat = vertices.reshape(-1, vertices.shape[-1])
        return _run(flat, (Block(TRIANGLES, 0, len(flat)),))

    def block_run(self, recorder: Immediate, setters: Mapping[str, Callable[..., None]]) -> Run | None:
        """What was recorded, with the places that GL evaluates for it; its last attributes are current then.

        None where GL makes another number of vertices: it has no map for some.
        """
        caught = self._caught(lambda: replay(self._driver, recorder, setters, POINTS), 1)[:, 0]
        if len(caught) != len(recorder.positions) // 3:
            return None
        evaluated, given = _run(caught, ()), recorder.take()
        attributes = {name: values for name, values in given.attributes.items() if name not in _ATTRIBUTES}
        constant = tuple((name, value) for name, value in given.constant if name not in _ATTRIBUTES)
        return replace(
            given,
            positions=evaluated.positions,
            attributes=attributes | evaluated.attributes,
            constant=constant + evaluated.constant,
        )

    def _caught(self, draw: Callable[[], object], corners: int) -> NDArray[np.float32]:
        bound = self._driver.integer(_CURRENT_PROGRAM)
        self._driver.glUseProgram(self._program.name)
        try:
            return self._catcher.catch(draw, corners, sum(_CAUGHT.values()))
        finally:
            self._driver.glUseProgram(bound)

    @cached_property
    def _program(self) -> Program:
        vertex = source(self._driver, "caught/evaluated.vert")
        return Program(self._driver, vertex, caught=tuple(_CAUGHT))


def _strips(lines: NDArray[np.float32]) -> Run:
    """Lines (n, 2, k), each that begins where the one before it ended as part of the same strip."""
    begins = np.append(True, (lines[1:, 0] != lines[:-1, 1]).any(-1))[: len(lines)]
    keep = np.stack([begins, np.ones_like(begins)], -1)
    firsts = np.flatnonzero(begins) + np.arange(np.count_nonzero(begins))
    vertices = lines[keep]
    ends = [*firsts[1:].tolist(), len(vertices)]
    return _run(vertices, tuple(Block(LINE_STRIP, a, b) for a, b in zip(firsts.tolist(), ends, strict=False)))


def _run(vertices: NDArray[np.float32], blocks: tuple[Block, ...]) -> Run:
    """Caught vertices, (n, 15), as a run; attributes that all have in common are its constants."""
    columns = np.split(vertices, np.cumsum(list(_CAUGHT.values()))[:-1], axis=1)
    found = dict(zip(_ATTRIBUTES, columns, strict=True))
    positions = found.pop("vertex")
    if (positions[:, 3] == 1).all():
        positions = positions[:, :3]
    alike = {name for name, values in found.items() if (values == values[:1]).all()}
    return Run(
        np.ascontiguousarray(positions),
        {name: np.ascontiguousarray(values) for name, values in found.items() if name not in alike},
        blocks,
        constant=tuple(
            (name, tuple(found[name][0].tolist())) for name in found if name in alike and len(vertices)
        ),
    )
