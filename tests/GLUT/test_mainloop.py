"""The main loop off screen: order, timers, redisplays, the virtual clock."""

from __future__ import annotations

from typing import Any

import pytest

from domeshim import GLUT
from domeshim.session import Session


class Log(list[Any]):
    """What the program heard, with the virtual time in milliseconds."""

    def note(self, name: str, result: Any = None) -> Any:
        def heard(*args: Any) -> None:
            self.append((name, *args))
            if callable(result):
                result()

        return heard


def open_window(mode: int = GLUT.GLUT_DOUBLE) -> int:
    GLUT.glutInit()
    GLUT.glutInitDisplayMode(mode)
    return GLUT.glutCreateWindow(b"test")


def leave_after(pictures: int, also: Any = lambda: None) -> Any:
    left = [pictures]

    def display() -> None:
        also()
        GLUT.glutSwapBuffers()
        left[0] -= 1
        if left[0] <= 0:
            GLUT.glutLeaveMainLoop()

    return display


def run_loop() -> None:
    GLUT.glutSetOption(GLUT.GLUT_ACTION_ON_WINDOW_CLOSE, GLUT.GLUT_ACTION_GLUTMAINLOOP_RETURNS)
    GLUT.glutMainLoop()


def test_reshape_comes_before_the_first_display_and_idle_after_it(glut_session: Session) -> None:
    open_window()
    log = Log()
    GLUT.glutReshapeFunc(log.note("reshape"))
    GLUT.glutVisibilityFunc(log.note("visibility"))
    GLUT.glutTimerFunc(0, log.note("timer"), 5)
    GLUT.glutIdleFunc(log.note("idle", GLUT.glutPostRedisplay))
    GLUT.glutDisplayFunc(leave_after(2, log.note("display")))
    GLUT.glutCloseFunc(log.note("close"))
    run_loop()
    assert log == [
        ("reshape", 256, 192),
        ("visibility", GLUT.GLUT_VISIBLE),
        ("timer", 5),
        ("display",),
        ("idle",),
        ("display",),
        ("close",),
    ]


def test_several_redisplays_make_one_display(glut_session: Session) -> None:
    open_window()
    log = Log()

    def post_thrice() -> None:
        for _ in range(3):
            GLUT.glutPostRedisplay()
        GLUT.glutPostWindowRedisplay(GLUT.glutGetWindow())

    GLUT.glutIdleFunc(log.note("idle", post_thrice))
    GLUT.glutDisplayFunc(leave_after(3, log.note("display")))
    run_loop()
    assert log == [("display",), ("idle",), ("display",), ("idle",), ("display",)]


def test_a_redisplay_posted_in_display_is_for_the_next_round(glut_session: Session) -> None:
    open_window()
    log = Log()
    GLUT.glutIdleFunc(log.note("idle"))
    GLUT.glutDisplayFunc(leave_after(3, log.note("display", GLUT.glutPostRedisplay)))
    run_loop()
    assert [name for (name,) in log] == ["display", "idle", "display", "idle", "display"]


def test_picture_n_is_drawn_at_n_minus_one_sixtieths(glut_session: Session) -> None:
    open_window()
    times = Log()

    def look() -> None:
        times.append(GLUT.glutGet(GLUT.GLUT_ELAPSED_TIME))
        GLUT.glutPostRedisplay()

    GLUT.glutDisplayFunc(leave_after(40, look))
    run_loop()
    assert times == [n * 1000 // 60 for n in range(40)]
    assert glut_session.frames == 40


def test_the_virtual_clock_goes_to_the_next_timer_where_nothing_else_happens(glut_session: Session) -> None:
    open_window()
    times = Log()

    def tick(value: int) -> None:
        times.append((value, GLUT.glutGet(GLUT.GLUT_ELAPSED_TIME)))
        GLUT.glutPostRedisplay()
        GLUT.glutTimerFunc(500, tick, value + 1)

    GLUT.glutTimerFunc(500, tick, 1)
    GLUT.glutDisplayFunc(leave_after(4))
    run_loop()
    assert times == [(1, 500), (2, 1000), (3, 1500)]


def test_timers_of_a_sixtieth_keep_pictures_at_sixtieths(glut_session: Session) -> None:
    open_window()
    times = Log()

    def tick(value: int) -> None:
        GLUT.glutPostRedisplay()
        GLUT.glutTimerFunc(16, tick, 0)

    GLUT.glutTimerFunc(16, tick, 0)
    GLUT.glutDisplayFunc(leave_after(30, lambda: times.append(GLUT.glutGet(GLUT.GLUT_ELAPSED_TIME))))
    run_loop()
    assert all(abs(time - n * 1000 / 60) <= 17 for n, time in enumerate(times))
    assert times == sorted(set(times))


def test_timers_fire_in_the_order_of_their_moments_then_of_their_making(glut_session: Session) -> None:
    open_window()
    log = Log()
    for wait, value in ((30, 3), (10, 1), (20, 2), (10, None)):
        GLUT.glutTimerFunc(wait, log.note("timer"), value)
    GLUT.glutTimerFunc(40, lambda value: GLUT.glutLeaveMainLoop(), 0)
    GLUT.glutDisplayFunc(GLUT.glutSwapBuffers)
    run_loop()
    assert [value for _, value in log] == [1, 0, 2, 3]


def test_a_timer_of_no_time_lets_pictures_be_drawn(glut_session: Session) -> None:
    open_window()
    fired = Log()

    def again(value: int) -> None:
        fired.append(value)
        GLUT.glutPostRedisplay()
        GLUT.glutTimerFunc(0, again, value + 1)

    GLUT.glutTimerFunc(0, again, 0)
    GLUT.glutDisplayFunc(leave_after(5))
    run_loop()
    assert fired == [0, 1, 2, 3, 4]


@pytest.mark.parametrize("busy", ["nothing", "timer", "idle"])
def test_a_program_that_asks_for_no_picture_is_asked_for_one(glut_session: Session, busy: str) -> None:
    open_window()
    if busy == "timer":

        def again(value: int) -> None:
            GLUT.glutTimerFunc(100, again, 0)

        GLUT.glutTimerFunc(100, again, 0)
    if busy == "idle":
        GLUT.glutIdleFunc(lambda: None)
    GLUT.glutDisplayFunc(leave_after(3))
    run_loop()
    assert glut_session.frames == 3


def test_an_idle_that_waits_for_its_moment_gets_there(glut_session: Session) -> None:
    open_window()
    drawn = Log()

    def idle() -> None:
        if GLUT.glutGet(GLUT.GLUT_ELAPSED_TIME) >= 100 * len(drawn):
            GLUT.glutPostRedisplay()

    GLUT.glutIdleFunc(idle)
    GLUT.glutDisplayFunc(leave_after(4, lambda: drawn.append(GLUT.glutGet(GLUT.GLUT_ELAPSED_TIME))))
    run_loop()
    assert drawn == [0, 100, 200, 300]


def test_main_loop_event_runs_no_idle(glut_session: Session) -> None:
    open_window()
    log = Log()
    GLUT.glutIdleFunc(log.note("idle"))
    GLUT.glutDisplayFunc(log.note("display", GLUT.glutSwapBuffers))
    GLUT.glutMainLoopEvent()
    GLUT.glutMainLoopEvent()
    GLUT.glutPostRedisplay()
    GLUT.glutMainLoopEvent()
    assert log == [("display",), ("display",)]


def test_windows_are_served_each_with_itself_current(glut_session: Session) -> None:
    first = open_window()
    drawn = Log()

    def display() -> None:
        drawn.append(GLUT.glutGetWindow())
        GLUT.glutSwapBuffers()

    GLUT.glutDisplayFunc(display)
    second = GLUT.glutCreateWindow("second")
    GLUT.glutDisplayFunc(display)
    GLUT.glutMainLoopEvent()
    GLUT.glutPostWindowRedisplay(first)
    GLUT.glutMainLoopEvent()
    GLUT.glutSetWindow(second)
    GLUT.glutPostRedisplay()
    GLUT.glutMainLoopEvent()
    assert drawn == [first, second, first, second]
    GLUT.glutDestroyWindow(first)
    GLUT.glutPostRedisplay()
    GLUT.glutMainLoopEvent()
    assert drawn[4:] == [second]
    assert GLUT.glutGetWindow() == second


def test_hidden_windows_are_not_displayed_until_shown(glut_session: Session) -> None:
    open_window()
    log = Log()
    GLUT.glutDisplayFunc(log.note("display", GLUT.glutSwapBuffers))
    GLUT.glutVisibilityFunc(log.note("visibility"))
    GLUT.glutMainLoopEvent()
    GLUT.glutHideWindow()
    GLUT.glutPostRedisplay()
    GLUT.glutTimerFunc(0, lambda value: GLUT.glutShowWindow(), 0)
    GLUT.glutMainLoopEvent()
    GLUT.glutMainLoopEvent()
    assert log == [("visibility", 1), ("display",), ("visibility", 0), ("visibility", 1), ("display",)]
