"""Pop-up menus off screen; the screen's events are put in by hand."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from domeshim import GLUT
from domeshim.GLUT.popup import LETTER, MARGIN, ROW
from domeshim.GLUT.state import GlutWindow
from domeshim.session import Session
from domeshim.window.contract import WindowEvents
from tests.GLUT.program_runs import run_off_screen


def hear(log: list[tuple[Any, ...]]) -> list[tuple[Any, ...]]:
    GLUT.glutMainLoopEvent()
    heard = log.copy()
    log.clear()
    return heard


def menu_rows(heard: list[Any]) -> tuple[int, int]:
    """Make a menu of two entries and a submenu of one, on the right button; return both numbers."""
    inner = GLUT.glutCreateMenu(lambda value: heard.append(("inner", value)))
    GLUT.glutAddMenuEntry(b"deep", 30)
    outer = GLUT.glutCreateMenu(lambda value: heard.append(("outer", value)))
    GLUT.glutAddMenuEntry("first", 10)
    GLUT.glutAddMenuEntry("second", 20)
    GLUT.glutAddSubMenu("more", inner)
    GLUT.glutAttachMenu(GLUT.GLUT_RIGHT_BUTTON)
    return inner, outer


def click(screen: WindowEvents, x: float, y: float, button: int = 0) -> None:
    screen.pointer_moved(x, y)
    screen.button(button, True, 0)
    screen.button(button, False, 0)


def test_a_menu_opens_is_chosen_from_and_closes(screen: WindowEvents, log: list[Any]) -> None:
    menu_rows(log)
    GLUT.glutMenuStateFunc(lambda status: log.append(("state", status)))
    click(screen, 20, 30, button=1)
    click(screen, 30, 30 + 1.5 * ROW)
    assert [event for event in hear(log) if event[0] != "passive"] == [
        ("state", GLUT.GLUT_MENU_IN_USE),
        ("state", GLUT.GLUT_MENU_NOT_IN_USE),
        ("outer", 20),
        ("mouse", GLUT.GLUT_LEFT_BUTTON, GLUT.GLUT_UP, 30, 57, 0),
    ]


def test_a_menu_entry_is_chosen_by_releasing_the_button_over_it(screen: WindowEvents, log: list[Any]) -> None:
    menu_rows(log)
    screen.pointer_moved(20, 30)
    screen.button(1, True, 0)
    screen.pointer_moved(30, 30 + 1.5 * ROW)
    screen.button(1, False, 0)
    assert hear(log)[-1] == ("outer", 20)


def test_submenus_open_beside_their_entry(screen: WindowEvents, log: list[Any], window: GlutWindow) -> None:
    menu_rows(log)
    click(screen, 20, 30, button=1)
    screen.pointer_moved(30, 30 + 2.5 * ROW)
    GLUT.glutMainLoopEvent()
    from domeshim import session as sessions

    glut = sessions.current().glut
    assert glut is not None
    pane = glut.open_menu.panes[1]
    click(screen, pane.x + 5, pane.y + 5)
    assert ("inner", 30) in hear(log)
    assert glut.open_menu is None


def test_a_press_beside_the_menu_closes_it_and_tells_nothing(screen: WindowEvents, log: list[Any]) -> None:
    menu_rows(log)
    click(screen, 20, 30, button=1)
    click(screen, 250, 190)
    click(screen, 20, 31)
    assert [event[0] for event in hear(log) if event[0] != "passive"] == ["mouse", "mouse", "mouse"]


def test_an_open_menu_is_drawn_and_leaves_no_trace_in_gl(screen: WindowEvents, log: list[Any]) -> None:
    from OpenGL import GL

    pictures: list[Any] = []

    def display() -> None:
        GL.glColorMask(1, 1, 1, 1)
        GL.glClearColor(0, 0, 0, 1)
        GL.glClear(GL.GL_COLOR_BUFFER_BIT)
        GL.glColorMask(1, 0, 0, 1)
        GLUT.glutSwapBuffers()
        pixels = GL.glReadPixels(0, 0, 256, 192, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
        pictures.append(np.frombuffer(pixels, np.uint8).reshape(192, 256, 3)[::-1])

    GLUT.glutDisplayFunc(display)
    menu_rows(log)
    GL.glMatrixMode(GL.GL_TEXTURE)
    GL.glEnable(GL.GL_LIGHTING)
    click(screen, 20, 30, button=1)
    GLUT.glutMainLoopEvent()
    assert pictures[-1][31, 22].tolist() == [191, 191, 191]  # three quarters of white
    assert (pictures[-1][30:48, 26:66] == 0).any()  # letters
    assert pictures[-1][29, 22].tolist() == [0, 0, 0]
    assert GL.glGetIntegerv(GL.GL_MATRIX_MODE) == GL.GL_TEXTURE
    assert GL.glIsEnabled(GL.GL_LIGHTING)
    assert GL.glGetBooleanv(GL.GL_COLOR_WRITEMASK).tolist() == [1, 0, 0, 1]
    click(screen, 250, 190)
    GLUT.glutMainLoopEvent()
    assert not pictures[-1].any()


def test_an_open_menu_is_drawn_in_a_single_buffered_window_as_well(glut_session: Session) -> None:
    from OpenGL import GL

    GLUT.glutInit()
    GLUT.glutInitDisplayMode(GLUT.GLUT_SINGLE)
    GLUT.glutCreateWindow("single")
    GLUT.glutDisplayFunc(lambda: GL.glClear(GL.GL_COLOR_BUFFER_BIT))
    menu_rows([])
    assert glut_session.glut is not None
    assert glut_session.glut.current is not None
    click(glut_session.glut.current.surface.events, 20, 30, button=1)
    GLUT.glutMainLoopEvent()
    assert list(GL.glReadPixels(22, 191 - 31, 1, 1, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)) == [191, 191, 191]


def test_menus_can_be_changed(window: GlutWindow) -> None:
    heard: list[Any] = []
    inner, outer = menu_rows(heard)
    assert GLUT.glutGetMenu() == outer
    assert GLUT.glutGet(GLUT.GLUT_MENU_NUM_ITEMS) == 3
    GLUT.glutChangeToMenuEntry(3, "plain", 40)
    GLUT.glutRemoveMenuItem(1)
    GLUT.glutChangeToSubMenu(1, "deeper", inner)
    assert GLUT.glutGet(GLUT.GLUT_MENU_NUM_ITEMS) == 2
    GLUT.glutMenuDestroyFunc(lambda: heard.append("gone"))
    GLUT.glutDestroyMenu(outer)
    assert heard == ["gone"]
    assert GLUT.glutGetMenu() == 0
    assert window.menus == {}
    GLUT.glutSetMenu(inner)
    assert GLUT.glutGetMenu() == inner


ON_DOME = """
from OpenGL.GL import *
from OpenGL.GLU import *
from domeshim.GLUT import *
from domeshim import session
import numpy as np

def display():
    glClearColor(0, 0, 0.5, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glLoadIdentity()
    gluPerspective(40, 1, 0.1, 10)
    glRectf(-0.1, -0.1, 0.1, 0.1)
    glutSwapBuffers()

glutInit()
glutInitWindowSize(300, 300)
glutCreateWindow("menu")
glutDisplayFunc(display)
chosen = []
glutCreateMenu(chosen.append)
glutAddMenuEntry("first entry", 1)
glutAddMenuEntry("second", 2)
glutAttachMenu(GLUT_RIGHT_BUTTON)
glutMainLoopEvent()
surface = session.current().glut.current.surface
surface.events.pointer_moved(150, 180)
surface.events.button(1, True, 0)
surface.events.button(1, False, 0)
glutMainLoopEvent()
from domeshim.measure.pixels import read_pixels
picture = np.frombuffer(read_pixels(300, 300), np.uint8).reshape(300, 300, 3)
grey = (picture == 191).all(-1)
rows, columns = np.nonzero(grey)
surface.events.pointer_moved(160, 180 + 27)
surface.events.button(0, True, 0)
surface.events.button(0, False, 0)
glutMainLoopEvent()
print(*(int(k) for k in (rows.min(), rows.max() + 1, columns.min(), columns.max() + 1)), chosen)
"""


def test_on_a_dome_a_menu_is_as_large_as_on_the_monitor_and_hears_the_mouse_where_it_is(
    tmp_path: Path,
) -> None:
    done = run_off_screen(tmp_path, ON_DOME, "enabled=True")
    assert done.returncode == 0, done.stderr
    width = (len("first entry") + 2) * LETTER + 2 * MARGIN
    assert done.stdout.split() == [*map(str, (180, 180 + 2 * ROW, 150, 150 + width)), "[2]"]
