"""Programs that open their window with pygame, glfw or Qt: the session hears of their windows and pictures.

Under a command that gives the windows itself (capture), the program's GL window is one of the command's, and
the toolkit, on its own driver for no display, keeps the events; GLX is there without its functions.
"""

from __future__ import annotations

from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from domeshim.intercept.toolkits.glfw import GlfwToolkit
    from domeshim.intercept.toolkits.pygame import PygameToolkit
    from domeshim.intercept.toolkits.qt import QtToolkit
    from domeshim.session import Session

_PYGAME = ("pygame.display", "pygame.event", "pygame.mouse", "pygame.time")
_QT_BINDINGS = ("PySide6", "PyQt6", "PyQt5", "PySide2")
_QT_MODULES = ("QtCore", "QtGui", "QtWidgets", "QtOpenGL", "QtOpenGLWidgets")

_PLATFORM = "OpenGL.platform"

WATCHED = (
    _PLATFORM,
    *_PYGAME,
    "glfw",
    *(f"{binding}.{part}" for binding in _QT_BINDINGS for part in _QT_MODULES),
)
"""The modules of toolkits in which some names are led to ours."""


class Toolkits:
    """The toolkits of one session, each begun with the first of its modules."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._pygame: PygameToolkit | None = None
        self._glfw: GlfwToolkit | None = None
        self._qt: dict[str, QtToolkit] = {}

    def replacements(self, name: str, module: ModuleType) -> dict[str, Any]:
        """What stands in for which names of this module; nothing where neither dome nor command needs it."""
        session = self._session
        if not session.options.enabled and not session.backend_given:
            return {}
        if name == _PLATFORM:
            if session.backend_given:
                from domeshim.intercept.toolkits.glx import without_functions  # noqa: PLC0415 - as below

                without_functions(module.PLATFORM)
            return {}
        if name in _PYGAME:
            return self._the_pygame().replacements(name, module)
        if name == "glfw":
            return self._the_glfw(module).replacements()
        binding, _, part = name.partition(".")
        return self._the_qt(binding).replacements(part, module)

    def _the_pygame(self) -> PygameToolkit:
        if self._pygame is None:
            from domeshim.intercept.toolkits.pygame import PygameToolkit  # noqa: PLC0415 - only who uses it pays

            self._pygame = PygameToolkit(self._session)
        return self._pygame

    def _the_glfw(self, module: ModuleType) -> GlfwToolkit:
        if self._glfw is None:
            from domeshim.intercept.toolkits.glfw import GlfwToolkit  # noqa: PLC0415 - as above

            self._glfw = GlfwToolkit(self._session, module)
        return self._glfw

    def _the_qt(self, binding: str) -> QtToolkit:
        if binding not in self._qt:
            from domeshim.intercept.toolkits.qt import QtToolkit  # noqa: PLC0415 - as above

            self._qt[binding] = QtToolkit(self._session, binding)
        return self._qt[binding]
