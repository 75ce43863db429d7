"""The overlay: names of OpenGL.GL, .GLU, .GLUT and of other toolkits lead to ours; it keeps the originals."""

from __future__ import annotations

import sys
from types import ModuleType
from typing import TYPE_CHECKING, Any

from domeshim.intercept.toolkits import WATCHED, Toolkits

if TYPE_CHECKING:
    from domeshim.session import Session

_MISSING = object()


class Overlay:
    """What was laid over which module, so that it can be taken off exactly.

    Names that a program bound before (`from OpenGL.GL import *` above the shim's import) are led to ours as
    well, wherever they are bound at module level.
    """

    def __init__(self, session: Session) -> None:
        self._session = session
        self._toolkits = Toolkits(session)
        self._originals: dict[str, dict[str, Any]] = {}
        self._ours: dict[int, tuple[Any, Any]] = {}
        self._rebound: list[tuple[dict[str, Any], str, Any]] = []

    def module_imported(self, name: str, module: ModuleType) -> None:
        """A watched module has been imported: lay our names over its own."""
        if name in self._originals:
            return
        replacements = self._replacements(name, module)
        self._originals[name] = {key: vars(module).get(key, _MISSING) for key in replacements}
        for key, ours in replacements.items():
            original = self._originals[name][key]
            if original is not _MISSING and callable(original):
                self._ours[id(original)] = (original, ours)
            setattr(module, key, ours)
        self._rebind(skip=module)

    def remove(self) -> None:
        """Put every original back where it was."""
        for name, originals in self._originals.items():
            module = sys.modules.get(name)
            for key, original in originals.items() if module is not None else ():
                if original is _MISSING:
                    delattr(module, key)
                else:
                    setattr(module, key, original)
        for namespace, key, original in self._rebound:
            namespace[key] = original
        self._originals.clear()
        self._ours.clear()
        self._rebound.clear()

    def _rebind(self, skip: ModuleType) -> None:
        for module in tuple(sys.modules.values()):
            namespace = getattr(module, "__dict__", None)
            if namespace is None or module is skip or _is_library(getattr(module, "__name__", "")):
                continue
            for key, value in tuple(namespace.items()):
                original, ours = self._ours.get(id(value), (None, None))
                if original is value and original is not None:
                    self._rebound.append((namespace, key, original))
                    namespace[key] = ours

    def _replacements(self, name: str, module: ModuleType) -> dict[str, Any]:
        if name in WATCHED:
            return self._toolkits.replacements(name, module)
        from domeshim.intercept import gl, glu  # noqa: PLC0415 - nothing of this before OpenGL is there
        from domeshim.intercept.dome import Dome  # noqa: PLC0415

        session = self._session
        if session.options.enabled and session.dome is None:
            session.dome_made(Dome(session))
        if name == "OpenGL.GLUT":
            from domeshim import GLUT  # noqa: PLC0415

            return {key: value for key, value in vars(GLUT).items() if key.startswith(("glut", "GLUT_"))}
        if name == "OpenGL.GLU":
            return glu.replacements(session, module)
        return gl.replacements(session, module)


def _is_library(module_name: str) -> bool:
    """PyOpenGL's own modules and ours call the originals."""
    return module_name.partition(".")[0] in ("OpenGL", "domeshim")
