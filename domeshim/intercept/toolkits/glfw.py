"""glfw: a window is GL's from its first make_context_current on; swap_buffers finishes a picture."""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Callable
from types import ModuleType
from typing import TYPE_CHECKING, Any

from domeshim.errors import ScreenError
from domeshim.intercept.toolkits.glfw_hints import Hints
from domeshim.intercept.toolkits.windows import ToolkitHost, ToolkitWindow
from domeshim.window.contract import Window, WindowEvents

if TYPE_CHECKING:
    from domeshim.session import Session

_OUR_OWN = "domeshim.window.handles"
"""The module that opens our own windows through the same glfw."""


class GlfwToolkit(ToolkitHost):
    """The program's glfw windows; those that are our own are left alone."""

    def __init__(self, session: Session, module: ModuleType) -> None:
        super().__init__(session, "glfw")
        self._glfw = _Originals(module)
        self._hints = Hints(self._glfw)
        self._windows: dict[int, _GlfwWindow] = {}
        self._current: Any = None

    def replacements(self) -> dict[str, Any]:
        """Our names for the module glfw."""
        glfw = self._glfw
        ours: dict[str, Any] = {
            "window_hint": self._hints.window_hint,
            "default_window_hints": self._hints.default_window_hints,
            "create_window": self.create_window,
            "make_context_current": self.make_context_current,
            "swap_buffers": self.swap_buffers,
            "destroy_window": self.destroy_window,
            "terminate": self.terminate,
            "get_cursor_pos": self.get_cursor_pos,
            "set_cursor_pos": self.set_cursor_pos,
            "set_cursor_pos_callback": self.set_cursor_pos_callback,
            "set_key_callback": self.set_key_callback,
            "poll_events": self._delivering(glfw.poll_events),
            "wait_events": self._delivering(glfw.wait_events),
            "wait_events_timeout": self._delivering(glfw.wait_events_timeout),
        }
        if self.session.clock.virtual:
            ours |= {
                "wait_events": self._delivering(glfw.poll_events),
                "wait_events_timeout": self._delivering(lambda timeout: glfw.poll_events()),  # noqa: ARG005
            }
        if self.gives_windows:
            ours |= {
                "init": self.init,
                "set_window_size": self.set_window_size,
                "get_current_context": lambda: self._current,
                "swap_interval": lambda interval: None,  # noqa: ARG005 - nothing is shown, nothing waits
                "get_proc_address": _proc_address,
                "extension_supported": self._extension_supported,
            }
        return ours

    def init(self) -> Any:
        """Start glfw without a display."""
        self._glfw.init_hint(self._glfw.PLATFORM, self._glfw.PLATFORM_NULL)
        return self._glfw.init()

    def create_window(self, width: int, height: int, title: Any, monitor: Any, share: Any) -> Any:
        """Open one of the program's windows, or one of our own."""
        glfw = self._glfw
        if sys._getframe(1).f_globals.get("__name__") == _OUR_OWN:
            return glfw.create_window(width, height, title, monitor, share)
        if self._hints.without_gl:
            return glfw.create_window(width, height, title, monitor, share)
        if self.gives_windows:
            handle = self._create_given(width, height, title, share)
        else:
            handle = self._hints.opened_with_samples(
                lambda: glfw.create_window(width, height, title, monitor, share), self.samples_wished
            )
            if handle:
                self._windows[_address(handle)] = _GlfwWindow(handle, self._own_window(handle))
                self.set_key_callback(handle, None)
        return handle

    def _own_window(self, handle: Any) -> Window:
        return ToolkitWindow(
            lambda: self._glfw.get_framebuffer_size(handle),
            lambda: self._glfw.swap_buffers(handle),
            double_buffer=self._hints.surface(0).double_buffer,
        )

    def _create_given(self, width: int, height: int, title: Any, share: Any) -> Any:
        """The GL window is the session's; glfw, without a display, keeps one for its events."""
        glfw, session = self._glfw, self.session
        size = session.window_size or (width, height)
        handle = self._hints.opened_without_gl(lambda: glfw.create_window(*size, title, None, None))
        if not handle:
            raise ScreenError("glfw could not open a window without a display")
        wanted = self._hints.surface(self.samples_wished)
        shared = self._windows[_address(share)].surface if share else None
        surface = session.backend.open_window("", size, None, wanted, WindowEvents(), shared)
        surface.asked = (width, height) if size != (width, height) else None
        opened = _GlfwWindow(handle, surface, self._hints.without_fixed_function)
        self._windows[_address(handle)] = opened
        if self._current is not None:
            self._windows[_address(self._current)].surface.make_current()
        return handle

    def make_context_current(self, window: Any) -> None:
        """Direct GL to one of the program's windows, and let the session know."""
        opened = self._windows.get(_address(window)) if window else None
        if self.gives_windows:
            if opened is not None:
                opened.surface.make_current()
        else:
            self._glfw.make_context_current(window)
        self._current = window
        if opened is None:
            if not window:
                self.session.window_current(None)
            return
        if opened.met:
            self.session.window_current(opened.surface)
        else:
            opened.told_size = opened.surface.size
            self.opened(opened.surface, opened.told_size, core=opened.core)
            opened.met = True

    def swap_buffers(self, window: Any) -> None:
        """Finish the picture in one of the program's windows, or show one of our own."""
        opened = self._windows.get(_address(window))
        if opened is None or not opened.met:
            self._glfw.swap_buffers(window)
        else:
            self.finished(opened.surface)

    def set_window_size(self, window: Any, width: int, height: int) -> None:
        """Give the window another size, unless the user fixed it."""
        if self.session.window_size is None:
            self._glfw.set_window_size(window, width, height)
            self._look_at_sizes()

    def destroy_window(self, window: Any) -> None:
        """Close one of the program's windows, or one of our own."""
        opened = self._windows.pop(_address(window), None)
        if opened is not None:
            self.session.window_closed(opened.surface)
            opened.surface.close()
            if self._current and _address(self._current) == _address(window):
                self._current = None
        self._glfw.destroy_window(window)

    def terminate(self) -> None:
        """Close all of the program's windows."""
        for opened in self._windows.values():
            self.session.window_closed(opened.surface)
            opened.surface.close()
        self._windows.clear()
        self._current = None
        self._glfw.terminate()

    def get_cursor_pos(self, window: Any) -> tuple[float, float]:
        """Where the pointer is, in the program's screen coordinates; (0, 0) where nobody has moved it."""
        x, y = self._glfw.get_cursor_pos(window)
        if x == y == 0:
            return x, y
        return self._placed(window, x, y, self.program_place)

    def set_cursor_pos(self, window: Any, x: float, y: float) -> None:
        """Put the pointer where the dome has that place of the program's."""
        self._glfw.set_cursor_pos(window, *self._placed(window, x, y, self.window_place))

    def set_cursor_pos_callback(self, window: Any, function: Any) -> Any:
        """Tell function(window, x, y) of the pointer, in the program's screen coordinates."""

        def placed(handle: Any, x: float, y: float) -> None:
            function(handle, *self._placed(handle, x, y, self.program_place))

        opened = self._windows.get(_address(window))
        if opened is None:
            return self._glfw.set_cursor_pos_callback(window, function)
        former, opened.cursor_told = opened.cursor_told, function
        self._glfw.set_cursor_pos_callback(window, placed if function else None)
        return former

    def set_key_callback(self, window: Any, function: Any) -> Any:
        """Tell function(window, key, scancode, action, modifiers) of the keys, but not of the dome's."""
        opened = self._windows.get(_address(window))
        if opened is None:
            return self._glfw.set_key_callback(window, function)

        def heard(handle: Any, key: int, scancode: int, action: int, modifiers: int) -> None:
            down = action != self._glfw.RELEASE
            if not self.is_domes(opened.surface, key, modifiers, down=down) and function:
                function(handle, key, scancode, action, modifiers)

        former, opened.key_told = opened.key_told, function
        self._glfw.set_key_callback(window, heard)
        return former

    def _placed(
        self, window: Any, x: float, y: float, place: Callable[[Window, float, float], tuple[float, float]]
    ) -> tuple[float, float]:
        """A pointer's place converted, by its pixel's middle; one that glfw has disabled is only counted."""
        glfw, opened = self._glfw, self._windows.get(_address(window))
        if opened is None or glfw.get_input_mode(window, glfw.CURSOR) == glfw.CURSOR_DISABLED:
            return x, y
        screen, frame = glfw.get_window_size(window), opened.surface.size
        if min(*screen, *frame) <= 0:
            return x, y
        x, y = place(opened.surface, x * frame[0] / screen[0] + 0.5, y * frame[1] / screen[1] + 0.5)
        return (x - 0.5) * screen[0] / frame[0], (y - 0.5) * screen[1] / frame[1]

    def _delivering(self, original: Callable[..., Any]) -> Callable[..., Any]:
        """The call, in which glfw tells of the windows' new sizes."""

        def call(*args: Any, **named: Any) -> Any:
            result = original(*args, **named)
            self._look_at_sizes()
            return result

        return call

    def _look_at_sizes(self) -> None:
        for opened in self._windows.values():
            if not opened.met:
                continue
            if self.gives_windows:
                opened.surface.resize(*self._glfw.get_framebuffer_size(opened.handle))
            size = opened.surface.size
            if size != opened.told_size and min(size) > 0:
                opened.told_size = size
                self.session.window_resized(opened.surface, size)

    def _extension_supported(self, extension: str) -> bool:
        from OpenGL.extensions import hasGLExtension  # noqa: PLC0415 - asked with a context

        return bool(hasGLExtension(extension))


class _GlfwWindow:
    """One of the program's windows."""

    def __init__(self, handle: Any, surface: Window, core: bool | None = None) -> None:
        self.handle = handle
        self.surface = surface
        self.core = core
        self.met = False
        """It has been current, and the session knows it."""
        self.told_size = (0, 0)
        self.cursor_told: Any = None
        """The program's function that hears of the pointer."""
        self.key_told: Any = None
        """The one that hears of the keys."""


class _Originals:
    """glfw as it was before any of its names led to ours."""

    def __init__(self, module: ModuleType) -> None:
        self._names = dict(vars(module))

    def __getattr__(self, name: str) -> Any:
        return self._names[name]


def _address(window: Any) -> int:
    return ctypes.cast(window, ctypes.c_void_p).value or 0


def _proc_address(name: str | bytes) -> Any:
    from OpenGL.platform import PLATFORM  # noqa: PLC0415 - the program may still set PyOpenGL's flags

    return PLATFORM.getExtensionProcedure(name.encode() if isinstance(name, str) else name)
