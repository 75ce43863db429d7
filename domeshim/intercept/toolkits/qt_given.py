"""Qt without a display: its GL widgets and windows as plain ones, which draw in windows of the session's."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from domeshim.errors import ScreenError
from domeshim.intercept.toolkits.qt_objects import (
    FUNCTIONS,
    array_object_class,
    asking_class,
    buffer_class,
    context_class,
    lend_enumerations,
)
from domeshim.intercept.toolkits.qt_surface import Surface
from domeshim.intercept.toolkits.qt_time import Pacer

if TYPE_CHECKING:
    from domeshim.intercept.toolkits.qt import QtToolkit


class GivenWindows:
    """Makes the classes that stand in for Qt's, and keeps their surfaces at one pace."""

    def __init__(self, toolkit: QtToolkit) -> None:
        self.toolkit = toolkit
        self.pacer = Pacer(toolkit)
        self.current: Callable[[], Any] | None = None
        """Gives the widget that GL's calls go to, if it still is there."""

    def make(self, name: str, original: type) -> type:
        """A class that serves as one of Qt's that draw with GL."""
        from domeshim.intercept.toolkits.qt import under_the_name_of  # noqa: PLC0415 - which imports this

        return under_the_name_of(original, self._made(name, original))

    def _made(self, name: str, original: type) -> type:
        if name == "QOpenGLContext":
            return asking_class(original, self._current_context)
        if name == "QOpenGLBuffer":
            return buffer_class(original)
        if name == "QOpenGLVertexArrayObject":
            return array_object_class(original, self.toolkit.part("QtCore"))
        return _window_class(self, original) if name == "QOpenGLWindow" else _widget_class(self, original)

    def _current_context(self) -> Any:
        """The context of the widget that draws now, as Qt would give it; None where none does."""
        widget = None if self.current is None else self.current()
        return None if widget is None else widget.context()

    def adopt(self, widget: Any) -> Surface:
        """A widget was made: it has a surface from now on."""
        from domeshim.intercept.toolkits.qt import draws_by_qt  # noqa: PLC0415 - which imports this

        if draws_by_qt(widget):
            raise ScreenError(FUNCTIONS)
        surface = Surface(self, widget)
        self.pacer.surfaces.append(surface)
        self.pacer.begin()
        return surface


class _GlCalls:
    """What QOpenGLWidget and QOpenGLWindow have in common for a program."""

    windows: GivenWindows

    @property
    def surface(self) -> Surface:
        """Made on first use: some programs call the __init__ of another of Qt's classes."""
        if "_domeshim_surface" not in vars(self):
            self._domeshim_surface = self.windows.adopt(self)
        return self._domeshim_surface

    def initializeGL(self) -> None:
        pass

    def resizeGL(self, width: int, height: int) -> None:
        pass

    def paintGL(self) -> None:
        pass

    def update(self, *part: Any) -> None:  # noqa: ARG002 - Qt's signature; a part is the whole here
        self.surface.asked = True

    def makeCurrent(self) -> None:
        self.surface.make_current()

    def doneCurrent(self) -> None:
        pass

    def isValid(self) -> bool:
        return self.surface.initialised

    def defaultFramebufferObject(self) -> int:
        return 0

    def format(self) -> Any:
        return self.surface.format

    def setFormat(self, surface_format: Any) -> None:
        self.surface.format = surface_format

    def grabFramebuffer(self) -> Any:
        return self.surface.grab()

    grabFrameBuffer = grabFramebuffer


def _widget_class(given: GivenWindows, original: type) -> type:
    core = given.toolkit.part("QtCore")
    widget: Any = given.toolkit.part("QtWidgets").QWidget
    signal = getattr(core, "Signal", None) or core.pyqtSignal
    contexts = context_class(core)

    class Widget(_GlCalls, widget):  # type: ignore[misc]
        windows = given
        aboutToCompose, frameSwapped, aboutToResize, resized = signal(), signal(), signal(), signal()

        def __init__(self, *args: Any, **named: Any) -> None:
            super().__init__(*(arg for arg in args if _is_widgets(arg, widget, core)), **named)
            self.surface.asked = True

        def event(self, event: Any) -> bool:
            if event.type() != core.QEvent.Type.Paint:
                return self.surface.hand_on(event, super().event)
            surface = self.surface
            if surface.painting:  # and not at a moment of Qt's own choosing
                surface.in_event = True
                try:
                    return bool(super().event(event))
                finally:
                    surface.in_event = False
            return True

        def paintEvent(self, event: Any) -> None:  # noqa: ARG002 - Qt's signature
            self.surface.draw()
            self.frameSwapped.emit()

        def paint_now(self) -> None:
            super().repaint()

        def repaint(self, *part: Any) -> None:  # noqa: ARG002 - Qt's signature
            if self.surface.visible():
                self.surface.paint()

        def initPainter(self, painter: Any) -> None:
            if self.surface.in_event:  # Qt makes some itself, for the background
                self.surface.say_of_painter()
            super().initPainter(painter)

        def context(self) -> Any:
            if self.surface.context is None:
                self.surface.context = contexts(self.surface)
            return self.surface.context

        def updateGL(self) -> None:
            self.surface.asked = True

        def swapBuffers(self) -> None:
            self.surface.finish()

    lend_enumerations(Widget, original)
    return Widget


def _window_class(given: GivenWindows, original: type) -> type:
    toolkit = given.toolkit
    core, gui = toolkit.part("QtCore"), toolkit.part("QtGui")
    signal = getattr(core, "Signal", None) or core.pyqtSignal
    contexts = context_class(core)

    class GlWindow(_GlCalls, gui.QRasterWindow):  # type: ignore[misc,name-defined]
        windows = given
        frameSwapped = signal()

        def __init__(self, *args: Any, **named: Any) -> None:
            super().__init__(*(arg for arg in args if isinstance(arg, gui.QWindow)), **named)
            self.surface.asked = True

        def paintEvent(self, event: Any) -> None:  # noqa: ARG002 - Qt's signature
            if self.surface.painting:
                self.surface.draw()
                self.frameSwapped.emit()

        def event(self, event: Any) -> bool:
            return self.surface.hand_on(event, super().event)

        def paint_now(self) -> None:
            self.paintEvent(None)

        def fix_size(self, width: int, height: int) -> None:
            super().resize(width, height)

        def resize(self, *size: Any) -> None:
            if toolkit.session.window_size is None:
                super().resize(*size)

        def context(self) -> Any:
            if self.surface.context is None:
                self.surface.context = contexts(self.surface)
            return self.surface.context

    lend_enumerations(GlWindow, original)
    return GlWindow


def _is_widgets(argument: Any, widget: type, core: Any) -> bool:
    """A QWidget takes this argument: its parent, or window flags; formats and share widgets are GL's."""
    flags = [getattr(core.Qt, name) for name in ("WindowType", "WindowFlags") if hasattr(core.Qt, name)]
    return argument is None or isinstance(argument, (widget, *flags))
