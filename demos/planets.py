"""The solar system, with the names written where gluProject says, and a panel with the date.

    python planets.py [--date DAYS]

Sizes and distances are drawn nearer to each other than they are; the periods are true. The eye stands among
the orbits, or rides along with a planet.

Keys: 0 among the orbits, 1 to 8 ride along with a planet, + and - faster and slower, n names, o orbits; drag
to look around; space pauses; h shows all of them; ESC quits.
"""

import argparse
import datetime
import math
from dataclasses import dataclass, field

import numpy as np
from masonry import compiled
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
from paint import between, fractal, texture
from stage import Stage

MAP = (128, 256)
"""Rows and columns of a planet's map."""
FIRST_DAY = datetime.date(2026, 1, 1)
AMONG = (0.0, 2.3, 9.0)
"""Where the eye stands when it rides with no planet: above the asteroid belt."""

DOWN = -11.0
"""How the eye is then turned up, in degrees."""


@dataclass
class Planet:
    """Drawn sizes: radius, distance from the Sun; true ones: period in days, tilt of the axis in degrees."""

    name: str
    radius: float
    distance: float
    period: float
    tilt: float
    start: float  # degrees along the orbit on the first day
    kind: str  # of its map
    colours: tuple  # from low or dark to high or bright, RGB
    place: tuple = (0.0, 0.0, 0.0)
    texture: int = field(default=0, repr=False)


PLANETS = [
    Planet("Mercury", 0.26, 2.6, 88.0, 0.0, 300.0, "rock", ((0.25, 0.22, 0.2), (0.62, 0.57, 0.52))),
    Planet("Venus", 0.45, 3.9, 224.7, 177.0, 190.0, "cloud", ((0.75, 0.55, 0.3), (1.0, 0.93, 0.75))),
    Planet("Earth", 0.52, 5.4, 365.3, 23.4, 222.0, "earth", ()),
    Planet("Mars", 0.40, 7.0, 687.0, 25.2, 322.0, "rock", ((0.35, 0.13, 0.07), (0.9, 0.5, 0.3))),
    Planet("Jupiter", 1.60, 11.0, 4333.0, 3.1, 203.0, "bands",
           ((0.55, 0.33, 0.2), (0.93, 0.85, 0.7), (0.72, 0.47, 0.3), (0.98, 0.94, 0.86))),
    Planet("Saturn", 1.35, 13.5, 10759.0, 26.7, 335.0, "bands",
           ((0.72, 0.58, 0.38), (0.95, 0.86, 0.63), (0.85, 0.72, 0.5), (1.0, 0.95, 0.8))),
    Planet("Uranus", 1.00, 17.0, 30687.0, 97.8, 118.0, "bands", ((0.5, 0.78, 0.82), (0.72, 0.92, 0.93))),
    Planet("Neptune", 1.00, 20.0, 60190.0, 28.3, 62.0, "bands", ((0.12, 0.22, 0.65), (0.38, 0.56, 0.95))),
]  # fmt: skip


def on_sphere() -> np.ndarray:
    """Points of the unit sphere for each texel of a map: (rows, columns, 3)."""
    rows, columns = MAP
    up = np.linspace(-np.pi / 2, np.pi / 2, rows)[:, None]
    around = np.arange(columns) * 2 * np.pi / columns
    parts = np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), np.sin(up) + 0 * around
    return np.stack(parts, -1)


def planet_map(planet: Planet, seed: int) -> np.ndarray:
    """What a planet looks like all around, (rows, columns, 3), 0 to 1."""
    at = on_sphere()
    rough = fractal(at * 3.0, 6, seed)
    if planet.kind == "earth":
        height = rough + 0.25 * fractal(at * 9.0, 4, seed + 9, ridged=True)
        sea = between((height + 0.8) * 1.2, ((0.01, 0.05, 0.2), (0.05, 0.25, 0.5)))
        land = between(
            np.abs(at[..., 2]) + 0.5 * rough, ((0.12, 0.36, 0.1), (0.5, 0.42, 0.2), (0.95, 0.97, 1.0))
        )
        colours = np.where((height > 0.08)[..., None], land, sea)
        clouds = np.clip(2.2 * fractal(at * (2.5, 2.5, 5.0), 6, seed + 20) - 0.1, 0.0, 1.0)[..., None]
        return colours * (1.0 - clouds) + clouds
    if planet.kind == "bands":
        latitude = at[..., 2] + 0.05 * rough
        bands = fractal(np.stack([latitude * 7.0, 0.0 * latitude], -1), 3, seed)
        return between(0.5 + 0.42 * bands + 0.12 * rough, planet.colours)
    if planet.kind == "cloud":
        return between(0.5 + fractal(at * (1.5, 1.5, 5.0), 6, seed), planet.colours)
    return between(0.5 + rough + 0.4 * fractal(at * 8.0, 4, seed + 5, ridged=True) - 0.2, planet.colours)


def milky_way() -> np.ndarray:
    """The sky's map: a band of haze along the equator with dark clouds in it."""
    at = on_sphere()
    band = np.exp(-((at[..., 2] / 0.2) ** 2)) * (0.6 + 0.4 * at[..., 0])
    dark = np.clip(1.6 * fractal(at * (4.0, 4.0, 9.0), 6, 77) + 0.1, 0.0, 1.0) * np.exp(
        -((at[..., 2] / 0.1) ** 2)
    )
    light = np.clip(band * (0.75 + 0.5 * fractal(at * 5.0, 5, 70)) - 0.9 * dark, 0.0, 1.0)
    return between(light, ((0.012, 0.014, 0.034), (0.26, 0.21, 0.3), (0.62, 0.54, 0.5)))


def glow() -> np.ndarray:
    """The Sun's shine: white in the middle, clear at the edge, (64, 64, 4)."""
    x = np.linspace(-1, 1, 128)
    far = np.hypot(x, x[:, None])
    alpha = np.clip(1.0 - far, 0, 1) ** 2.2 + 0.8 * np.exp(-((far / 0.22) ** 4))
    return np.dstack([between(far * 1.6, ((1, 0.97, 0.85), (1, 0.75, 0.35), (1, 0.45, 0.15))), alpha])


class Planets(Stage):
    """The Sun, eight planets, a moon, a ring, the belt, and the stars."""

    title = "Solar system"
    fovy, near, far = 60.0, 0.05, 400.0

    def __init__(self, days: float) -> None:
        super().__init__()
        self.days, self.pace = days, 10.0  # days a second
        self.before = 0.0
        self.riding: Planet | None = None
        self.pitch = DOWN
        self.names = self.orbits = True
        self.keys = {"0": ("stand among the orbits", lambda: self.ride(None))} | {
            str(number): (f"ride along with {planet.name}", lambda planet=planet: self.ride(planet))
            for number, planet in enumerate(PLANETS, 1)
        } | {
            "+": ("faster", lambda: self.hurry(2.0)),
            "-": ("slower", lambda: self.hurry(0.5)),
            "n": ("names", lambda: setattr(self, "names", not self.names)),
            "o": ("orbits", lambda: setattr(self, "orbits", not self.orbits)),
        } | self.keys  # fmt: skip

    def set_up(self) -> None:
        glClearColor(0.006, 0.008, 0.02, 1.0)
        glEnable(GL_DEPTH_TEST)
        glEnable(GL_LIGHT0)
        glLightfv(GL_LIGHT0, GL_DIFFUSE, (1.0, 0.97, 0.9, 1.0))
        glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (0.2, 0.2, 0.24, 1.0))
        glEnable(GL_NORMALIZE)
        for number, planet in enumerate(PLANETS):
            planet.texture = texture(planet_map(planet, 40 + 31 * number))
        self.moon = texture(planet_map(Planet("", 0, 0, 0, 0, 0, "rock", ((0.3,) * 3, (0.8,) * 3)), 7))
        self.sun = texture(between(0.6 + fractal(on_sphere() * 6.0, 5, 3), ((1, 0.55, 0.1), (1, 0.95, 0.6))))
        self.glow, self.haze = texture(glow()), texture(milky_way())
        self.ball = gluNewQuadric()
        gluQuadricTexture(self.ball, GL_TRUE)
        self.sky, self.paths, self.belt, self.ring = (
            compiled(draw) for draw in (draw_stars, draw_orbits, draw_belt, draw_ring)
        )

    def draw(self) -> None:
        self.days += (self.seconds - self.before) * self.pace
        self.before = self.seconds
        for planet in PLANETS:
            angle = math.radians(planet.start + 360.0 * self.days / planet.period)
            planet.place = planet.distance * math.cos(angle), 0.0, -planet.distance * math.sin(angle)
        self.look()
        self.draw_sky()
        glClear(GL_DEPTH_BUFFER_BIT)
        eye = self.eye()
        glTranslatef(*(-c for c in eye))
        glLightfv(GL_LIGHT0, GL_POSITION, (0.0, 0.0, 0.0, 1.0))
        if self.orbits:
            glCallList(self.paths)
        glCallList(self.belt)
        glColor3f(1.0, 1.0, 1.0)
        glEnable(GL_TEXTURE_2D)
        self.draw_ball(self.sun, 1.25, (0.0, 0.0, 0.0), 7.0, 25.0)
        glEnable(GL_LIGHTING)
        for planet in PLANETS:
            self.draw_ball(planet.texture, planet.radius, planet.place, planet.tilt, 1.0)
        x, _, z = PLANETS[2].place
        along = 2 * math.pi * self.days / 27.3 + 1.2
        self.draw_ball(
            self.moon, 0.11, (x + 0.75 * math.cos(along), 0.06, z - 0.75 * math.sin(along)), 0.0, 27.3
        )
        glDisable(GL_LIGHTING)
        self.draw_shine(eye)
        glDisable(GL_TEXTURE_2D)
        glPushMatrix()
        glTranslatef(*PLANETS[5].place)
        glRotatef(PLANETS[5].tilt, 0.0, 0.0, 1.0)
        glCallList(self.ring)
        glPopMatrix()
        self.measures = [glGetDoublev(GL_MODELVIEW_MATRIX), glGetDoublev(GL_PROJECTION_MATRIX),
                         glGetIntegerv(GL_VIEWPORT)]  # fmt: skip

    def draw_sky(self) -> None:
        glPushMatrix()
        glRotatef(62.0, 0.0, 0.0, 1.0)
        glRotatef(90.0, 1.0, 0.0, 0.0)
        glEnable(GL_TEXTURE_2D)
        glColor3f(1.0, 1.0, 1.0)
        glBindTexture(GL_TEXTURE_2D, self.haze)
        gluSphere(self.ball, 200.0, 40, 20)
        glDisable(GL_TEXTURE_2D)
        glCallList(self.sky)
        glPopMatrix()

    def eye(self) -> tuple:
        """Above the belt, or beyond the planet that the eye rides with, the Sun behind it."""
        if self.riding is None:
            return AMONG
        x, _, z = self.riding.place
        out = 1.0 + 3.2 * self.riding.radius / self.riding.distance
        return x * out, 0.9 * self.riding.radius, z * out

    def draw_ball(self, texture: int, radius: float, place: tuple, tilt: float, day: float) -> None:
        glBindTexture(GL_TEXTURE_2D, texture)
        glPushMatrix()
        glTranslatef(*place)
        glRotatef(tilt, 0.0, 0.0, 1.0)
        glRotatef(-90.0, 1.0, 0.0, 0.0)
        glRotatef(20.0 * self.seconds / day, 0.0, 0.0, 1.0)
        gluSphere(self.ball, radius, 40, 20)
        glPopMatrix()

    def draw_shine(self, eye: tuple) -> None:
        """The Sun's glow: a square that faces the eye, added to what is there."""
        towards = np.array(eye) / np.linalg.norm(eye)
        right = np.cross((0.0, 1.0, 0.0), towards)
        right /= np.linalg.norm(right)
        up = np.cross(towards, right)
        glBindTexture(GL_TEXTURE_2D, self.glow)
        glEnable(GL_BLEND)
        glBlendFunc(GL_SRC_ALPHA, GL_ONE)
        glDepthMask(GL_FALSE)
        glBegin(GL_QUADS)
        for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
            glTexCoord2f(s, t)
            glVertex3fv(5.0 * ((2 * s - 1) * right + (2 * t - 1) * up))
        glEnd()
        glDepthMask(GL_TRUE)
        glDisable(GL_BLEND)

    def write_over(self) -> None:
        super().write_over()
        if not self.names:
            return
        size = self.height / 52.0
        places = [(gluProject(*p.place, *self.measures), p) for p in PLANETS]
        self.begin_flat()
        for (x, y, depth), planet in places:
            if 0.0 < depth < 1.0:
                self.write(x + 0.8 * size, y + 0.8 * size, planet.name, size, (0.75, 0.9, 1.0))
        self.end_flat()

    def status(self) -> list[str]:
        date = (FIRST_DAY + datetime.timedelta(days=int(self.days))).isoformat()
        place = f"riding with {self.riding.name}" if self.riding else "among the orbits"
        return [f"{date}   {self.pace:g} days a second   {place}", *super().status()]

    def ride(self, planet: Planet | None) -> None:
        self.riding = planet
        eye = self.eye()
        self.yaw, self.pitch = math.degrees(math.atan2(-eye[0], eye[2])), DOWN if planet is None else -8.0

    def hurry(self, factor: float) -> None:
        self.pace = max(0.625, min(5120.0, self.pace * factor))


def draw_stars() -> None:
    """Stars on a far sphere, more than half of them along the Milky Way, the plane z = 0."""
    unit = max(1.0, glGetIntegerv(GL_VIEWPORT)[3] / 640.0)
    chance = np.random.default_rng(6)
    at = chance.normal(size=(6000, 3))
    at[2500:, 2] *= 0.16
    at *= 150.0 / np.linalg.norm(at, axis=1)[:, None]
    bright = chance.power(0.3, len(at)) * np.where(np.arange(len(at)) < 2500, 1.0, 0.55) + 0.12
    colours = (
        between(chance.uniform(size=len(at)), ((1, 0.8, 0.6), (1, 1, 1), (0.7, 0.8, 1))) * bright[:, None]
    )
    sizes = np.digitize(bright, (0.55, 0.9))
    for size in range(3):
        glPointSize(unit * (1.0 + 0.7 * size))
        glBegin(GL_POINTS)
        for place, colour in zip(at[sizes == size], colours[sizes == size], strict=True):
            glColor3fv(colour)
            glVertex3fv(place)
        glEnd()


def draw_orbits() -> None:
    for planet in PLANETS:
        glColor3f(0.16, 0.25, 0.38)
        glBegin(GL_LINE_LOOP)
        for step in range(180):
            angle = math.radians(2.0 * step)
            glVertex3f(planet.distance * math.cos(angle), 0.0, planet.distance * math.sin(angle))
        glEnd()


def draw_belt() -> None:
    """The asteroids between Mars and Jupiter."""
    chance = np.random.default_rng(2)
    glPointSize(1.5 * max(1.0, glGetIntegerv(GL_VIEWPORT)[3] / 640.0))
    glBegin(GL_POINTS)
    for far, angle, up in chance.normal((8.6, 0.0, 0.0), (0.45, 9.0, 0.15), (2500, 3)):
        glColor3fv(np.array((0.75, 0.65, 0.55)) * chance.uniform(0.25, 0.9))
        glVertex3f(far * math.cos(angle), up, far * math.sin(angle))
    glEnd()


def draw_ring() -> None:
    """Saturn's, in narrow bands from the inside out, with Cassini's gap."""
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
    edges = np.linspace(1.35, 2.5, 25)
    for inner, outer, light in zip(
        edges, edges[1:], 0.75 + 0.25 * fractal(edges[1:, None] * (9, 0), 3), strict=False
    ):
        gap = 2.02 < outer < 2.14
        glColor4f(0.9 * light, 0.8 * light, 0.6 * light, 0.05 if gap else 0.75 * light)
        glBegin(GL_TRIANGLE_STRIP)
        for step in range(91):
            angle = math.radians(4.0 * step)
            for far in (inner, outer):
                glVertex3f(far * math.cos(angle), 0.0, far * math.sin(angle))
        glEnd()
    glDisable(GL_BLEND)


def main() -> None:
    parser = argparse.ArgumentParser(description="The solar system.")
    parser.add_argument("--date", type=float, default=0.0, metavar="DAYS", help=f"since {FIRST_DAY}")
    Planets(parser.parse_args().date).run()


if __name__ == "__main__":
    main()
