"""pygame: set_mode(OPENGL) opens the window, flip() finishes a picture, and SDL resizes behind the scenes."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from types import ModuleType
from typing import TYPE_CHECKING, Any

from domeshim.intercept.toolkits.pygame_time import PygameTimers
from domeshim.intercept.toolkits.windows import ToolkitHost, ToolkitWindow
from domeshim.window.contract import SurfaceFormat, Window, WindowEvents
from domeshim.window.dome_keys import DOME_KEYS

if TYPE_CHECKING:
    from domeshim.session import Session

_FULLSCREEN, _OPENGL, _RESIZABLE, _SCALED = -0x80000000, 0x2, 0x10, 0x200
_ALPHA, _DOUBLEBUFFER, _DEPTH, _STENCIL, _STEREO = 3, 5, 6, 7, 12
_ACCUMULATION = (8, 9, 10, 11)
_SAMPLE_BUFFERS, _SAMPLES = 13, 14
_FLAGS, _PROFILE = 20, 21
_FORWARD_COMPATIBLE, _CORE, _ES = 2, 1, 4
_POINTING = (0x400, 0x401, 0x402)
"""SDL's mouse motion, button down and button up."""
_NO_EVENT, _KEY_DOWN, _KEY_UP = 0, 0x300, 0x301
_DOME_KEYS = {ord(chr(key).lower()): key for key in DOME_KEYS}
"""The dome's keys by pygame's numbers."""
_TYPES = (
    *(*range(0x100, 0x110), *range(0x150, 0x153), *range(0x200, 0x202), *range(0x300, 0x306)),
    *(*range(0x400, 0x405), *range(0x600, 0x660), *range(0x700, 0x703), *range(0x800, 0x803)),
    *(*range(0x900, 0x902), *range(0x1000, 0x1006), 0x1100, 0x1101, *range(0x8000, 0x8200)),
)
"""SDL's and pygame's types of events, and the first of a program's own."""
_MODIFIERS = {1: 0x3, 2: 0xC0, 4: 0x300, 8: 0xC00}
"""SDL's bits of Shift, Control, Alt and Super, left and right, by glfw's."""
_DEFAULTS = {_DEPTH: 16, _DOUBLEBUFFER: 1}
"""What SDL gives to a program that has not called gl_set_attribute."""


class PygameToolkit(ToolkitHost):
    """The one window that pygame has."""

    def __init__(self, session: Session) -> None:
        super().__init__(session, "pygame")
        self._asked = dict(_DEFAULTS)
        """What the program asked of GL by gl_set_attribute, by SDL's numbers."""
        self._window: Window | None = None
        self._told_size = (0, 0)
        self._display: Mapping[str, Any] = {}
        self._event: Mapping[str, Any] = {}
        self._mouse: Mapping[str, Any] = {}
        self._timers = PygameTimers(session, self._event_waits)

    def replacements(self, name: str, module: ModuleType) -> dict[str, Any]:
        """Our names for pygame.display, pygame.event, pygame.mouse or pygame.time."""
        part = name.rpartition(".")[2]
        originals = dict(vars(module))
        if part == "display":
            self._display = originals
            given = {"gl_get_attribute": self.gl_get_attribute, "update": self.update}
            return {
                "set_mode": self.set_mode,
                "flip": self.flip,
                "quit": self.quit,
                "gl_set_attribute": self.gl_set_attribute,
            } | (given if self.gives_windows else {})
        if part == "event":
            self._event = self._timers.event = originals
            ours = {name: self._pumping(originals[name]) for name in ("get", "poll", "pump")}
            return ours | {"wait": self.wait}
        if part == "mouse":
            self._mouse = originals
            return {"get_pos": self.get_pos, "set_pos": self.set_pos}
        return {"set_timer": self._timers.set} if self.session.clock.virtual else {}

    # pygame.display.

    def set_mode(self, *args: Any, **named: Any) -> Any:
        """Open pygame's window, or give it another size; one without OPENGL is none of ours."""
        size = args[0] if args else named.pop("size", (0, 0))
        flags = args[1] if len(args) > 1 else named.pop("flags", 0)
        rest = args[2:]
        if not flags & _OPENGL:
            return self._display["set_mode"](size, flags, *rest, **named)
        known = self._window if self._display["get_surface"]() is not None else None
        if self.gives_windows:
            surface = self._set_given_mode(known, size, flags, rest, named)
        else:
            surface = self._set_own_mode(known, size, flags, rest, named)
        return surface

    def _set_own_mode(
        self, known: Window | None, size: Any, flags: int, rest: tuple[Any, ...], named: dict[str, Any]
    ) -> Any:
        set_mode = self._display["set_mode"]
        if known is not None:
            surface = set_mode(size, flags, *rest, **named)
            self._look_at_size()
            return surface
        surface = self._with_samples(lambda: set_mode(size, flags, *rest, **named))
        self._told_size = self._display["get_window_size"]()
        self._window = ToolkitWindow(self._display["get_window_size"], self._display["flip"])
        self.opened(self._window, self._told_size)
        return surface

    def _with_samples(self, opening: Callable[[], Any]) -> Any:
        """Open a window that smooths edges if the program asks for none, the driver has it and it suits."""
        if not self.samples_wished or _SAMPLES in self._asked or _SAMPLE_BUFFERS in self._asked:
            return opening()
        from domeshim.window.probe import probed_samples  # noqa: PLC0415 - brings all of GL with it

        samples = probed_samples()
        if not samples:
            return opening()
        if not self._display["get_init"]():
            self._display["init"]()  # set_mode would, but too late for the samples
        put = self._display["gl_set_attribute"]
        put(_SAMPLE_BUFFERS, 1)
        put(_SAMPLES, samples)
        try:
            return opening()
        except Exception:  # noqa: BLE001,RUF100 - pygame.error; asked again as the program did, it may go well
            put(_SAMPLE_BUFFERS, 0)
            put(_SAMPLES, 0)
            return opening()

    def _set_given_mode(
        self, known: Window | None, size: Any, flags: int, rest: tuple[Any, ...], named: dict[str, Any]
    ) -> Any:
        """The window is the session's; pygame, without a display, keeps one for its events."""
        real = self.session.window_size or tuple(size)
        surface = self._display["set_mode"](real, flags & ~(_OPENGL | _FULLSCREEN | _SCALED), *rest, **named)
        real = surface.get_size()
        if known is None:
            self._window = self.session.backend.open_window("", real, None, self._format(), WindowEvents())
            self._window.asked = tuple(size) if self.session.window_size not in (None, tuple(size)) else None
            core = bool(self._asked.get(_PROFILE, 0) & (_CORE | _ES))
            forward = bool(self._asked.get(_FLAGS, 0) & _FORWARD_COMPATIBLE)
            self._told_size = real
            self.opened(self._window, real, core=core or forward)
        elif known.size != real:
            known.resize(*real)
            self._look_at_size()
        if flags & _RESIZABLE and real != tuple(size):
            self._post("VIDEORESIZE", size=real, w=real[0], h=real[1])
        return surface

    def _format(self) -> SurfaceFormat:
        asked = self._asked
        samples = asked.get(_SAMPLES, 0) if _SAMPLES in asked else self.samples_wished
        return SurfaceFormat(
            depth=asked[_DEPTH] > 0,
            stencil=asked.get(_STENCIL, 0) > 0,
            alpha=asked.get(_ALPHA, 0) > 0,
            accumulation=any(asked.get(name, 0) for name in _ACCUMULATION),
            stereo=bool(asked.get(_STEREO, 0)),
            samples=samples,
        )

    def flip(self) -> None:
        """Finish the picture; a window without OPENGL is shown as ever."""
        if self._window is None or self._display["get_surface"]() is None:
            self._display["flip"]()
            return
        self.finished(self._window)
        self._look_at_size()

    def update(self, *args: Any) -> None:
        """pygame's own refusal on an OPENGL window, which without a display it would not know for one."""
        if self._window is None:
            self._display["update"](*args)
        else:
            raise self._display["error"]("Cannot update an OPENGL display")

    def quit(self) -> None:
        """Close the window."""
        window, self._window = self._window, None
        if window is not None:
            self.session.window_closed(window)
            window.close()
        self._display["quit"]()

    def gl_set_attribute(self, flag: int, value: int) -> None:
        """Remember what the program asks for, and pass it on."""
        self._asked[flag] = value
        self._display["gl_set_attribute"](flag, value)

    def gl_get_attribute(self, flag: int) -> int:
        """What the session's window was asked for, which it has."""
        return self._asked.get(flag, 0)

    def _look_at_size(self) -> None:
        """Tell the session if the window's size has changed."""
        window = self._window
        if window is None or self._display["get_surface"]() is None:
            return
        size = window.size
        if size != self._told_size:
            self._told_size = size
            self.session.window_resized(window, size)

    # pygame.event.

    def _pumping(self, original: Callable[..., Any]) -> Callable[..., Any]:
        """The call, in which SDL hears of the window's new size."""

        def call(*args: Any, **named: Any) -> Any:
            self._timers.turn()
            result = original(*args, **named)
            self._look_at_size()
            if isinstance(result, list):
                return [event for event in result if self._passes(event)]
            return result if self._passes(result) else self._event["Event"](_NO_EVENT)

        return call

    def wait(self, *args: Any, **named: Any) -> Any:
        """Wait for an event; on a clock that counts pictures none will come: a new picture is asked for."""
        if not self.session.clock.virtual:
            event = self._event["wait"](*args, **named)
            self._look_at_size()
            return event if self._passes(event) else self._event["Event"](_NO_EVENT)
        self._timers.turn()
        if not self._event_waits():
            self._post("VIDEOEXPOSE")
        event = self._event["poll"]()
        return event if self._passes(event) else self._event["Event"](_NO_EVENT)

    def _event_waits(self) -> bool:
        """An event is in the queue. pygame 2.6's peek() for any would take a reference from a posted one."""
        return bool(self._event["peek"](_TYPES))

    def _passes(self, event: Any) -> bool:
        """Make an event the program's; False for a key of the dome's."""
        if event is None:
            return True
        if event.type in (_KEY_DOWN, _KEY_UP) and getattr(event, "key", None) in _DOME_KEYS:
            held = getattr(event, "mod", 0)
            modifiers = sum(bit for bit, mask in _MODIFIERS.items() if held & mask)
            if self.is_domes(self._window, _DOME_KEYS[event.key], modifiers, down=event.type == _KEY_DOWN):
                return False
        self._place(event)
        return True

    # pygame.mouse.

    def _place(self, event: Any) -> None:
        """Let an event of the mouse say where it is on the monitor; rel stays the hand's own movement."""
        if event is not None and event.type in _POINTING:
            event.pos = self._program_place(event.pos)

    def _program_place(self, place: Sequence[int]) -> tuple[int, int]:
        if self._window is None:
            return place[0], place[1]
        x, y = self.program_place(self._window, place[0] + 0.5, place[1] + 0.5)
        return math.floor(x), math.floor(y)

    def get_pos(self) -> tuple[int, int]:
        """Where the pointer is, in the program's pixels; as SDL says it, (0, 0) until it first moves."""
        place = self._mouse["get_pos"]()
        return self._program_place(place) if any(place) else (0, 0)

    def set_pos(self, *place: Any) -> None:
        """Put the pointer where the dome has that pixel of the program's."""
        x, y = place[0] if len(place) == 1 else place
        if self._window is not None:
            width, height = self._window.size
            x, y = self.window_place(self._window, x + 0.5, y + 0.5)
            x, y = max(0, min(math.floor(x), width - 1)), max(0, min(math.floor(y), height - 1))
        self._mouse["set_pos"](x, y)

    def _post(self, name: str, **attributes: Any) -> None:
        import pygame  # noqa: PLC0415 - it is the program's, and there

        pygame.event.post(pygame.event.Event(getattr(pygame, name), **attributes))
