"""A scene drawn twice, by stock GL and through the dome, under a lens so narrow that both must be equal.

Over one degree an equidistant disc and a perspective differ by less than the rasteriser's own grid, so what
is compared is everything but the geometry: colours, textures, fog, clipping, the order of things.
"""

from __future__ import annotations

import types
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import OpenGL.GL
import OpenGL.GLU
from numpy.typing import NDArray
from OpenGL.platform import PLATFORM
from PIL import Image
from scipy import ndimage

from domeshim.intercept.dome import Dome
from domeshim.intercept.overlay import Overlay
from domeshim.options import Options
from domeshim.session import Session
from domeshim.window.contract import SurfaceFormat, WindowEvents
from domeshim.window.offscreen import OffscreenBackend

SIZE = 256
FOV = 1.0
DISTANCE = 1 / np.tan(np.radians(FOV / 2))
"""From here the unit square fills the picture."""

GL = types.SimpleNamespace
Scene = Callable[[GL], Any]
Picture = NDArray[np.uint8]
"""(SIZE, SIZE, 3), the top row first; black outside the disc."""


@dataclass(frozen=True)
class Drawn:
    """What a scene left behind: its picture, and what it returned."""

    picture: Picture
    answer: Any


class Beside:
    """Draws scenes both ways, each in a fresh context."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        """Where pictures that differ are kept."""
        self.surface = SurfaceFormat()
        """What the windows hold."""
        self.backend = OffscreenBackend()
        self.options = Options(enabled=True, fov=FOV, panel=FOV)
        self.stock = self._namespace()
        self.session = Session(self.options, backend=lambda: self.backend)
        self._overlay = Overlay(self.session)
        self._overlay.module_imported("OpenGL.GL", OpenGL.GL)
        self._overlay.module_imported("OpenGL.GLU", OpenGL.GLU)
        self.dome = self._namespace()

    def close(self) -> None:
        self._overlay.remove()
        self.backend.close()

    @property
    def _dome(self) -> Dome:
        assert isinstance(self.session.dome, Dome)
        return self.session.dome

    @staticmethod
    def _namespace() -> GL:
        glu = {name: value for name, value in vars(OpenGL.GLU).items() if name.lower().startswith("glu")}
        return GL(**(vars(OpenGL.GL) | glu))

    def monitor(self, scene: Scene, size: tuple[int, int] = (SIZE, SIZE)) -> Drawn:
        """The scene by stock GL."""
        window = self._open(size)
        try:
            renderer = self.stock.glGetString(self.stock.GL_RENDERER)
            assert renderer, "no GL renderer"
            answer = scene(self.stock)
            return Drawn(_disc(self._read(size)), answer)
        finally:
            window.close()

    def through_dome(self, scene: Scene, size: tuple[int, int] = (SIZE, SIZE), **options: Any) -> Drawn:
        """The scene through the dome; options: fields of Options that differ from the narrow lens."""
        with self.window(size, **options) as finish:
            answer = scene(self.dome)
            finish()
            return Drawn(_disc(self._read(size)), answer)

    @contextmanager
    def window(self, size: tuple[int, int] = (SIZE, SIZE), **options: Any) -> Iterator[Callable[[], None]]:
        """A dome's window, current; gives the function that ends a frame."""
        window = self._open(size)
        self.session.options = replace(self.options, **options)
        self.session.window_opened(window, size)
        try:
            yield lambda: self._ended(window)
        finally:
            self._dome.recorder.block = None
            self._dome.flush()
            self.session.window_closed(window)
            window.close()

    def _ended(self, window: Any) -> None:
        self._dome.frame_ending(window)
        self._dome.showing(window)

    def equal(self, scene: Scene, *, name: str = "", wrong: float = 0.002, **options: Any) -> Any:
        """Assert that both pictures of the scene are equal and both answers the same; returns the answer.

        wrong: the share of the disc's pixels that may differ because an edge passes their centres; options:
        as for through_dome.
        """
        __tracebackhide__ = True
        name = name or scene.__name__
        monitor, dome = self.monitor(scene), self.through_dome(scene, **options)
        assert monitor.picture.std() > 1, f"{name}: nothing to see on the monitor"
        self.assert_equal(monitor.picture, dome.picture, name=name, wrong=wrong)
        assert_alike(dome.answer, monitor.answer)
        return monitor.answer

    def assert_equal(self, monitor: Picture, dome: Picture, *, name: str, wrong: float = 0.002) -> None:
        """Assert that two pictures are equal up to pixels on edges."""
        __tracebackhide__ = True
        differs = (np.abs(monitor.astype(int) - dome) > 2).any(-1)
        beyond = _beyond(monitor, dome) | _beyond(dome, monitor)
        shares = differs.sum() / _MASK.sum(), beyond.sum() / _MASK.sum()
        if shares[0] > wrong or shares[1] > wrong / 10:
            self.folder.mkdir(parents=True, exist_ok=True)
            amplified = np.clip(np.abs(monitor.astype(int) - dome) * 8, 0, 255).astype(np.uint8)
            kept = self.folder / f"{name}.png"
            Image.fromarray(np.hstack([monitor, dome, amplified])).save(kept)
            raise AssertionError(
                f"{name}: {shares[0]:.4f} of the pixels differ, {shares[1]:.4f} from all around; see {kept}"
            )

    def _open(self, size: tuple[int, int]) -> Any:
        window = self.backend.open_window("test", size, None, self.surface, WindowEvents())
        window.make_current()
        return window

    def _read(self, size: tuple[int, int]) -> Picture:
        error = PLATFORM.GL.glGetError()
        assert error == 0, f"the scene left GL error {error:#x} behind"
        gl = self.stock
        gl.glPixelStorei(gl.GL_PACK_ALIGNMENT, 1)
        data = gl.glReadPixels(0, 0, *size, gl.GL_RGB, gl.GL_UNSIGNED_BYTE)
        return np.frombuffer(data, np.uint8).reshape(size[1], size[0], 3)[::-1]


_MIDDLES = np.arange(SIZE) + 0.5 - SIZE / 2
_MASK = np.hypot(*np.meshgrid(_MIDDLES, _MIDDLES)) < SIZE / 2 - 1


def _disc(picture: Picture) -> Picture:
    return np.where(_MASK[..., None], picture, 0) if picture.shape[:2] == _MASK.shape else picture


def assert_alike(one: Any, other: Any) -> None:
    """Assert that two answers are the same, numbers to single precision."""
    __tracebackhide__ = True
    if isinstance(other, list | tuple):
        assert type(one) is type(other)
        assert len(one) == len(other)
        for a, b in zip(one, other, strict=True):
            assert_alike(a, b)
    elif isinstance(other, float | np.ndarray):
        np.testing.assert_allclose(one, other, rtol=1e-5, atol=1e-6)
    else:
        assert one == other


def _beyond(one: Picture, other: Picture) -> NDArray[np.bool_]:
    """Pixels of one that are unlike everything within a pixel's reach in the other."""
    around = (3, 3, 1)
    low, high = ndimage.minimum_filter(other, around), ndimage.maximum_filter(other, around)
    return ((one < low.astype(int) - 2) | (one > high.astype(int) + 2)).any(-1)


def looking(gl: GL, *, depth: bool = True) -> None:
    """The usual beginning of a scene: a clear window, one degree of perspective, the unit square ahead."""
    gl.glClearColor(0.1, 0.1, 0.2, 1)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT | gl.GL_STENCIL_BUFFER_BIT)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gl.gluPerspective(FOV, 1.0, DISTANCE - 4, DISTANCE + 4)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glLoadIdentity()
    gl.glTranslatef(0, 0, -DISTANCE)
    if depth:
        gl.glEnable(gl.GL_DEPTH_TEST)


def flat(gl: GL) -> None:
    """The window's pixels are the program's units."""
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gl.gluOrtho2D(0, SIZE, 0, SIZE)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glLoadIdentity()


def looking_around(gl: GL) -> None:
    """A clear window, 60 degrees of perspective, the eye at the origin."""
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gl.glLoadIdentity()
    gl.gluPerspective(60, 1, 0.1, 100)
    gl.glMatrixMode(gl.GL_MODELVIEW)
    gl.glLoadIdentity()


def points_at(places: Any) -> Scene:
    """A scene of a point, three pixels wide, at each place of eye space."""

    def scene(gl: GL) -> None:
        looking_around(gl)
        gl.glPointSize(3)
        gl.glBegin(gl.GL_POINTS)
        for place in places:
            gl.glVertex3f(*place)
        gl.glEnd()

    return scene


def sphere(gl: GL, radius: float = 0.7, slices: int = 24, stacks: int = 16) -> None:
    """A sphere of quad strips with normals and texture coordinates, by glBegin/glEnd."""
    u, v = np.linspace(0, 2 * np.pi, slices + 1), np.linspace(0, np.pi, stacks + 1)
    for j in range(stacks):
        gl.glBegin(gl.GL_QUAD_STRIP)
        for i in range(slices + 1):
            for k in (j, j + 1):
                n = np.sin(v[k]) * np.cos(u[i]), np.cos(v[k]), np.sin(v[k]) * np.sin(u[i])
                gl.glNormal3f(*n)
                gl.glTexCoord2f(i / slices, k / stacks)
                gl.glVertex3f(*(radius * c for c in n))
        gl.glEnd()


def checks(gl: GL, target: int | None = None, size: int = 8) -> None:
    """A texture of coloured checks, bound and enabled."""
    target = target or gl.GL_TEXTURE_2D
    rows, columns = np.mgrid[0:size, 0:size]
    texels = np.stack(
        [255 * ((rows + columns) % 2), 30 * columns, 255 - 30 * rows, np.full_like(rows, 255)], -1
    ).astype(np.uint8)
    gl.glBindTexture(target, gl.glGenTextures(1))
    for parameter in (gl.GL_TEXTURE_MIN_FILTER, gl.GL_TEXTURE_MAG_FILTER):
        gl.glTexParameteri(target, parameter, gl.GL_LINEAR)
    gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
    if target == gl.GL_TEXTURE_1D:
        gl.glTexImage1D(target, 0, gl.GL_RGBA, size, 0, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE, texels[0])
    elif target == gl.GL_TEXTURE_CUBE_MAP:
        for face in range(6):
            tinted = (texels * [1, face / 5, 1 - face / 8, 1]).astype(np.uint8)
            gl.glTexImage2D(
                gl.GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, gl.GL_RGBA, size, size, 0, gl.GL_RGBA,
                gl.GL_UNSIGNED_BYTE, tinted,
            )  # fmt: skip
    else:
        gl.glTexImage2D(target, 0, gl.GL_RGBA, size, size, 0, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE, texels)
    gl.glEnable(target)
