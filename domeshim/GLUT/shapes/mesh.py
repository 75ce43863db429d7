"""What a shape is made of: vertices with normals, and triangles or line strips that index them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float32]
Indices = NDArray[np.unsignedinteger]


@dataclass(frozen=True, eq=False)
class Vertices:
    """Vertices in one interleaved block: [s, t,] normal, position; float32 (n, 6 or 8), object space."""

    interleaved: Floats

    @classmethod
    def of(cls, positions: ArrayLike, normals: ArrayLike, texcoords: ArrayLike | None = None) -> Vertices:
        """Interleave arrays of n rows each: positions (n, 3), normals (n, 3), texture coordinates (n, 2)."""
        columns = [normals, positions] if texcoords is None else [texcoords, normals, positions]
        return cls(_frozen(np.hstack([np.asarray(column, np.float32) for column in columns])))

    @property
    def positions(self) -> Floats:
        """Where the vertices are, (n, 3)."""
        return self.interleaved[:, -3:]

    @property
    def normals(self) -> Floats:
        """The normals, (n, 3); of unit length unless the shape says otherwise."""
        return self.interleaved[:, -6:-3]

    @property
    def texcoords(self) -> Floats | None:
        """The texture coordinates, (n, 2), where the shape has them."""
        return self.interleaved[:, :2] if self.interleaved.shape[1] == 8 else None

    def scaled(self, factor: float) -> Vertices:
        """The same vertices, their positions multiplied by a factor; normals as they were."""
        block = self.interleaved.copy()
        block[:, -3:] *= np.float32(factor)
        return Vertices(_frozen(block))


@dataclass(frozen=True, eq=False)
class Solid:
    """A filled shape: vertices and triangles, (m, 3) indices in the order in which they are drawn."""

    vertices: Vertices
    triangles: Indices

    @classmethod
    def of(cls, vertices: Vertices, triangles: ArrayLike) -> Solid:
        """Keep the triangles in the narrowest index type that holds them; leave out those without an area."""
        corners = np.asarray(triangles, np.int64).reshape(-1, 3)
        a, b, c = corners.T
        corners = corners[(a != b) & (b != c) & (c != a)]
        return cls(vertices, _narrow(corners, len(vertices.interleaved)))

    def scaled(self, factor: float) -> Solid:
        """The same shape in another size."""
        return Solid(self.vertices.scaled(factor), self.triangles)


@dataclass(frozen=True, eq=False)
class Strips:
    """Line strips of equal length, one a row of indices (k, n); closed ones return to where they began."""

    indices: Indices
    closed: bool

    @property
    def lines(self) -> Indices:
        """The strips cut into single lines, (m, 2) indices, in the order in which the strips draw them."""
        ends = np.roll(self.indices, -1, axis=1)
        pairs = np.stack([self.indices, ends], axis=-1)
        return (pairs if self.closed else pairs[:, :-1]).reshape(-1, 2)


@dataclass(frozen=True, eq=False)
class Wire:
    """A shape of lines: vertices and the strips that join them, in the order in which they are drawn."""

    vertices: Vertices
    strips: tuple[Strips, ...]

    @classmethod
    def of(cls, vertices: Vertices, strips: Iterable[tuple[ArrayLike, bool]]) -> Wire:
        """Build it from (indices (k, n), closed) pairs."""
        count = len(vertices.interleaved)
        narrow = [Strips(_narrow(rows, count), closed) for rows, closed in strips if len(np.asarray(rows))]
        return cls(vertices, tuple(narrow))

    @cached_property
    def lines(self) -> Indices:
        """All strips as single lines, (m, 2) indices."""
        return np.ascontiguousarray(np.concatenate([strips.lines for strips in self.strips]))

    def scaled(self, factor: float) -> Wire:
        """The same shape in another size."""
        return Wire(self.vertices.scaled(factor), self.strips)


def _narrow(indices: ArrayLike, count: int) -> Indices:
    wanted = np.uint16 if count <= 1 << 16 else np.uint32
    return _frozen(np.ascontiguousarray(indices, dtype=wanted))


def _frozen(array: NDArray[Any]) -> NDArray[Any]:
    array.flags.writeable = False
    return array
