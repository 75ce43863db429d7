"""The bench's own scenes: what is drawn, how a program would draw it, and what is true of it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from domeshim.bench import meshes, walls
from domeshim.bench.meshes import Floats, Mesh

NEAR, FAR, FOVY = 0.05, 100.0, 90.0
"""Of every scene's perspective."""


@dataclass(frozen=True)
class Scene:
    """A still scene in eye space."""

    name: str
    title: str
    make: Callable[[], Sequence[Mesh]]
    way: Literal["buffers", "immediate"] = "buffers"
    """From buffers on the GPU, or by glBegin and glVertex."""
    lit: bool = False
    look: Callable[[Floats], Floats] | None = None
    """(..., 3) directions -> (..., 3) colours from 0 to 1, where a ray can tell them."""

    @cached_property
    def meshes(self) -> tuple[Mesh, ...]:
        """What is drawn."""
        return tuple(self.make())

    @cached_property
    def edges(self) -> Floats:
        """(e, 2, 3): the ends of all edges."""
        return np.concatenate([mesh.edges for mesh in self.meshes])


_BOX = (np.array([-4.0, -3.0, -6.0]), np.array([5.0, 4.0, 3.0]))

SCENES = (
    Scene("mesh-10k", "Dense mesh, 10,000 triangles", lambda: [meshes.ball(71)], lit=True),
    Scene("mesh-100k", "Dense mesh, 100,000 triangles", lambda: [meshes.ball(224)], lit=True),
    Scene("mesh-500k", "Dense mesh, 500,000 triangles", lambda: [meshes.ball(500)], lit=True),
    Scene("immediate", "20,000 vertices by glBegin", lambda: [meshes.ball(71, halved=False)], "immediate"),
    Scene("lines", "200 long lines", lambda: [meshes.long_lines(200)]),
    Scene("room", "Textured room, six quads", walls.room, "immediate", look=walls.look_in_room),
    Scene("flow", "Flow box, 10,000 arrows", lambda: [meshes.arrows(10_000), meshes.box_edges(*_BOX)]),
    Scene("teapots", "Thirteen teapots, the eye among them", meshes.teapots, lit=True),
    Scene("panorama", "Panorama on 50 x 50 quads", lambda: [walls.panorama()], look=walls.look_at_panorama),
)
"""By rising difficulty for what splits edges, more or less."""


def scene(name: str) -> Scene:
    """The scene of that name."""
    return next(each for each in SCENES if each.name == name)
