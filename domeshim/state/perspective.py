"""Perspective matrices: made as GLU and GL make them, found inside others, and read.

All matrices here are (4, 4) float64, mathematical rows by columns (GL's memory is the transpose).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]
CAMERA = [0, 1, 3]
"""The rows of a matrix that make x, y and w: all that decides a direction."""
_NEARLY = 1e-3
DepthTerms = tuple[float, float]
"""(a, b), the uniform domeDepth: depth * r = a r + b."""


def perspective(fovy: float, aspect: float, near: float, far: float) -> Matrix | None:
    """The matrix of gluPerspective; None where GLU itself would do nothing (a zero in the wrong place)."""
    half = np.radians(fovy) / 2
    if near == far or np.sin(half) == 0 or aspect == 0:
        return None
    cotangent = np.cos(half) / np.sin(half)
    m = np.zeros((4, 4))
    m[0, 0], m[1, 1] = cotangent / aspect, cotangent
    m[2, 2], m[2, 3] = -(far + near) / (far - near), -2 * near * far / (far - near)
    m[3, 2] = -1
    return m


def frustum(left: float, right: float, bottom: float, top: float, near: float, far: float) -> Matrix | None:
    """The matrix of glFrustum; None where GL itself reports GL_INVALID_VALUE."""
    if near <= 0 or far <= 0 or left == right or bottom == top or near == far:
        return None
    m = np.zeros((4, 4))
    m[0, 0], m[0, 2] = 2 * near / (right - left), (right + left) / (right - left)
    m[1, 1], m[1, 2] = 2 * near / (top - bottom), (top + bottom) / (top - bottom)
    m[2, 2], m[2, 3] = -(far + near) / (far - near), -2 * near * far / (far - near)
    m[3, 2] = -1
    return m


def is_perspective(m: Matrix) -> bool:
    """The last row depends on x, y or z: w varies over the scene."""
    return bool(np.abs(m[3, :3]).max() > 1e-9 * np.abs(m[3]).max())


def perspective_part(m: Matrix) -> Matrix:
    """The P of a loaded matrix m = P V, V a rigid motion: the camera matrix's RQ decomposition.

    Hartley, Zisserman, "Multiple View Geometry", section 6.2.4, with the eye looking along -z.
    """
    rows = m[CAMERA, :3]
    r3 = -rows[2]
    scale = np.linalg.norm(r3)
    r3 = r3 / scale
    shear_y, rest_y = _split(rows[1], r3)
    up = np.linalg.norm(rest_y)
    r2 = rest_y / up
    r1 = np.cross(r2, r3)
    p = np.zeros((4, 4))
    p[0, 0], p[0, 1], p[0, 2] = rows[0] @ r1, rows[0] @ r2, rows[0] @ r3
    p[1, 1], p[1, 2] = up, shear_y
    p[3, 2] = -scale
    rotation = np.stack([r1, r2, r3])
    shift = np.linalg.solve(p[np.ix_(CAMERA, [0, 1, 2])], m[CAMERA, 3])
    p[2, :3] = rotation @ m[2, :3]
    p[2, 3] = m[2, 3] - p[2, :3] @ shift
    return p


def _split(row: Matrix, axis: Matrix) -> tuple[float, Matrix]:
    along = float(row @ axis)
    return along, row - along * axis


def perspective_within(m: Matrix, aspect: float, known: Iterable[Matrix] = ()) -> Matrix | None:
    """The P of a matrix m = P V M, V a rigid motion, M a mesh's place and size; None where none can be told.

    How wide P sees and what M stretches may be one in m. So of all that would explain m the likeliest counts:
    a known one, if M then stretches along its own axes alone; a P with square pixels, if M is of one scale;
    a centred P with square pixels, if M stretches along its own axes; any P, if M is of one scale.
    aspect: the window's width over its height; known: perspectives that the program has used.
    """
    camera = m[CAMERA, :3]
    volume = np.linalg.det(camera)
    if not is_perspective(m) or abs(volume) < 1e-12 * np.prod(np.linalg.norm(camera, axis=1)):
        return None
    if volume > 0:  # M mirrors; the same without that has the same P
        m = m * [-1, 1, 1, 1]
    for p in known:
        if _is_square(p, aspect) and _explains(p, m):
            return p
    p = perspective_part(m)
    p[:, :3] /= -p[3, 2]  # M's scale taken out again: clip w is the distance along the view
    if np.abs(p[:2, 2] + 0.5).max() <= _NEARLY:
        return None  # it ends in a texture, from 0 to 1: a lamp's or a projector's
    unskewed = bool(abs(p[0, 1]) <= _NEARLY * abs(p[1, 1]))
    if unskewed and _is_square(p, aspect):
        return p
    centred = _centred(m, aspect)
    return p if centred is None and unskewed else centred


def _is_square(p: Matrix, aspect: float) -> bool:
    """A pixel of a window of this aspect is seen as high as it is wide."""
    return bool(abs(p[0, 0] * aspect - p[1, 1]) <= _NEARLY * abs(p[1, 1]))


def _explains(p: Matrix, m: Matrix) -> bool:
    """M stretches along its own axes alone if m = P V M has this P."""
    _, _, z = rows = np.linalg.solve(p[np.ix_(CAMERA, [0, 1, 2])], m[CAMERA])
    if not _is_upright(rows[:, :3].T @ rows[:, :3]):
        return False
    off = np.abs(m[2] - p[2, 2] * z - [0, 0, 0, p[2, 3]])
    return bool(
        off[:3].max() <= _NEARLY * np.abs(m[2]).max()
        and off[3] <= _NEARLY * (abs(p[2, 3]) + abs(m[2, 3]) / 100)
    )


def _centred(m: Matrix, aspect: float) -> Matrix | None:
    """The P of square pixels, the same to all sides, by which M stretches along its own axes alone.

    With c the cotangent of half the angle of view, the columns of V M are those of (aspect x, y, c w) / c
    for the rows x, y and w of m: at right angles for one c, unless they are so for each.
    """
    lengths = np.sqrt((m[CAMERA, :3] ** 2).sum(0))
    x, y, w = m[CAMERA, :3] / lengths
    wide, deep = aspect**2 * np.outer(x, x) + np.outer(y, y), np.outer(w, w)
    pairs = np.triu_indices(3, 1)
    square = -float(wide[pairs] @ deep[pairs]) / max(float(deep[pairs] @ deep[pairs]), 1e-30)
    if square <= 0:
        return None
    products = wide + square * deep
    told = square * np.abs(deep) > 0.01 * np.sqrt(np.outer(np.diag(products), np.diag(products)))
    if not told[pairs].any() or not _is_upright(products):
        return None
    p = np.zeros((4, 4))
    p[0, 0], p[1, 1], p[3, 2] = np.sqrt(square) / aspect, np.sqrt(square), -1
    p[2, 2] = -(m[2, :3] @ m[3, :3]) / (m[3, :3] @ m[3, :3])
    p[2, 3] = m[2, 3] + p[2, 2] * m[3, 3]
    return p


def _is_upright(products: Matrix) -> bool:
    """Of three vectors, whose products these are, each is at right angles to the others."""
    squares = np.diag(products)
    return bool((np.abs(products - np.diag(squares)) <= _NEARLY * np.sqrt(np.outer(squares, squares))).all())


@dataclass(frozen=True)
class DepthRange:
    """How far the program's perspective sees, in eye space units; far may be infinity."""

    near: float
    far: float

    @property
    def uniform(self) -> DepthTerms:
        """What puts r = near at depth -1 and r = far at +1.

        The far end is moved out by sqrt(3): the monitor's far plane is flat, and a corner of its view (or of
        a sky box) is that much farther away than its middle; nothing that the monitor shows may vanish.
        """
        if np.isinf(self.far):
            return 1.0, -2 * self.near
        near, far = self.near, self.far * np.sqrt(3.0)
        return (far + near) / (far - near), -2 * far * near / (far - near)


def planar(by_distance: DepthTerms) -> DepthTerms:
    """DepthRange.uniform where depth goes by the distance along a cube face's axis; (0, 0) stays.

    Its near end comes closer by sqrt(3): a point in a face's corner lies that much nearer along the axis than
    it is away. Nothing that is shown by distance may vanish.
    """
    a, b = by_distance
    if b == 0:
        return by_distance
    near = -b / (1 + a) / float(np.sqrt(3.0))
    if a == 1:
        return 1.0, -2 * near
    far = b / (1 - a)
    return (far + near) / (far - near), -2 * far * near / (far - near)


def depth_range(p: Matrix) -> DepthRange:
    """Near and far of a perspective matrix; sane ones where the matrix has none that make sense."""
    a, b = p[2, 2] / -p[3, 2], p[2, 3] / -p[3, 2]
    near = b / (a - 1) if a != 1 else np.inf
    far = b / (a + 1) if a != -1 else np.inf
    near, far = min(abs(near), abs(far)), max(abs(near), abs(far))
    if not (0 < near < np.inf) and not 0 < far < np.inf:
        near, far = 0.0, 1e4
    if not near > 0:
        near = 1e-6 * far
    return DepthRange(float(near), float(max(far, near * (1 + 1e-6))))
