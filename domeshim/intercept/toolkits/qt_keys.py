"""The recording's key in a program of Qt's."""

from __future__ import annotations

import weakref
from functools import partial
from typing import TYPE_CHECKING, Any

from domeshim.window.dome_keys import RECORD_KEY

if TYPE_CHECKING:
    from domeshim.intercept.toolkits.qt import QtToolkit
    from domeshim.window.contract import Window

_QT_5 = "Qt 5 has no shortcuts in a QOpenGLWindow: Ctrl+Shift+R does not record here"


class QtKeys:
    """Listens for it as a shortcut, whichever widget of the program has the keyboard."""

    def __init__(self, toolkit: QtToolkit) -> None:
        self._toolkit = toolkit
        self._shortcut: Any = None

    def listen(self, widget: Any, window: Window) -> None:
        """The key is for this widget's window from now on, unless it is for another's."""
        if self._shortcut is not None or not self._toolkit.session.options.enabled:
            return
        core, gui = self._toolkit.part("QtCore"), self._toolkit.part("QtGui")
        make = getattr(gui, "QShortcut", None)
        if make is None and isinstance(widget, gui.QWindow):
            self._toolkit.say_once(_QT_5)
            return
        make = make or self._toolkit.part("QtWidgets").QShortcut
        self._shortcut = make(gui.QKeySequence(f"Ctrl+Shift+{chr(RECORD_KEY)}"), widget)
        self._shortcut.setContext(core.Qt.ShortcutContext.ApplicationShortcut)
        self._shortcut.setAutoRepeat(False)
        self._shortcut.activated.connect(partial(self._pressed, weakref.ref(widget), window))
        self._shortcut.destroyed.connect(self._gone)

    def _gone(self, *_: Any) -> None:
        self._shortcut = None

    def _pressed(self, known: weakref.ref[Any], window: Window) -> None:
        widget = known()
        if widget is not None:
            widget.makeCurrent()
            self._toolkit.session.takes_key(window, RECORD_KEY)
