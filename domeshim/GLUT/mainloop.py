"""The main loop: events, timers, pictures, idle, in freeglut's order, on the session's clock."""

from __future__ import annotations

import heapq
from typing import Any

from domeshim import session as sessions
from domeshim.GLUT import constants as c
from domeshim.GLUT.arguments import callback, integer
from domeshim.GLUT.closing import close_all, close_marked, closing_action
from domeshim.GLUT.dispatch import call, make_current
from domeshim.GLUT.families import shown
from domeshim.GLUT.joystick import next_joystick_time, tell_of_joysticks
from domeshim.GLUT.popup import draw_open_menu
from domeshim.GLUT.reactions import dispatch_events
from domeshim.GLUT.state import GlutState, GlutWindow, Timer, current_window, glut_state, initialised_state

LONGEST_WAIT = 0.1
"""Seconds after which a waiting loop lets Python hear of Ctrl-C."""
PATIENCE = 1.0
"""Virtual seconds without a picture after which one is asked for, as by a screen that lost the old one."""
_SAME_MOMENT = 1e-9


def glutMainLoop(*_more: object) -> None:
    """Serve the program until its last window is closed or it leaves the loop.

    Then the program ends with status 0, or goes on where it chose so by GLUT_ACTION_ON_WINDOW_CLOSE.
    """
    state = initialised_state("glutMainLoop")
    if not state.windows:
        state.fail("glutMainLoop called with no windows created.")
    state.running = True
    while state.running and state.windows:
        _round(state, _wait(state))
        if state.running and state.windows:
            idled = state.idle is not None
            if state.idle is not None:
                call(state, state.idle)
                _show_composed()
            _turn_virtual_clock(state, idled)
    state.running = False
    action = closing_action(state)
    close_all(state)
    sessions.current().glut = None
    if action == c.GLUT_ACTION_EXIT:
        raise SystemExit(0)


def glutMainLoopEvent(*_more: object) -> None:
    """Serve the program once, without waiting and without its idle callback."""
    state = initialised_state("glutMainLoopEvent")
    _round(state, 0.0)
    if state.windows:
        _turn_virtual_clock(state, idled=False)


def glutCheckLoop(*_more: object) -> None:
    """Serve the program once, as Apple's GLUT calls it."""
    glutMainLoopEvent()


def glutLeaveMainLoop(*_more: object) -> None:
    """End the main loop once this round is over."""
    initialised_state("glutLeaveMainLoop").running = False


def glutExit(*_more: object) -> None:
    """Close all windows; the program goes on."""
    close_all(glut_state())
    sessions.current().glut = None


def glutTimerFunc(milliseconds: Any, function: Any, value: Any) -> None:
    """Have function(value) called once, so many milliseconds from now."""
    state = initialised_state("glutTimerFunc")
    wait = integer("glutTimerFunc", "milliseconds", milliseconds) & 0xFFFFFFFF
    wanted = callback("glutTimerFunc", function)
    number = 0 if value is None else integer("glutTimerFunc", "value", value)
    if wanted is None:
        return
    state.timers_made += 1
    due = sessions.current().clock.now() + wait / 1000.0
    heapq.heappush(state.timers, Timer(due, state.timers_made, wanted, number))


def glutIdleFunc(function: Any) -> Any:
    """Have function() called whenever there is nothing else to do; None stops that."""
    state = initialised_state("glutIdleFunc")
    state.idle = callback("glutIdleFunc", function)
    return function


def glutSwapBuffers(*_more: object) -> None:
    """Show the current window's picture, which is finished also where there is but one buffer."""
    window = current_window("glutSwapBuffers")
    if window.surface.format.double_buffer and not window.children:  # else the menu is drawn over all of them
        draw_open_menu(glut_state(), window)
    sessions.current().swapped(window.surface)


def _round(state: GlutState, wait: float) -> None:
    sessions.current().backend.poll(wait)
    dispatch_events(state)
    tell_of_joysticks(state)
    _fire_timers(state)
    for window in list(state.windows.values()):
        if window.redisplay and shown(state, window) and window.number in state.windows:
            _display(state, window)
    _show_composed()
    close_marked(state)


def _show_composed() -> None:
    """Show the pictures that are made of several windows'."""
    parts = sessions.current().parts
    if parts is not None:
        parts.round_ended()


def _fire_timers(state: GlutState) -> None:
    """Call the timers that are due, not those that they set in turn: a timer of 0 ms must let others live."""
    now = sessions.current().clock.now() + _SAME_MOMENT
    due = []
    while state.timers and state.timers[0].due <= now:
        due.append(heapq.heappop(state.timers))
    for timer in due:
        call(state, timer.function, timer.value)


def _display(state: GlutState, window: GlutWindow) -> None:
    display = window.callbacks.get("display")
    if display is None:
        state.fail(f"No display callback registered for window {window.number}")
    assert display is not None
    session, former = sessions.current(), state.current
    window.redisplay = False
    make_current(state, window)
    session.display_begins(window.surface)
    call(state, display)
    if not (window.surface.format.double_buffer or window.children):
        draw_open_menu(state, window)
    session.display_ended(window.surface)
    if window.parent and not window.surface.format.double_buffer and not window.fresh:
        session.swapped(window.surface)  # where nobody watches the program's glFlush
    if former is not None and former.number in state.windows:
        make_current(state, former)  # as freeglut does after this callback alone


def _wait(state: GlutState) -> float:
    """Return for how many seconds nothing is known to happen."""
    clock = sessions.current().clock
    if clock.virtual or state.idle is not None or _work_pending(state):
        return 0.0
    moments = [state.timers[0].due if state.timers else None, next_joystick_time(state)]
    waits = [max(moment - clock.now(), 0.0) for moment in moments if moment is not None]
    return min([*waits, LONGEST_WAIT])


def _work_pending(state: GlutState) -> bool:
    return bool(state.events) or any(w.redisplay and shown(state, w) for w in state.windows.values())


def _turn_virtual_clock(state: GlutState, idled: bool) -> None:
    """Let a virtual clock go on where nothing else moves it: to the next timer, or 1 ms for an idle round.

    Where no picture comes of that, one is asked for: the user wants a later frame than this.
    """
    session = sessions.current()
    clock = session.clock
    if not clock.virtual:
        return
    if session.frames != state.last_frame[0]:
        state.last_frame = (session.frames, clock.now())
        return
    if _work_pending(state):
        return
    if idled:
        clock.advance_to(clock.now() + 0.001)
    elif state.timers:
        clock.advance_to(state.timers[0].due)
    if not (idled or state.timers) or clock.now() - state.last_frame[1] >= PATIENCE:
        _expose_all(state)


def _expose_all(state: GlutState) -> None:
    visible = [window for window in state.windows.values() if window.visible]
    if not visible:
        state.fail("all windows are hidden and no timer is set: there will never be another picture.")
    for window in visible:
        window.redisplay = True
