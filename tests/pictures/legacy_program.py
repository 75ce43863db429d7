"""A program of many parts: lighting, a room, a long line, clip planes, arrays, a list, a HUD and text."""

import numpy as np
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *

TRIANGLE = np.array([(-1, -1, 0), (1, -1, 0), (0, 1, 0)], np.float32)
EQUATION = (0.0, 1.0, 0.0, 0.1)


def room():
    glColor3f(0.2, 0.3, 0.5)
    glBegin(GL_QUADS)
    for x, y in ((-4, -2), (4, -2), (4, 3), (-4, 3)):
        glVertex3f(x, y, -6)
    glColor3f(0.5, 0.3, 0.2)
    for x, z in ((-4, 6), (4, 6), (4, -6), (-4, -6)):
        glVertex3f(x, -2, z)
    glEnd()
    glColor3f(1, 1, 0)
    glBegin(GL_LINES)
    glVertex3f(-50, 2.5, -3)
    glVertex3f(50, 2.5, -3)
    glEnd()


def solids():
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glLightfv(GL_LIGHT0, GL_POSITION, (1, 2, 3, 1))
    glPushMatrix()
    glTranslatef(-1, 0, -4)
    glutSolidTeapot(0.6)
    glTranslatef(2, 0, 0)
    glClipPlane(GL_CLIP_PLANE0, EQUATION)
    glClipPlane(GL_CLIP_PLANE1, (1, 0, 0, 0.2))
    glEnable(GL_CLIP_PLANE0)
    glEnable(GL_CLIP_PLANE1)
    glutSolidSphere(0.6, 24, 16)
    glPopMatrix()
    kept = np.allclose(glGetClipPlane(GL_CLIP_PLANE0), EQUATION, atol=1e-6)
    print("planes", "kept" if kept else glGetClipPlane(GL_CLIP_PLANE0))
    glDisable(GL_CLIP_PLANE0)
    glDisable(GL_CLIP_PLANE1)
    glDisable(GL_LIGHTING)


def arrays():
    glPushMatrix()
    glTranslatef(2.5, 1, -4)
    glColor3f(0, 1, 1)
    glBindBuffer(GL_ARRAY_BUFFER, buffer)
    glEnableClientState(GL_VERTEX_ARRAY)
    glVertexPointer(3, GL_FLOAT, 0, None)
    glDrawArrays(GL_TRIANGLES, 0, 3)
    glDisableClientState(GL_VERTEX_ARRAY)
    glBindBuffer(GL_ARRAY_BUFFER, 0)
    glTranslatef(-5, 0, 0)
    glCallList(1)
    glPopMatrix()


def head_up():
    glMatrixMode(GL_PROJECTION)
    glPushMatrix()
    glLoadIdentity()
    glOrtho(0, 100, 0, 100, -1, 1)
    glMatrixMode(GL_MODELVIEW)
    glDisable(GL_DEPTH_TEST)
    glColor3f(0, 0.5, 0)
    glRectf(-20, 5, 60, 20)
    glColor3f(1, 1, 1)
    glRasterPos2f(10, 10)
    glutBitmapString(GLUT_BITMAP_HELVETICA_18, b"OpenGL")
    glEnable(GL_DEPTH_TEST)
    glMatrixMode(GL_PROJECTION)
    glPopMatrix()
    glMatrixMode(GL_MODELVIEW)


def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(90, 1, 0.1, 100)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    room()
    solids()
    arrays()
    head_up()
    glReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE)
    glutSwapBuffers()
    glutPostRedisplay()


glutInit()
glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH | GLUT_RGB)
glutCreateWindow("legacy")
print("version", glGetString(GL_VERSION).decode())
glEnable(GL_DEPTH_TEST)
buffer = glGenBuffers(1)
glBindBuffer(GL_ARRAY_BUFFER, buffer)
glBufferData(GL_ARRAY_BUFFER, TRIANGLE, GL_STATIC_DRAW)
glBindBuffer(GL_ARRAY_BUFFER, 0)
glNewList(1, GL_COMPILE)
glColor3f(1, 0, 1)
glutWireTorus(0.2, 0.5, 12, 24)
glEndList()
glutDisplayFunc(display)
glutMainLoop()
