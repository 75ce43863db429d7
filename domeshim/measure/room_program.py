"""A monitor program for measuring: a room of six textured walls around the viewer.

Its texture is smooth enough that how it is filtered makes no difference.
"""

from collections.abc import Iterator

import numpy as np
from OpenGL import GL, GLU, GLUT

from domeshim.measure.room import FACES, TEXELS, colors


def make_textures() -> Iterator[int]:
    """One texture for each wall; row by row from the bottom."""
    across = (np.arange(TEXELS) + 0.5) / TEXELS
    s, t = np.meshgrid(across, across)
    for face, texture in enumerate(GL.glGenTextures(len(FACES))):
        GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
        for parameter in (GL.GL_TEXTURE_MIN_FILTER, GL.GL_TEXTURE_MAG_FILTER):
            GL.glTexParameteri(GL.GL_TEXTURE_2D, parameter, GL.GL_LINEAR)
        for parameter in (GL.GL_TEXTURE_WRAP_S, GL.GL_TEXTURE_WRAP_T):
            GL.glTexParameteri(GL.GL_TEXTURE_2D, parameter, GL.GL_CLAMP_TO_EDGE)
        texels = np.rint(255 * colors(face, s, t)).astype(np.uint8)
        GL.glTexImage2D(
            GL.GL_TEXTURE_2D, 0, GL.GL_RGB8, TEXELS, TEXELS, 0, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, texels
        )
        yield texture


def display() -> None:
    """Six quads."""
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    for texture, corners in zip(textures, FACES, strict=True):
        GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
        GL.glBegin(GL.GL_QUADS)
        for (s, t), corner in zip(((0, 0), (1, 0), (1, 1), (0, 1)), corners, strict=True):
            GL.glTexCoord2f(s, t)
            GL.glVertex3f(*corner)
        GL.glEnd()
    GLUT.glutSwapBuffers()


GLUT.glutInit()
GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE | GLUT.GLUT_RGB | GLUT.GLUT_DEPTH)
GLUT.glutCreateWindow("room")
GL.glEnable(GL.GL_TEXTURE_2D)
GL.glEnable(GL.GL_DEPTH_TEST)
GL.glTexEnvi(GL.GL_TEXTURE_ENV, GL.GL_TEXTURE_ENV_MODE, GL.GL_REPLACE)
GL.glMatrixMode(GL.GL_PROJECTION)
GLU.gluPerspective(60.0, 1.0, 0.05, 50.0)
GL.glMatrixMode(GL.GL_MODELVIEW)
textures = list(make_textures())
GLUT.glutDisplayFunc(display)
GLUT.glutMainLoop()
