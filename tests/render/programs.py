"""A small animated program, and what it can be made to do besides."""

SPINNER = """
import os, signal, sys
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
n = 0
def before(): pass
def after(): pass
def display():
    global n
    n += 1
    before()
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glTranslatef(0, 0, -4)
    glRotatef(7 * n, 0, 1, 0)
    glBegin(GL_TRIANGLES)
    for angle in range(0, 3):
        glColor3f(angle == 0, angle == 1, angle == 2)
        glVertex3f(angle - 1, (angle % 2) * 2 - 1, 0)
    glEnd()
    glCallList(1)
    after()
    glutSwapBuffers()
    glutPostRedisplay()
def clear(): glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
{}
glutInit()
glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH)
glutCreateWindow("spinner")
glMatrixMode(GL_PROJECTION)
gluPerspective(60, 1, 0.1, 50)
glNewList(1, GL_COMPILE)
glTranslatef(0, 1.5, 0)
glColor3f(1, 1, 0)
glRectf(-0.3, -0.3, 0.3, 0.3)
glEndList()
glutDisplayFunc(display)
glutMainLoop()
"""

CLEARS = "before = clear"
"""Each picture begins empty: others may be passed by."""
BUILDS = """
def before():
    if n == 1: clear()
"""
"""Each picture is drawn over the former one."""
READS = """
seen = 0
def before():
    clear()
    glRotatef(seen, 0, 0, 1)
def after():
    global seen
    seen = int(glReadPixels(32, 32, 1, 1, GL_RGB, GL_UNSIGNED_BYTE)[0])
"""
"""Each picture depends on a pixel of the former one."""
ENDS = CLEARS + "\ndef after():\n    if n == 5: os._exit(0)\n"
"""It has four pictures."""
CRASHES = CLEARS + "\ndef after():\n    if n == 3: os._exit(7)\n"
"""Its third picture cannot be made."""
CHANCE = "def before():\n    clear(); glClearColor(*(b / 255 for b in os.urandom(3)), 1); clear()\n"
"""No two runs are alike."""
KILLS = (
    CLEARS
    + """
def after():
    mark = sys.argv[1]
    if n == 5 and not os.path.exists(mark):
        open(mark, "w").close()
        os.kill(os.getppid(), signal.SIGKILL)
"""
)
"""The first time that it comes to its fifth picture it kills whoever started it."""
