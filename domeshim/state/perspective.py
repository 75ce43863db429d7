"""Perspective matrices: made as GLU and GL make them, found inside others, and read.

All matrices here are (4, 4) float64, mathematical rows by columns (GL's memory is the transpose).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]
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
    rows = m[[0, 1, 3], :3]
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
    shift = np.linalg.solve(p[np.ix_([0, 1, 3], [0, 1, 2])], m[[0, 1, 3], 3])
    p[2, :3] = rotation @ m[2, :3]
    p[2, 3] = m[2, 3] - p[2, :3] @ shift
    return p


def _split(row: Matrix, axis: Matrix) -> tuple[float, Matrix]:
    along = float(row @ axis)
    return along, row - along * axis


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
