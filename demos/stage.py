"""What most of these demos share: a GLUT window, an eye that looks around, a table of keys, and writing."""

from collections.abc import Callable

from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *

STEP = 16
"""Milliseconds between two pictures."""
CAP_HEIGHT = 100.0
"""Of GLUT's stroke letters, in their own units."""
LETTERINGS = 300
"""How many texts are kept as display lists."""
NAMED = {b" ": "space", b"\x1b": "ESC", b"\r": "return"}
ARROWS = {GLUT_KEY_LEFT: (-3, 0), GLUT_KEY_RIGHT: (3, 0), GLUT_KEY_UP: (0, 3), GLUT_KEY_DOWN: (0, -3)}
"""Degrees by which an arrow key turns the eye: to the right, up."""


class Stage:
    """A scene that is drawn again and again; demos derive from it, draw(), and say what their keys do."""

    title = ""
    fovy, near, far = 60.0, 0.1, 100.0

    def __init__(self) -> None:
        self.yaw = self.pitch = 0.0  # degrees: to the right, up
        self.width = self.height = 1
        self.seconds = 0.0  # on the scene's own clock, which stands still in a pause
        self.paused = False
        self.helping = False
        self.grip: tuple[int, int] | None = None  # where the mouse took hold, in pixels
        self.now = 0  # milliseconds
        self.lists: dict[str, int] = {}
        self.keys: dict[str, tuple[str, Callable[[], object]]] = {
            "space": ("pause or go on", self.pause),
            "h": ("these lines", self.help),
            "f": ("full screen or window", glutFullScreenToggle),
            "ESC": ("quit", lambda: glutDestroyWindow(glutGetWindow())),
        }

    def set_up(self) -> None:
        """What the scene needs once, with a window there."""

    def draw(self) -> None:
        """The scene, in the eye's own space: look() first."""

    def wheel(self, up: bool) -> None:
        """What the mouse wheel does."""

    def status(self) -> list[str]:
        """What is written at the bottom, a line each."""
        return [f"{self.title}   [h] keys"]

    def run(self, width: int = 900, height: int = 700) -> None:
        """Open the window, print the keys, and hand over to GLUT."""
        glutInit()
        glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH | GLUT_MULTISAMPLE)
        glutInitWindowSize(width, height)
        glutCreateWindow(self.title)
        print("\n".join([self.title, *self.help_lines()]), flush=True)
        self.set_up()
        self.now = glutGet(GLUT_ELAPSED_TIME)
        glutDisplayFunc(self.display)
        glutReshapeFunc(self.reshape)
        glutKeyboardFunc(self.keyboard)
        glutSpecialFunc(self.special)
        glutMouseFunc(self.mouse)
        glutMotionFunc(self.motion)
        glutTimerFunc(STEP, self.tick, 0)
        glutMainLoop()

    def help_lines(self) -> list[str]:
        """Every key with what it does."""
        looking = ["drag, arrows: look around"]
        return looking + [f"{key}: {does}" for key, (does, _) in self.keys.items()]

    def reshape(self, width: int, height: int) -> None:
        self.width, self.height = width, max(height, 1)
        glViewport(0, 0, self.width, self.height)
        glMatrixMode(GL_PROJECTION)
        glLoadIdentity()
        gluPerspective(self.fovy, self.width / self.height, self.near, self.far)
        glMatrixMode(GL_MODELVIEW)

    def display(self) -> None:
        now = glutGet(GLUT_ELAPSED_TIME)
        self.seconds += 0.0 if self.paused else (now - self.now) / 1000.0
        self.now = now
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
        glLoadIdentity()
        self.draw()
        self.write_over()
        glutSwapBuffers()

    def look(self) -> None:
        """Turn the scene as the eye is turned."""
        glRotatef(-self.pitch, 1.0, 0.0, 0.0)
        glRotatef(self.yaw, 0.0, 1.0, 0.0)

    def write_over(self) -> None:
        """Write the status, and the keys if they are wanted, flat over the picture."""
        size = self.height / 48.0
        with_keys = self.help_lines()[::-1] if self.helping else []
        self.begin_flat()
        for number, line in enumerate(self.status()[::-1] + with_keys):
            self.write(size, size * (1.0 + 1.8 * number), line, size)
        self.end_flat()

    def begin_flat(self) -> None:
        """From here on, coordinates are the window's pixels, and nothing is lit, textured or hidden."""
        glPushAttrib(GL_ENABLE_BIT | GL_LINE_BIT | GL_CURRENT_BIT)
        for capability in (GL_LIGHTING, GL_TEXTURE_2D, GL_DEPTH_TEST, GL_FOG, GL_CULL_FACE):
            glDisable(capability)
        glMatrixMode(GL_PROJECTION)
        glPushMatrix()
        glLoadIdentity()
        gluOrtho2D(0, self.width, 0, self.height)
        glMatrixMode(GL_MODELVIEW)
        glPushMatrix()
        glLoadIdentity()

    def end_flat(self) -> None:
        glMatrixMode(GL_PROJECTION)
        glPopMatrix()
        glMatrixMode(GL_MODELVIEW)
        glPopMatrix()
        glPopAttrib()

    def write(self, x: float, y: float, text: str, size: float, colour=(1.0, 1.0, 1.0)) -> None:
        """Text from a pixel on, size pixels high, with a dark edge so that it is seen over anything."""
        if text not in self.lists:
            self.letter(text)
        stroke = max(1.0, self.height / 550.0)
        for width, shade in ((3.0 * stroke, (0.0, 0.0, 0.0)), (stroke, colour)):
            glLineWidth(width)
            glColor3fv(shade)
            glPushMatrix()
            glTranslatef(x, y, 0.0)
            glScalef(size / CAP_HEIGHT, size / CAP_HEIGHT, 1.0)
            glCallList(self.lists[text])
            glPopMatrix()

    def letter(self, text: str) -> None:
        """Keep a text as a display list; texts that change with time push all out now and then."""
        if len(self.lists) >= LETTERINGS:
            for kept in self.lists.values():
                glDeleteLists(kept, 1)
            self.lists.clear()
        self.lists[text] = glGenLists(1)
        glNewList(self.lists[text], GL_COMPILE)
        for letter in text.encode("ascii", "replace"):
            glutStrokeCharacter(GLUT_STROKE_ROMAN, letter)
        glEndList()

    def tick(self, value: int) -> None:
        glutTimerFunc(STEP, self.tick, value)
        glutPostRedisplay()

    def keyboard(self, key: bytes, x: int, y: int) -> None:
        name = NAMED.get(key, key.decode("latin-1"))
        if name in self.keys:
            self.keys[name][1]()

    def special(self, key: int, x: int, y: int) -> None:
        right, up = ARROWS.get(key, (0, 0))
        self.turn(right, up)

    def mouse(self, button: int, state: int, x: int, y: int) -> None:
        if button in (3, 4) and state == GLUT_DOWN:
            self.wheel(button == 3)
        self.grip = (x, y) if button == GLUT_LEFT_BUTTON and state == GLUT_DOWN else None

    def motion(self, x: int, y: int) -> None:
        if self.grip is not None:
            self.turn(0.15 * (self.grip[0] - x), 0.15 * (y - self.grip[1]))
            self.grip = (x, y)

    def turn(self, right: float, up: float) -> None:
        self.yaw = (self.yaw + right) % 360.0
        self.pitch = max(-90.0, min(90.0, self.pitch + up))

    def pause(self) -> None:
        self.paused = not self.paused

    def help(self) -> None:
        self.helping = not self.helping
