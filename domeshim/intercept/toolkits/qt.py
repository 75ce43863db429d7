"""Qt: QOpenGLWidget, QOpenGLWindow and the QGLWidget of old draw in paintGL, whose end finishes a picture.

The names of these classes lead to subclasses of them; what a program derives from one has its paintGL and
its like led through here. The widget's frame buffer need not be GL's number 0: its window says which it is.
"""

from __future__ import annotations

import weakref
from collections.abc import Callable
from functools import wraps
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

from domeshim.intercept.toolkits.qt_given import GivenWindows
from domeshim.intercept.toolkits.qt_keys import QtKeys
from domeshim.intercept.toolkits.qt_pointer import QtPointer
from domeshim.intercept.toolkits.qt_time import time_classes
from domeshim.intercept.toolkits.windows import ToolkitHost, ToolkitWindow

if TYPE_CHECKING:
    from domeshim.session import Session
    from domeshim.window.contract import Window

_GL_CLASSES = ("QOpenGLWidget", "QOpenGLWindow", "QGLWidget")
_GIVEN_CLASSES = (*_GL_CLASSES, "QOpenGLContext", "QOpenGLBuffer", "QOpenGLVertexArrayObject")
"""What cannot be made without a display, for a context of Qt's is missing then."""
_HOOKED = ("initializeGL", "resizeGL", "paintGL", "paintEvent")
_QPAINTER = "what QPainter draws over GL is not bent onto the dome; it lies flat over the picture"


class QtToolkit(ToolkitHost):
    """The GL widgets and windows of one binding to Qt: PySide or PyQt."""

    def __init__(self, session: Session, binding: str) -> None:
        super().__init__(session, "Qt")
        self._binding = binding
        self._given: GivenWindows | None = None
        self.pointer = QtPointer(self)
        self._keys = QtKeys(self)

    def part(self, name: str) -> Any:
        """One of the binding's modules, such as QtGui."""
        return import_module(f"{self._binding}.{name}")

    def replacements(self, part: str, module: ModuleType) -> dict[str, Any]:
        """Our classes for those of Qt in this module that draw with GL, or tell the time."""
        ours: dict[str, Any] = {}
        gives = self.gives_windows
        for name in _GIVEN_CLASSES if gives else _GL_CLASSES:
            original = getattr(module, name, None)
            if original is not None:
                ours[name] = self._the_given().make(name, original) if gives else self._hook(original)
        if part == "QtCore" and self.gives_windows and self.session.clock.virtual:
            ours |= time_classes(self._the_given().pacer, module)
        return ours

    def _the_given(self) -> GivenWindows:
        if self._given is None:
            self._given = GivenWindows(self)
        return self._given

    def _hook(self, original: type) -> type:
        """A subclass of Qt's class that tells the session of its windows and pictures."""
        toolkit = self

        class Hooked(original):  # type: ignore[misc]
            def __init_subclass__(cls, **named: Any) -> None:
                super().__init_subclass__(**named)
                toolkit._lead_overrides(cls, original)

            def makeCurrent(self) -> None:
                super().makeCurrent()
                toolkit._enter(self)

            def doneCurrent(self) -> None:
                super().doneCurrent()
                toolkit.session.window_current(None)

            def event(self, event: Any) -> bool:
                hold: _Hold | None = getattr(self, "_domeshim_hold", None)
                if hold is None:
                    return bool(super().event(event))
                return toolkit.pointer.hand_on(hold.window, self.width(), event, super().event)

            def initPainter(self, painter: Any) -> None:
                toolkit._painter_begins(self)
                super().initPainter(painter)

        return under_the_name_of(original, Hooked)

    def _painter_begins(self, widget: Any) -> None:
        """A QPainter is made for the widget; Qt makes some itself, but not while the program draws."""
        hold: _Hold | None = getattr(widget, "_domeshim_hold", None)
        if self.session.dome is not None and hold is not None and (hold.depth or hold.in_event):
            self.session.dome.flush()
            self.say_once(_QPAINTER)

    def _lead_overrides(self, cls: type, original: type) -> None:
        """Lead the class's own paintGL and its like through the toolkit, wherever it has them from."""
        for name in _HOOKED:
            owner = (
                next(base for base in cls.__mro__ if name in vars(base)) if hasattr(cls, name) else original
            )
            method = vars(owner).get(name)
            if not issubclass(original, owner) and method is not None and not hasattr(method, "leads_to"):
                setattr(cls, name, self._leading(name, method))

    def _leading(self, name: str, method: Callable[..., Any]) -> Callable[..., Any]:
        @wraps(method)
        def call(widget: Any, *args: Any) -> Any:
            if name == "paintEvent":
                return self._paint_event(widget, method, args)
            hold = self._enter(widget, fresh=name == "initializeGL")
            hold.depth += 1
            try:
                result = method(widget, *args)
            finally:
                hold.depth -= 1
            if name == "paintGL" and hold.depth == 0:
                self._finish(hold)
            return result

        call.leads_to = method  # type: ignore[attr-defined]
        return call

    def _paint_event(self, widget: Any, method: Callable[..., Any], args: tuple[Any, ...]) -> Any:
        """A paintEvent of the program's own may draw between makeCurrent and its end, without any paintGL."""
        hold: _Hold | None = getattr(widget, "_domeshim_hold", None)
        if hold is None:
            return method(widget, *args)
        hold.drawing, hold.in_event = False, True
        try:
            result = method(widget, *args)
        finally:
            hold.in_event = False
        if hold.drawing:
            self._finish(hold)
        return result

    def _enter(self, widget: Any, *, fresh: bool = False) -> _Hold:
        """The widget's context is current now: find its window, or open one."""
        hold: _Hold | None = getattr(widget, "_domeshim_hold", None)
        if hold is not None and fresh and hold.depth == 0:  # Qt has made it another context
            self.session.window_closed(hold.window)
            hold = None
        if hold is None:
            hold = _Hold(widget)
            widget._domeshim_hold = hold
            weakref.finalize(widget, self.session.window_closed, hold.window).atexit = False
            self._say_of_functions(widget)
            self.opened(hold.window, hold.window.size)
            self._keys.listen(widget, hold.window)
        elif hold.depth == 0:
            self.session.window_current(hold.window)
            # Qt sets the viewport itself, unseen: what is known of it is known no longer.
            self.session.window_resized(hold.window, hold.window.size)
        hold.drawing = True
        return hold

    def _finish(self, hold: _Hold) -> None:
        hold.drawing = False
        self.finished(hold.window)

    def _say_of_functions(self, widget: Any) -> None:
        if self.session.options.enabled and draws_by_qt(widget):
            self.say_once("GL called by Qt's own QOpenGLFunctions is not bent; only PyOpenGL's calls are")


class _Hold:
    """What is kept for one widget: its window for the session, and how deep in its own calls it is."""

    def __init__(self, widget: Any) -> None:
        known = weakref.ref(widget)
        self.depth = 0
        self.drawing = False
        """The context was made current, and no picture was finished since."""
        self.in_event = False
        self._size = (1, 1)

        def size() -> tuple[int, int]:
            alive = known()
            if alive is not None:
                self._size = pixel_size(alive)
            return self._size

        def framebuffer() -> int:
            asked = getattr(known(), "defaultFramebufferObject", None)  # QGLWidget has none of its own
            return int(asked()) if asked is not None else 0

        # Qt shows it when paintGL has returned.
        self.window: Window = ToolkitWindow(size, lambda: None, framebuffer=framebuffer)


def pixel_size(widget: Any) -> tuple[int, int]:
    """Width and height of a widget's or window's frame buffer in pixels."""
    ratio = getattr(widget, "devicePixelRatioF", widget.devicePixelRatio)()
    return max(round(widget.width() * ratio), 1), max(round(widget.height() * ratio), 1)


def draws_by_qt(widget: Any) -> bool:
    """The widget is also one of Qt's own sets of GL functions."""
    return any(
        base.__name__.startswith("QOpenGL") and "Functions" in base.__name__ for base in type(widget).__mro__
    )


def under_the_name_of(original: type, ours: type) -> type:
    """Our class, named as Qt's, by which style sheets and messages know it."""
    ours.__name__, ours.__qualname__, ours.__module__ = (
        original.__name__,
        original.__qualname__,
        original.__module__,
    )
    return ours
