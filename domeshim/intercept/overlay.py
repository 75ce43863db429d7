"""The overlay: names of OpenGL.GL, .GLU, .GLUT and of other toolkits lead to ours; it keeps the originals."""

from __future__ import annotations

import importlib
import sys
from types import ModuleType
from typing import TYPE_CHECKING, Any

from domeshim.intercept.finder import EXTENSIONS, being_imported
from domeshim.intercept.inner import PUBLIC, InnerModules
from domeshim.intercept.toolkits import WATCHED, Toolkits

if TYPE_CHECKING:
    from domeshim.session import Session

_MISSING = object()
_GL = "OpenGL.GL"


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
        self._laid: dict[int, Any] = {}
        self._rebound: list[tuple[dict[str, Any], str, Any]] = []
        self._inner = InnerModules()

    def module_imported(self, name: str, module: ModuleType) -> None:
        """A watched module has been imported: lay our names over its own."""
        if name in self._originals or (name.startswith(EXTENSIONS) and _GL not in self._originals):
            return  # an extension that OpenGL.GL itself imports is covered after it
        if name in PUBLIC:
            within = any(being_imported(other) for other in PUBLIC if other != name)
            if PUBLIC[name] not in sys.modules and not within:
                importlib.import_module(PUBLIC[name])  # it comes here in turn
            return  # so does another inner module that has only imported this one
        self._cover(name, module)
        for extension in _loaded_extensions() if name == _GL else ():
            self._cover(extension.__name__, extension)
        for original, ours in self._inner.cover(
            name, {key: vars(module)[key] for key in self._originals[name]}
        ):
            self._ours.setdefault(id(original), (original, ours))
        self._rebind()

    def _cover(self, name: str, module: ModuleType) -> None:
        replacements = self._replacements(name, module)
        self._originals[name] = {key: vars(module).get(key, _MISSING) for key in replacements}
        for key, ours in replacements.items():
            original = self._originals[name][key]
            if original is not _MISSING and callable(original):
                self._ours[id(original)] = (original, ours)
            self._laid[id(ours)] = ours
            setattr(module, key, ours)

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
        self._inner.remove()
        self._originals.clear()
        self._ours.clear()
        self._laid.clear()
        self._rebound.clear()

    def _rebind(self) -> None:
        originals = self._ours.keys()
        for module in tuple(sys.modules.values()):
            namespace = getattr(module, "__dict__", None)
            if namespace is None or _is_library(getattr(module, "__name__", "")):
                continue
            if originals.isdisjoint(map(id, tuple(namespace.values()))):
                continue  # nearly all of them
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
        if name == _GL:
            return gl.replacements(session, module)
        known, rest = self._known(module)
        return known | gl.replacements(session, rest)

    def _known(self, extension: ModuleType) -> tuple[dict[str, Any], ModuleType]:
        """Names of an extension that OpenGL.GL has as well, each with ours, and a module of all others."""
        known, rest = {}, ModuleType(extension.__name__)
        for key, value in vars(extension).items():
            original, ours = self._ours.get(id(value), (None, None))
            if original is value:
                known[key] = ours
            elif key.startswith("gl") and id(value) not in self._laid:
                setattr(rest, key, value)
        return known, rest


def _loaded_extensions() -> list[ModuleType]:
    """Those of PyOpenGL's extensions, and of what it builds on them, that were there before us."""
    return [
        module
        for name, module in tuple(sys.modules.items())
        if name.startswith(EXTENSIONS) or name in ("OpenGL.GL.shaders", "OpenGL.GL.framebufferobjects")
    ]


def _is_library(module_name: str) -> bool:
    """PyOpenGL's own modules and ours call the originals."""
    return module_name.partition(".")[0] in ("OpenGL", "domeshim")
