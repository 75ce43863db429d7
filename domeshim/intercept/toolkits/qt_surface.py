"""The GL side of one Qt widget where there is no display: a window of the session's, and when it is drawn."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from domeshim.driver import Driver
from domeshim.errors import ProgramFinished
from domeshim.window.contract import SurfaceFormat, Window, WindowEvents

if TYPE_CHECKING:
    from domeshim.intercept.toolkits.qt_given import GivenWindows

_QPAINTER = "what QPainter draws over GL is not in this picture, which is taken without a display"


class Surface:
    """The GL side of one widget: the session's window it draws in, and what Qt would call when."""

    def __init__(self, given: GivenWindows, widget: Any) -> None:
        self.asked = True
        self._given = given
        self._toolkit = given.toolkit
        self._widget = weakref.ref(widget)
        self._window: Window | None = None
        self.initialised = False
        """The program's initializeGL has been called."""
        self._told_size: tuple[int, int] | None = None
        self.painting = False
        self.in_event = False
        """The program's paintEvent runs."""
        self._drawing = False
        gui = self._toolkit.part("QtGui")
        self.format: Any = gui.QSurfaceFormat.defaultFormat() if hasattr(gui, "QSurfaceFormat") else None
        self.context: Any = None
        size = self._toolkit.session.window_size
        if size is not None:
            self._fix_size(widget, size)

    def _fix_size(self, widget: Any, size: tuple[int, int]) -> None:
        if hasattr(widget, "setFixedSize"):
            widget.setFixedSize(*size)
        else:
            widget.fix_size(*size)

    def hand_on(self, event: Any, handle: Callable[[Any], bool]) -> bool:
        """Have Qt's own event() handle an event; one of the mouse with the monitor's place."""
        widget, window = self._widget(), self._window
        if widget is None or window is None:
            return bool(handle(event))
        return self._toolkit.pointer.hand_on(window, widget.width(), event, handle)

    def visible(self) -> bool:
        """The program shows the widget, and Qt has not deleted it."""
        widget = self._widget()
        try:
            return widget is not None and bool(widget.isVisible())
        except RuntimeError:  # the C++ part is gone
            return False

    def paint(self) -> None:
        """Have Qt paint the widget now, and the program its picture; not before Qt has a place for it."""
        widget = self._widget()
        if widget is None or not _is_exposed(widget):
            return
        self.asked, self._drawing, self.painting = False, False, True
        try:
            widget.paint_now()
            if self._drawing:  # a paintEvent of the program's own, between makeCurrent and its end
                self.finish()
        finally:
            self.painting = False

    def draw(self) -> None:
        """Call the program as Qt does: initializeGL once, resizeGL at each size, and paintGL."""
        widget = self._widget()
        if widget is None:
            return
        window = self.make_current()
        if not self.initialised:
            self.initialised = True
            widget.initializeGL()
        if window.size != self._told_size:
            self._told_size = window.size
            self._set_viewport(window.size)
            widget.resizeGL(*window.size)
            self.make_current()
        self._drawing = False  # a picture that fails is none
        widget.paintGL()
        self.finish()

    def finish(self) -> None:
        """The picture is finished; if it was the last one wanted, the program's event loop ends."""
        self._drawing = False
        if self._window is None:
            return
        try:
            self._toolkit.finished(self._window)
        except ProgramFinished:
            self._toolkit.part("QtCore").QCoreApplication.exit(0)

    def make_current(self) -> Window:
        """Direct GL to the widget's window, opened on first use and as large as the widget is."""
        self._drawing = True
        self._given.current = self._widget
        session = self._toolkit.session
        size = session.window_size or self._widget_size()
        if self._window is None:
            self._window = session.backend.open_window("", size, None, self._surface_format(), WindowEvents())
            self._toolkit.opened(self._window, size, core=self._core_asked())
            self._tell_version()
            return self._window
        self._window.make_current()
        session.window_current(self._window)
        if self._window.size != size:
            self._window.resize(*size)
            session.window_resized(self._window, size)
        return self._window

    def _widget_size(self) -> tuple[int, int]:
        widget = self._widget()
        return (max(widget.width(), 1), max(widget.height(), 1)) if widget is not None else (1, 1)

    def _set_viewport(self, size: tuple[int, int]) -> None:
        """Qt sets the viewport to the whole widget before resizeGL."""
        from OpenGL import GL  # noqa: PLC0415 - its functions as they are overlaid now

        GL.glViewport(0, 0, *size)

    def _surface_format(self) -> SurfaceFormat:
        samples = self.format.samples() if self.format is not None else -1
        return SurfaceFormat(samples=max(samples, 0) or self._toolkit.samples_wished)

    def _tell_version(self) -> None:
        """Let the format say which OpenGL there is, as Qt does once there is a context."""
        if not hasattr(self.format, "setVersion") or not hasattr(self.format, "renderableType"):
            return
        self.format = self._toolkit.part("QtGui").QSurfaceFormat(self.format)
        self.format.setVersion(*Driver().version)
        self.format.setProfile(self.format.OpenGLContextProfile.CompatibilityProfile)

    def _core_asked(self) -> bool:
        asked = self.format
        if asked is None or not hasattr(asked, "renderableType"):
            return False
        version = (asked.majorVersion(), asked.minorVersion())
        core = asked.profile() == asked.OpenGLContextProfile.CoreProfile and version >= (3, 2)
        return bool(core or asked.renderableType() == asked.RenderableType.OpenGLES)

    def grab(self) -> Any:
        """The picture as it stands, as a QImage."""
        from domeshim.measure.pixels import read_pixels  # noqa: PLC0415 - only who asks needs it

        image = self._toolkit.part("QtGui").QImage
        width, height = self.make_current().size
        pixels = read_pixels(width, height)
        return image(pixels, width, height, 3 * width, image.Format.Format_RGB888).copy()

    def say_of_painter(self) -> None:
        """Tell once that QPainter's part is missing."""
        self._toolkit.say_once(_QPAINTER)


def _is_exposed(widget: Any) -> bool:
    window = widget if hasattr(widget, "isExposed") else widget.window().windowHandle()
    return window is not None and bool(window.isExposed())
