"""A lit room with a few things in it, or the same with one fault: what domeshim compare must see.

python benchmarks/faulty_scene.py [FAULT]
"""

import sys

from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *

FAULTS = ("missing", "swapped", "unlit", "moved", "deep", "fogless", "mirrored", "textureless", "nothing")
fault = sys.argv[1] if len(sys.argv) > 1 else ""


def texture():
    texels = bytes(255 if (x // 2 + y // 2) % 2 else 96 for y in range(16) for x in range(16) for _ in "rgb")
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR)
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB, 16, 16, GL_RGB, GL_UNSIGNED_BYTE, texels)


def colour(red, green, blue):
    glColor3f(*((blue, green, red) if fault == "swapped" else (red, green, blue)))


def floor():
    if fault != "textureless":
        glEnable(GL_TEXTURE_2D)
    colour(0.9, 0.85, 0.6)
    glNormal3f(0, 1, 0)  # of many pieces: light is reckoned at vertices, here as there
    for z in range(-14, 2):
        glBegin(GL_QUAD_STRIP)
        for x in range(-6, 7):
            for depth in (z, z + 1):
                glTexCoord2f(x / 2, depth / 2)
                glVertex3f(x, -1.5, depth)
        glEnd()
    glDisable(GL_TEXTURE_2D)


def things():
    for place, (red, green, blue), solid in (
        ((-1.6, -0.8, -4.5), (0.9, 0.2, 0.1), lambda: glutSolidTeapot(0.6)),
        ((1.3, 0.9, -6.0), (0.2, 0.3, 0.9), lambda: glutSolidSphere(0.8, 32, 24)),
        ((2.4, -1.0, -5.0), (0.2, 0.8, 0.3), lambda: glutSolidCube(0.9)),
    ):
        glPushMatrix()
        glTranslatef(*place)
        colour(red, green, blue)
        solid()
        glPopMatrix()


def small():
    """A cube that covers 1 % of the picture: a tenth of its height, 5.77 at that distance."""
    if fault == "missing":
        return
    glPushMatrix()
    glTranslatef(0.15 if fault == "moved" else 0.0, 0.0, -5.0)
    colour(1.0, 0.8, 0.1)
    glutSolidCube(0.53)
    glPopMatrix()


def display():
    glClearColor(0.1, 0.1, 0.2, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    if fault == "nothing":
        glutSwapBuffers()
        return
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(60, glutGet(GLUT_WINDOW_WIDTH) / glutGet(GLUT_WINDOW_HEIGHT), 0.1, 50)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    if fault == "mirrored":
        glScalef(-1, 1, 1)
        glFrontFace(GL_CW)
    glLightfv(GL_LIGHT0, GL_POSITION, (2, 4, 1, 1))
    for capability, without in ((GL_LIGHTING, "unlit"), (GL_FOG, "fogless"), (GL_DEPTH_TEST, "deep")):
        (glDisable if fault == without else glEnable)(capability)
    floor()
    things()
    small()
    glutSwapBuffers()


glutInit(sys.argv[:1])
glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH)
glutInitWindowSize(512, 512)
glutCreateWindow("faulty scene")
for switched_on in (GL_LIGHT0, GL_COLOR_MATERIAL, GL_NORMALIZE):
    glEnable(switched_on)
glFogi(GL_FOG_MODE, GL_LINEAR)
glFogf(GL_FOG_START, 3)
glFogf(GL_FOG_END, 14)
glFogfv(GL_FOG_COLOR, (0.1, 0.1, 0.2, 1))
texture()
glutDisplayFunc(display)
glutMainLoop()
