"""Qt's events of the mouse, told again as they would be on the monitor."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from domeshim.intercept.toolkits.qt import QtToolkit
    from domeshim.window.contract import Window


class QtPointer:
    """Hands a GL widget's or window's mouse events on with the monitor's places; global ones stay."""

    def __init__(self, toolkit: QtToolkit) -> None:
        self._toolkit = toolkit

    def hand_on(self, window: Window, width: float, event: Any, handle: Callable[[Any], bool]) -> bool:
        """Have Qt's own event() handle it, or another in its place; width: the widget's, in Qt's units.

        window: the widget's, in pixels, of which one of Qt's units may have several.
        """
        gui = self._toolkit.part("QtGui")
        make = _mouse if isinstance(event, gui.QMouseEvent) else _wheel
        if not isinstance(event, (gui.QMouseEvent, gui.QWheelEvent)) or self._toolkit.session.dome is None:
            return handle(event)
        place = event.position() if hasattr(event, "position") else event.localPos()
        scale = window.size[0] / max(width, 1)
        x, y = ((at + 0.5) * scale for at in (place.x(), place.y()))  # a whole number is a pixel's middle
        x, y = self._toolkit.program_place(window, x, y)
        told = make(event, type(place)(x / scale - 0.5, y / scale - 0.5))
        if hasattr(told, "setTimestamp"):
            told.setTimestamp(event.timestamp())
        handled = handle(told)
        event.setAccepted(told.isAccepted())
        return handled


def _mouse(event: Any, place: Any) -> Any:
    held = (event.button(), event.buttons(), event.modifiers())
    if hasattr(event, "globalPosition"):
        around = (event.scenePosition(), event.globalPosition())
        return type(event)(event.type(), place, *around, *held, event.pointingDevice())
    return type(event)(event.type(), place, event.windowPos(), event.screenPos(), *held, event.source())


def _wheel(event: Any, place: Any) -> Any:
    everywhere = event.globalPosition() if hasattr(event, "globalPosition") else event.globalPosF()
    turned = (event.pixelDelta(), event.angleDelta(), event.buttons(), event.modifiers())
    rest: dict[str, Any] = {}
    if hasattr(event, "source"):  # PyQt6 has it not
        rest["source"] = event.source()
    if hasattr(event, "pointingDevice"):
        rest["device"] = event.pointingDevice()
    return type(event)(place, everywhere, *turned, event.phase(), event.inverted(), **rest)
