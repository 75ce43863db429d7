"""Windows without a display: pixel buffers of EGL, on Mesa's surfaceless platform or on a GPU device."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from typing import Any

from OpenGL.platform import PLATFORM

from domeshim.errors import ScreenError
from domeshim.window.contract import DOME_SAMPLES, Backend, SurfaceFormat, Window, WindowEvents
from domeshim.window.egl import EGL

SURFACELESS, DEVICE = 0x31DD, 0x313F  # EGL_PLATFORM_SURFACELESS_MESA, EGL_PLATFORM_DEVICE_EXT
SCREEN_SIZE = (1920, 1080)
"""The size of the screen that is not there, for programs that ask."""
PIXELS_PER_MM = 96 / 25.4


class OffscreenBackend(Backend):
    """Opens pixel buffers; each has a context of its own and is as large as it was asked to be."""

    name = "offscreen"

    def __init__(self, part: tuple[int, int, int, int] | None = None) -> None:
        """Connect to the first EGL platform that offers a desktop GL.

        part: of each window, for which alone there shall be pixels (see Window).

        Raises ScreenError naming every attempt where none does.
        """
        if type(PLATFORM).__name__ != "EGLPlatform":
            raise ScreenError(
                "pictures without a display need PyOpenGL on EGL, but OpenGL was imported for "
                f"{type(PLATFORM).__name__}: set PYOPENGL_PLATFORM=egl before OpenGL is imported"
            )
        self._display = _connect()
        self._part = part
        self._windows: list[OffscreenWindow] = []

    def open_window(
        self,
        title: str,  # noqa: ARG002 - there is no title bar
        size: tuple[int, int],
        position: tuple[int, int] | None,
        surface: SurfaceFormat,
        events: WindowEvents,
        share: Window | None = None,
        *,
        shown: bool = True,  # noqa: ARG002 - none is
    ) -> Window:
        """Make a pixel buffer of that size and its context, and make it current.

        Raises ScreenError where the driver has no such configuration or refuses the context.
        """
        shared = share.context if isinstance(share, OffscreenWindow) else EGL.EGL_NO_CONTEXT
        window = OffscreenWindow(self._display, size, surface, events, shared, self._part)
        window.move(*(position or (0, 0)))
        self._windows.append(window)
        window.make_current()
        return window

    def poll(self, timeout: float) -> None:
        """Return at once: nobody types or points off screen."""

    @property
    def screen_size(self) -> tuple[int, int]:
        """1920 x 1080, since programs ask and centre their windows by it."""
        return SCREEN_SIZE

    @property
    def screen_size_mm(self) -> tuple[int, int]:
        """The screen's size at 96 pixels an inch."""
        return round(SCREEN_SIZE[0] / PIXELS_PER_MM), round(SCREEN_SIZE[1] / PIXELS_PER_MM)

    def close(self) -> None:
        """Destroy all buffers and contexts; the EGL display is the whole process's and stays."""
        for window in self._windows:
            window.close()
        self._windows.clear()


class OffscreenWindow(Window):
    """One pixel buffer with its context; resizing makes a new buffer for the same context."""

    def __init__(
        self,
        display: Any,
        size: tuple[int, int],
        surface: SurfaceFormat,
        events: WindowEvents,
        shared: Any,
        part: tuple[int, int, int, int] | None = None,
    ) -> None:
        self.events = events
        self.part = part
        self._display = display
        self._size = size
        self._position = (0, 0)
        self._config, self.format = _choose_config(display, surface)
        EGL.eglBindAPI(EGL.EGL_OPENGL_API)
        self.context: Any = EGL.eglCreateContext(display, self._config, shared, None)
        if not self.context:
            raise ScreenError(f"EGL refused an OpenGL compatibility context ({_error()}); {_ADVICE}")
        self._surface = self._buffer(self.pixels)

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the buffer in pixels."""
        return self._size

    @property
    def position(self) -> tuple[int, int]:
        """Where the program last put the window."""
        return self._position

    def make_current(self) -> None:
        """Direct the GL calls of this thread to this buffer."""
        if not EGL.eglMakeCurrent(self._display, self._surface, self._surface, self.context):
            raise ScreenError(f"EGL could not make its pixel buffer current ({_error()})")

    def swap_buffers(self) -> None:
        """Finish the picture; a pixel buffer has only one colour buffer, which keeps it."""
        EGL.eglWaitGL()

    def resize(self, width: int, height: int) -> None:
        """Draw into a new buffer of that size from now on; events.resized follows at once."""
        if (width, height) == self._size:
            return
        current = self._is_current()
        self._size = (width, height)
        old, self._surface = self._surface, self._buffer(self.pixels)
        if current:
            self.make_current()
        EGL.eglDestroySurface(self._display, old)
        self.events.resized(width, height)

    def move(self, x: int, y: int) -> None:
        """Remember the place and tell of it."""
        self._position = (x, y)
        self.events.moved(x, y)

    def set_title(self, title: str) -> None:
        """Do nothing: there is no title bar."""

    def set_visible(self, visible: bool) -> None:
        """Tell of it; the buffer exists either way."""
        self.events.visibility_changed(visible)

    def put(self, *, highest: bool) -> bool:  # noqa: ARG002 - no window hides another
        """Return True: nothing lies over anything."""
        return True

    def iconify(self) -> None:
        """Tell that the window is hidden; the buffer exists either way."""
        self.events.visibility_changed(False)

    def set_full_screen(self, full: bool, display: int = 0) -> None:
        """Do nothing: there is no screen to cover."""

    def set_cursor(self, shape: str) -> None:
        """Do nothing: there is no pointer."""

    def warp_pointer(self, x: float, y: float) -> None:
        """Do nothing: there is no pointer."""

    def close(self) -> None:
        """Destroy the buffer and its context; safe to call twice."""
        if not self.context:
            return
        if self._is_current():
            EGL.eglMakeCurrent(self._display, EGL.EGL_NO_SURFACE, EGL.EGL_NO_SURFACE, EGL.EGL_NO_CONTEXT)
        EGL.eglDestroySurface(self._display, self._surface)
        EGL.eglDestroyContext(self._display, self.context)
        self.context = None

    def _is_current(self) -> bool:
        contexts = self.context, EGL.eglGetCurrentContext()
        own, current = (ctypes.cast(context, ctypes.c_void_p).value for context in contexts)
        return own == current

    def _buffer(self, size: tuple[int, int]) -> Any:
        attributes = (EGL.EGLint * 5)(EGL.EGL_WIDTH, size[0], EGL.EGL_HEIGHT, size[1], EGL.EGL_NONE)
        surface = EGL.eglCreatePbufferSurface(self._display, self._config, attributes)
        if not surface:
            raise ScreenError(f"EGL refused a pixel buffer of {size[0]}x{size[1]} ({_error()})")
        return surface


_ADVICE = "install Mesa's EGL (Debian: libegl1 libegl-mesa0 libgl1-mesa-dri) or the GPU vendor's"


def _connect() -> Any:
    """Return the first EGL display with desktop GL: surfaceless, then each device, then the default."""
    failures: list[str] = []
    for name, display in _displays(failures):
        major, minor = EGL.EGLint(), EGL.EGLint()
        try:
            if not display or not EGL.eglInitialize(display, major, minor):
                failures.append(f"{name}: {_error()}")
            elif not EGL.eglBindAPI(EGL.EGL_OPENGL_API):
                failures.append(f"{name}: no desktop OpenGL")
            else:
                return display
        except EGL.EGLError as error:
            failures.append(f"{name}: {_words(error)}")
    raise ScreenError(f"no off-screen OpenGL ({'; '.join(failures)}); {_ADVICE}")


def _displays(failures: list[str]) -> Iterator[tuple[str, Any]]:
    """Yield the name and the display of each platform worth trying; notes those that EGL itself lacks."""
    from OpenGL.EGL.EXT.platform_base import eglGetPlatformDisplayEXT  # noqa: PLC0415 - needs a loaded EGL

    try:
        yield "surfaceless", eglGetPlatformDisplayEXT(SURFACELESS, None, None)
    except Exception as error:  # noqa: BLE001,RUF100 - PyOpenGL raises its own error or none of its kind here
        failures.append(f"surfaceless: {_words(error)}")
    try:
        for number, device in enumerate(_devices()):
            yield f"device {number}", eglGetPlatformDisplayEXT(DEVICE, device, None)
    except Exception as error:  # noqa: BLE001,RUF100 - as above
        failures.append(f"device: {_words(error)}")
    try:
        yield "default", EGL.eglGetDisplay(EGL.EGL_DEFAULT_DISPLAY)
    except Exception as error:  # noqa: BLE001,RUF100 - as above
        failures.append(f"default: {_words(error)}")


def _devices() -> list[Any]:
    from OpenGL.EGL.EXT.device_base import eglQueryDevicesEXT  # noqa: PLC0415 - needs a loaded EGL

    found = EGL.EGLint()
    devices = (EGL.EGLDeviceEXT * 16)()
    eglQueryDevicesEXT(16, devices, found)
    return [devices[i] for i in range(found.value)]


def _choose_config(display: Any, wanted: SurfaceFormat) -> tuple[Any, SurfaceFormat]:
    """Return the configuration nearest to the wish, and what it really holds; fewer samples before none."""
    samples = DOME_SAMPLES if wanted.samples is None else wanted.samples
    while True:
        config = _find_config(display, wanted, samples)
        if config is not None:
            given = SurfaceFormat(
                wanted.double_buffer, wanted.depth, wanted.stencil, wanted.alpha, samples=samples
            )
            return config, given
        if samples == 0:
            raise ScreenError(f"EGL has no pixel-buffer configuration for {wanted}; {_ADVICE}")
        samples = samples // 2 if samples > 2 else 0


def _find_config(display: Any, wanted: SurfaceFormat, samples: int) -> Any | None:
    at_least = {
        EGL.EGL_SURFACE_TYPE: EGL.EGL_PBUFFER_BIT,
        EGL.EGL_RENDERABLE_TYPE: EGL.EGL_OPENGL_BIT,
        EGL.EGL_RED_SIZE: 8,
        EGL.EGL_GREEN_SIZE: 8,
        EGL.EGL_BLUE_SIZE: 8,
        EGL.EGL_ALPHA_SIZE: 8 if wanted.alpha else 0,
        EGL.EGL_DEPTH_SIZE: 24 if wanted.depth else 0,
        EGL.EGL_STENCIL_SIZE: 8 if wanted.stencil else 0,
        EGL.EGL_SAMPLES: samples,
    }
    flat = [int(number) for pair in at_least.items() for number in pair]
    found = EGL.EGLint()
    configs = (EGL.EGLConfig * 256)()
    EGL.eglChooseConfig(display, (EGL.EGLint * (len(flat) + 1))(*flat, EGL.EGL_NONE), configs, 256, found)
    exact = [name for name in at_least if name not in (EGL.EGL_SURFACE_TYPE, EGL.EGL_RENDERABLE_TYPE)]

    def surplus(config: Any) -> list[int]:
        return [_attribute(display, config, name) - at_least[name] for name in exact]

    return min((configs[i] for i in range(found.value)), key=surplus, default=None)


def _attribute(display: Any, config: Any, name: Any) -> int:
    value = EGL.EGLint()
    EGL.eglGetConfigAttrib(display, config, name, value)
    return int(value.value)


def _error() -> str:
    return f"EGL error {int(EGL.eglGetError()):#06x}"


def _words(error: BaseException) -> str:
    number = getattr(error, "err", None)
    return f"EGL error {int(number):#06x}" if number else str(error).splitlines()[0][:120]
