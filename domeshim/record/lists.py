"""Display lists: GL keeps what it can by itself; what concerns the dome runs when the list is called.

A list is a row of parts. Geometry, matrices, materials and the like are compiled into GL's own lists; a call
that the dome must see (glEnable(GL_LIGHTING), glMatrixMode, another list ...) is kept as it was made. Most
lists are a single part, under the program's own name.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Protocol, runtime_checkable

from domeshim.driver import Driver
from domeshim.record.bitmaps import Bitmap, Written

Part = int | Callable[[], object]
"""The name of a GL list, or a call to make."""


@runtime_checkable
class Mesh(Protocol):
    """A part that has GL lists of its own."""

    def __call__(self) -> None:
        """Draw it."""

    def names(self) -> list[int]:
        """The GL lists that it has made."""

    def delete(self) -> None:
        """Give back what it has of GL beside them."""


_COMPILE = 0x1300
_DEEPEST = 64
"""OpenGL 2.1, table 6.39: GL_MAX_LIST_NESTING."""
_OWN_NAMES = 0x4000_0000
"""Names of further parts begin here, far above what programs choose for themselves."""


@dataclass
class Building:
    """A list between glNewList and glEndList."""

    name: int
    execute: bool
    matrix_mode: int
    """The matrix stack that calls go to at this place of the list."""
    parts: list[Part] = field(default_factory=list)
    used: bool = False
    """The open part holds something."""
    meshes: int = 0
    """How many meshes are kept as parts of their own."""


class DisplayLists:
    """The lists of one context that consist of more than one part, and the one being built."""

    def __init__(self, driver: Driver, *, apart: bool = False) -> None:
        """apart: what draws is kept in parts of its own; the others change state, and are called as is."""
        self._driver = driver
        self._apart = apart
        self._lists: dict[int, list[Part]] = {}
        self._next = _OWN_NAMES
        self._depth = 0
        self.building: Building | None = None

    def begin(self, name: int, *, execute: bool, matrix_mode: int) -> None:
        """The program's glNewList has opened the GL list of this name, the first part."""
        self.building = Building(name, execute, matrix_mode, [name])

    def keep(self, call: Callable[[], object]) -> None:
        """A call that must run when the list does: close the open part, keep it, open the next."""
        self.keep_mesh(lambda: call)

    def keep_mesh(self, make: Callable[[], Callable[[], object]]) -> None:
        """A mesh that chooses at each call how it is drawn; make may compile lists of its own for it."""
        building = self.building
        assert building is not None
        self._driver.glEndList()
        self._drop_unused(building)
        building.parts += [make(), self._free_name()]
        building.used = False
        self._driver.glNewList(building.parts[-1], _COMPILE)

    def compile(self, draw: Callable[[], object]) -> int:
        """A GL list of what draw() draws, under a free name."""
        name = self._free_name()
        self._driver.glNewList(name, _COMPILE)
        draw()
        self._driver.glEndList()
        return name

    def _free_name(self) -> int:
        self._next += 1
        while self._driver.glIsList(self._next):  # glGenLists gives names above the highest in use
            self._next += 1
        return self._next

    def end(self) -> Building:
        """The program's glEndList has closed the open part."""
        building = self.building
        assert building is not None
        self.building = None
        self._drop_unused(building)
        self.forget(building.name, 1)
        if self._apart or building.parts != [building.name]:
            self._lists[building.name] = building.parts
        return building

    def run(self, name: int, call_own: Callable[[int], object]) -> None:
        """Call a list; call_own calls one of GL's own. Lists nested too deep do nothing, as in GL."""
        parts = self._lists.get(name)
        if parts is None:
            call_own(name)
            return
        if self._depth >= _DEEPEST:
            return
        self._depth += 1
        call_own = self._driver.glCallList if self._apart else call_own
        try:
            for part in parts:
                if isinstance(part, int):
                    call_own(part)
                else:
                    part()
        finally:
            self._depth -= 1

    def bitmaps(self, name: int) -> Sequence[Bitmap] | None:
        """What a list draws that is nothing but bitmaps; none where there is no such list."""
        parts = self._lists.get(name)
        if parts is None:
            return None if self._driver.glIsList(name) else ()
        only = parts[0] if len(parts) == 1 else None
        return only.bitmaps if isinstance(only, Written) else None

    @property
    def all_plain(self) -> bool:
        """Every list is one part under its own name."""
        return not self._lists

    def forget(self, first: int, count: int) -> None:
        """Delete the further parts of these lists; those of their own names the program deletes."""
        for name in [n for n in self._lists if first <= n < first + count]:
            for part in self._lists.pop(name):
                own = part.names() if isinstance(part, Mesh) else [part] if isinstance(part, int) else []
                if isinstance(part, Mesh):
                    part.delete()
                for list_name in own:
                    if list_name != name:
                        self._driver.glDeleteLists(list_name, 1)

    def _drop_unused(self, building: Building) -> None:
        last = building.parts[-1]
        if not building.used and isinstance(last, int):
            building.parts.pop()
            if last != building.name:
                self._driver.glDeleteLists(last, 1)
