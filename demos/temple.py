"""A walk among columns, with pygame: mouse-look, a polished floor, afternoon light.

    python temple.py

Keys: w, a, s, d or the arrows walk; drag to look, m lets the mouse look without a button; l sends the Sun
round; h shows the keys; ESC quits.
"""

import math
import sys

import numpy as np
from masonry import box, compiled, draw_mesh, turned
from OpenGL.GL import *
from OpenGL.GLU import *
from paint import between, fractal, texture

try:
    import pygame
except ImportError:
    sys.exit("temple.py needs pygame: pip install pygame")

TITLE = "Temple"
HELP = [
    "w a s d, arrows: walk",
    "drag: look around",
    "m: look without a button",
    "l: the Sun goes round",
    "h: these lines",
    "ESC: quit",
]
WINDOW = (900, 700)
FOVY, NEAR, FAR = 70.0, 0.08, 300.0
ROWS, APART = 8, 3.6
"""Columns each way, and metres from one to the next."""
TALL, THICK, FLUTES = 5.2, 0.46, 20
"""A column's height and radius, metres, and its flutes."""
EYE, SPEED = 1.65, 3.2
"""Metres above the floor; metres a second."""
PLACES = [
    ((i - ROWS / 2 + 0.5) * APART, (j - ROWS / 2 + 0.5) * APART) for i in range(ROWS) for j in range(ROWS)
]
PLACES = [(x, z) for x, z in PLACES if max(abs(x), abs(z)) > APART]
"""The columns' x and z: none in the middle, where the ball lies."""
PROFILE = [
    (0.66, 0.14), (0.66, 0.20), (0.70, 0.25), (0.66, 0.31), (0.56, 0.33), (0.58, 0.38), (0.52, 0.42),
    *((0.46 - 0.08 * t * t, 0.44 + 3.96 * t) for t in np.linspace(0, 1, 12)),
    (0.42, 4.44), (0.42, 4.50), (0.38, 4.54), (0.46, 4.66), (0.62, 4.80), (0.66, 4.86),
]  # fmt: skip
"""Radius and height of a column's rings; the flutes lie between the narrow rings below and above."""


def fluted(radii: np.ndarray, heights: np.ndarray, angles: np.ndarray) -> np.ndarray:
    """A column's radii with its flutes, where it is a shaft."""
    shaft = (heights > 0.43) & (heights < 4.41)
    return radii - 0.035 * shaft * np.abs(np.sin(angles * FLUTES / 2)) ** 0.7


def marble(dark, light, seed: int) -> np.ndarray:
    """Veined stone, (256, 256, 3), that repeats."""
    at = np.stack(np.meshgrid(np.arange(256), np.arange(256)), -1) / 256.0 * 4.0
    bent = at + 0.6 * np.stack([fractal(at, 4, seed + s, period=4) for s in (1, 5)], -1)
    veins = np.clip(fractal(bent, 5, seed + 9, ridged=True, period=4), 0.0, 1.0)
    grain = 0.08 * fractal(at * 8, 3, seed + 30, period=32)
    return between(1.05 - 0.9 * veins**3 - 0.25 * veins + grain, (dark, light))


class Temple:
    """The hall, where the walker stands and looks, and the Sun."""

    def __init__(self) -> None:
        self.place = np.array([APART * 0.1, EYE, APART * 1.75])
        self.yaw, self.pitch = -6.0, 6.0
        self.sun = 222.0  # degrees around
        self.sun_moves = self.helping = False
        self.words: dict[str, tuple[int, int, int]] = {}
        self.font = pygame.font.Font(None, WINDOW[1] // 26)
        glEnable(GL_NORMALIZE)
        glEnable(GL_LIGHT0)
        glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (0.34, 0.36, 0.44, 1.0))
        glLightfv(GL_LIGHT0, GL_DIFFUSE, (0.85, 0.72, 0.52, 1.0))
        glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, (1.0, 1.0, 1.0, 1.0))
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
        self.stone = texture(marble((0.62, 0.56, 0.50), (0.97, 0.93, 0.86), 3))
        checks = np.kron([[0, 1], [1, 0]], np.ones((256, 256)))[..., None]
        dark = np.tile(marble((0.1, 0.13, 0.15), (0.26, 0.31, 0.31), 60), (2, 2, 1))
        light = np.tile(marble((0.7, 0.62, 0.52), (0.93, 0.88, 0.8), 90), (2, 2, 1))
        self.floor = texture(checks * dark + (1 - checks) * light)
        edge = np.sin(np.linspace(0, math.pi, 32))[None, :, None] ** 0.7 * np.ones((2, 1, 1))
        self.shade = texture(np.concatenate([np.zeros((2, 32, 3)), edge], -1))
        self.ball = gluNewQuadric()
        gluQuadricTexture(self.ball, GL_TRUE)
        self.column, self.beams = compiled(draw_column), compiled(draw_beams)

    def towards_sun(self) -> np.ndarray:
        around = math.radians(self.sun)
        return np.array([math.sin(around), 0.78, -math.cos(around)])

    def draw(self, size: tuple[int, int]) -> None:
        glViewport(0, 0, *size)
        glMatrixMode(GL_PROJECTION)
        glLoadIdentity()
        gluPerspective(FOVY, size[0] / max(size[1], 1), NEAR, FAR)
        glMatrixMode(GL_MODELVIEW)
        glLoadIdentity()
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
        glRotatef(-self.pitch, 1.0, 0.0, 0.0)
        glRotatef(self.yaw, 0.0, 1.0, 0.0)
        draw_sky()
        glTranslatef(*-self.place)
        glEnable(GL_TEXTURE_2D)
        glPushMatrix()
        glScalef(1.0, -1.0, 1.0)  # what the floor mirrors
        self.draw_hall()
        glPopMatrix()
        self.draw_floor()
        self.draw_hall()
        glDisable(GL_TEXTURE_2D)
        self.write(size)

    def draw_hall(self) -> None:
        glEnable(GL_DEPTH_TEST)
        glEnable(GL_LIGHTING)
        glLightfv(GL_LIGHT0, GL_POSITION, (*self.towards_sun(), 0.0))
        glBindTexture(GL_TEXTURE_2D, self.stone)
        for x, z in PLACES:
            glPushMatrix()
            glTranslatef(x, 0.0, z)
            glCallList(self.column)
            glPopMatrix()
        glCallList(self.beams)
        glPushMatrix()
        glTranslatef(0.0, 1.3, 0.0)
        glRotatef(-70.0, 1.0, 0.2, 0.0)
        gluSphere(self.ball, 1.3, 48, 32)
        glPopMatrix()
        glDisable(GL_LIGHTING)

    def draw_floor(self) -> None:
        """A floor that lets a little of its mirror image through, with the columns' shadows on it."""
        glDisable(GL_DEPTH_TEST)
        glEnable(GL_BLEND)
        glBindTexture(GL_TEXTURE_2D, self.floor)
        glColor4f(1.0, 0.95, 0.88, 0.80)
        out = ROWS * APART * 0.5 + 3.0
        glBegin(GL_QUADS)
        for x, z in ((-out, -out), (out, -out), (out, out), (-out, out)):
            glTexCoord2f(x / 2.4, z / 2.4)
            glVertex3f(x, 0.0, z)
        glEnd()
        glBindTexture(GL_TEXTURE_2D, self.shade)
        glColor4f(0.05, 0.05, 0.12, 0.55)
        away = -self.towards_sun()[[0, 2]] * 4.0
        aside = np.array((-away[1], away[0])) / np.linalg.norm(away) * THICK
        glBegin(GL_QUADS)
        for at in np.array([*PLACES, (0.0, 0.0)]):
            for s, t, corner in (
                (0, 0, at - aside),
                (1, 0, at + aside),
                (1, 1, at + aside + away),
                (0, 1, at - aside + away),
            ):
                glTexCoord2f(s, t)
                glVertex3f(corner[0], 0.0, corner[1])
        glEnd()
        glDisable(GL_BLEND)
        glColor4f(1.0, 1.0, 1.0, 1.0)

    def write(self, size: tuple[int, int]) -> None:
        """The lines at the bottom left, each a texture of its own, flat over the picture."""
        glMatrixMode(GL_PROJECTION)
        glLoadIdentity()
        gluOrtho2D(0, size[0], 0, size[1])
        glMatrixMode(GL_MODELVIEW)
        glLoadIdentity()
        glDisable(GL_DEPTH_TEST)
        glEnable(GL_TEXTURE_2D)
        glEnable(GL_BLEND)
        scale = size[1] / WINDOW[1]
        for number, line in enumerate([f"{TITLE}   [h] keys", *(HELP[::-1] if self.helping else [])]):
            name, width, height = self.words.get(line) or self.word(line)
            glBindTexture(GL_TEXTURE_2D, name)
            left, low = 14 * scale, (12 + 27 * number) * scale
            glBegin(GL_QUADS)
            for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
                glTexCoord2f(s, t)
                glVertex2f(left + s * width * scale, low + t * height * scale)
            glEnd()
        glDisable(GL_BLEND)
        glDisable(GL_TEXTURE_2D)

    def word(self, line: str) -> tuple[int, int, int]:
        """A line's texture, width and height in pixels; kept."""
        image = pygame.Surface(np.add(self.font.size(line), 4), pygame.SRCALPHA)
        for colour, shift in (((0, 0, 0), 3), ((255, 250, 235), 1)):
            image.blit(self.font.render(line, True, colour), (shift, shift))
        pixels = pygame.image.tobytes(image, "RGBA", True)
        name = glGenTextures(1)
        glBindTexture(GL_TEXTURE_2D, name)
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, *image.get_size(), 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)
        self.words[line] = name, *image.get_size()
        return self.words[line]

    def walk(self, ahead: float, right: float, seconds: float) -> None:
        """Go on, but through no column."""
        turn = math.radians(self.yaw)
        step = ahead * np.array([math.sin(turn), -math.cos(turn)]) + right * np.array(
            [math.cos(turn), math.sin(turn)]
        )
        there = self.place[[0, 2]] + SPEED * seconds * step
        wide = [*(((x, z), 0.95) for x, z in PLACES), ((0.0, 0.0), 1.6)]
        if (
            all(np.hypot(*(there - at)) > reach for at, reach in wide)
            and np.abs(there).max() < ROWS * APART * 0.5 + 2
        ):
            self.place[[0, 2]] = there

    def look(self, right: float, down: float) -> None:
        self.yaw += 0.15 * right
        self.pitch = max(-89.0, min(89.0, self.pitch - 0.15 * down))


def draw_column() -> None:
    draw_mesh(turned(PROFILE, 3 * FLUTES, fluted))
    box((0.0, 0.0, 0.0), (1.45, 0.14, 1.45))
    box((0.0, 4.86, 0.0), (1.4, 0.34, 1.4))


def draw_beams() -> None:
    """Long beams on the columns: one over each row, and slender ones across."""
    long = ROWS * APART
    for x in sorted({x for x, _ in PLACES}):
        box((x, TALL, 0.0), (0.8, 0.7, long))
    for z in np.arange(-long / 2 + APART / 4, long / 2, APART / 2):
        box((0.0, TALL + 0.7, z), (long, 0.32, 0.28))


def draw_sky() -> None:
    """The sky as rings of a ball around the eye, from the warm horizon to the blue zenith."""
    glDisable(GL_DEPTH_TEST)
    rows = (
        (0.60, 0.52, 0.45),
        (0.98, 0.84, 0.66),
        (0.72, 0.78, 0.86),
        (0.36, 0.55, 0.84),
        (0.16, 0.34, 0.70),
        (0.10, 0.24, 0.56),
    )
    ups = np.radians((-90.0, 0.0, 9.0, 28.0, 55.0, 90.0))
    for low, high, one, two in zip(ups, ups[1:], rows, rows[1:], strict=False):
        glBegin(GL_QUAD_STRIP)
        for step in range(33):
            around = step * math.pi / 16
            for up, colour in ((low, one), (high, two)):
                glColor3fv(colour)
                glVertex3f(
                    100 * math.cos(up) * math.sin(around),
                    100 * math.sin(up),
                    -100 * math.cos(up) * math.cos(around),
                )
        glEnd()
    glColor3f(1.0, 1.0, 1.0)


def main() -> None:
    """Open the window and walk until it is closed."""
    pygame.init()
    pygame.display.gl_set_attribute(pygame.GL_MULTISAMPLEBUFFERS, 1)
    pygame.display.gl_set_attribute(pygame.GL_MULTISAMPLESAMPLES, 4)
    pygame.display.set_mode(WINDOW, pygame.OPENGL | pygame.DOUBLEBUF | pygame.RESIZABLE)
    pygame.display.set_caption(TITLE)
    print("\n".join([TITLE, *HELP]), flush=True)
    temple, clock = Temple(), pygame.time.Clock()
    while True:
        seconds = clock.tick(60) / 1000.0
        for event in pygame.event.get():
            if event.type == pygame.QUIT or (event.type == pygame.KEYDOWN and event.key == pygame.K_ESCAPE):
                return
            if event.type == pygame.KEYDOWN and event.key == pygame.K_h:
                temple.helping = not temple.helping
            elif event.type == pygame.KEYDOWN and event.key == pygame.K_l:
                temple.sun_moves = not temple.sun_moves
            elif event.type == pygame.KEYDOWN and event.key == pygame.K_m:
                pygame.event.set_grab(not pygame.event.get_grab())
                pygame.mouse.set_visible(not pygame.event.get_grab())
            elif event.type == pygame.MOUSEMOTION and pygame.event.get_grab():
                temple.look(*event.rel)
            elif event.type == pygame.MOUSEMOTION and event.buttons[0]:
                temple.look(*(-rel for rel in event.rel))
        keys = pygame.key.get_pressed()
        ahead = (keys[pygame.K_w] or keys[pygame.K_UP]) - (keys[pygame.K_s] or keys[pygame.K_DOWN])
        right = (keys[pygame.K_d] or keys[pygame.K_RIGHT]) - (keys[pygame.K_a] or keys[pygame.K_LEFT])
        temple.walk(ahead, right, seconds)
        temple.sun += 10.0 * seconds * temple.sun_moves
        temple.draw(pygame.display.get_surface().get_size())
        pygame.display.flip()


if __name__ == "__main__":
    main()
