"""Hears of chosen modules the moment they have been imported, whatever file they come from.

The import itself is left to Python's own machinery; only the loader is stood in for, and it takes its place
back before the module's first line runs.
"""

from __future__ import annotations

import copy
import sys
from collections.abc import Callable, Collection, Sequence
from importlib.machinery import ModuleSpec
from types import ModuleType
from typing import Any

EXTENSIONS = tuple(f"OpenGL.GL.{vendor}." for vendor in ("ARB", "EXT", "NV", "ATI", "SGIS", "APPLE"))
"""How the names of the modules begin in which PyOpenGL keeps GL's extensions."""

OnImport = Callable[[str, ModuleType], None]
"""Called with the module's name and the module, complete, each time it has been loaded or reloaded."""


def being_imported(name: str) -> bool:
    """The module of this name is in the middle of its import: it has not got its names yet."""
    return getattr(getattr(sys.modules.get(name), "__spec__", None), "_initializing", False) is True


class ImportFinder:
    """A meta path finder that finds nothing itself: it asks the finders behind it and listens.

    Not by name a MetaPathFinder: importlib.abc takes longer to load than all the rest of the start-up.
    """

    def __init__(self, names: Collection[str], on_import: OnImport, prefixes: tuple[str, ...] = ()) -> None:
        """prefixes: modules whose names begin so are listened for as well, but not looked for when armed."""
        self._names = tuple(names)
        self._prefixes = prefixes
        self._on_import = on_import
        self._armed = False

    def arm(self) -> None:
        """Listen from now on; modules that are there already are reported at once, in the names' order."""
        if self._armed:
            return
        self._armed = True
        sys.meta_path.insert(0, self)
        for name in self._names:
            module = sys.modules.get(name)
            if module is not None and not being_imported(name):
                self._on_import(name, module)

    def disarm(self) -> None:
        """Listen no longer, also to imports that have begun."""
        self._armed = False
        sys.meta_path[:] = [finder for finder in sys.meta_path if finder is not self]

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """The spec that the other finders give, for the watched names; None for all others."""
        if fullname not in self._names and not fullname.startswith(self._prefixes):
            return None
        if self not in sys.meta_path:
            return None
        for finder in sys.meta_path[sys.meta_path.index(self) + 1 :]:
            ask = getattr(finder, "find_spec", None)  # Python, too, passes over finders of the old kind
            spec: ModuleSpec | None = ask and ask(fullname, path, target)
            if spec is not None:
                if spec.loader is not None:
                    spec.loader = _StandIn(spec.loader, self._loaded)  # type: ignore[assignment]
                return spec
        return None

    def _loaded(self, module: ModuleType) -> None:
        if self._armed:
            self._on_import(module.__name__, module)


class _StandIn:
    """Stands in for a loader until the module is executed; everything else asked of it goes to the loader."""

    def __init__(self, loader: Any, loaded: Callable[[ModuleType], None]) -> None:
        self._loader = loader
        self._loaded = loaded

    def create_module(self, spec: ModuleSpec) -> ModuleType | None:
        module: ModuleType | None = self._loader.create_module(spec)
        return module

    def exec_module(self, module: ModuleType) -> None:
        module.__loader__ = self._loader
        if module.__spec__ is not None:
            module.__spec__.loader = self._loader
        self._loader.exec_module(module)
        self._loaded(module)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        return getattr(self._loader, name)

    def __reduce__(self) -> Any:
        return copy.copy, (self._loader,)  # a pickle or a copy has the loader in its place
