"""A menu while it is open: where its panes lie, what the mouse does to it, and how it is drawn.

It is drawn over the picture just before that is shown: in the window's real pixels, so that whoever holds the
mouse can read it on a dome as well.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass

from domeshim import session as sessions
from domeshim.draw.over import way_cleared
from domeshim.driver import Driver
from domeshim.GLUT import constants as c
from domeshim.GLUT.dispatch import call, make_current
from domeshim.GLUT.families import outermost
from domeshim.GLUT.state import GlutState, GlutWindow, Menu

ROW, LETTER, MARGIN = 18, 8, 6
"""Height of an entry, width of a letter (GLUT_BITMAP_8_BY_13) and space around the text, in pixels."""
NEAR = 4
"""Pixels that the pointer may move in one click."""


@dataclass
class Pane:
    """One menu's rectangle: its top left corner in the real window, and the entry under the pointer."""

    menu: Menu
    x: int
    y: int
    pointed: int | None = None

    @property
    def width(self) -> int:
        """Wide enough for the longest label and a submenu's sign."""
        longest = max((len(label) for label, _, _ in self.menu.items), default=4)
        return (longest + 2) * LETTER + 2 * MARGIN

    def item_at(self, x: int, y: int) -> int | None:
        """Return the index of the entry at that place of the window, or None outside."""
        index = (y - self.y) // ROW
        inside = self.x <= x < self.x + self.width and 0 <= index < len(self.menu.items)
        return index if inside else None


@dataclass
class OpenMenu:
    """The open panes, each submenu after the one that it belongs to."""

    window: GlutWindow
    """Where the button was pressed."""
    outer: GlutWindow
    """The outermost window around that one: the panes lie in it and may leave the inner one."""
    button: int
    opened_at: tuple[int, int]
    panes: list[Pane]

    def dragged(self) -> bool:
        """Return whether the pointer has left the place where the menu was opened: a release chooses then."""
        x, y = self.outer.pixel
        return abs(x - self.opened_at[0]) + abs(y - self.opened_at[1]) > NEAR

    def point(self, state: GlutState, x: int, y: int) -> None:
        """Mark the entry at (x, y), open its submenu, and close those of others."""
        for depth in reversed(range(len(self.panes))):
            pane = self.panes[depth]
            index = pane.item_at(x, y)
            if index is not None:
                break
        else:
            return
        if index == pane.pointed:
            return
        pane.pointed = index
        del self.panes[depth + 1 :]
        _, number, opens = pane.menu.items[index]
        if opens and number in state.menus:
            self.panes.append(Pane(state.menus[number], pane.x + pane.width, pane.y + index * ROW))
        self.drawn_again()

    def drawn_again(self) -> None:
        """Have the picture made anew, with the panes as they are now."""
        if self.outer.children:
            self.outer.stale = True
        else:
            self.outer.redisplay = True

    def choice(self, x: int, y: int) -> tuple[Menu, int | None] | None:
        """Return the menu and the value of the entry at (x, y), no value where it opens another; or None."""
        for pane in reversed(self.panes):
            index = pane.item_at(x, y)
            if index is not None:
                _, value, opens = pane.menu.items[index]
                return pane.menu, None if opens else value
        return None


def menu_takes_button(state: GlutState, window: GlutWindow, button: int, pressed: bool) -> bool:
    """Let a mouse button open, close or choose from a menu; False where it is the program's own business."""
    menu = state.open_menu
    if menu is None:
        number = window.menus.get(button) if pressed else None
        if number is None:
            return False
        _open(state, window, button, state.menus[number])
        return True
    outer = outermost(state, window)
    choice = menu.choice(*outer.pixel) if outer is menu.outer else None
    if choice is None:
        if pressed:
            close_open_menu(state)
    elif choice[1] is not None and (pressed or (button == menu.button and menu.dragged())):
        close_open_menu(state)
        state.menu = choice[0]
        make_current(state, menu.window)
        call(state, choice[0].chosen, choice[1])
    return True


def menu_takes_motion(state: GlutState, window: GlutWindow) -> bool:
    """Let the pointer mark entries of an open menu; False where none is open in this outermost window."""
    menu = state.open_menu
    if menu is None or menu.outer is not window:
        return False
    menu.point(state, *window.pixel)
    return True


def _open(state: GlutState, window: GlutWindow, button: int, menu: Menu) -> None:
    outer = outermost(state, window)
    x, y = outer.pixel
    width, height = outer.surface.size
    pane = Pane(menu, x, y)
    pane.x = max(min(x, width - pane.width), 0)
    pane.y = max(min(y, height - ROW * len(menu.items)), 0)
    state.open_menu = OpenMenu(window, outer, button, (x, y), [pane])
    state.menu = menu
    state.open_menu.drawn_again()
    _tell(state, window, c.GLUT_MENU_IN_USE)


def close_open_menu(state: GlutState) -> None:
    """Take the open menu, if any, from the window."""
    menu, state.open_menu = state.open_menu, None
    if menu is not None:
        menu.drawn_again()
        _tell(state, menu.window, c.GLUT_MENU_NOT_IN_USE)


def _tell(state: GlutState, window: GlutWindow, status: int) -> None:
    if state.menu_state is not None:
        call(state, state.menu_state, status)
    if state.menu_status is not None:
        call(state, state.menu_status, status, *window.pointer)


def draw_open_menu(state: GlutState, window: GlutWindow) -> None:
    """Draw the menu over the picture of the outermost window that it is open in."""
    if state.open_menu is None or state.open_menu.outer is not window:
        return
    from OpenGL import GL  # noqa: PLC0415 - its functions as they are overlaid now

    dome = sessions.current().dome
    straight = dome.straight(window.surface) if dome is not None else nullcontext()
    with straight, _flat_drawing(*window.surface.size):
        for pane in state.open_menu.panes:
            _draw_pane(pane)
    GL.glFlush()


def _draw_pane(pane: Pane) -> None:
    from OpenGL import GL  # noqa: PLC0415 - its functions as they are overlaid now

    from domeshim.GLUT.fonts import GLUT_BITMAP_8_BY_13, glutBitmapString  # noqa: PLC0415 - only where a menu is drawn

    for index, (label, _, opens) in enumerate(pane.menu.items):
        shade = 1.0 if index == pane.pointed else 0.75
        top, right = pane.y + index * ROW, pane.x + pane.width
        GL.glColor3f(shade, shade, shade)
        GL.glBegin(GL.GL_QUADS)
        for corner in ((pane.x, top), (pane.x, top + ROW), (right, top + ROW), (right, top)):
            GL.glVertex2f(*corner)
        GL.glEnd()
        GL.glColor3f(0.0, 0.0, 0.0)
        GL.glRasterPos2f(pane.x + MARGIN, top + ROW - 5)
        glutBitmapString(GLUT_BITMAP_8_BY_13, label.encode("latin-1", "replace"))
        if opens:
            GL.glRasterPos2f(right - MARGIN - LETTER, top + ROW - 5)
            glutBitmapString(GLUT_BITMAP_8_BY_13, b">")


@contextmanager
def _flat_drawing(width: int, height: int) -> Iterator[None]:
    """Draw in pixels from the top left, in plain colours; then put back what the program had set."""
    from OpenGL import GL  # noqa: PLC0415 - its functions as they are overlaid now

    program, mode = GL.glGetIntegerv(GL.GL_CURRENT_PROGRAM), GL.glGetIntegerv(GL.GL_MATRIX_MODE)
    GL.glUseProgram(0)  # through the overlay: the dome minds which one is bound, and the matrix mode
    with way_cleared(Driver()):
        GL.glColorMask(1, 1, 1, 1)
        GL.glViewport(0, 0, width, height)
        for stack in (GL.GL_PROJECTION, GL.GL_MODELVIEW):
            GL.glMatrixMode(stack)
            GL.glPushMatrix()
            GL.glLoadIdentity()
            if stack == GL.GL_PROJECTION:
                GL.glOrtho(0, width, height, 0, -1, 1)
        try:
            yield
        finally:
            for stack in (GL.GL_MODELVIEW, GL.GL_PROJECTION):
                GL.glMatrixMode(stack)
                GL.glPopMatrix()
            GL.glMatrixMode(mode)
    GL.glUseProgram(program)
