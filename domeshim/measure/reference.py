"""An independent dome picture of a program: six runs with stock PyOpenGL and freeglut, put together in numpy.

Needs Xvfb and freeglut, and scipy beside what the package itself needs. It knows of perspectives that a
program sets by gluPerspective and glFrustum, in one viewport; for other programs it has nothing to say.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from domeshim.errors import DomeError, ScreenError
from domeshim.measure.face_program import FACES, MONITOR, UNFINISHED
from domeshim.measure.match import Picture
from domeshim.measure.words import last_words
from domeshim.wording import counted

PACKAGE = Path(__file__).parents[1]


class NoPictureError(DomeError):
    """A program gave no picture with stock PyOpenGL; says why, as far as the program did.

    ended: it came to its end without an error. silent: and said nothing.
    """

    def __init__(self, reason: str, *, ended: bool = False, silent: bool = False) -> None:
        super().__init__(reason)
        self.ended = ended
        self.silent = silent


@dataclass(frozen=True)
class StockPicture:
    """One picture by stock PyOpenGL, and what is known of the run that made it."""

    picture: Picture
    perspectives: int
    """How often the program set a perspective by gluPerspective or glFrustum."""
    viewports: int
    """In how many viewports it did; the dome's reference shows the views of several one above the other."""
    fog: bool
    """Fixed-function fog was on at the picture's end."""
    renderer: str
    version: str


@dataclass(frozen=True)
class StockRuns:
    """Runs a program on an X display, for picture number frame (1 the first), size pixels square."""

    display: str
    program: Path
    arguments: tuple[str, ...] = ()
    frame: int = 1
    size: int = 768
    timeout: float = 60.0

    def monitor(self) -> StockPicture:
        """The program's picture on the monitor.

        Raises NoPictureError.
        """
        return self._run(MONITOR)

    def dome(self, fov: float = 180.0, tilt: float = 0.0) -> Picture:
        """The program's picture on an equidistant dome, angles in degrees; black outside the disc.

        Raises NoPictureError.
        """
        return dome_picture({face: self._run(face).picture for face in FACES}, self.size, fov, tilt)

    def _run(self, face: str) -> StockPicture:
        program = self.program.absolute()
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder) / "picture.npz"
            script = [sys.executable, "-m", "domeshim.measure.face_program"]
            wanted = [face, str(self.frame), str(self.size), str(output), str(program)]
            try:
                ended = subprocess.run(
                    [*script, *wanted, *self.arguments],
                    cwd=program.parent,
                    env=stock_environment(self.display),
                    stdin=subprocess.DEVNULL,
                    capture_output=True,
                    timeout=self.timeout,
                    check=False,
                )
            except subprocess.TimeoutExpired:
                raise NoPictureError(f"no picture within {counted(self.timeout, 'second')}") from None
            if output.exists():
                return _load(output)
        raise _failure(ended)


def _load(path: Path) -> StockPicture:
    with np.load(path) as saved:
        return StockPicture(
            saved["picture"],
            int(saved["perspectives"]),
            int(saved["viewports"]),
            bool(saved["fog"]),
            str(saved["renderer"]),
            str(saved["version"]),
        )


def _failure(ended: subprocess.CompletedProcess[bytes]) -> NoPictureError:
    if ended.returncode not in (0, UNFINISHED):
        return NoPictureError(last_words(ended.stderr, ended.returncode))
    said = ended.stderr + ended.stdout if ended.returncode == 0 else ended.stderr
    return NoPictureError(last_words(said, ended.returncode), ended=True, silent=not said.strip())


def stock_environment(display: str, environ: Mapping[str, str] | None = None) -> dict[str, str]:
    """The variables for a program that draws on this X display: no dome, and this package to be found."""
    environ = os.environ if environ is None else environ
    unwanted = ("PYOPENGL_PLATFORM", "WAYLAND_DISPLAY", "DOME")
    kept = {n: v for n, v in environ.items() if n not in unwanted and not n.startswith("DOME_")}
    paths = [str(PACKAGE.parent), environ.get("PYTHONPATH", "")]
    searched = os.pathsep.join(path for path in paths if path)
    return {**kept, "DISPLAY": display, "PYTHONPATH": searched, "PYTHONHASHSEED": "0"}


@contextmanager
def virtual_display(size: tuple[int, int] = (2048, 2048)) -> Iterator[str]:
    """The name of an X display of its own, of so many pixels, that lasts as long as the with block.

    It takes a number that is free, and no key that is held repeats itself.

    Raises ScreenError where Xvfb is missing or will not start.
    """
    ours, servers = os.pipe()
    screen = ["-screen", "0", "{}x{}x24".format(*size), "-r", "-nolisten", "tcp"]
    # -noreset: else it throws out a program that comes as another one, the only one, goes.
    command = ["Xvfb", "-displayfd", str(servers), *screen, "-noreset"]
    try:
        server = subprocess.Popen(command, pass_fds=[servers], stderr=subprocess.DEVNULL)
    except OSError as error:
        os.close(ours)
        raise ScreenError(f"cannot start Xvfb: {error.strerror}; install Debian's xvfb") from None
    finally:
        os.close(servers)
    try:
        with os.fdopen(ours) as told:
            number = told.readline().strip()
        if not number:
            raise ScreenError("Xvfb ended before it had a display")
        yield f":{number}"
    finally:
        server.terminate()
        server.wait()


def dome_picture(faces: Mapping[str, Picture], size: int, fov: float = 180.0, tilt: float = 0.0) -> Picture:
    """The equidistant picture, size pixels square, of what a cube's square faces show; angles in degrees.

    The disc fills the picture; its centre looks tilt degrees above the front face's middle.
    """
    directions, inside = disc_directions(size, fov, tilt)
    rotations = {face: np.array(rows, float) for face, rows in FACES.items()}
    names = list(FACES)
    # A direction belongs to the face along whose axis it is longest.
    along = np.stack([-(directions @ rotations[name][2]) for name in names])
    nearest = along.argmax(axis=0)
    picture = np.zeros((size, size, 3))
    for number, name in enumerate(names):
        chosen = inside & (nearest == number)
        picture[chosen] = _sampled(faces[name], directions[chosen] @ rotations[name].T)
    return np.rint(picture).astype(np.uint8)


def disc_directions(size: int, fov: float, tilt: float) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Eye space's unit direction of each pixel's middle, (size, size, 3), and whether it lies on the disc."""
    across = (2 * np.arange(size) + 1 - size) / size
    x, y = np.meshgrid(across, -across)
    radius = np.hypot(x, y)
    phi, theta = radius * np.radians(fov / 2), np.arctan2(y, x)
    level = np.stack([np.sin(phi) * np.cos(theta), np.sin(phi) * np.sin(theta), -np.cos(phi)], axis=-1)
    sine, cosine = np.sin(np.radians(tilt)), np.cos(np.radians(tilt))
    raised = np.array([[1, 0, 0], [0, cosine, -sine], [0, sine, cosine]])
    return level @ raised.T, radius <= 1


def _sampled(face: Picture, directions: NDArray[np.float64]) -> NDArray[np.float64]:
    """A face's colours, (n, 3), in directions, (n, 3), of the face's own space, linear between pixels."""
    from scipy import ndimage  # noqa: PLC0415 - needed for measuring alone, and not installed with the package

    height, width = face.shape[:2]
    right, up = (directions[:, axis] / -directions[:, 2] for axis in (0, 1))
    places = np.stack([(1 - up) / 2 * height - 0.5, (1 + right) / 2 * width - 0.5])
    channels = [
        ndimage.map_coordinates(face[..., channel].astype(float), places, order=1, mode="nearest")
        for channel in range(3)
    ]
    return np.stack(channels, axis=-1)
