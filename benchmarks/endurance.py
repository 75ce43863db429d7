"""Draws an animated scene on the dome for many frames and tells what it holds on to.

    make endurance, or python benchmarks/endurance.py [FRAMES]

Every hundredth part of the way: the frame, the process's resident memory in MiB, and how many GL objects
there are. The first ones build shaders and fill caches; after them nothing may grow.
"""

import os

os.environ["PYOPENGL_PLATFORM"] = "egl"  # before OpenGL is imported

import ctypes
import gc
import math
import sys
from pathlib import Path
from types import SimpleNamespace

import OpenGL.GL
import OpenGL.GLU

from domeshim.intercept.overlay import Overlay
from domeshim.options import Options
from domeshim.session import Session
from domeshim.window.contract import SurfaceFormat, WindowEvents
from domeshim.window.offscreen import OffscreenBackend

SIZE = 64
GL = SimpleNamespace
PAGE = os.sysconf("SC_PAGE_SIZE")


def scene(gl: GL, frame: int) -> None:
    """What programs do every frame, the wasteful things among it."""
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gl.gluPerspective(40 + 10 * math.sin(frame / 10), 1, 0.1, 100)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glLoadIdentity()
    gl.gluLookAt(math.sin(frame / 7), 1, 5, 0, 0, 0, 0, 1, 0)
    gl.glEnable(gl.GL_LIGHTING)
    gl.glEnable(gl.GL_LIGHT0 + frame % 3)
    gl.glLightfv(gl.GL_LIGHT0, gl.GL_POSITION, (math.cos(frame), 1, 1, frame % 2))
    gl.glNewList(1, gl.GL_COMPILE)  # a list built anew each frame, of several parts
    quadric = gl.gluNewQuadric()
    gl.gluSphere(quadric, 1, 8, 6)
    gl.gluDeleteQuadric(quadric)
    gl.glDisable(gl.GL_LIGHTING)
    gl.glBegin(gl.GL_TRIANGLE_STRIP)
    for k in range(60):
        gl.glColor3f(k / 60, 0, 1)
        gl.glVertex3f(math.cos(k), k / 60, math.sin(k))
    gl.glEnd()
    gl.glEndList()
    gl.glCallList(1)
    gl.glBegin(gl.GL_LINES)
    for k in range(40):
        gl.glVertex3f(k - 20, -1, -20)
        gl.glVertex3f(k - 20, -1, 20)
    gl.glEnd()
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glPushMatrix()
    gl.glLoadIdentity()
    gl.gluOrtho2D(0, SIZE, 0, SIZE)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glPushAttrib(gl.GL_ALL_ATTRIB_BITS)
    gl.glLoadIdentity()
    gl.glEnable(gl.GL_SCISSOR_TEST)
    gl.glScissor(frame % 20, 10, 30, 20)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT)
    gl.glWindowPos2i(frame % SIZE, 20)
    gl.glBitmap(8, 8, 0, 0, 9, 0, bytes(range(8)))
    gl.glPopAttrib()
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glPopMatrix()
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glReadPixels(3, 3, 1, 1, gl.GL_DEPTH_COMPONENT, gl.GL_FLOAT)


class Endurance:
    """The scene's window and its frames so far."""

    def __init__(self) -> None:
        self.backend = OffscreenBackend()
        self.stock = GL(**vars(OpenGL.GL))
        self.session = Session(Options(enabled=True), backend=lambda: self.backend)
        self._overlay = Overlay(self.session)
        self._overlay.module_imported("OpenGL.GL", OpenGL.GL)
        self._overlay.module_imported("OpenGL.GLU", OpenGL.GLU)
        glu = {name: value for name, value in vars(OpenGL.GLU).items() if name.startswith("glu")}
        self.shim = GL(**(vars(OpenGL.GL) | glu))
        self.window = self.backend.open_window("", (SIZE, SIZE), None, SurfaceFormat(), WindowEvents())
        self.session.window_opened(self.window, (SIZE, SIZE))
        self.frame = 0

    def close(self) -> None:
        """Put GL's own names back."""
        self._overlay.remove()
        self.session.window_closed(self.window)
        self.backend.close()

    def run(self, frames: int) -> None:
        """Draw so many frames more."""
        for _ in range(frames):
            self.frame += 1
            scene(self.shim, self.frame)
            self.session.swapped(self.window)

    def objects(self) -> int:
        """How many of GL's names are taken: lists, buffers, textures, programs and the like."""
        gl = self.stock
        kinds = (gl.glIsBuffer, gl.glIsTexture, gl.glIsProgram, gl.glIsShader, gl.glIsVertexArray)
        kinds = (*kinds, gl.glIsFramebuffer, gl.glIsRenderbuffer)
        names = sum(bool(is_one(name)) for is_one in kinds for name in range(1, 2000))
        return names + sum(bool(gl.glIsList(name)) for name in (*range(1, 1000), *range(2**30, 2**30 + 1000)))

    @staticmethod
    def memory() -> float:
        """The process's resident memory, MiB, without what is free: how much of that is kept is chance."""
        gc.collect()
        ctypes.CDLL(None).malloc_trim(0)
        return int(Path("/proc/self/statm").read_text().split()[1]) * PAGE / 2**20


def main(frames: int) -> None:
    """Run, and report on the way."""
    endurance = Endurance()
    print(endurance.stock.glGetString(endurance.stock.GL_RENDERER).decode())
    for _ in range(100):
        endurance.run(max(frames // 100, 1))
        print(
            f"frame {endurance.frame:8d}  {endurance.memory():8.1f} MiB  {endurance.objects():5d} objects",
            flush=True,
        )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 100_000)
