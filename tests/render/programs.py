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
PAINTS = """
def before():
    clear()
    glPushMatrix(); glLoadIdentity()
    glLineWidth(5); glPointSize(9)
    glBegin(GL_LINES)
    for a in range(-20, 21, 5):
        glColor3f(1, a / 40 + 0.5, 0); glVertex3f(a, -20, -5); glVertex3f(-a, 20, -3)
    glEnd()
    glBegin(GL_POINTS)
    for a in range(-4, 5):
        glColor3f(0, 1, a / 8 + 0.5); glVertex3f(a, a / 2, -3)
    glEnd()
    glColor3f(0.3, 0.5, 1)
    glRasterPos3f(-2, 0.3, -3)
    for letter in b"over tiles' borders":
        glutBitmapCharacter(GLUT_BITMAP_HELVETICA_18, letter)
    glPopMatrix()
"""
"""Wide lines, large points and text."""
SHARDS = """
import random
def own_program():
    shader = glCreateShader(GL_VERTEX_SHADER)
    glShaderSource(shader, "void main() { gl_Position = ftransform(); gl_FrontColor = gl_Color; }")
    glCompileShader(shader)
    program = glCreateProgram()
    glAttachShader(program, shader)
    glLinkProgram(program)
    return program
def shards(count, size):
    glBegin(GL_TRIANGLES)
    for _ in range(count):
        x, y, z = (random.uniform(-4, 4) for _ in "xyz")
        glColor3f(*(random.random() for _ in "rgb"))
        for _ in range(3):
            glVertex3f(x + random.uniform(-size, size), y + random.uniform(-size, size), z)
    glEnd()
def before():
    clear()
    glPushMatrix(); glLoadIdentity()
    glShadeModel(GL_FLAT)
    shards(10000, 0.1)
    shards(40, 1)
    glUseProgram(own_program())
    shards(10000, 0.1)
    glUseProgram(0)
    glPopMatrix()
"""
"""Many edges, some long, some by its own GLSL, and nothing that is interpolated."""
LISTS = """
def before():
    clear()
    if n == 1:
        glNewList(2, GL_COMPILE)
        glBegin(GL_TRIANGLES)
        for x, y in ((-30, 0), (30, 0), (0, 30)):
            glColor3f(x / 60 + 0.5, y / 30, 1); glVertex3f(x, y, -6)
        glEnd()
        glEndList()
    glCallList(2)
"""
"""A triangle that is subdivided lies in a display list."""
