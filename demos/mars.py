"""A panorama around the eye, on a cylinder of 50 x 50 quads: a landscape on Mars, or any picture.

    python mars.py [PICTURE]

PICTURE goes 360 degrees around, with as many pixels a degree up as across; 2:1 shows everything. Without one
the demo makes a landscape of its own: ridges, craters, stones, a low Sun in the dust. That takes some
seconds, once; the picture is kept in the user's cache folder.

Keys: + and - or the mouse wheel step nearer and back, t turns the eye slowly, q shows the quads; drag or
arrows to look around; h shows all of them; ESC quits.
"""

import argparse
import math
import os
import sys
from itertools import pairwise
from pathlib import Path

import numpy as np
from masonry import compiled
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
from paint import between, bytes_of, fractal, kept, texture
from PIL import Image
from stage import Stage

QUADS = 50
"""Around the cylinder and up it."""
RADIUS = 10.0
HIGHEST = math.radians(82.0)
"""How far up and down the cylinder reaches, seen from its middle; two lids close it."""
MADE = "mars-2.png"
"""The name under which the landscape is kept; another number for another landscape."""
SIZE = (3072, 1536)
SUN = (math.radians(31.0), math.radians(17.0))
"""To the right of straight ahead, and above the horizon."""
EYE = 2.6
"""Metres above the ground."""
RINGS = np.r_[np.geomspace(0.35, 300.0, 1150)[:-1], np.geomspace(300.0, 60_000.0, 500)].astype(np.float32)
"""Metres from the eye to the rings around it."""
GREAT_CRATER = (70.0, 330.0, 350.0)
"""Its middle, to the right and ahead, and its radius, metres: the eye stands on its rim."""
HAZE = 15_000.0
"""Metres in which the dust hides all but a third."""


def landscape() -> np.ndarray:
    """The panorama, (rows, columns, 3) of 0 to 1, the zenith first, straight ahead in the middle.

    The ground is worked out on rings around the eye, as many points to a ring as the picture has columns.
    Where a ring rises above all nearer ones it is seen, and the picture's row lies between two rings.
    """
    width, tall = SIZE
    angles = ((np.arange(width) + 0.5) / width * 2 * math.pi - math.pi).astype(np.float32)
    up = (math.pi / 2 - (np.arange(tall) + 0.5) / tall * math.pi).astype(np.float32)
    picture = sky(*np.meshgrid(angles, up))
    x, y = RINGS[:, None] * np.sin(angles), RINGS[:, None] * np.cos(angles)
    ground = height(x, y)
    colours = ground_colours(ground, x, y, picture[tall // 2 - tall // 90])
    level = ground[0].mean() + EYE
    rising = np.maximum.accumulate(np.arctan2(ground - level, RINGS[:, None]), axis=0)
    seen = np.stack([np.searchsorted(column, up) for column in rising.T], -1)
    rows, columns = np.nonzero(seen < len(RINGS))
    farther = seen[rows, columns]
    nearer = np.maximum(farther - 1, 0)
    low, high = rising[nearer, columns], rising[farther, columns]
    share = np.clip((up[rows] - low) / np.maximum(high - low, 1e-9), 0.0, 1.0)[:, None]
    picture[rows, columns] = (1.0 - share) * colours[nearer, columns] + share * colours[farther, columns]
    return picture


def height(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """The ground's height, metres, at places (rings, columns): mountains, dunes, craters, stones, ripples."""
    at = np.stack([x, y], -1)
    total = 8.0 * np.clip(RINGS / 150.0, 0.02, 1.0)[:, None] * fractal(at / 230.0, 4, 23, ridged=True)
    total += 0.25 * fractal(at / 5.0, 3, 31)
    far = RINGS > 1500.0
    ridges = np.clip(0.5 + 0.6 * fractal(at[far] / 8000.0 + 3.1, 7, 12, ridged=True), 0.0, 1.2)
    total[far] += 2600.0 * np.clip((RINGS[far] - 1500.0) / 9000.0, 0.0, 1.0)[:, None] * ridges**1.8
    near = RINGS < 50.0
    waves = np.sin(at[near] @ np.array((5.0, 2.0), np.float32) + 3.0 * fractal(at[near] / 2.5, 2, 81))
    total[near] += 0.02 * waves * np.clip(1.3 - RINGS[near] / 40.0, 0.0, 1.0)[:, None]
    chance = np.random.default_rng(5)
    add_crater(total, x, y, GREAT_CRATER)
    for _ in range(30):
        away, angle = 60.0 * 1.25 ** chance.uniform(0, 22), chance.uniform(0.5, 2 * math.pi - 0.5)
        add_crater(
            total, x, y, (away * math.sin(angle), away * math.cos(angle), away * chance.uniform(0.1, 0.3))
        )
    for cell, share, seed in ((7.0, 0.22, 71), (2.3, 0.35, 72), (0.9, 0.45, 73), (0.35, 0.5, 74)):
        near = RINGS / cell < 120.0
        total[near] += stones(x[near], y[near], cell, share, seed)
    return total


def add_crater(total: np.ndarray, x: np.ndarray, y: np.ndarray, crater: tuple) -> None:
    """Dig a bowl with a raised rim: (east, north, radius), metres."""
    east, north, size = crater
    there = np.hypot(x - east, y - north) < 2.0 * size
    x, y = x[there] - east, y[there] - north
    r = np.hypot(x, y) / size * (1.0 + 0.05 * fractal(np.stack([x, y], -1) / size * 3.0, 3, 51))
    bowl = np.where(r < 1.0, r * r - 1.0, 0.0) * 0.25 + 0.09 * np.exp(-(((r - 1.0) / 0.3) ** 2))
    total[there] += size * bowl


def stones(x: np.ndarray, y: np.ndarray, cell: float, share: float, seed: int) -> np.ndarray:
    """How much stones add, metres: one to a cell of a grid at most, in a share of the cells."""
    chance = np.random.default_rng(seed).uniform(size=(64, 64, 4)).astype(np.float32)
    column, row = np.floor(x / cell), np.floor(y / cell)
    there, size, east, north = np.moveaxis(chance[column.astype(int) % 64, row.astype(int) % 64], -1, 0)
    radius = 0.08 + 0.3 * size**4
    off_x = (x / cell - column - radius - (1.0 - 2.0 * radius) * east) / radius
    off_y = (y / cell - row - radius - (1.0 - 2.0 * radius) * north) / radius
    total = np.zeros_like(x)
    at = np.nonzero((there < share) & (off_x**2 + off_y**2 < 1.4) & (np.hypot(x, y) > 1.2))
    off = np.stack([off_x[at], off_y[at]], -1)
    rough = 0.35 * fractal(off * 1.7 + 9.0 * column[at][:, None], 2, seed)
    total[at] = cell * radius[at] * 0.95 * np.clip(1.0 - (off**2).sum(-1) - rough, 0.0, 1.0) ** 0.42
    return total


def ground_colours(ground: np.ndarray, x: np.ndarray, y: np.ndarray, horizon: np.ndarray) -> np.ndarray:
    """What the ground looks like on the rings, (rings, columns, 3): sand in the Sun, in shadow, in dust."""
    away = RINGS[:, None]
    outwards = np.gradient(ground, axis=0) / np.gradient(RINGS)[:, None]
    around = (np.roll(ground, -1, 1) - np.roll(ground, 1, 1)) * SIZE[0] / (4 * math.pi * away)
    slope_x, slope_y = outwards * x / away + around * y / away, outwards * y / away - around * x / away
    steep = np.sqrt(1.0 + slope_x**2 + slope_y**2)
    east, north, up = (
        math.cos(SUN[1]) * math.sin(SUN[0]),
        math.cos(SUN[1]) * math.cos(SUN[0]),
        math.sin(SUN[1]),
    )
    light = np.clip(2.1 * (up - slope_x * east - slope_y * north) / steep, 0.0, 1.4)
    for step in np.geomspace(0.06, 8.0, 12):
        reach = step * np.maximum(1.0, away / 25.0)  # towards the Sun, where something may stand in its light
        x_there, y_there = x + reach * east, y + reach * north
        ring = np.interp(np.hypot(x_there, y_there), RINGS, np.arange(len(RINGS)))
        column = (np.arctan2(x_there, y_there) / (2 * math.pi) + 0.5) * SIZE[0]
        risen = ground[ring.astype(int), column.astype(int) % SIZE[0]] - ground - reach * up
        light *= 1.0 - np.clip(risen / (0.15 * reach) + 0.5, 0.0, 1.0)
    at = np.stack([x, y], -1)
    afar = np.clip(away / 400.0, 0.0, 1.0)
    patches = (1.0 - afar) * fractal(at / 6.0, 4, 61) + afar * fractal(at / 900.0, 4, 62)
    sand = between(0.5 + 0.7 * patches, ((0.44, 0.24, 0.16), (0.66, 0.39, 0.26), (0.80, 0.55, 0.40)))
    sand *= (0.72 + 0.28 / steep)[..., None]
    lit = sand * ((0.4 + 0.6 / steep)[..., None] * (0.46, 0.42, 0.44) + light[..., None] * (0.74, 0.65, 0.54))
    dust = 1.0 - np.exp(-away / HAZE)[..., None]
    return lit * (1.0 - dust) + horizon * dust


def sky(angles: np.ndarray, up: np.ndarray) -> np.ndarray:
    """The dusty sky in directions: butter-coloured, and blue around the Sun as it is on Mars."""
    east, lift = SUN
    along = np.sin(up) * math.sin(lift) + np.cos(up) * math.cos(lift) * np.cos(angles - east)
    off = np.degrees(np.arccos(np.clip(along, -1.0, 1.0)))[..., None]
    high = np.clip(np.sin(up), 0.0, 1.0) ** 0.6
    colours = between(high, ((0.90, 0.72, 0.54), (0.80, 0.59, 0.42), (0.62, 0.43, 0.31), (0.46, 0.31, 0.24)))
    veil = np.stack([np.cos(up) * np.sin(angles) * 2, np.cos(up) * np.cos(angles) * 2, np.sin(up) * 9], -1)
    colours = colours * (1.0 + 0.10 * fractal(veil, 5, 91)[..., None])
    for colour, width, weight in (
        ((0.95, 0.82, 0.66), 45.0, 0.55), ((0.72, 0.80, 0.92), 13.0, 0.75), ((1.0, 1.0, 1.0), 2.2, 1.0),
    ):  # fmt: skip
        shine = weight * np.exp(-((off / width) ** 1.5))
        colours = colours * (1.0 - shine) + np.array(colour) * shine
    return colours


def made_landscape() -> Image.Image:
    """The demo's own landscape, from the cache folder or made and put there."""
    file = kept(MADE)
    if file.exists():
        return Image.open(file)
    print("Making a landscape on Mars ...", flush=True)
    picture = Image.fromarray(bytes_of(landscape()))
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        unfinished = file.with_name(f"{os.getpid()}.png")
        picture.save(unfinished)
        unfinished.replace(file)
    except OSError as error:
        print(f"It cannot be kept in {file.parent}: {error.strerror}", file=sys.stderr)
    return picture


class Panorama(Stage):
    """The cylinder around the eye, and how far the eye has stepped towards what it looks at."""

    title = "Panorama"
    fovy, near, far = 70.0, 0.1, 200.0

    def __init__(self, picture: Image.Image) -> None:
        super().__init__()
        self.picture = picture
        self.nearer = 0.0  # to the cylinder, 0 to 0.8 of its radius
        self.turning = self.quads = False
        self.before = 0.0
        self.keys = {
            "+": ("a step nearer", lambda: self.wheel(True)),
            "-": ("a step back", lambda: self.wheel(False)),
            "t": ("turn slowly", lambda: setattr(self, "turning", not self.turning)),
            "q": ("show the quads", lambda: setattr(self, "quads", not self.quads)),
            **self.keys,
        }

    def set_up(self) -> None:
        largest = glGetIntegerv(GL_MAX_TEXTURE_SIZE)
        self.picture.thumbnail((largest, largest))
        picture = np.asarray(self.picture.convert("RGB"))[::-1]
        glClearColor(*picture[-1].mean(0) / 255.0, 1.0)
        texture(picture)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE)
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE)
        half = math.pi * picture.shape[0] / picture.shape[1]  # how far up it reaches
        self.cylinder = compiled(lambda: draw_cylinder(half))

    def draw(self) -> None:
        if self.turning:
            self.yaw += 6.0 * (self.seconds - self.before)
        self.before = self.seconds
        glTranslatef(0.0, 0.0, self.nearer * RADIUS)
        self.look()
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE if self.quads else GL_FILL)
        (glDisable if self.quads else glEnable)(GL_TEXTURE_2D)
        glCallList(self.cylinder)
        glDisable(GL_TEXTURE_2D)
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL)

    def wheel(self, up: bool) -> None:
        self.nearer = max(0.0, min(0.8, self.nearer + (0.05 if up else -0.05)))


def draw_cylinder(half: float) -> None:
    """The quads, even in angle as seen from the middle; half: how far up the picture reaches, radians.

    A picture that reaches beyond the cylinder closes it with two lids.
    """
    top = min(half, HIGHEST)
    ups = np.linspace(-top, top, QUADS + 1)
    for low, high in pairwise(ups):
        glBegin(GL_QUAD_STRIP)
        for column in range(QUADS + 1):
            put(column, low, half)
            put(column, high, half)
        glEnd()
    if half <= HIGHEST:
        return
    for up in (-top, top):
        glBegin(GL_TRIANGLES)
        for column in range(QUADS):
            put(column, up, half)
            put(column + 1, up, half)
            glTexCoord2f((column + 0.5) / QUADS, 0.0 if up < 0 else 1.0)
            glVertex3f(0.0, RADIUS * math.tan(up), 0.0)
        glEnd()


def put(column: int, up: float, half: float) -> None:
    """A corner of a quad, with its place in the picture."""
    angle = 2.0 * math.pi * column / QUADS - math.pi
    glTexCoord2f(column / QUADS, 0.5 + 0.5 * up / half)
    glVertex3f(RADIUS * math.sin(angle), RADIUS * math.tan(up), -RADIUS * math.cos(angle))


def main() -> None:
    parser = argparse.ArgumentParser(description="A panorama on a cylinder around the eye.")
    parser.add_argument("picture", nargs="?", type=Path, help="any picture of 360 degrees; without one, Mars")
    given = parser.parse_args().picture
    try:
        picture = Image.open(given) if given else made_landscape()
        picture.load()
    except OSError as error:
        parser.error(f"cannot read {given}: {error.strerror or error}")
    Panorama(picture).run()


if __name__ == "__main__":
    main()
