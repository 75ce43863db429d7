"""The shapes of the pointer."""

from __future__ import annotations

from domeshim.GLUT import constants as c
from domeshim.GLUT.state import GlutState, GlutWindow

_SHAPES = {
    c.GLUT_CURSOR_INFO: "hand",
    c.GLUT_CURSOR_TEXT: "ibeam",
    c.GLUT_CURSOR_CROSSHAIR: "crosshair",
    c.GLUT_CURSOR_FULL_CROSSHAIR: "crosshair",
    c.GLUT_CURSOR_UP_DOWN: "vresize",
    c.GLUT_CURSOR_TOP_SIDE: "vresize",
    c.GLUT_CURSOR_BOTTOM_SIDE: "vresize",
    c.GLUT_CURSOR_LEFT_RIGHT: "hresize",
    c.GLUT_CURSOR_LEFT_SIDE: "hresize",
    c.GLUT_CURSOR_RIGHT_SIDE: "hresize",
    c.GLUT_CURSOR_NONE: "none",
}
"""The contract's shape for each of GLUT's cursors; an arrow for the others."""


def show_cursor(state: GlutState, window: GlutWindow) -> None:
    """Give the pointer the shape that it has over a window; a subwindow without one has its parent's."""
    wanted: GlutWindow | None = window
    while wanted is not None and wanted.cursor == c.GLUT_CURSOR_INHERIT:
        wanted = state.windows.get(wanted.parent)
    window.surface.set_cursor(_SHAPES.get(wanted.cursor, "arrow") if wanted else "arrow")
