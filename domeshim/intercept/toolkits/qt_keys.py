"""The dome's own keys in a program of Qt's."""

from __future__ import annotations

import weakref
from functools import partial
from typing import TYPE_CHECKING, Any

from domeshim.window.dome_keys import DOME_KEYS

if TYPE_CHECKING:
    from domeshim.intercept.toolkits.qt import QtToolkit
    from domeshim.window.contract import Window

_QT_5 = "Qt 5 has no shortcuts in a QOpenGLWindow: Ctrl+Shift+R and Ctrl+Shift+P do nothing here"


class QtKeys:
    """Listens for them as shortcuts, whichever widget of the program has the keyboard."""

    def __init__(self, toolkit: QtToolkit) -> None:
        self._toolkit = toolkit
        self._shortcuts: dict[int, Any] = {}

    def listen(self, widget: Any, window: Window) -> None:
        """The keys are for this widget's window from now on, unless they are for another's."""
        if self._shortcuts or not self._toolkit.session.options.enabled:
            return
        core, gui = self._toolkit.part("QtCore"), self._toolkit.part("QtGui")
        make = getattr(gui, "QShortcut", None)
        if make is None and isinstance(widget, gui.QWindow):
            self._toolkit.say_once(_QT_5)
            return
        make = make or self._toolkit.part("QtWidgets").QShortcut
        for key in DOME_KEYS:
            shortcut = self._shortcuts[key] = make(gui.QKeySequence(f"Ctrl+Shift+{chr(key)}"), widget)
            shortcut.setContext(core.Qt.ShortcutContext.ApplicationShortcut)
            shortcut.setAutoRepeat(False)
            shortcut.activated.connect(partial(self._pressed, key, weakref.ref(widget), window))
            shortcut.destroyed.connect(partial(self._gone, key))

    def _gone(self, key: int, *_: Any) -> None:
        self._shortcuts.pop(key, None)

    def _pressed(self, key: int, known: weakref.ref[Any], window: Window) -> None:
        widget = known()
        if widget is not None:
            widget.makeCurrent()
            self._toolkit.session.takes_key(window, key)
            widget.update()  # a program that stands still shows it as well
