"""PyOpenGL's inner modules, from which programs import as well: OpenGL.raw.GLU, OpenGL.GLUT.freeglut.

Editors write such imports by themselves. The inner modules call each other through their own names, so those
must stay; what a later import finds is a stand-in with ours.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from types import ModuleType
from typing import Any

from domeshim.intercept.finder import EXTENSIONS

PUBLIC = {
    "OpenGL.raw.GL.VERSION.GL_1_0": "OpenGL.GL",
    "OpenGL.raw.GL.VERSION.GL_1_1": "OpenGL.GL",
    "OpenGL.raw.GLU": "OpenGL.GLU",
    "OpenGL.raw.GLUT": "OpenGL.GLUT",
}
"""The inner modules with which a program may begin, and the module that must be covered then."""
_INSIDE = {
    "OpenGL.GL": ("OpenGL.GL.", "OpenGL.raw.GL."),
    "OpenGL.GLU": ("OpenGL.GLU.", "OpenGL.raw.GLU"),
    "OpenGL.GLUT": ("OpenGL.GLUT.", "OpenGL.raw.GLUT"),
}


class InnerModules:
    """The stand-ins of one overlay."""

    def __init__(self) -> None:
        self._originals: dict[str, ModuleType] = {}

    def cover(self, public: str, ours: Mapping[str, Any]) -> Iterator[tuple[Any, Any]]:
        """Put stand-ins for what is loaded inside a public module, with ours for its names.

        Yields each function that is stood in for, with ours.
        """
        for name, module in tuple(sys.modules.items()):
            if not name.startswith(_INSIDE.get(public, ())) or name.startswith(EXTENSIONS):
                continue
            names = vars(module)
            covered = {key: ours[key] for key in ours.keys() & names.keys() if callable(names[key])}
            if not covered or name in self._originals:
                continue
            self._originals[name] = module
            stand_in = ModuleType(name)
            vars(stand_in).update(names | covered)
            _put(name, stand_in)
            for key, call in covered.items():
                yield names[key], call

    def remove(self) -> None:
        """Put the modules themselves back."""
        for name, module in self._originals.items():
            _put(name, module)
        self._originals.clear()


def _put(name: str, module: ModuleType) -> None:
    sys.modules[name] = module
    package, _, key = name.rpartition(".")
    if package in sys.modules:
        setattr(sys.modules[package], key, module)
