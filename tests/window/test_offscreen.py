from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator

import pytest
from OpenGL import GL

from domeshim.window.contract import SurfaceFormat, Window, WindowEvents
from domeshim.window.offscreen import OffscreenBackend, _displays


class Heard(WindowEvents):
    def __init__(self) -> None:
        self.sizes: list[tuple[int, int]] = []

    def resized(self, width: int, height: int) -> None:
        self.sizes.append((width, height))


@pytest.fixture
def backend() -> Iterator[OffscreenBackend]:
    backend = OffscreenBackend()
    yield backend
    backend.close()


def open_one(
    backend: OffscreenBackend, surface: SurfaceFormat | None = None, share: Window | None = None
) -> Window:
    return backend.open_window("test", (64, 48), None, surface or SurfaceFormat(), Heard(), share)


def fill(red: float, green: float, blue: float) -> None:
    GL.glClearColor(red, green, blue, 1)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT)


def pixel(x: int, y: int) -> tuple[int, ...]:
    return tuple(GL.glReadPixels(x, y, 1, 1, GL.GL_RGB, GL.GL_UNSIGNED_BYTE))


def test_a_window_has_a_compatibility_context_of_its_size(backend: OffscreenBackend) -> None:
    window = open_one(backend)
    assert window.size == (64, 48)
    assert list(GL.glGetIntegerv(GL.GL_VIEWPORT)) == [0, 0, 64, 48]
    GL.glMatrixMode(GL.GL_MODELVIEW)  # an error in a core context
    fill(1, 0, 0)
    assert pixel(63, 47) == (255, 0, 0)


@pytest.mark.parametrize(
    ("surface", "depth", "stencil", "alpha"),
    [
        (SurfaceFormat(), True, True, True),
        (SurfaceFormat(depth=False, stencil=False, alpha=False), False, False, False),
        (SurfaceFormat(stencil=False, alpha=False), True, False, False),
    ],
)
def test_the_buffer_holds_what_was_asked_for_and_no_more(
    backend: OffscreenBackend, surface: SurfaceFormat, depth: bool, stencil: bool, alpha: bool
) -> None:
    open_one(backend, surface)
    bits = [int(GL.glGetIntegerv(name)) for name in (GL.GL_DEPTH_BITS, GL.GL_STENCIL_BITS, GL.GL_ALPHA_BITS)]
    assert [bool(number) for number in bits] == [depth, stencil, alpha]


def test_too_many_samples_become_what_the_driver_has(backend: OffscreenBackend) -> None:
    window = open_one(backend, SurfaceFormat(samples=64))
    assert 0 < window.format.samples == int(GL.glGetIntegerv(GL.GL_SAMPLES)) < 64


def test_resizing_keeps_the_context_and_tells_of_it(backend: OffscreenBackend) -> None:
    window = open_one(backend)
    texture = GL.glGenTextures(1)
    GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
    window.resize(100, 90)
    assert window.size == (100, 90)
    assert isinstance(window.events, Heard)
    assert window.events.sizes == [(100, 90)]
    assert GL.glIsTexture(texture)
    fill(0, 1, 0)
    assert pixel(99, 89) == (0, 255, 0)


def test_windows_have_contexts_of_their_own_unless_shared(backend: OffscreenBackend) -> None:
    first = open_one(backend)
    texture = GL.glGenTextures(1)
    GL.glBindTexture(GL.GL_TEXTURE_2D, texture)
    fill(1, 0, 0)
    open_one(backend)
    assert not GL.glIsTexture(texture)
    fill(0, 0, 1)
    open_one(backend, share=first)
    assert GL.glIsTexture(texture)
    first.make_current()
    assert pixel(5, 5) == (255, 0, 0)


def test_closing_twice_is_safe(backend: OffscreenBackend) -> None:
    window = open_one(backend)
    window.close()
    window.close()


def test_the_wrong_platform_is_named() -> None:
    script = (
        "import os; os.environ['PYOPENGL_PLATFORM'] = 'glx'\n"
        "from domeshim.errors import ScreenError\n"
        "from domeshim.window.offscreen import OffscreenBackend\n"
        "try: OffscreenBackend()\n"
        "except ScreenError as error: print(error)\n"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
    assert "PYOPENGL_PLATFORM=egl" in done.stdout


def test_egl_can_be_imported_where_the_program_switched_error_checking_off() -> None:
    program = (
        "import OpenGL; OpenGL.ERROR_CHECKING = False\n"
        "from domeshim.window.offscreen import OffscreenBackend\n"
        "from domeshim.window.contract import SurfaceFormat, WindowEvents\n"
        "window = OffscreenBackend().open_window('test', (8, 6), None, SurfaceFormat(), WindowEvents())\n"
        "print(window.size)"
    )
    result = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert (result.stdout, result.stderr) == ("(8, 6)\n", "")


def test_devices_can_be_asked_for(backend: OffscreenBackend) -> None:
    failures: list[str] = []
    for _name, display in _displays(failures):
        assert display
    assert not [failure for failure in failures if "ctypes" in failure or "argument" in failure]
