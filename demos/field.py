"""Vector fields from the inside: ten thousand arrows, streamlines, and a box around them.

    python field.py [lorenz|pendulum|hopf|abc|vanderpol] [--without arrows,lines,box,text]

Each streamline is integrated by scipy: by an explicit method of order 8, or, for van der Pol's stiff equation
with mu = 1000, by the implicit Radau method. Steps, calls of the field, and error stand on the screen.

Keys: 1 to 5 choose a field, a arrows, s streamlines, b box, w and x or the mouse wheel move the eye forward
and back, c puts it back; drag to look around; h shows all of them; ESC quits.
"""

import argparse
import math
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from itertools import product

import numpy as np
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *
from paint import between
from stage import Stage

try:
    from scipy.integrate import solve_ivp
except ImportError:
    sys.exit("field.py integrates with scipy: pip install scipy")

ARROWS = (25, 20, 20)
"""Along x, y and z: 10,000."""
LINES, STIFF_LINES = 30, 12
MU = 1000.0
TOLERANCE = 1e-6
"""Of the integration, relative; the error is taken against a run a hundred times finer."""
COLOURS = ((0.16, 0.10, 0.42), (0.12, 0.36, 0.72), (0.10, 0.66, 0.62), (0.62, 0.84, 0.28), (1.0, 0.88, 0.25))
"""From slow to fast."""
SHOWN = ("arrows", "lines", "box", "text")
EYE = (0.13, -0.16, 0.83)
ROOM = 0.2

Vectors = np.ndarray


@dataclass(frozen=True)
class Field:
    """A vector field, vectors of (3, n), in a box, and the time for which its streamlines run."""

    title: str
    flow: Callable[[Vectors], Vectors]
    low: tuple
    high: tuple
    duration: float
    slopes: Callable[[Vectors], Vectors] | None = None
    """The flow's derivatives; given for a stiff field, which is integrated implicitly."""


def lorenz(p: Vectors) -> Vectors:
    x, y, z = p
    return np.stack([10.0 * (y - x), x * (28.0 - z) - y, x * y - 8.0 / 3.0 * z])


def pendulum(p: Vectors) -> Vectors:
    """Angle and speed of a pendulum in the plane, time upwards: damped a little, and pushed."""
    angle, speed, when = p
    return np.stack([speed, -np.sin(angle) - 0.15 * speed + 0.5 * np.cos(when), np.ones_like(when)])


def hopf(p: Vectors) -> Vectors:
    """Hopf's: every line is a circle, and every two of them are linked."""
    x, y, z = p
    return np.stack([2.0 * (x * z - y), 2.0 * (y * z + x), 1.0 + z * z - x * x - y * y])


def abc(p: Vectors) -> Vectors:
    """Arnold, Beltrami and Childress: a steady flow with chaos in it."""
    x, y, z = p
    return np.stack(
        [np.sin(z) + 0.6 * np.cos(y), 0.8 * np.sin(x) + np.cos(z), 0.6 * np.sin(y) + 0.8 * np.cos(x)]
    )


def vanderpol(p: Vectors) -> Vectors:
    """Lienard's form, time in units of mu, growing upwards: slow along x = y + x^3 / 3, then a jump."""
    x, y, when = p
    return np.stack([MU * MU * (x - x**3 / 3.0 - y), x, np.ones_like(when)])


def vanderpol_slopes(p: Vectors) -> Vectors:
    """The flow's derivatives at one place, (3, 3): what an implicit method solves with."""
    return np.array([[MU * MU * (1.0 - p[0] ** 2), -MU * MU, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])


FIELDS = {
    "lorenz": Field("Lorenz", lorenz, (-24.0, -30.0, 0.0), (24.0, 30.0, 52.0), 4.0),
    "pendulum": Field("A pushed pendulum", pendulum, (-4.0, -3.0, 0.0), (4.0, 3.0, 14.0), 14.0),
    "hopf": Field("Hopf's circles", hopf, (-2.0, -2.0, -2.0), (2.0, 2.0, 2.0), math.pi),
    "abc": Field("Arnold, Beltrami, Childress", abc, (-math.pi,) * 3, (math.pi,) * 3, 9.0),
    "vanderpol": Field(
        "van der Pol, mu = 1000", vanderpol, (-2.6, -1.2, 0.0), (2.6, 1.2, 4.0), 4.0, vanderpol_slopes
    ),
}


class Seen:
    """A field as it is drawn: all in the box from -1 to 1, with what the integration took."""

    def __init__(self, field: Field) -> None:
        self.field = field
        self.low, self.high = np.array(field.low), np.array(field.high)
        self.steps = self.evaluations = 0
        self.error = 0.0
        before = time.perf_counter()
        self.lines = [self.streamline(start) for start in self.starts()]
        self.took = time.perf_counter() - before
        self.arrows, self.normals, self.arrow_colours = self.arrow_mesh()

    def in_box(self, places: Vectors) -> Vectors:
        """(n, 3), from the field's own units."""
        return 2.0 * (places - self.low) / (self.high - self.low) - 1.0

    def flow_in_box(self, places: Vectors) -> Vectors:
        """The field at places of the box, (n, 3)."""
        own = (places + 1.0) / 2.0 * (self.high - self.low) + self.low
        return 2.0 * self.field.flow(own.T).T / (self.high - self.low)

    def starts(self) -> Vectors:
        """Where the streamlines begin, (lines, 3): on the floor where time goes up, else anywhere."""
        chance = np.random.default_rng(12)
        count = STIFF_LINES if self.field.slopes else LINES
        starts = chance.uniform(self.low, self.high, (count, 3)) * 0.9 + 0.05 * (self.low + self.high)
        if self.field.flow in (pendulum, vanderpol):
            starts[:, 2] = self.low[2]
        return starts

    def streamline(self, start: Vectors) -> tuple[Vectors, Vectors]:
        """Places (n, 3) in the box and colours (n, 3) of one; counts its steps, keeps the largest error."""
        reach = 0.51 * (self.high - self.low)

        def leaving(_: float, p: Vectors) -> float:
            return float(np.min(reach - np.abs(p - (self.low + self.high) / 2.0)))

        leaving.terminal = True
        run = self.integrate(start, (0.0, self.field.duration), TOLERANCE, leaving)
        fine = self.integrate(start, (0.0, run.t[-1]), TOLERANCE / 100.0)
        self.steps += len(run.t) - 1
        self.evaluations += run.nfev
        self.error = max(
            self.error, float(np.abs(self.in_box(run.y[:, -1]) - self.in_box(fine.y[:, -1])).max())
        )
        # The steps themselves, and places between them where they are long.
        times = np.union1d(run.t, np.linspace(0.0, run.t[-1], 400))
        places = self.in_box(run.sol(times).T)
        return places.astype("f"), self.colours(self.flow_in_box(places))

    def integrate(self, start: Vectors, span: tuple, tolerance: float, *events: Callable):
        """The streamline from a start on, by the method that the field asks for."""
        flow, slopes = self.field.flow, self.field.slopes
        how = {"method": "Radau", "jac": lambda _, p: slopes(p)} if slopes else {"method": "DOP853"}
        return solve_ivp(lambda _, p: flow(p), span, start, **how, rtol=tolerance, atol=1e-3 * tolerance,
                         events=events or None, dense_output=True)  # fmt: skip

    def colours(self, flow: Vectors) -> Vectors:
        """By speed, on a logarithmic scale, dark to light."""
        speed = np.log(np.linalg.norm(flow, axis=-1) + 1e-9)
        low, high = np.percentile(speed, (4, 96))
        return between((speed - low) / max(high - low, 1e-9), COLOURS)

    def arrow_mesh(self) -> tuple[Vectors, Vectors, Vectors]:
        """Slim darts of four sides, triangles as rows of (3,): places, normals, colours."""
        lattice = np.array(list(product(*((np.arange(n) + 0.5) / n * 2 - 1 for n in ARROWS))))
        lattice += np.random.default_rng(3).uniform(-0.025, 0.025, lattice.shape)
        off = lattice - EYE  # the eye begins with some room around it
        lattice = EYE + off * np.maximum(1.0, ROOM / np.linalg.norm(off, axis=1))[:, None]
        flow = self.flow_in_box(lattice)
        along = flow / (np.linalg.norm(flow, axis=1)[:, None] + 1e-12)
        side = np.cross(along, np.where(np.abs(along[:, :1]) < 0.8, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)))
        side /= np.linalg.norm(side, axis=1)[:, None]
        other = np.cross(along, side)
        tip = lattice + 0.030 * along
        corners = [lattice - 0.020 * along + 0.0050 * d for d in (side, other, -side, -other)]
        places, normals = [], []
        for one, two in zip(corners, corners[1:] + corners[:1], strict=True):
            places += [tip, one, two]
            normal = np.cross(one - tip, two - tip)
            normals += 3 * [normal / np.linalg.norm(normal, axis=1)[:, None]]
        colours = np.repeat(self.colours(flow), len(places), axis=0)
        return (*(np.stack(rows, 1).reshape(-1, 3).astype("f") for rows in (places, normals)), colours)


class Fields(Stage):
    """The box, the arrows and streamlines of one field after another, with the eye among them."""

    title = "Vector field"
    fovy, near, far = 70.0, 0.01, 20.0

    def __init__(self, name: str, without: list[str]) -> None:
        super().__init__()
        self.name = name
        self.shown = {part: part not in without for part in SHOWN}
        self.eye = np.array(EYE)
        self.keys = {
            str(number): (FIELDS[name].title, lambda name=name: self.choose(name))
            for number, name in enumerate(FIELDS, 1)
        } | {
            "a": ("arrows", lambda: self.toggle("arrows")),
            "s": ("streamlines", lambda: self.toggle("lines")),
            "b": ("box", lambda: self.toggle("box")),
            "t": ("text", lambda: self.toggle("text")),
            "w": ("forward", lambda: self.move(0.04)),
            "x": ("back", lambda: self.move(-0.04)),
            "c": ("back to the beginning", lambda: setattr(self, "eye", np.array(EYE))),
        } | self.keys  # fmt: skip

    def set_up(self) -> None:
        glClearColor(0.015, 0.02, 0.045, 1.0)
        glEnable(GL_DEPTH_TEST)
        glEnable(GL_LIGHT0)
        glEnable(GL_COLOR_MATERIAL)
        glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (0.45, 0.45, 0.5, 1.0))
        glLightfv(GL_LIGHT0, GL_DIFFUSE, (0.8, 0.8, 0.75, 1.0))
        self.buffers = glGenBuffers(4)
        self.choose(self.name)

    def choose(self, name: str) -> None:
        """Integrate a field and send it to the card."""
        self.seen = seen = Seen(FIELDS[name])
        places = np.concatenate([line for line, _ in seen.lines])
        colours = np.concatenate([colour for _, colour in seen.lines])
        for buffer, rows in zip(
            self.buffers,
            (np.hstack([seen.arrows, seen.normals]), seen.arrow_colours, places, colours),
            strict=True,
        ):
            data = np.ascontiguousarray(rows, "f")
            glBindBuffer(GL_ARRAY_BUFFER, buffer)
            glBufferData(GL_ARRAY_BUFFER, data.nbytes, data, GL_STATIC_DRAW)
        glBindBuffer(GL_ARRAY_BUFFER, 0)

    def draw(self) -> None:
        self.look()
        glTranslatef(*-self.eye)
        glLightfv(GL_LIGHT0, GL_POSITION, (0.4, 1.0, 0.6, 0.0))
        if self.shown["box"]:
            draw_box(max(1.5, self.height / 320.0))
        glEnableClientState(GL_VERTEX_ARRAY)
        glEnableClientState(GL_COLOR_ARRAY)
        if self.shown["arrows"]:
            self.draw_arrows()
        if self.shown["lines"]:
            self.draw_lines()
        glBindBuffer(GL_ARRAY_BUFFER, 0)
        glDisableClientState(GL_COLOR_ARRAY)
        glDisableClientState(GL_VERTEX_ARRAY)

    def draw_arrows(self) -> None:
        glEnable(GL_LIGHTING)
        glEnableClientState(GL_NORMAL_ARRAY)
        glBindBuffer(GL_ARRAY_BUFFER, self.buffers[0])
        glVertexPointer(3, GL_FLOAT, 24, None)
        glNormalPointer(GL_FLOAT, 24, GLvoidp(12))
        glBindBuffer(GL_ARRAY_BUFFER, self.buffers[1])
        glColorPointer(3, GL_FLOAT, 0, None)
        glDrawArrays(GL_TRIANGLES, 0, len(self.seen.arrows))
        glDisableClientState(GL_NORMAL_ARRAY)
        glDisable(GL_LIGHTING)

    def draw_lines(self) -> None:
        glLineWidth(max(2.0, self.height / 256.0))
        glBindBuffer(GL_ARRAY_BUFFER, self.buffers[2])
        glVertexPointer(3, GL_FLOAT, 0, None)
        glBindBuffer(GL_ARRAY_BUFFER, self.buffers[3])
        glColorPointer(3, GL_FLOAT, 0, None)
        first = 0
        for line, _ in self.seen.lines:
            glDrawArrays(GL_LINE_STRIP, first, len(line))
            first += len(line)

    def write_over(self) -> None:
        if self.shown["text"]:
            super().write_over()

    def status(self) -> list[str]:
        seen = self.seen
        method = "Radau (implicit)" if seen.field.slopes else "DOP853 (explicit)"
        return [
            f"{seen.field.title}: {len(seen.arrows) // 12} arrows, {len(seen.lines)} streamlines",
            f"{method}: {seen.steps} steps, {seen.evaluations} calls, error {seen.error:.0e}",
            *super().status(),
        ]

    def toggle(self, part: str) -> None:
        self.shown[part] = not self.shown[part]

    def wheel(self, up: bool) -> None:
        self.move(0.04 if up else -0.04)

    def move(self, forward: float) -> None:
        yaw, pitch = math.radians(self.yaw), math.radians(self.pitch)
        ahead = math.sin(yaw) * math.cos(pitch), math.sin(pitch), -math.cos(yaw) * math.cos(pitch)
        self.eye = np.clip(self.eye + forward * np.array(ahead), -3.0, 3.0)


def draw_box(width: float) -> None:
    """The box: twelve lines, each from corner to corner."""
    glLineWidth(width)
    glColor3f(0.95, 0.97, 1.0)
    glBegin(GL_LINES)
    for one, two in product(product((-1.0, 1.0), repeat=3), repeat=2):
        if one < two and sum(a != b for a, b in zip(one, two, strict=True)) == 1:
            glVertex3f(*one)
            glVertex3f(*two)
    glEnd()


def main() -> None:
    parser = argparse.ArgumentParser(description="Vector fields from the inside.")
    parser.add_argument("field", nargs="?", choices=FIELDS, default="lorenz")
    parser.add_argument("--without", default="", metavar="PARTS", help=f"of {','.join(SHOWN)}")
    given = parser.parse_args()
    without = [part for part in given.without.split(",") if part]
    if wrong := set(without) - set(SHOWN):
        parser.error(f"--without={given.without}: {', '.join(sorted(wrong))} is none of {', '.join(SHOWN)}")
    Fields(given.field, without).run()


if __name__ == "__main__":
    main()
