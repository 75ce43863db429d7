"""Warp meshes: which place of the dome's picture each place of the projector's frame shows.

Two kinds of file: Paul Bourke's warping meshes (paulbourke.net/dataformats/meshwarp: a kind, a size, then a
line "x y u v i" a node), and OBJ objects with texture coordinates.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from domeshim.errors import DomeError

Floats = NDArray[np.float64]
_POLAR, _RECTANGULAR = 1, 2
_LARGEST = 4_000_000
"""So many nodes at most: more than any projector has pixels for."""


class MeshError(DomeError):
    """A file is not a warp mesh; says why."""


@dataclass(frozen=True, eq=False)
class WarpMesh:
    """Triangles of the frame, each with the part of the dome's picture that it shows."""

    places: Floats
    """(n, 2): of each node in the frame, -1 to 1 from left to right and from bottom to top."""
    picture: Floats
    """(n, 2): what it shows of the dome's square picture, 0 to 1 from left to right and bottom to top."""
    intensity: Floats
    """(n,): what the picture is multiplied by there, to even the light out."""
    triangles: NDArray[np.int64]
    """(m, 3): indices of nodes."""

    def shown_at(self, places: Floats) -> Floats:
        """places: (k, 2) in the frame, as self.places -> (k, 2) of the picture shown there, nan for none.

        Where triangles lie over each other the last one counts, as it does when they are drawn.
        """
        points = np.asarray(places, float)
        found = np.full(points.shape, np.nan)
        a, b, c = (self.places[self.triangles[:, corner]] for corner in range(3))
        doubled = _cross(b - a, c - a)
        for i, point in enumerate(points):
            shares = np.stack([_cross(b - point, c - point), _cross(c - point, a - point)], -1)
            with np.errstate(divide="ignore", invalid="ignore"):
                u, v = (shares / doubled[:, None]).T
            inside = np.flatnonzero((u >= -1e-9) & (v >= -1e-9) & (u + v <= 1 + 1e-9))
            if inside.size:
                k = inside[-1]
                weights = np.array([u[k], v[k], 1 - u[k] - v[k]])
                found[i] = weights @ self.picture[self.triangles[k]]
        return found


def read_mesh(path: Path, aspect: float) -> WarpMesh:
    """The warp mesh of a file; aspect: the frame's width over its height.

    Raises MeshError.
    """
    try:
        text = path.read_text()
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "not a text file"
        raise MeshError(f"{path}: {reason}") from None
    return (
        _read_obj(path, text, aspect) if path.suffix.lower() == ".obj" else _read_bourke(path, text, aspect)
    )


def _read_bourke(path: Path, text: str, aspect: float) -> WarpMesh:
    lines = text.split("\n", 2)
    try:
        kind = int(lines[0])
        columns, rows = (int(number) for number in lines[1].split())
    except (ValueError, IndexError):
        raise MeshError(
            f"{path}: no warp mesh; its first line is to be the mesh's kind, its second two sizes"
        ) from None
    if kind not in (_POLAR, _RECTANGULAR):
        raise MeshError(f"{path}: a mesh of kind {kind}; known are 1 (polar) and 2 (rectangular)")
    if columns < 2 or rows < 2 or columns * rows > _LARGEST:
        raise MeshError(f"{path}: a mesh of {columns} by {rows} nodes; each way at least 2 are needed")
    try:
        nodes = np.array(lines[2].split() if len(lines) > 2 else [], float)
    except ValueError as error:
        raise MeshError(f"{path}: not a number among the nodes ({error})") from None
    if nodes.size != 5 * columns * rows:
        wanted = f"{columns} by {rows} nodes of x y u v i are {5 * columns * rows} numbers"
        raise MeshError(f"{path}: {wanted}, and there are {nodes.size}")
    nodes = nodes.reshape(-1, 5)
    index = np.arange(columns * rows).reshape(rows, columns)
    if kind == _POLAR:
        index = np.hstack([index, index[:, :1]])
    return _mesh(path, nodes[:, :2], nodes[:, 2:4], nodes[:, 4], _cells(index), aspect)


def _cells(index: NDArray[np.int64]) -> NDArray[np.int64]:
    """Two triangles a cell of a grid of nodes."""
    a, b, c, d = index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]
    return np.stack([np.stack([a, b, c], -1), np.stack([a, c, d], -1)], -2).reshape(-1, 3)


def _read_obj(path: Path, text: str, aspect: float) -> WarpMesh:
    """An object whose x and y are places in the frame, and whose texture is the dome's picture."""
    places: list[list[float]] = []
    picture: list[list[float]] = []
    corners: list[tuple[int, int]] = []
    for number, line in enumerate(text.splitlines(), 1):
        word, *values = line.split("#")[0].split() or [""]
        try:
            if word == "v":
                places.append([float(value) for value in values[:2]])
            elif word == "vt":
                picture.append([float(value) for value in values[:2]])
            elif word == "f":
                face = [_corner(value, len(places), len(picture)) for value in values]
                for k in range(1, len(face) - 1):
                    corners += [face[0], face[k], face[k + 1]]
        except (ValueError, IndexError) as error:
            raise MeshError(f"{path}, line {number}: {error}") from None
    if not corners:
        raise MeshError(f"{path}: no faces with texture coordinates (f v/vt v/vt v/vt)")
    at, of = np.array(corners).T
    triangles = np.arange(len(corners)).reshape(-1, 3)
    nodes = np.array(places, float)[at], np.array(picture, float)[of]
    return _mesh(path, *nodes, np.ones(len(corners)), triangles, aspect)


def _corner(text: str, places: int, pictures: int) -> tuple[int, int]:
    """Indices of a face's corner, "v/vt" or "v/vt/vn", counted from 1 or, if negative, from the end."""
    parts = text.split("/")
    if len(parts) < 2 or not parts[1]:
        raise ValueError(f"a face's corner without texture coordinates: {text}")
    found = []
    for part, count in zip(parts, (places, pictures), strict=False):
        index = int(part)
        index = index + count if index < 0 else index - 1
        if not 0 <= index < count:
            raise ValueError(f"a face's corner that there is not: {text}")
        found.append(index)
    return found[0], found[1]


def _mesh(
    path: Path,
    places: Floats,
    picture: Floats,
    intensity: Floats,
    triangles: NDArray[np.int64],
    aspect: float,
) -> WarpMesh:
    """The mesh, without the triangles that a node of negative intensity switches off.

    Meshes give x as from -1 to 1, or from -aspect to aspect: whichever it is shows where it goes beyond 1.
    """
    if not (np.isfinite(places).all() and np.isfinite(picture).all() and np.isfinite(intensity).all()):
        raise MeshError(f"{path}: a node is not finite")
    seen = triangles[(intensity[triangles] >= 0).all(1)]
    if not seen.size:
        raise MeshError(f"{path}: no cell of the mesh is switched on")
    used = np.unique(seen)
    if abs(places[used, 0]).max() > 1.001 and aspect > 1:
        places = places / (aspect, 1.0)
    if (picture[used] < -0.001).any() or (picture[used] > 1.001).any():
        raise MeshError(f"{path}: u and v lie outside 0 to 1")
    return WarpMesh(places, picture, intensity, seen)


def _cross(a: Floats, b: Floats) -> Floats:
    product: Floats = a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
    return product
