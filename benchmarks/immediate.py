"""What the dome costs the fixed-function ways to draw: each by stock PyOpenGL and on the dome, in turns.

    make bench-immediate, or python benchmarks/immediate.py [FRAMES]

Prints the medians of both in milliseconds and dome over monitor. One process, off screen, one renderer (its
name comes first); display lists are built by whoever draws them.
"""

import os

os.environ["PYOPENGL_PLATFORM"] = "egl"  # before OpenGL is imported

import math
import statistics
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from ctypes import c_ubyte
from types import SimpleNamespace

import OpenGL.GL
import OpenGL.GLU

from domeshim.intercept.dome import Dome
from domeshim.intercept.overlay import Overlay
from domeshim.options import Options
from domeshim.session import Session
from domeshim.window.contract import SurfaceFormat, WindowEvents
from domeshim.window.offscreen import OffscreenBackend

SIZE = 1024
LETTER = (c_ubyte * 8)(0x7E, 0x81, 0xBD, 0xA1, 0xBD, 0x85, 0xFD, 0x01)
GL = SimpleNamespace


def sphere_points(pieces: int) -> list[tuple[float, float, float]]:
    """A grid of (pieces + 1) squared points on the unit sphere."""
    return [
        (
            math.cos(2 * math.pi * i / pieces) * math.sin(math.pi * j / pieces),
            math.cos(math.pi * j / pieces),
            math.sin(2 * math.pi * i / pieces) * math.sin(math.pi * j / pieces),
        )
        for j in range(pieces + 1)
        for i in range(pieces + 1)
    ]


def corners(pieces: int) -> list[tuple[float, float, float]]:
    """The sphere's quads, corner by corner."""
    points = sphere_points(pieces)
    row = pieces + 1
    return [
        points[k]
        for j in range(pieces)
        for i in range(pieces)
        for k in (j * row + i, j * row + i + 1, (j + 1) * row + i + 1, (j + 1) * row + i)
    ]


CORNERS = corners(71)


def vertices(gl: GL) -> None:
    """20,000 vertices in one glBegin..glEnd."""
    vertex = gl.glVertex3f
    gl.glBegin(gl.GL_QUADS)
    for x, y, z in CORNERS:
        vertex(x, y, z)
    gl.glEnd()


def lit_vertices(gl: GL) -> None:
    """The same with a normal each and a colour every fourth."""
    vertex, normal, color = gl.glVertex3f, gl.glNormal3f, gl.glColor3f
    gl.glBegin(gl.GL_QUADS)
    for k, (x, y, z) in enumerate(CORNERS):
        if k % 4 == 0:
            color(1, 1, 0.5)
        normal(x, y, z)
        vertex(x, y, z)
    gl.glEnd()


def small_quad(gl: GL, k: int, width: float = 0.1) -> None:
    """One quad with its colour."""
    gl.glColor3f(1, 0.5, k / 2000)
    gl.glBegin(gl.GL_QUADS)
    gl.glVertex3f(-width, 0, 0)
    gl.glVertex3f(width, 0, 0)
    gl.glVertex3f(width, 0.01, 0)
    gl.glVertex3f(-width, 0.01, 0)
    gl.glEnd()


def small_quads(gl: GL) -> None:
    """2,000 quads in a glBegin..glEnd each."""
    for k in range(2000):
        small_quad(gl, k)


def moved_quads(gl: GL) -> None:
    """1,000 quads, the matrix pushed, moved and popped around each."""
    for k in range(1000):
        gl.glPushMatrix()
        gl.glTranslatef(k / 1000, 0, 0)
        small_quad(gl, k)
        gl.glPopMatrix()


def wide_quads(gl: GL) -> None:
    """1,000 moved quads so wide that they must bend."""
    for k in range(1000):
        gl.glPushMatrix()
        gl.glTranslatef(k / 1000, 0, 0)
        small_quad(gl, k, 0.5)
        gl.glPopMatrix()


def light_switched(gl: GL) -> None:
    """2,000 quads, every second of them lit."""
    for k in range(1000):
        gl.glEnable(gl.GL_LIGHTING)
        small_quad(gl, k)
        gl.glDisable(gl.GL_LIGHTING)
        small_quad(gl, k)


def texture_switched(gl: GL) -> None:
    """2,000 quads, every second of them textured."""
    for k in range(1000):
        gl.glEnable(gl.GL_TEXTURE_2D)
        small_quad(gl, k)
        gl.glDisable(gl.GL_TEXTURE_2D)
        small_quad(gl, k)


def big_list(gl: GL) -> None:
    """A display list of 100,000 triangles."""
    gl.glCallList(1)


def small_lists(gl: GL) -> None:
    """2,000 calls of a list of 12 triangles."""
    for _ in range(2000):
        gl.glCallList(2)


def letters(gl: GL) -> None:
    """1,000 letters in lines of 40, in the window's pixels."""
    with flat(gl):
        for k in range(1000):
            if k % 40 == 0:
                gl.glRasterPos2i(10, 20 + k // 2)
            gl.glBitmap(8, 8, 0, 0, 9, 0, LETTER)


def font(gl: GL) -> None:
    """The same by a display list for each letter."""
    with flat(gl):
        for k in range(25):
            gl.glRasterPos2i(10, 20 + 20 * k)
            gl.glCallLists(bytes([3] * 40))


@contextmanager
def flat(gl: GL) -> Iterator[None]:
    """Within it the window's pixels are the units, over a scene in perspective."""
    small_quad(gl, 0)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glPushMatrix()
    gl.glLoadIdentity()
    gl.glOrtho(0, SIZE, 0, SIZE, -1, 1)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glPushMatrix()
    gl.glLoadIdentity()
    yield
    gl.glPopMatrix()
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glPopMatrix()
    gl.glMatrixMode(gl.GL_MODELVIEW)


SCENES = (
    vertices,
    lit_vertices,
    small_quads,
    moved_quads,
    wide_quads,
    light_switched,
    texture_switched,
    big_list,
    small_lists,
    letters,
    font,
)


class Pair:
    """Stock GL and the dome, each in a window of its own."""

    def __init__(self) -> None:
        self.backend = OffscreenBackend()
        self.stock = GL(**vars(OpenGL.GL), gluPerspective=OpenGL.GLU.gluPerspective)
        self.session = Session(Options(enabled=True), backend=lambda: self.backend)
        overlay = Overlay(self.session)
        overlay.module_imported("OpenGL.GL", OpenGL.GL)
        overlay.module_imported("OpenGL.GLU", OpenGL.GLU)
        self.shim = GL(**vars(OpenGL.GL), gluPerspective=OpenGL.GLU.gluPerspective)
        self.windows = [
            self.backend.open_window("", (SIZE, SIZE), None, SurfaceFormat(), WindowEvents())
            for _ in range(2)
        ]
        self.windows[0].make_current()
        prepare(self.stock)
        self.windows[1].make_current()
        self.session.window_opened(self.windows[1], (SIZE, SIZE))
        prepare(self.shim)

    def frame(self, scene: Callable[[GL], None], *, dome: bool) -> float:
        """Seconds for one picture, finished."""
        self.windows[dome].make_current()
        gl = self.shim if dome else self.stock
        begun = time.perf_counter()
        gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
        scene(gl)
        if dome:
            assert isinstance(self.session.dome, Dome)
            self.session.dome.frame_ending(self.windows[1])
        self.stock.glReadPixels(0, 0, 1, 1, gl.GL_RGB, gl.GL_UNSIGNED_BYTE)
        return time.perf_counter() - begun


def prepare(gl: GL) -> None:
    """The perspective, a light, a texture, and the display lists."""
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.gluPerspective(45, 1, 0.1, 100)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glEnable(gl.GL_LIGHT0)
    gl.glTranslatef(0, 0, -5)
    gl.glTexImage2D(gl.GL_TEXTURE_2D, 0, gl.GL_RGB, 1, 1, 0, gl.GL_RGB, gl.GL_UNSIGNED_BYTE, bytes(4))
    gl.glTexParameteri(gl.GL_TEXTURE_2D, gl.GL_TEXTURE_MIN_FILTER, gl.GL_NEAREST)
    gl.glNewList(1, gl.GL_COMPILE)
    for _ in range(10):
        lit_vertices(gl)
    gl.glEndList()
    gl.glNewList(2, gl.GL_COMPILE)
    gl.glBegin(gl.GL_TRIANGLES)
    for k in range(12):
        gl.glVertex3f(0, 0, 0)
        gl.glVertex3f(0.1, 0, 0)
        gl.glVertex3f(0, 0.1, k / 100)
    gl.glEnd()
    gl.glEndList()
    gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
    gl.glNewList(3, gl.GL_COMPILE)
    gl.glBitmap(8, 8, 0, 0, 9, 0, LETTER)
    gl.glEndList()


def main(frames: int) -> None:
    """Draw each scene in turns and print a line for it."""
    pair = Pair()
    print(pair.stock.glGetString(pair.stock.GL_RENDERER).decode())
    for scene in SCENES:
        times: tuple[list[float], list[float]] = ([], [])
        for k in range(frames + 2):
            for dome in (False, True):
                seconds = pair.frame(scene, dome=dome)
                if k >= 2:  # the first ones build shaders
                    times[dome].append(seconds)
        monitor, ours = (1000 * statistics.median(t) for t in times)
        print(
            f"{scene.__name__:18s} monitor {monitor:7.1f} ms  dome {ours:7.1f} ms  ratio {ours / monitor:.2f}"
        )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 15)
