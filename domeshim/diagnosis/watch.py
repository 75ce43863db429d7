"""GL, looked on as the dome calls it: which program draws how much, and what making it cost."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from contextlib import contextmanager
from ctypes import c_uint
from dataclasses import dataclass, field
from functools import wraps
from typing import TYPE_CHECKING, Any

from domeshim.draw.patches import corners
from domeshim.driver import Driver

if TYPE_CHECKING:
    from collections.abc import Iterator

_PATCHES, _PRIMITIVES_GENERATED, _QUERY_RESULT = 0x000E, 0x8C87, 0x8866
_QUADS, _QUAD_STRIP, _POLYGON = 7, 8, 9
_COMPILE_AND_EXECUTE = 0x1301
_PROGRAM_DRAWS = ("glDrawArrays", "glDrawElements", "glDrawRangeElements", "glMultiDrawArrays")


@dataclass
class Tally:
    """What one program drew in a picture."""

    draws: int = 0
    vertices: int = 0
    """Handed to GL."""
    primitives: int = 0
    """Points, lines and triangles that these make."""
    generated: int = 0
    """What came of them, subdivided or not."""

    def add(self, other: Tally) -> None:
        """Count the other's as well."""
        self.draws += other.draws
        self.vertices += other.vertices
        self.primitives += other.primitives


@dataclass
class Made:
    """What it took to make one program."""

    characters: int = 0
    seconds: float = 0.0
    shaders: list[int] = field(default_factory=list)


class WatchedDriver(Driver):
    """GL's entry points, counted on the way."""

    def __init__(self, seconds: Callable[[], float]) -> None:
        """seconds: the real time, which the program's may not be."""
        self._gl = Driver()
        self._seconds = seconds
        self.tallies: defaultdict[int, Tally] = defaultdict(Tally)
        """By the name of the program that was bound; 0 where none of the dome's was."""
        self.made: defaultdict[int, Made] = defaultdict(Made)
        """By the program's name."""
        self._shaders: defaultdict[int, Made] = defaultdict(Made)
        self._bound = 0
        self._block = 0, 0
        """The mode of glBegin, and the vertices since."""
        self._listing: Tally | None = None
        self._listed: dict[int, Tally] = {}
        self._name = self._mode = 0
        self._query = 0

    def begin_picture(self) -> None:
        """Count from the start."""
        self.tallies.clear()

    def watch_module(self, module: Any) -> None:
        """Count the draws as well that go to GL as the program makes them."""
        for name in _PROGRAM_DRAWS:
            if hasattr(module, name):
                setattr(module, name, self._counted(name, getattr(module, name)))
        new_list, end_list, call_list = module.glNewList, module.glEndList, module.glCallList
        module.glNewList = lambda name, mode: self._into_list(name, mode, new_list)
        module.glEndList = lambda: self._list_complete(end_list)
        module.glCallList = lambda name: self._from_list(name, call_list)

    def _counted(self, name: str, original: Callable[..., Any]) -> Callable[..., Any]:
        @wraps(original)
        def call(*args: Any, **named: Any) -> Any:
            with self._drawing(int(args[0]), _count_of(name, args)):
                return original(*args, **named)

        return call

    # Programs.

    def glUseProgram(self, name: int) -> None:
        """Note which program draws."""
        self._bound = int(name)
        self._gl.glUseProgram(name)

    def glShaderSource(self, shader: int, count: int, texts: Any, lengths: Any) -> None:
        """Note how long the text is."""
        value = getattr(texts, "value", None)
        self._shaders[int(shader)].characters = len(value) if isinstance(value, bytes) else 0
        self._gl.glShaderSource(shader, count, texts, lengths)

    def glCompileShader(self, shader: int) -> None:
        """Note how long it took."""
        began = self._seconds()
        self._gl.glCompileShader(shader)
        self._shaders[int(shader)].seconds = self._seconds() - began

    def glAttachShader(self, program: int, shader: int) -> None:
        """Note what the program is made of."""
        self.made[int(program)].shaders.append(int(shader))
        self._gl.glAttachShader(program, shader)

    def glLinkProgram(self, program: int) -> None:
        """Note how long it took, with the time of its shaders."""
        made, began = self.made[int(program)], self._seconds()
        self._gl.glLinkProgram(program)
        parts = [self._shaders[shader] for shader in made.shaders]
        made.seconds = self._seconds() - began + sum(part.seconds for part in parts)
        made.characters = sum(part.characters for part in parts)

    # Draws.

    def glDrawArrays(self, mode: int, first: int, count: int) -> None:
        """Count it."""
        with self._drawing(mode, count):
            self._gl.glDrawArrays(mode, first, count)

    def glDrawElements(self, mode: int, count: int, kind: int, indices: Any) -> None:
        """Count it."""
        with self._drawing(mode, count):
            self._gl.glDrawElements(mode, count, kind, indices)

    def glMultiDrawArrays(self, mode: int, firsts: Any, counts: Any, number: int) -> None:
        """Count it, as one."""
        with self._drawing(mode, *(counts[i] for i in range(number))):
            self._gl.glMultiDrawArrays(mode, firsts, counts, number)

    def glBegin(self, mode: int) -> None:
        """A primitive begins."""
        self._block = int(mode), 0
        self._begin_query()
        self._gl.glBegin(mode)

    def glVertex3f(self, x: float, y: float, z: float) -> None:
        """Count it."""
        self._block = self._block[0], self._block[1] + 1
        self._gl.glVertex3f(x, y, z)

    def glVertex4f(self, x: float, y: float, z: float, w: float) -> None:
        """Count it."""
        self._block = self._block[0], self._block[1] + 1
        self._gl.glVertex4f(x, y, z, w)

    def glEnd(self) -> None:
        """Count the primitive."""
        self._gl.glEnd()
        self._count(_tally(*self._block))
        self._end_query()

    def glNewList(self, name: int, mode: int) -> None:
        """What is drawn now goes into a list."""
        self._into_list(name, mode, self._gl.glNewList)

    def glEndList(self) -> None:
        """The list is complete."""
        self._list_complete(self._gl.glEndList)

    def glCallList(self, name: int) -> None:
        """Count what is in the list."""
        self._from_list(name, self._gl.glCallList)

    def _into_list(self, name: int, mode: int, new_list: Callable[[int, int], Any]) -> None:
        new_list(name, mode)
        self._name, self._mode, self._listing = int(name), int(mode), Tally()

    def _list_complete(self, end_list: Callable[[], Any]) -> None:
        end_list()
        if self._listing is not None:
            self._listed[self._name] = self._listing
            self._listing = None

    def _from_list(self, name: int, call_list: Callable[[int], Any]) -> None:
        listed = self._listed.get(int(name))
        if listed is None or not listed.draws:
            call_list(name)
            return
        self._count(Tally(1, listed.vertices, listed.primitives))
        self._begin_query()
        call_list(name)
        self._end_query()

    @contextmanager
    def _drawing(self, mode: int, *counts: int) -> Iterator[None]:
        whole = Tally(1)
        for count in counts:
            part = _tally(mode, count)
            whole.vertices += part.vertices
            whole.primitives += part.primitives
        self._count(whole)
        self._begin_query()
        yield
        self._end_query()

    def _count(self, tally: Tally) -> None:
        if self._listing is not None:
            self._listing.add(tally)
            if self._mode != _COMPILE_AND_EXECUTE:
                return
        self.tallies[self._bound].add(tally)

    def _begin_query(self) -> None:
        if self._listing is not None:
            return
        if not self._query:
            query = c_uint()
            self._gl.glGenQueries(1, query)
            self._query = query.value
        self._gl.glBeginQuery(_PRIMITIVES_GENERATED, self._query)

    def _end_query(self) -> None:
        if self._listing is not None:
            return
        self._gl.glEndQuery(_PRIMITIVES_GENERATED)
        found = c_uint()
        self._gl.glGetQueryObjectuiv(self._query, _QUERY_RESULT, found)
        self.tallies[self._bound].generated += found.value


def _tally(mode: int, count: int) -> Tally:
    """One draw of so many vertices; GL counts a quad, or a polygon, as one. Patches count as triangles."""
    primitives = count // 3 if mode == _PATCHES else len(corners(mode, count)) if mode < 10 else 0
    if mode in (_QUADS, _QUAD_STRIP):
        primitives //= 2
    elif mode == _POLYGON:
        primitives = min(primitives, 1)
    return Tally(1, count, primitives)


def _count_of(name: str, args: tuple[Any, ...]) -> int:
    """How many vertices a call of the program's draws."""
    place = {"glDrawElements": 1, "glDrawArrays": 2, "glDrawRangeElements": 3}.get(name)
    try:
        return int(args[place]) if place is not None else int(sum(args[2]))
    except (IndexError, TypeError, ValueError):
        return 0
