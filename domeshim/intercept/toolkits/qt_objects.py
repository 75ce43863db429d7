"""Qt without a display: the context that a program asks about, and the buffers it fills by Qt's own classes.

They stand in for Qt's where no context of Qt's can be made, and go by PyOpenGL as the program does.
"""

from __future__ import annotations

from ctypes import create_string_buffer
from typing import TYPE_CHECKING, Any, cast

from domeshim.driver import Driver
from domeshim.errors import ScreenError

if TYPE_CHECKING:
    from domeshim.intercept.toolkits.qt_surface import Surface

FUNCTIONS = "Qt's own GL functions cannot draw without a display; only PyOpenGL's calls can be captured"


def context_class(core: Any) -> type:
    """What a widget's context() gives: it can be asked, and cannot draw."""
    signal = getattr(core, "Signal", None) or core.pyqtSignal

    class Context(core.QObject):  # type: ignore[misc]
        aboutToBeDestroyed = signal()

        def __init__(self, surface: Surface) -> None:
            super().__init__()
            self._surface = surface

        def format(self) -> Any:
            return self._surface.format

        def isValid(self) -> bool:
            return self._surface.initialised

        def isOpenGLES(self) -> bool:
            return False

        def hasExtension(self, name: Any) -> bool:
            return Driver().names(bytes(name).decode())

        def functions(self, *_: Any) -> Any:
            raise ScreenError(FUNCTIONS)

        extraFunctions = versionFunctions = functions

    return Context


def asking_class(original: Any, current: Any) -> type:
    """Qt's QOpenGLContext, which knows the context of the widget that draws now.

    current: gives that widget's stand-in, or None.
    """

    class Asking(original):  # type: ignore[misc]
        @staticmethod
        def currentContext() -> Any:
            return current()

    return Asking


class _GlObject:
    """An object of GL's, made when the program says so."""

    sort = ""
    """What GL calls such objects."""
    _name = 0

    def create(self) -> bool:
        self._name = self._name or int(getattr(_gl(), f"glGen{self.sort}")(1))
        return True

    def isCreated(self) -> bool:
        return self._name != 0

    def destroy(self) -> None:
        if self._name:
            getattr(_gl(), f"glDelete{self.sort}")(1, [self._name])
        self._name = 0


def buffer_class(original: Any) -> type:
    """What serves as QOpenGLBuffer: a buffer object of GL."""

    class Buffer(_GlObject):
        sort = "Buffers"

        def __init__(self, kind: Any = original.Type.VertexBuffer) -> None:
            self._kind = kind
            self._usage = original.UsagePattern.StaticDraw

        def type(self) -> Any:
            return self._kind

        def usagePattern(self) -> Any:
            return self._usage

        def setUsagePattern(self, usage: Any) -> None:
            self._usage = usage

        def bufferId(self) -> int:
            return self._name

        def bind(self) -> bool:
            if self._name:
                _gl().glBindBuffer(self._target, self._name)
            return self._name != 0

        def release(self, kind: Any = None) -> None:
            _gl().glBindBuffer(self._target if kind is None else _number(kind), 0)

        def size(self) -> int:
            gl = _gl()
            return int(gl.glGetBufferParameteriv(self._target, gl.GL_BUFFER_SIZE)) if self._name else -1

        def allocate(self, data: Any, count: int = -1) -> None:
            if isinstance(data, int):
                _gl().glBufferData(self._target, data, None, self._gl_usage)
            else:
                content = _bytes(data, count)
                _gl().glBufferData(self._target, len(content), content, self._gl_usage)

        def write(self, offset: int, data: Any, count: int = -1) -> None:
            content = _bytes(data, count)
            _gl().glBufferSubData(self._target, offset, len(content), content)

        def read(self, offset: int, count: int) -> bytes:
            content = create_string_buffer(count)
            _gl().glGetBufferSubData(self._target, offset, count, content)
            return content.raw

        @property
        def _target(self) -> int:
            return _number(self._kind)

        @property
        def _gl_usage(self) -> int:
            return _number(self._usage)

    lend_enumerations(Buffer, original)
    return Buffer


def array_object_class(original: Any, core: Any) -> type:
    """What serves as QOpenGLVertexArrayObject: a vertex array object of GL."""

    class ArrayObject(_GlObject, core.QObject):  # type: ignore[misc]
        sort = "VertexArrays"

        def objectId(self) -> int:
            return self._name

        def bind(self) -> None:
            _gl().glBindVertexArray(self._name)

        def release(self) -> None:
            _gl().glBindVertexArray(0)

    lend_enumerations(ArrayObject, original)
    return ArrayObject


def _gl() -> Any:
    from OpenGL import GL  # noqa: PLC0415 - its functions as they are overlaid now

    return GL


def _number(value: Any) -> int:
    """GL's number, which Qt's enumerations are."""
    return int(getattr(value, "value", value))


def _bytes(data: Any, count: int) -> bytes:
    content = bytes(cast("Any", memoryview(data)).cast("B"))
    return content if count < 0 else content[:count]


def lend_enumerations(ours: type, original: type) -> None:
    """Qt's enumerations and their members, which a program looks up on Qt's own class."""
    for name, value in vars(original).items():
        if name[0].isupper() and not hasattr(ours, name):
            setattr(ours, name, value)
            for member in getattr(value, "__members__", {}).items():
                setattr(ours, *member)
