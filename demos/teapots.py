"""Teapots at three distances, after "Realtime Dome Imaging and Interaction" (Bailey, Clothier, Gebbie 2006).

Thirteen teapots float on a ball around the origin. From far away they are a group in front of the eye; from
the middle of the ball they are on all sides; and then there is the inside of the white one.

    python teapots.py [far|closer|closest|inside] [--solid|--wire]

Keys: 1 far, 2 closer, 3 closest, 4 inside; w wire or solid; space flies the eye in and out again; h prints
these lines; ESC quits. Dragging the mouse turns the teapots about the ball's middle.
"""

import argparse
import math

from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *

HELP = __doc__[__doc__.index("Keys:") :].strip()
RADIUS = 3.5
"""Of the ball."""
SIZE = 1.1
"""Of a teapot."""
DISTANCES = {"far": 12.0, "closer": 6.0, "closest": 0.0, "inside": -RADIUS}
"""From the eye to the middle of the ball."""
KEYS = {b"1": "far", b"2": "closer", b"3": "closest", b"4": "inside"}
FLIGHT = 16.0
"""Seconds that a flight takes, in and out."""
STEP = 16
"""Milliseconds between two pictures of the flight."""

CORNER = RADIUS / math.sqrt(3.0)
TEAPOTS = [
    # place, turn about the upright, colour
    ((0.0, 0.0, -RADIUS), 0.0, (0.85, 0.85, 0.90)),
    ((-RADIUS, 0.0, 0.0), 60.0, (0.90, 0.25, 0.20)),
    ((RADIUS, 0.0, 0.0), -60.0, (0.20, 0.45, 0.95)),
    ((0.0, RADIUS, 0.0), 20.0, (0.95, 0.75, 0.20)),
    ((0.0, -RADIUS, 0.0), -20.0, (0.55, 0.35, 0.85)),
    ((-CORNER, CORNER, -CORNER), 30.0, (0.95, 0.50, 0.15)),
    ((CORNER, CORNER, -CORNER), 150.0, (0.30, 0.75, 0.35)),
    ((-CORNER, -CORNER, -CORNER), -30.0, (0.20, 0.70, 0.75)),
    ((CORNER, -CORNER, -CORNER), 210.0, (0.85, 0.40, 0.60)),
    ((-CORNER, CORNER, CORNER), 100.0, (0.45, 0.60, 0.90)),
    ((CORNER, CORNER, CORNER), 80.0, (0.85, 0.70, 0.55)),
    ((-CORNER, -CORNER, CORNER), 260.0, (0.60, 0.80, 0.30)),
    ((CORNER, -CORNER, CORNER), -80.0, (0.80, 0.30, 0.30)),
]


class Viewer:
    """Where the eye is, how far the ball is turned, and how the teapots are drawn."""

    def __init__(self, place, wire):
        self.distance = DISTANCES[place]
        self.wire = wire
        self.yaw = self.pitch = 0.0  # degrees
        self.grip = None  # where the mouse took hold, in pixels
        self.flying = False
        self.phase = 0.0  # of the flight: 0 far away, pi inside

    def reshape(self, width, height):
        glViewport(0, 0, width, height)
        glMatrixMode(GL_PROJECTION)
        glLoadIdentity()
        gluPerspective(50.0, width / max(height, 1), 0.1, 40.0)
        glMatrixMode(GL_MODELVIEW)

    def display(self):
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
        glLoadIdentity()
        glLightfv(GL_LIGHT1, GL_POSITION, (0.0, 0.5, 0.0, 1.0))  # a lamp just above the eye
        glTranslatef(0.0, 0.0, -self.distance)
        glRotatef(self.pitch, 1.0, 0.0, 0.0)
        glRotatef(self.yaw, 0.0, 1.0, 0.0)
        glLightfv(GL_LIGHT0, GL_POSITION, (-2.0, 5.0, 3.0, 0.0))  # the sun
        (glDisable if self.wire else glEnable)(GL_LIGHTING)
        for place, turn, colour in TEAPOTS:
            glPushMatrix()
            glTranslatef(*place)
            glRotatef(turn, 0.0, 1.0, 0.0)
            glColor3fv(colour)
            (glutWireTeapot if self.wire else glutSolidTeapot)(SIZE)
            glPopMatrix()
        glutSwapBuffers()

    def keyboard(self, key, x, y):
        if key == b"\x1b":
            glutDestroyWindow(glutGetWindow())
            return
        if key in KEYS:
            self.distance = DISTANCES[KEYS[key]]
            self.flying = False
        elif key == b"w":
            self.wire = not self.wire
        elif key == b"h":
            print(HELP, flush=True)
        elif key == b" ":
            self.start_or_stop_flying()
        glutPostRedisplay()

    def start_or_stop_flying(self):
        self.flying = not self.flying
        if self.flying:
            share = (self.distance - DISTANCES["inside"]) / (DISTANCES["far"] - DISTANCES["inside"])
            self.phase = math.acos(2.0 * share - 1.0)
            glutTimerFunc(STEP, self.fly, 0)

    def fly(self, value):
        if not self.flying:
            return
        self.phase += 2.0 * math.pi * STEP / 1000.0 / FLIGHT
        share = (1.0 + math.cos(self.phase)) / 2.0
        self.distance = share * DISTANCES["far"] + (1.0 - share) * DISTANCES["inside"]
        glutPostRedisplay()
        glutTimerFunc(STEP, self.fly, value)

    def mouse(self, button, state, x, y):
        self.grip = (x, y) if button == GLUT_LEFT_BUTTON and state == GLUT_DOWN else None

    def motion(self, x, y):
        if self.grip is None:
            return
        self.yaw += 0.3 * (x - self.grip[0])
        self.pitch = max(-90.0, min(90.0, self.pitch + 0.3 * (y - self.grip[1])))
        self.grip = (x, y)
        glutPostRedisplay()


def set_up():
    """What stays the same all the time: a warm sun, a cool lamp, shiny paint."""
    glClearColor(0.06, 0.08, 0.16, 1.0)
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_NORMALIZE)
    glEnable(GL_LIGHT0)
    glLightfv(GL_LIGHT0, GL_DIFFUSE, (0.80, 0.75, 0.65, 1.0))
    glLightfv(GL_LIGHT0, GL_SPECULAR, (0.60, 0.55, 0.50, 1.0))
    glEnable(GL_LIGHT1)
    glLightfv(GL_LIGHT1, GL_DIFFUSE, (0.40, 0.45, 0.55, 1.0))
    glLightfv(GL_LIGHT1, GL_SPECULAR, (0.35, 0.40, 0.45, 1.0))
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (0.18, 0.18, 0.22, 1.0))
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE)
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE)  # for the teapot's inside
    glFrontFace(GL_CW)  # as GLUT's teapot has its faces
    glEnable(GL_COLOR_MATERIAL)
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE)
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (0.7, 0.7, 0.7, 1.0))
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 48.0)


def main():
    """Open the window and hand over to GLUT."""
    parser = argparse.ArgumentParser(description="Teapots at three distances.")
    parser.add_argument("place", nargs="?", choices=DISTANCES, default="closer")
    drawn = parser.add_mutually_exclusive_group()
    drawn.add_argument("--wire", action="store_true", help="teapots of lines")
    drawn.add_argument("--solid", dest="wire", action="store_false", help="shaded teapots (the default)")
    options = parser.parse_args()

    glutInit()
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH)
    glutInitWindowSize(800, 800)
    glutCreateWindow("Teapots: 1 far, 2 closer, 3 closest, 4 inside, w wire/solid, space fly")
    print(HELP, flush=True)
    set_up()
    viewer = Viewer(options.place, options.wire)
    glutDisplayFunc(viewer.display)
    glutReshapeFunc(viewer.reshape)
    glutKeyboardFunc(viewer.keyboard)
    glutMouseFunc(viewer.mouse)
    glutMotionFunc(viewer.motion)
    glutMainLoop()


if __name__ == "__main__":
    main()
