"""Windows on a display, through glfw."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import glfw
from OpenGL import GL

from domeshim.errors import ScreenError
from domeshim.window.contract import Backend, Joystick, SurfaceFormat, Window, WindowEvents
from domeshim.window.handles import attempts, complaints, create, dome_samples
from domeshim.window.x11 import order_on_x11

_CURSORS = {
    "arrow": glfw.ARROW_CURSOR,
    "ibeam": glfw.IBEAM_CURSOR,
    "crosshair": glfw.CROSSHAIR_CURSOR,
    "hand": glfw.HAND_CURSOR,
    "hresize": glfw.HRESIZE_CURSOR,
    "vresize": glfw.VRESIZE_CURSOR,
}


class ScreenBackend(Backend):
    """Opens windows on the display. X11 is tried before Wayland, which can place no window."""

    name = "screen"

    def __init__(self) -> None:
        """Connect to the display.

        Raises ScreenError where there is none.
        """
        self._windows: list[ScreenWindow] = []
        self._dome_samples: int | None = None
        """As many suit the dome; known with the first window."""
        failures = []
        for platform in (glfw.PLATFORM_X11, glfw.PLATFORM_WAYLAND, glfw.ANY_PLATFORM):
            with complaints() as said:
                glfw.init_hint(glfw.PLATFORM, platform)
                glfw.init_hint(glfw.JOYSTICK_HAT_BUTTONS, False)
                if glfw.init():
                    return
            failures += [words for words in said if words not in failures]
        raise ScreenError(
            f"no display to open a window on ({'; '.join(failures)}): set DISPLAY or WAYLAND_DISPLAY, "
            "or use `domeshim capture` to write pictures without a display"
        )

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
        """Open a window, with fewer samples or two colour buffers where the driver has nothing nearer.

        Where nobody knows yet how many samples suit the dome, one without any is opened first, and kept if
        that is how many.

        Raises ScreenError with glfw's words where it has nothing at all.
        """
        shared = share.handle if isinstance(share, ScreenWindow) else None
        if surface.samples is None:
            surface = replace(surface, samples=self._dome_samples)
        unsure = surface.samples is None
        failures: list[str] = []
        for attempt, really_double in attempts(surface):
            with complaints() as said:
                handle = create(title, size, attempt, really_double, shared, shown=shown and not unsure)
            failures += [words for words in said if words not in failures]
            if handle and unsure:
                self._dome_samples = dome_samples(handle)
                if self._dome_samples:
                    glfw.destroy_window(handle)
                    return self.open_window(title, size, position, surface, events, share, shown=shown)
                if shown:
                    glfw.show_window(handle)
            if handle:
                window = ScreenWindow(handle, attempt, events)
                self._windows.append(window)
                if position is not None:
                    window.move(*position)
                return window
        raise ScreenError(f"no window could be opened: {'; '.join(failures)}")

    def poll(self, timeout: float) -> None:
        """Deliver what happened; wait at most timeout seconds for something."""
        if timeout > 0:
            glfw.wait_events_timeout(timeout)
        else:
            glfw.poll_events()

    @property
    def joysticks(self) -> tuple[Joystick, ...]:
        """Those that are plugged in."""
        found = []
        for number in filter(glfw.joystick_present, range(glfw.JOYSTICK_1, glfw.JOYSTICK_LAST + 1)):
            axes, axis_count = glfw.get_joystick_axes(number)
            buttons, button_count = glfw.get_joystick_buttons(number)
            held = tuple(buttons[k] == glfw.PRESS for k in range(button_count))
            found.append(Joystick(tuple(float(axes[k]) for k in range(axis_count)), held))
        return tuple(found)

    @property
    def screen_size(self) -> tuple[int, int]:
        """Width and height of the main display in pixels."""
        return _monitor_size(glfw.get_primary_monitor())

    @property
    def screen_size_mm(self) -> tuple[int, int]:
        """Width and height of the main display in millimetres; 0 where it does not say."""
        monitor = glfw.get_primary_monitor()
        width, height = glfw.get_monitor_physical_size(monitor) if monitor else (0, 0)
        return int(width), int(height)

    def close(self) -> None:
        """Close all windows and leave the display."""
        for window in self._windows:
            window.close()
        self._windows.clear()
        glfw.terminate()


class ScreenWindow(Window):
    """One glfw window.

    A single-buffered format gets a single-buffered context where the driver has one; elsewhere the front
    buffer of a double-buffered one is drawn to and read from, which shows just as directly.
    """

    def __init__(self, handle: Any, surface: SurfaceFormat, events: WindowEvents) -> None:
        self.handle = handle
        self.events = events
        self._windowed: tuple[int, int, int, int] | None = None
        self._listen()
        self.make_current()
        self.format = replace(surface, samples=int(GL.glGetIntegerv(GL.GL_SAMPLES)))
        if not surface.double_buffer and GL.glGetBooleanv(GL.GL_DOUBLEBUFFER):
            GL.glDrawBuffer(GL.GL_FRONT)
            GL.glReadBuffer(GL.GL_FRONT)

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the frame buffer in pixels."""
        width, height = glfw.get_framebuffer_size(self.handle)
        return int(width), int(height)

    @property
    def position(self) -> tuple[int, int]:
        """The content's top left corner on the screen; (0, 0) where the display does not tell (Wayland)."""
        with complaints():
            x, y = glfw.get_window_pos(self.handle)
        return int(x), int(y)

    def make_current(self) -> None:
        """Direct the GL calls of this thread to this window."""
        glfw.make_context_current(self.handle)

    def swap_buffers(self) -> None:
        """Show what was drawn; a single-buffered window is flushed, which shows it."""
        if self.format.double_buffer:
            glfw.swap_buffers(self.handle)
        else:
            GL.glFinish()

    def resize(self, width: int, height: int) -> None:
        """Ask the window manager for that size."""
        glfw.set_window_size(self.handle, width, height)

    def move(self, x: int, y: int) -> None:
        """Put the content's top left corner there; Wayland ignores it."""
        with complaints():
            glfw.set_window_pos(self.handle, x, y)

    def set_title(self, title: str) -> None:
        """Name the window."""
        glfw.set_window_title(self.handle, title)

    def set_visible(self, visible: bool) -> None:
        """Show or hide the window."""
        (glfw.show_window if visible else glfw.hide_window)(self.handle)
        self.events.visibility_changed(visible)

    def put(self, *, highest: bool) -> bool:
        """Put the window over all others, or under them; False on Wayland, which lets no program do so."""
        if glfw.get_platform() != glfw.PLATFORM_X11:
            return False
        order_on_x11(self.handle, highest=highest)
        return True

    def iconify(self) -> None:
        """Shrink the window to an icon."""
        glfw.iconify_window(self.handle)

    def set_full_screen(self, full: bool, display: int = 0) -> None:
        """Cover the display of that number, or go back to the former size and place.

        Raises ScreenError where there is no display of that number.
        """
        if not full:
            if self._windowed is not None:
                windowed: Any = None  # glfw's stubs know no way back from a monitor
                glfw.set_window_monitor(self.handle, windowed, *self._windowed, glfw.DONT_CARE)
                self._windowed = None
            return
        monitors = glfw.get_monitors()
        if not 0 <= display < len(monitors):
            raise ScreenError(f"there is no display {display}: {len(monitors)} found, counted from 0")
        if self._windowed is None:
            self._windowed = (*self.position, *glfw.get_window_size(self.handle))
        mode = glfw.get_video_mode(monitors[display])
        glfw.set_window_monitor(
            self.handle, monitors[display], 0, 0, mode.size.width, mode.size.height, mode.refresh_rate
        )

    def set_cursor(self, shape: str) -> None:
        """Show one of the contract's shapes."""
        if shape == "none":
            glfw.set_input_mode(self.handle, glfw.CURSOR, glfw.CURSOR_HIDDEN)
            return
        glfw.set_input_mode(self.handle, glfw.CURSOR, glfw.CURSOR_NORMAL)
        glfw.set_cursor(self.handle, glfw.create_standard_cursor(_CURSORS[shape]))

    def set_vsync(self, on: bool) -> None:
        """Show pictures in step with the display, or at once; the window must be current."""
        glfw.swap_interval(int(on))

    def warp_pointer(self, x: float, y: float) -> None:
        """Put the pointer at (x, y) of the window."""
        scale_x, scale_y = self._scale()
        glfw.set_cursor_pos(self.handle, x / scale_x, y / scale_y)

    def close(self) -> None:
        """Destroy the window and its context; safe to call twice."""
        if self.handle is not None:
            glfw.destroy_window(self.handle)
            self.handle = None

    def _scale(self) -> tuple[float, float]:
        """Return how many pixels one of the screen's units is; not 1 on some high-density displays."""
        wide, high = glfw.get_window_size(self.handle)
        width, height = self.size
        return (width / wide, height / high) if wide and high else (1.0, 1.0)

    def _listen(self) -> None:
        """Pass glfw's events on as the contract's."""
        handle = self.handle
        glfw.set_framebuffer_size_callback(handle, lambda _, *size: self.events.resized(*size))
        glfw.set_window_refresh_callback(handle, lambda _: self.events.exposed())
        glfw.set_window_close_callback(handle, self._close_asked)
        glfw.set_window_pos_callback(handle, lambda _, x, y: self.events.moved(x, y))
        glfw.set_window_iconify_callback(handle, lambda _, icon: self.events.visibility_changed(not icon))
        glfw.set_key_callback(handle, self._key)
        glfw.set_char_callback(handle, lambda _, codepoint: self.events.character(codepoint))
        glfw.set_cursor_pos_callback(handle, self._pointer)
        glfw.set_cursor_enter_callback(handle, lambda _, inside: self.events.pointer_entered(bool(inside)))
        glfw.set_mouse_button_callback(handle, self._button)
        glfw.set_scroll_callback(handle, lambda _, dx, dy: self.events.wheel(dx, dy))

    def _close_asked(self, handle: Any) -> None:
        glfw.set_window_should_close(handle, False)
        self.events.close_asked()

    def _key(self, _: Any, key: int, scancode: int, action: int, modifiers: int) -> None:
        # glfw numbers keys by their place on a US keyboard; a letter shall go by what is written on it.
        name = glfw.get_key_name(key, scancode) if glfw.KEY_A <= key <= glfw.KEY_Z else None
        if name and len(name) == 1 and name.isascii():
            key = ord(name.upper())
        self.events.key(key, action != glfw.RELEASE, modifiers)

    def _pointer(self, _: Any, x: float, y: float) -> None:
        scale_x, scale_y = self._scale()
        self.events.pointer_moved(x * scale_x, y * scale_y)

    def _button(self, _: Any, button: int, action: int, modifiers: int) -> None:
        self.events.button(button, action == glfw.PRESS, modifiers)


def _monitor_size(monitor: Any) -> tuple[int, int]:
    if not monitor:
        return 0, 0
    mode = glfw.get_video_mode(monitor)
    return int(mode.size.width), int(mode.size.height)
