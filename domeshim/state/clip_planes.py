"""GL's clip planes while the dome has taken some of them: on OpenGL 2 there is nothing else to cut by."""

from __future__ import annotations

from collections.abc import Mapping
from ctypes import c_double

from domeshim.driver import Driver

Equation = tuple[float, float, float, float]
NOTHING: Equation = (0.0, 0.0, 0.0, 0.0)
"""A plane that cuts nothing."""
PARTS: tuple[Equation, ...] = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))
"""Planes that pick a part of gl_ClipVertex each."""
LEGACY_PLANES = 6
"""So many every OpenGL 2 has."""
GL_CLIP_PLANE0 = 0x3000
_MATRIX_MODE, _MODELVIEW, _MODELVIEW_MATRIX = 0x0BA0, 0x1700, 0x0BA6
_MOST = 8


class ClipPlanes:
    """The clip planes of one context; those that the dome takes are the program's again afterwards."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver
        self._own: dict[int, Equation] = {}
        """What the program has in each plane that is taken, in its eye space."""

    @property
    def own(self) -> tuple[float, ...]:
        """The uniform domePlanes: the program's equations, of planes not taken zeros."""
        return tuple(part for number in range(_MOST) for part in self._own.get(number, NOTHING))

    def take(self, wanted: Mapping[int, Equation]) -> None:
        """Put these equations into GL's planes, by number, and the program's back into all others."""
        free = {number: self._own.pop(number) for number in list(self._own) if number not in wanted}
        for number in wanted:
            if number not in self._own:
                self._own[number] = self._asked(number)
        self._set({**free, **wanted})

    def give_back(self) -> None:
        """Leave all planes as the program had them."""
        self.take({})

    def _asked(self, number: int) -> Equation:
        equation = (c_double * 4)()
        self._driver.glGetClipPlane(GL_CLIP_PLANE0 + number, equation)
        x, y, z, w = equation
        return x, y, z, w

    def _set(self, equations: Mapping[int, Equation]) -> None:
        """GL takes equations through MODELVIEW, which has to be the identity for those of eye space."""
        gl = self._driver
        if not equations:
            return
        mode, matrix = gl.integer(_MATRIX_MODE), gl.doubles(_MODELVIEW_MATRIX, 16)
        gl.glMatrixMode(_MODELVIEW)
        gl.glLoadIdentity()
        for number, equation in equations.items():
            gl.glClipPlane(GL_CLIP_PLANE0 + number, (c_double * 4)(*equation))
        gl.glLoadMatrixd((c_double * 16)(*matrix))
        gl.glMatrixMode(mode)
