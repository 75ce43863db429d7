"""All that GLUT remembers in one run: windows, callbacks, timers, menus, and how the next window shall be."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from domeshim import session as sessions
from domeshim.GLUT import constants as c
from domeshim.GLUT.arguments import Callback
from domeshim.GLUT.complaints import fatal, warn
from domeshim.window.contract import Window

_PLAIN_CONTEXT = {"major": 1, "minor": 0, "flags": 0, "profile": 0}


@dataclass(eq=False)
class GlutWindow:
    """One of the program's windows."""

    number: int
    surface: Window
    size: tuple[int, int]
    """Width and height in the program's own pixels."""
    asked_mode: int
    """The display mode it was opened with."""
    parent: int = 0
    """The number of the window around it, 0 for none."""
    children: list[GlutWindow] = field(default_factory=list)
    """The windows inside it, the lowest first."""
    fixed: bool = False
    """The surface has a size of its own, whatever the program's size is: DOME_FRAME, DOME_DISPLAY, inside."""
    callbacks: dict[str, Callback] = field(default_factory=dict)
    menus: dict[int, int] = field(default_factory=dict)
    """Which menu opens on which of GLUT's mouse buttons."""
    joystick_interval: float = 0.0
    """Seconds after which its joystick callback is called again; 0: never by itself."""
    joystick_due: float = 0.0
    """When that is next, on the session's clock."""
    redisplay: bool = False
    visible: bool = True
    full_screen: bool = False
    ignore_repeat: bool = False
    pointer: tuple[int, int] = (0, 0)
    """In the pixels that the program believes in."""
    pixel: tuple[int, int] = (0, 0)
    """The same place in the real window; of outermost windows."""
    buttons: set[int] = field(default_factory=set)
    """GLUT's numbers of the mouse buttons held down."""
    keys: dict[int, tuple[str, Any]] = field(default_factory=dict)
    """Held keys by glfw's number: which callback family they went to and what it was told."""
    typing: int | None = None
    """The key whose character is about to come."""
    modifiers: int = 0
    """GLUT_ACTIVE_... at the last key or button."""
    turned: list[float] = field(default_factory=lambda: [0.0, 0.0])
    """Parts of a notch by which each wheel has turned and no callback has heard of."""
    pointed: GlutWindow | None = None
    """Which of it and the windows inside it the pointer is over; of outermost windows."""
    picture: NDArray[np.uint8] | None = None
    """Its last finished picture, (height, width, 3), the top row first; of windows with others inside."""
    fresh: bool = False
    """That has not been shown yet."""
    stale: bool = False
    """What lies inside it has changed its place, so it must be shown anew; of outermost windows."""
    told_size: tuple[int, int] | None = None
    """The size that the last reshape callback was given."""
    cursor: int = c.GLUT_CURSOR_INHERIT
    data: Any = None


@dataclass
class Menu:
    """One pop-up menu; items are (label, value) or (label, the submenu's number) with the flag set."""

    number: int
    chosen: Callback
    items: list[tuple[str, int, bool]] = field(default_factory=list)
    destroyed: Callback | None = None
    data: Any = None


@dataclass(order=True)
class Timer:
    """A function to be called once at a moment of the session's clock."""

    due: float
    order: int
    function: Callback = field(compare=False)
    value: int = field(compare=False)


@dataclass
class GlutState:
    """GLUT's memory; one in each session."""

    initialised: bool = False
    program: str = "foo"
    began: float = 0.0
    display_mode: int = c.GLUT_DEPTH
    samples: int = 4
    init_size: tuple[int, int] = (300, 300)
    init_position: tuple[int, int] = (-1, -1)
    iconic: bool = False
    context: dict[str, int] = field(default_factory=lambda: dict(_PLAIN_CONTEXT))
    options: dict[int, int] = field(default_factory=dict)
    windows: dict[int, GlutWindow] = field(default_factory=dict)
    """The open windows, in the order of opening."""
    closing: list[GlutWindow] = field(default_factory=list)
    """Destroyed by the program, to be closed when this round of the main loop is over."""
    current: GlutWindow | None = None
    next_window: int = 1
    idle: Callback | None = None
    menu_state: Callback | None = None
    menu_status: Callback | None = None
    timers: list[Timer] = field(default_factory=list)
    """A heap, the next one first."""
    timers_made: int = 0
    menus: dict[int, Menu] = field(default_factory=dict)
    menu: Menu | None = None
    next_menu: int = 1
    open_menu: Any = None
    """What is drawn over a window while a menu is open, or None."""
    modifiers: int | None = None
    """The modifier keys of the event whose callback runs, or None outside those callbacks."""
    owns_joystick: bool = False
    """The program has asked for joysticks."""
    key_repeat: int = c.GLUT_KEY_REPEAT_ON
    game_mode: dict[str, int] = field(default_factory=dict)
    game_window: GlutWindow | None = None
    before_game: GlutWindow | None = None
    events: deque[tuple[GlutWindow, str, tuple[Any, ...]]] = field(default_factory=deque)
    """What happened to windows and has not been dispatched yet."""
    running: bool = False
    last_frame: tuple[int, float] = (0, 0.0)
    """How many pictures were finished when that was last looked at, and when the last one was."""
    on_error: Callback | None = None
    on_warning: Callback | None = None
    said: set[str] = field(default_factory=set)

    def say_once(self, words: str) -> None:
        """Tell the user of something that this GLUT does otherwise, the first time only."""
        if words not in self.said:
            self.said.add(words)
            warn(self.program, words)

    def warn(self, words: str) -> None:
        """Tell of a misuse that freeglut only warns of."""
        if self.on_warning is not None:
            self.on_warning(words.encode(), None)
        else:
            warn(self.program, words)

    def fail(self, words: str) -> None:
        """End the program, as freeglut does, unless it has its own function for errors."""
        if self.on_error is None:
            fatal(self.program, words)
        self.on_error(words.encode(), None)
        raise SystemExit(1)


def glut_state() -> GlutState:
    """Return the GLUT of the running session, made on first use."""
    session = sessions.current()
    if session.glut is None:
        session.glut = GlutState(began=session.clock.now())
    return session.glut


def initialised_state(function: str) -> GlutState:
    """Return the state, or end the program with one line where glutInit was not called before."""
    state = glut_state()
    if not state.initialised:
        state.fail(f"Function <{function}> called without first calling 'glutInit'.")
    return state


def current_window(function: str) -> GlutWindow:
    """Return the current window, or end the program with one line where there is none."""
    state = initialised_state(function)
    if state.current is None:
        state.fail(f"Function <{function}> called with no current window defined.")
    assert state.current is not None
    return state.current
