"""Programs that open their window with pygame or glfw: the session hears of their windows and pictures.

Under a command that gives the windows itself (capture), the program's GL window is one of the command's, and
the toolkit, on its own driver for no display, keeps the events.
"""

from __future__ import annotations

from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from domeshim.intercept.toolkits.glfw import GlfwToolkit
    from domeshim.intercept.toolkits.pygame import PygameToolkit
    from domeshim.session import Session

_PYGAME = ("pygame.display", "pygame.event", "pygame.time")

WATCHED = (*_PYGAME, "glfw")
"""The modules of toolkits in which some names are led to ours."""


class Toolkits:
    """The toolkits of one session, each begun with the first of its modules."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._pygame: PygameToolkit | None = None
        self._glfw: GlfwToolkit | None = None

    def replacements(self, name: str, module: ModuleType) -> dict[str, Any]:
        """What stands in for which names of this module; nothing where neither dome nor command needs it."""
        session = self._session
        if not session.options.enabled and not session.backend_given:
            return {}
        if name in _PYGAME:
            return self._the_pygame().replacements(name, module)
        return self._the_glfw(module).replacements()

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
