"""What a place to draw on must offer: one contract, kept by screen.py (glfw) and offscreen.py (EGL).

The GLUT package and the session know these two classes only, never a backend's own types.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class SurfaceFormat:
    """What a window's frame buffer shall hold; a backend gives the nearest that the driver has."""

    double_buffer: bool = True
    depth: bool = True
    stencil: bool = True
    alpha: bool = True
    accumulation: bool = False
    stereo: bool = False
    samples: int | None = 0
    """None: as many as suit the dome, for a program that asks for none."""


DOME_SAMPLES = 4
"""As many suit the dome where a GPU draws, and off screen."""
_PROCESSOR = (b"llvmpipe", b"softpipe", b"swrast", b"software")
"""In the names of renderers that draw without a GPU."""


def processor_draws(renderer: bytes) -> bool:
    """There is no GPU behind the driver that gives itself this name by GL_RENDERER."""
    return any(processor in renderer.lower() for processor in _PROCESSOR)


def suiting_samples(renderer: bytes) -> int:
    """As many samples as suit the dome on the driver that gives itself this name by GL_RENDERER.

    0 where the processor draws, for there they cost a simple picture ten times its time.
    """
    return 0 if processor_draws(renderer) else DOME_SAMPLES


@dataclass(frozen=True)
class Joystick:
    """A joystick or gamepad as it stands now."""

    axes: tuple[float, ...]
    """-1 (left, away from the user) to 1 each."""
    buttons: tuple[bool, ...]
    """Which are held."""


class WindowEvents:
    """What a window reports; the receiver overrides what it wants. Pixels, origin at the top left."""

    def resized(self, width: int, height: int) -> None:
        """The frame buffer now has this size in pixels."""

    def exposed(self) -> None:
        """The window's content is gone and must be drawn again."""

    def close_asked(self) -> None:
        """The user wants the window closed."""

    def key(self, key: int, pressed: bool, modifiers: int) -> None:
        """A key by its glfw number went down (also by auto-repeat) or up."""

    def character(self, codepoint: int) -> None:
        """A character was typed."""

    def pointer_moved(self, x: float, y: float) -> None:
        """The pointer is at (x, y)."""

    def pointer_entered(self, inside: bool) -> None:
        """The pointer came into the window or left it."""

    def button(self, button: int, pressed: bool, modifiers: int) -> None:
        """A mouse button by its glfw number (0 left, 1 right, 2 middle) went down or up."""

    def wheel(self, dx: float, dy: float) -> None:
        """The wheel turned by so many notches; dy > 0 is away from the user."""

    def visibility_changed(self, visible: bool) -> None:
        """The window was iconified or hidden, or came back."""

    def moved(self, x: int, y: int) -> None:
        """The window's top left corner is now at (x, y) of the screen."""


class Window(ABC):
    """One window, or one off-screen surface, with a GL compatibility context of its own."""

    format: SurfaceFormat
    events: WindowEvents
    part: tuple[int, int, int, int] | None = None
    """All that there are pixels for, if not the whole window: x and y from its bottom left, width, height."""
    asked: tuple[int, int] | None = None
    """The size that the program asked for, where the user's choice stands instead."""

    @property
    def pixels(self) -> tuple[int, int]:
        """Width and height of what there are pixels for."""
        return self.size if self.part is None else self.part[2:]

    @property
    def framebuffer(self) -> int:
        """GL's number of the framebuffer that its pictures are in."""
        return 0

    @property
    @abstractmethod
    def size(self) -> tuple[int, int]:
        """Width and height of the frame buffer in pixels."""

    @property
    @abstractmethod
    def position(self) -> tuple[int, int]:
        """The top left corner on the screen in pixels."""

    @abstractmethod
    def make_current(self) -> None:
        """Direct the GL calls of this thread to this window."""

    @abstractmethod
    def swap_buffers(self) -> None:
        """Show what was drawn."""

    @abstractmethod
    def resize(self, width: int, height: int) -> None:
        """Ask for another frame buffer size; events.resized tells what came of it."""

    @abstractmethod
    def move(self, x: int, y: int) -> None:
        """Put the top left corner at (x, y) of the screen."""

    @abstractmethod
    def set_title(self, title: str) -> None:
        """Name the window."""

    @abstractmethod
    def set_visible(self, visible: bool) -> None:
        """Show or hide the window."""

    def put(self, *, highest: bool) -> bool:  # noqa: ARG002 - few screens can
        """Put the window over all others, or under them; False where the screen does not let a program."""
        return False

    @abstractmethod
    def iconify(self) -> None:
        """Shrink the window to an icon."""

    @abstractmethod
    def set_full_screen(self, full: bool, display: int = 0) -> None:
        """Cover the display of that number, or go back to the former size and place."""

    @abstractmethod
    def set_cursor(self, shape: str) -> None:
        """One of arrow, ibeam, crosshair, hand, hresize, vresize, none."""

    @abstractmethod
    def warp_pointer(self, x: float, y: float) -> None:
        """Put the pointer at (x, y) of the window."""

    def set_vsync(self, on: bool) -> None:  # noqa: B027 - most have nothing to wait for
        """Show pictures in step with the display, or at once; does nothing where there is no display."""

    @abstractmethod
    def close(self) -> None:
        """Destroy the window and its context; safe to call twice."""


class Backend(ABC):
    """A way to get windows: on a screen, or off it."""

    name: str

    @abstractmethod
    def open_window(
        self,
        title: str,
        size: tuple[int, int],
        position: tuple[int, int] | None,
        surface: SurfaceFormat,
        events: WindowEvents,
        share: Window | None = None,
        *,
        shown: bool = True,
    ) -> Window:
        """Open a window and make it current; shown=False: one that is only drawn on.

        Raises ScreenError, naming what was tried, where none can be had.
        """

    @abstractmethod
    def poll(self, timeout: float) -> None:
        """Deliver what happened to the windows' events; wait at most so many seconds for something."""

    @property
    def joysticks(self) -> tuple[Joystick, ...]:
        """Those that are plugged in; none where nobody plays."""
        return ()

    @property
    @abstractmethod
    def screen_size(self) -> tuple[int, int]:
        """Width and height of the main display in pixels."""

    @property
    @abstractmethod
    def screen_size_mm(self) -> tuple[int, int]:
        """Width and height of the main display in millimetres."""

    @abstractmethod
    def close(self) -> None:
        """Close all windows and let the screen go."""


BackendFactory = Callable[[], Backend]
