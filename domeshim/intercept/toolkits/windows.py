"""A toolkit's own window as the session sees it, and what of its GL can be bent."""

from __future__ import annotations

from collections.abc import Callable

from domeshim.driver import Driver
from domeshim.session import Session
from domeshim.startup import say
from domeshim.window.contract import DOME_SAMPLES, SurfaceFormat, Window, WindowEvents
from domeshim.window.dome_keys import DOME_KEYS, is_dome_key

_VERSION = 0x1F02
_CONTEXT_FLAGS, _PROFILE_MASK = 0x821E, 0x9126
_FORWARD_COMPATIBLE, _CORE = 1, 1


class ToolkitWindow(Window):
    """A window that the program opened and keeps itself: the session only asks its size and shows it.

    Whatever else can be done to a window, the program does by its toolkit.
    """

    def __init__(
        self,
        size: Callable[[], tuple[int, int]],
        show: Callable[[], object],
        *,
        double_buffer: bool = True,
        framebuffer: Callable[[], int] = lambda: 0,
    ) -> None:
        """size: asks the toolkit for the frame buffer's pixels; show: the toolkit's own swap.

        framebuffer: asks for its number, where it may be another than GL's own.
        """
        self.format = SurfaceFormat(double_buffer=double_buffer)
        self.events = WindowEvents()
        self._size = size
        self._show = show
        self._framebuffer = framebuffer

    @property
    def framebuffer(self) -> int:
        """As the toolkit says."""
        return self._framebuffer()

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the frame buffer in pixels."""
        return self._size()

    @property
    def position(self) -> tuple[int, int]:
        """(0, 0): where the window stands is the program's business."""
        return 0, 0

    def swap_buffers(self) -> None:
        """Show what was drawn."""
        self._show()

    def make_current(self) -> None:
        """Do nothing: the program makes its contexts current itself."""

    def resize(self, width: int, height: int) -> None:
        """Do nothing: the program sizes its window itself."""

    def move(self, x: int, y: int) -> None:
        """Do nothing: the program moves its window itself."""

    def set_title(self, title: str) -> None:
        """Do nothing: the program names its window itself."""

    def set_visible(self, visible: bool) -> None:
        """Do nothing: the program shows and hides its window itself."""

    def iconify(self) -> None:
        """Do nothing: the program shrinks its window itself."""

    def set_full_screen(self, full: bool, display: int = 0) -> None:
        """Do nothing: the program covers the screen itself."""

    def set_cursor(self, shape: str) -> None:
        """Do nothing: the program chooses its pointer itself."""

    def warp_pointer(self, x: float, y: float) -> None:
        """Do nothing: the program moves the pointer itself."""

    def close(self) -> None:
        """Do nothing: the program closes its window itself."""


class ToolkitHost:
    """What the toolkits have in common: telling the session, and telling the user what is not done."""

    def __init__(self, session: Session, name: str) -> None:
        self.session = session
        self._name = name
        self._said: set[str] = set()
        self._driver = Driver()
        self._dome_keys_held: set[int] = set()

    @property
    def gives_windows(self) -> bool:
        """The program's GL windows come from the session, not from the toolkit."""
        return self.session.backend_given

    @property
    def samples_wished(self) -> int:
        """Samples a pixel on the dome for a program that asks for none: as in GLUT's windows on a GPU."""
        return DOME_SAMPLES if self.session.options.enabled else 0

    def say_once(self, words: str) -> None:
        """Tell the user what cannot be done as on GLUT's windows, the first time only."""
        if words not in self._said:
            self._said.add(words)
            say(words)

    def opened(self, window: Window, size: tuple[int, int], *, core: bool | None = None) -> None:
        """A GL window of the toolkit was opened and is current; size: in the program's own pixels.

        core: whether the program asked for a GL without fixed function; None: ask the GL that it got.
        """
        bent = True
        if self.session.options.enabled:
            options = self.session.options
            if options.frame is not None or options.display is not None:
                self.say_once(
                    f"DOME_FRAME and DOME_DISPLAY are for GLUT; a window of {self._name} stays as it is"
                )
            bent = not (self.without_fixed_function() if core is None else core)
            if not bent:
                self.say_once("the program's GL has no fixed function; what it draws with it is not bent")
        self.session.window_opened(window, size, bent=bent)

    def program_place(self, window: Window, x: float, y: float) -> tuple[float, float]:
        """Where the monitor would show a place of the frame; pixels from the top left."""
        dome = self.session.dome
        return (x, y) if dome is None else dome.program_place(window, x, y)

    def window_place(self, window: Window, x: float, y: float) -> tuple[float, float]:
        """program_place's way back."""
        dome = self.session.dome
        return (x, y) if dome is None else dome.frame_place(window, x, y)

    def is_domes(self, window: Window | None, key: int, modifiers: int, *, down: bool) -> bool:
        """The dome takes a key, by glfw's numbers, as its own; the program shall not hear of it."""
        if window is None or key not in DOME_KEYS:
            return False
        if key in self._dome_keys_held:  # its repetition, or its release, by which Ctrl may be up again
            if not down:
                self._dome_keys_held.discard(key)
            return True
        taken = down and is_dome_key(key, modifiers) and self.session.takes_key(window, key)
        if taken:
            self._dome_keys_held.add(key)
        return taken

    def finished(self, window: Window) -> None:
        """The program has finished a picture."""
        if self.session.options.enabled and self.session.dome is None:
            self.say_once("this program draws without PyOpenGL; only PyOpenGL's calls are bent onto the dome")
        self.session.swapped(window)

    def without_fixed_function(self) -> bool:
        """The current context is a core profile, forward-compatible, or OpenGL ES."""
        gl = self._driver
        version = (gl.glGetString(_VERSION) or b"").decode("ascii", "replace")
        if not version[:1].isdigit():
            return True
        major, minor = (int(part) for part in version.split()[0].split(".")[:2])
        forward = (major, minor) >= (3, 0) and bool(gl.integer(_CONTEXT_FLAGS) & _FORWARD_COMPATIBLE)
        return forward or ((major, minor) >= (3, 2) and bool(gl.integer(_PROFILE_MASK) & _CORE))
