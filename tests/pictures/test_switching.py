"""State that is switched to and fro between primitives means what it means on the monitor."""

from __future__ import annotations

import numpy as np
import pytest

from tests.pictures.beside import DISTANCE, FOV, GL, SIZE, Beside, checks, looking

_SWITCHES = (
    "GL_LIGHTING", "GL_TEXTURE_2D", "GL_FOG", "GL_CLIP_PLANE0", "GL_SCISSOR_TEST", "GL_NORMALIZE",
    "GL_CULL_FACE", "GL_LINE_STIPPLE",
)  # fmt: skip


def prepared(gl: GL) -> None:
    looking(gl)
    checks(gl)
    gl.glEnable(gl.GL_LIGHT0)
    gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, (1, 1, 1, 1))
    gl.glEnable(gl.GL_COLOR_MATERIAL)
    gl.glFogi(gl.GL_FOG_MODE, gl.GL_LINEAR)
    gl.glFogf(gl.GL_FOG_START, DISTANCE - 1)
    gl.glFogf(gl.GL_FOG_END, DISTANCE + 1)
    gl.glFogfv(gl.GL_FOG_COLOR, (0, 0.5, 0, 1))
    gl.glClipPlane(gl.GL_CLIP_PLANE0, (1, 0.4, 0, 0.1))
    gl.glScissor(SIZE // 4, SIZE // 5, SIZE // 2, SIZE // 2)


def primitive(gl: GL, k: int) -> None:
    """Number k of 36 in a raster: a quad, or its outline."""
    x, y = k % 6 / 3 - 1, k // 6 / 3 - 1
    gl.glColor3f(1, k / 36, 0.5)
    gl.glNormal3f(0, k % 3 / 4, 2)
    gl.glBegin(gl.GL_LINE_LOOP if k % 5 == 4 else gl.GL_QUADS)
    for s, t in ((0, 0), (0.25, 0), (0.25, 0.25), (0, 0.25)):
        gl.glTexCoord2f(4 * s, 4 * t)
        gl.glVertex3f(x + s, y + t, k / 40)
    gl.glEnd()


@pytest.mark.parametrize("seed", range(4))
def test_switched_at_each_primitive(beside: Beside, seed: int) -> None:
    """Few states, often: by capability, attribute stack, matrix and viewport."""

    def scene(gl: GL) -> None:
        random = np.random.default_rng(seed)
        prepared(gl)
        chosen = [getattr(gl, name) for name in random.choice(_SWITCHES, 2, replace=False)]
        for k in range(36):
            for capability in chosen:
                (gl.glEnable if random.integers(2) else gl.glDisable)(capability)
            if k % 12 == 7:
                gl.glPushAttrib(gl.GL_ENABLE_BIT)
                gl.glDisable(gl.GL_COLOR_MATERIAL)
                primitive(gl, k)
                gl.glPopAttrib()
            elif k % 12 == 9:
                gl.glViewport(*gl.glGetIntegerv(gl.GL_VIEWPORT))
            elif k % 12 == 11:
                gl.glMatrixMode(gl.GL_PROJECTION)
                gl.glLoadIdentity()
                gl.gluPerspective(FOV, 1, DISTANCE - 3, DISTANCE + 5)
                gl.glMatrixMode(gl.GL_MODELVIEW)
            primitive(gl, k)

    beside.equal(scene, name=f"switched {seed}", wrong=0.006)
