"""A small program for domeshim doctor: one triangle with long edges, one picture after the other."""

from OpenGL.GL import (
    GL_COLOR_BUFFER_BIT,
    GL_MODELVIEW,
    GL_PROJECTION,
    GL_TRIANGLES,
    glBegin,
    glClear,
    glColor3f,
    glEnd,
    glLoadIdentity,
    glMatrixMode,
    glVertex3f,
)
from OpenGL.GLU import gluPerspective
from OpenGL.GLUT import (
    GLUT_DOUBLE,
    GLUT_RGB,
    glutCreateWindow,
    glutDisplayFunc,
    glutInit,
    glutInitDisplayMode,
    glutMainLoop,
    glutSwapBuffers,
)


def display() -> None:
    """Draw the triangle."""
    glClear(GL_COLOR_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(90, 1, 0.1, 10)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glColor3f(1, 1, 1)
    glBegin(GL_TRIANGLES)
    for x, y in ((-4, -2), (4, -2), (0, 3)):
        glVertex3f(x, y, -1.5)
    glEnd()
    glutSwapBuffers()


glutInit()
glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB)
glutCreateWindow("doctor")
glutDisplayFunc(display)
glutMainLoop()
