"""Runs a GLUT program with stock PyOpenGL and freeglut, looking along one face of a cube, for one picture.

    python -m domeshim.measure.face_program FACE FRAME SIZE OUTPUT.npz PROG [ARGS]

The program is unchanged but for this: its window is SIZE pixels square; gluPerspective and glFrustum give 90
degrees along the FACE, and what it draws by glOrtho and gluOrtho2D once it had a perspective is left out;
time goes by pictures, and random numbers start from a seed. FACE "monitor" leaves the projection alone.

Nothing that draws here is domeshim's: this is what the dome's pictures are held against.
"""

from __future__ import annotations

import os
import random
import runpy
import sys
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NoReturn

import numpy as np

MONITOR = "monitor"
FACES: dict[str, tuple[tuple[int, int, int], ...]] = {
    "front": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "right": ((0, 0, 1), (0, 1, 0), (-1, 0, 0)),
    "back": ((-1, 0, 0), (0, 1, 0), (0, 0, -1)),
    "left": ((0, 0, -1), (0, 1, 0), (1, 0, 0)),
    "up": ((1, 0, 0), (0, 0, 1), (0, -1, 0)),
    "down": ((1, 0, 0), (0, 0, -1), (0, 1, 0)),
}
"""The rotation from eye space to each face's own, whose rows are the face's right, up and backward axes."""
FPS = 60.0
EPOCH = 1_700_000_000.0
PATIENCE = 10_000
"""How often a program may read the time within a picture before it is taken to be waiting for it to pass."""
FAR_OUTSIDE = (1e9, 1e9, 2.0)
"""Window coordinates that no picture shows."""
UNFINISHED = 3
"""The exit status of a program that opened a window and ended before the wanted picture."""
CALLBACKS = ("glutReshapeFunc", "glutIdleFunc", "glutVisibilityFunc")


@dataclass
class Run:
    """One run of one program: what is wanted of it, and how far it has come."""

    face: str
    frame: int
    size: int
    output: str
    frames: int = 0
    reads: int = 0
    perspectives: int = 0
    viewports: set[tuple[int, ...]] = field(default_factory=set)
    """Those that were set as a perspective was."""
    windows: int = 0
    displaying: bool = False
    finished: bool = False
    cleared: bool = False
    originals: dict[str, Callable[..., Any]] = field(default_factory=dict)

    def replace(self, module: Any, name: str, replacement: Callable[..., Any]) -> None:
        """Put a function in the place of the module's own, which is kept in originals."""
        self.originals[name] = getattr(module, name)
        setattr(module, name, replacement)

    def seconds(self) -> float:
        """The program's time: it stands still within a picture, unless the program waits for it."""
        self.reads += 1
        return self.frames / FPS + max(0, self.reads - PATIENCE) * 0.001

    def picture_finished(self) -> None:
        """Count a picture; write the wanted one and end the process."""
        self.frames += 1
        self.reads = 0
        self.finished = True
        if self.frames >= self.frame:
            write_picture(self)
            end(0)


def main(arguments: list[str]) -> None:
    """Run the program that the command line names."""
    face, frame, size, output, program, *rest = arguments
    run = Run(face, int(frame), int(size), os.path.abspath(output))
    pin_time_and_chance(run)
    replace_frames(run)
    replace_windows(run)
    if face != MONITOR:
        replace_projections(run)
    path = os.path.abspath(program)
    sys.argv = [program, *rest]
    sys.path[0] = os.path.dirname(path)
    runpy.run_path(path, run_name="__main__")
    if run.windows:
        sys.stderr.write("the program ended before the wanted picture\n")
        end(UNFINISHED)


def end(status: int) -> NoReturn:
    """End the process now: freeglut and the program's threads are not asked."""
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)


def pin_time_and_chance(run: Run) -> None:
    """Let six runs of a program see the same time and draw the same lots."""
    random.seed(0)
    np.random.seed(0)
    setattr(time, "time", lambda: EPOCH + run.seconds())  # noqa: B010 - mypy forbids the plain form
    for name in ("perf_counter", "monotonic"):
        setattr(time, name, run.seconds)
    setattr(time, "sleep", lambda seconds: None)  # noqa: B010, ARG005 - as above


def replace_projections(run: Run) -> None:
    """Put the face's frustum in the place of every perspective, and leave the HUD out."""
    from OpenGL import GL, GLU  # noqa: PLC0415 - first for the program's run alone

    def multiply(rows: np.ndarray[Any, Any]) -> None:
        GL.glMultMatrixd(np.ascontiguousarray(rows.T, np.float64))

    def look_along_face(near: float, far: float) -> None:
        run.perspectives += 1
        multiply(frustum(near, far) @ rotation(run.face))

    def left_out(name: str) -> Callable[..., None]:
        def orthographic(*bounds: float) -> None:
            if run.perspectives:
                multiply(nowhere())
            else:
                run.originals[name](*bounds)

        return orthographic

    def project(*arguments: Any) -> Any:
        try:
            return run.originals["gluProject"](*arguments)
        except ValueError:  # exactly beside this face's viewer, where w is 0
            return FAR_OUTSIDE

    run.replace(GLU, "gluProject", project)
    run.replace(GLU, "gluPerspective", lambda _fovy, _aspect, near, far: look_along_face(near, far))
    run.replace(GL, "glFrustum", lambda *bounds: look_along_face(*bounds[4:]))
    run.replace(GL, "glOrtho", left_out("glOrtho"))
    run.replace(GLU, "gluOrtho2D", left_out("gluOrtho2D"))


def frustum(near: float, far: float) -> np.ndarray[Any, Any]:
    """The matrix of a view 90 degrees wide and high, as glFrustum's manual page has it."""
    depth = near - far
    matrix = np.diag([1.0, 1.0, (far + near) / depth, 0.0])
    matrix[2, 3] = 2 * far * near / depth
    matrix[3, 2] = -1.0
    return matrix


def rotation(face: str) -> np.ndarray[Any, Any]:
    """The rotation to a face's own space, 4 x 4."""
    matrix = np.eye(4)
    matrix[:3, :3] = FACES[face]
    return matrix


def nowhere() -> np.ndarray[Any, Any]:
    """A matrix, invertible as gluUnProject wants it, that takes everything to a place outside of the view."""
    matrix = np.diag([1e-9, 1e-9, 1e-9, 1.0])
    matrix[:3, 3] = 3.0
    return matrix


def replace_windows(run: Run) -> None:
    """Give every window the wanted size, and count windows and perspectives."""
    from OpenGL import GL, GLU, GLUT  # noqa: PLC0415 - as above

    def opened(*arguments: Any) -> Any:
        run.windows += 1
        return run.originals["glutCreateWindow"](*arguments)

    def counted(name: str) -> Callable[..., Any]:
        def perspective(*arguments: Any) -> Any:
            run.perspectives += 1
            run.viewports.add(tuple(map(int, GL.glGetIntegerv(GL.GL_VIEWPORT))))
            return run.originals[name](*arguments)

        return perspective

    run.replace(GLUT, "glutInitWindowSize", lambda *_size: None)
    run.originals["glutInitWindowSize"](run.size, run.size)
    run.replace(GLUT, "glutReshapeWindow", lambda *_size: None)
    run.replace(GLUT, "glutFullScreen", lambda: None)
    run.replace(GLUT, "glutCreateWindow", opened)
    run.replace(GLU, "gluPerspective", counted("gluPerspective"))
    run.replace(GL, "glFrustum", counted("glFrustum"))


def replace_frames(run: Run) -> None:
    """Hear where a picture ends: at the swap, or at a single-buffered program's flush or return."""
    from OpenGL import GL, GLUT  # noqa: PLC0415 - as above

    original = run.originals

    def swap() -> None:
        run.picture_finished()
        original["glutSwapBuffers"]()

    def flush() -> None:
        original["glFlush"]()
        if not run.displaying and single_buffered():
            run.picture_finished()

    def clear(mask: int) -> None:
        run.cleared = True
        original["glClear"](mask)

    def single_buffered() -> bool:
        return bool(run.windows) and not original["glutGet"](GLUT.GLUT_WINDOW_DOUBLEBUFFER)

    def display_function(display: Callable[[], Any]) -> Any:
        def displayed() -> None:
            run.displaying, run.finished, run.cleared = True, False, False
            stopping(display)()
            run.displaying = False
            # A double-buffered window's display that did not even clear leaves drawing to another callback.
            if not run.finished and (run.cleared or single_buffered()):
                run.picture_finished()
            GLUT.glutPostRedisplay()

        return original["glutDisplayFunc"](displayed)

    def elapsed(what: int) -> Any:
        if int(what) == int(GLUT.GLUT_ELAPSED_TIME):
            return int(run.seconds() * 1000)
        return original["glutGet"](what)

    run.replace(GLUT, "glutSwapBuffers", swap)
    run.replace(GL, "glFlush", flush)
    run.replace(GL, "glClear", clear)
    run.replace(GLUT, "glutDisplayFunc", display_function)
    run.replace(GLUT, "glutGet", elapsed)
    for name in CALLBACKS:
        run.replace(GLUT, name, lambda callback, name=name: original[name](callback and stopping(callback)))
    run.replace(
        GLUT,
        "glutTimerFunc",
        lambda wait, call, value: original["glutTimerFunc"](wait, stopping(call), value),
    )


def stopping(callback: Callable[..., Any]) -> Callable[..., Any]:
    """The callback, but an exception in it ends the program; PyOpenGL by itself goes on and draws nothing."""

    def called(*arguments: Any) -> Any:
        try:
            return callback(*arguments)
        except SystemExit:
            sys.stderr.write("the program ended before the wanted picture\n")
            end(UNFINISHED)
        except BaseException:
            traceback.print_exc()
            end(1)

    return called


def write_picture(run: Run) -> None:
    """Write the window's picture, (height, width, 3), the top row first, and what is known of the run."""
    from OpenGL import GL, GLUT  # noqa: PLC0415 - as above

    size = [run.originals["glutGet"](side) for side in (GLUT.GLUT_WINDOW_WIDTH, GLUT.GLUT_WINDOW_HEIGHT)]
    GL.glBindFramebuffer(GL.GL_READ_FRAMEBUFFER, 0)
    double = run.originals["glutGet"](GLUT.GLUT_WINDOW_DOUBLEBUFFER)
    GL.glReadBuffer(GL.GL_BACK if double else GL.GL_FRONT)
    for name in ("ROW_LENGTH", "SKIP_ROWS", "SKIP_PIXELS"):
        GL.glPixelStorei(getattr(GL, f"GL_PACK_{name}"), 0)
    GL.glPixelStorei(GL.GL_PACK_ALIGNMENT, 1)
    pixels = GL.glReadPixels(0, 0, *size, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
    picture = np.frombuffer(pixels, np.uint8).reshape(size[1], size[0], 3)[::-1]
    np.savez(
        run.output,
        picture=picture,
        perspectives=run.perspectives,
        viewports=len(run.viewports),
        fog=bool(GL.glIsEnabled(GL.GL_FOG)),
        renderer=GL.glGetString(GL.GL_RENDERER).decode(),
        version=GL.glGetString(GL.GL_VERSION).decode(),
    )


if __name__ == "__main__":
    main(sys.argv[1:])
