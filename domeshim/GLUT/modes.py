"""Game mode, overlays, video resizing and colour maps: what is left of them."""

from __future__ import annotations

import re
from typing import Any

from domeshim import session as sessions
from domeshim.GLUT import constants as c
from domeshim.GLUT.arguments import integer, real, text
from domeshim.GLUT.closing import mark_closed
from domeshim.GLUT.dispatch import make_current
from domeshim.GLUT.opening import open_window
from domeshim.GLUT.state import GlutState, current_window, glut_state, initialised_state
from domeshim.GLUT.windows import glutFullScreen

_GAME_MODE = re.compile(r"(?:(\d+)x(\d+))?(?::(\d+))?(?:@(\d+))?")


def glutGameModeString(string: Any, *_more: object) -> None:
    """Note the size, depth and rate that a game wants: "800x600:32@60"."""
    state = initialised_state("glutGameModeString")
    words = text("glutGameModeString", "string", string)
    found = _GAME_MODE.fullmatch(words.strip())
    if found is None:
        state.warn(f"glutGameModeString(): {words!r} is not WIDTHxHEIGHT:DEPTH@RATE")
        return
    state.game_mode = {
        name: int(number)
        for name, number in zip(("width", "height", "depth", "rate"), found.groups(), strict=True)
        if number
    }


def glutEnterGameMode(*_more: object) -> int:
    """Open a window over the whole screen and return its number; the screen's own resolution stays."""
    state = initialised_state("glutEnterGameMode")
    if state.game_window is not None:
        glutLeaveGameMode()
    state.before_game = state.current
    wanted = sessions.current().backend.screen_size
    size = (state.game_mode.get("width", wanted[0]), state.game_mode.get("height", wanted[1]))
    state.game_window = open_window(state, "", size, None)
    glutFullScreen()
    return state.game_window.number


def glutLeaveGameMode(*_more: object) -> None:
    """Close the window over the whole screen and go back to the one before."""
    state = initialised_state("glutLeaveGameMode")
    if state.game_window is None:
        return
    mark_closed(state, state.game_window)
    state.game_window = None
    if state.before_game is not None and state.before_game.number in state.windows:
        make_current(state, state.before_game)


def glutGameModeGet(query: Any, *_more: object) -> int:
    """Return what is known of the game mode: GLUT_GAME_MODE_ACTIVE and the like; -1 for anything else."""
    state = initialised_state("glutGameModeGet")
    number = integer("glutGameModeGet", "query", query)
    width, height = _game_size(state)
    answers = {
        c.GLUT_GAME_MODE_ACTIVE: int(state.game_window is not None),
        c.GLUT_GAME_MODE_POSSIBLE: 1,
        c.GLUT_GAME_MODE_WIDTH: width,
        c.GLUT_GAME_MODE_HEIGHT: height,
        c.GLUT_GAME_MODE_PIXEL_DEPTH: state.game_mode.get("depth", -1),
        c.GLUT_GAME_MODE_REFRESH_RATE: state.game_mode.get("rate", -1),
        c.GLUT_GAME_MODE_DISPLAY_CHANGED: 0,
    }
    return answers.get(number, -1)


def _game_size(state: GlutState) -> tuple[int, int]:
    if state.game_window is not None:
        return state.game_window.size
    return state.game_mode.get("width", -1), state.game_mode.get("height", -1)


# Overlays: glutLayerGet(GLUT_OVERLAY_POSSIBLE) says that there are none, as on all of today's screens.


def glutEstablishOverlay(*_more: object) -> None:
    """End the program: it asks for what glutLayerGet says is not there."""
    current_window("glutEstablishOverlay")
    glut_state().fail("glutEstablishOverlay(): there are no overlays.")


def glutRemoveOverlay(*_more: object) -> None:
    """Do nothing: there is no overlay."""
    current_window("glutRemoveOverlay")


def glutUseLayer(layer: Any, *_more: object) -> None:
    """Do nothing: the normal layer is the only one."""
    integer("glutUseLayer", "layer", layer)
    current_window("glutUseLayer")


def glutShowOverlay(*_more: object) -> None:
    """Do nothing: there is no overlay."""
    current_window("glutShowOverlay")


def glutHideOverlay(*_more: object) -> None:
    """Do nothing: there is no overlay."""
    current_window("glutHideOverlay")


def glutPostOverlayRedisplay(*_more: object) -> None:
    """Do nothing: there is no overlay."""
    current_window("glutPostOverlayRedisplay")


def glutPostWindowOverlayRedisplay(window: Any, *_more: object) -> None:
    """Do nothing: there is no overlay."""
    integer("glutPostWindowOverlayRedisplay", "window", window)


def glutSetupVideoResizing(*_more: object) -> int:
    """Return 0: video resizing went with the machines that had it."""
    return 0


def glutStopVideoResizing(*_more: object) -> None:
    """Do nothing: see glutSetupVideoResizing."""


def glutVideoResize(x: Any, y: Any, width: Any, height: Any, *_more: object) -> None:
    """Do nothing: see glutSetupVideoResizing."""


def glutVideoPan(x: Any, y: Any, width: Any, height: Any, *_more: object) -> None:
    """Do nothing: see glutSetupVideoResizing."""


def glutVideoResizeGet(query: Any, *_more: object) -> int:
    """Return 0, GLUT_VIDEO_RESIZE_POSSIBLE's answer among others: see glutSetupVideoResizing."""
    integer("glutVideoResizeGet", "query", query)
    return 0


def glutSetColor(color: Any, red: Any, green: Any, blue: Any, *_more: object) -> None:
    """Do nothing but check: windows have no colour map."""
    integer("glutSetColor", "color", color)
    for name, value in (("red", red), ("green", green), ("blue", blue)):
        real("glutSetColor", name, value)
    current_window("glutSetColor")


def glutGetColor(color: Any, component: Any, *_more: object) -> float:
    """Return -1, as for any colour outside the map: windows have none."""
    integer("glutGetColor", "color", color)
    integer("glutGetColor", "component", component)
    current_window("glutGetColor")
    return -1.0


def glutCopyColormap(window: Any, *_more: object) -> None:
    """Do nothing but check: windows have no colour map."""
    integer("glutCopyColormap", "window", window)
    current_window("glutCopyColormap")
