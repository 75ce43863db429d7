"""GL, looked on as the dome calls it: which program draws how much."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable
from contextlib import contextmanager
from ctypes import c_uint, c_void_p, cast
from functools import wraps
from typing import TYPE_CHECKING, Any

from domeshim.diagnosis.making import WatchedMaking
from domeshim.diagnosis.tally import PATCHES, Tally, count_of, strips_of, tally_of
from domeshim.draw import own_patches, subdivide
from domeshim.driver import callable_from_c
from domeshim.shading.recipe import Patch

if TYPE_CHECKING:
    from collections.abc import Iterator

_PATCH_VERTICES, _PRIMITIVES_GENERATED, _QUERY_RESULT = 0x8E72, 0x8C87, 0x8866
_CURRENT_PROGRAM, _COMPILE_AND_EXECUTE = 0x8B8D, 0x1301
_BY_LIBRARIES = ("glCompileShader", "glLinkProgram", "glDrawArraysInstanced", "glDrawElementsInstanced")
"""What moderngl calls to make programs and to draw by them."""
_MESHES = ("glEvalMesh1", "glEvalMesh2")
_PROGRAM_DRAWS = ("glDrawArrays", "glDrawElements", "glDrawRangeElements", "glMultiDrawArrays")


class WatchedDriver(WatchedMaking):
    """GL's entry points, counted on the way."""

    def __init__(self, seconds: Callable[[], float]) -> None:
        """seconds: the real time, which the program's may not be."""
        super().__init__(seconds)
        self.tallies: defaultdict[int, Tally] = defaultdict(Tally)
        """By the name of the program that was bound; 0 where none of the dome's was."""
        self._block = 0, 0
        """The mode of glBegin, and the vertices since."""
        self._listing: Tally | None = None
        self._listed: dict[int, Tally] = {}
        self._name = self._mode = 0
        self._query = 0
        self._given: Tally | None = None
        """The primitives that the program gave, while their pieces are drawn."""
        self._asking = False
        self._entries: dict[str, Any] = {}
        """Our functions that C code calls, by name."""
        self.doing = ""
        """The pass over the picture that is under way, if one is."""
        self.owners: dict[int, str] = {}
        """Whose pass it was that drew by a program, by that one's name."""
        self.blits: Counter[str] = Counter()
        """Copies from framebuffer to framebuffer, by the pass that made them."""

    def address(self, name: str) -> int:
        """Where the entry point is, to a library that calls GL by itself: ours where we look on."""
        if name not in _BY_LIBRARIES:
            return self._gl.address(name)
        if name not in self._entries:
            self._entries[name] = callable_from_c(name, getattr(self, name))
        return cast(self._entries[name], c_void_p).value or 0

    def begin_picture(self) -> None:
        """Count from the start."""
        self.tallies.clear()
        self.blits.clear()

    def watch_subdivision(self) -> None:
        """Count what is subdivided as the program gave it."""
        for name, cut, primitives in (
            (
                "draw_patches",
                False,
                # A quad's four corners count as the two triangles that they make.
                lambda run, kind, *_: len(run.positions) // Patch(kind).corners,
            ),
            ("draw_cut", True, lambda run, *_: len(run.positions) // 3),
            ("draw_strips", True, lambda _run, lines, *_: len(lines)),
        ):
            setattr(subdivide, name, self._counted_as_given(getattr(subdivide, name), primitives, cut=cut))
        own_patches.draw_copies = self._counted_as_given(
            own_patches.draw_copies,
            lambda patch, _program, halvings, _by_number, copies: copies.size // patch.corners >> halvings,
            cut=False,
        )

    def _counted_as_given(
        self, original: Callable[..., None], primitives: Callable[..., int], *, cut: bool
    ) -> Callable[..., None]:
        @wraps(original)
        def call(*args: Any) -> None:
            self._given = Tally(primitives=primitives(*args), cut=cut)
            try:
                original(*args)
            finally:
                self._given = None

        return call

    def watch_module(self, module: Any) -> None:
        """Count the draws as well that go to GL as the program makes them."""
        for name in _PROGRAM_DRAWS:
            if hasattr(module, name):
                setattr(module, name, self._counted(name, getattr(module, name)))
        for name in _MESHES:
            setattr(module, name, self._counted_mesh(getattr(module, name)))
        new_list, end_list, call_list = module.glNewList, module.glEndList, module.glCallList
        module.glNewList = lambda name, mode: self._into_list(name, mode, new_list)
        module.glEndList = lambda: self._list_complete(end_list)
        module.glCallList = lambda name: self._from_list(name, call_list)

    def _counted(self, name: str, original: Callable[..., Any]) -> Callable[..., Any]:
        @wraps(original)
        def call(*args: Any, **named: Any) -> Any:
            with self._drawing(int(args[0]), count_of(name, args)):
                return original(*args, **named)

        return call

    def _counted_mesh(self, original: Callable[..., Any]) -> Callable[..., Any]:
        @wraps(original)
        def call(mode: int, *limits: int) -> Any:
            with self._drawing(*strips_of(int(mode), [int(limit) for limit in limits])):
                return original(mode, *limits)

        return call

    def glBlitFramebuffer(self, *args: Any) -> None:
        """Count it."""
        self.blits[self.doing] += 1
        self._gl.glBlitFramebuffer(*args)

    # Draws.

    @property
    def _bound(self) -> int:
        """The program that draws now, the dome's or the program's own; 0: GL's fixed stages."""
        return self._gl.integer(_CURRENT_PROGRAM)

    def glDrawArrays(self, mode: int, first: int, count: int) -> None:
        """Count it."""
        with self._drawing(mode, count):
            self._gl.glDrawArrays(mode, first, count)

    def glDrawElements(self, mode: int, count: int, kind: int, indices: Any) -> None:
        """Count it."""
        with self._drawing(mode, count):
            self._gl.glDrawElements(mode, count, kind, indices)

    def glDrawArraysInstanced(self, mode: int, first: int, count: int, instances: int) -> None:
        """Count it."""
        with self._drawing(mode, *[count] * instances):
            self._gl.glDrawArraysInstanced(mode, first, count, instances)

    def glDrawElementsInstanced(self, mode: int, count: int, kind: int, indices: Any, instances: int) -> None:
        """Count it."""
        with self._drawing(mode, *[count] * instances):
            self._gl.glDrawElementsInstanced(mode, count, kind, indices, instances)

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
        self._count(tally_of(*self._block, self._patch(self._block[0])))
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
        self._count(Tally(1, listed.vertices, listed.primitives, listed.generated, listed.cut))
        self._begin_query()
        call_list(name)
        self._end_query()

    @contextmanager
    def _drawing(self, mode: int, *counts: int) -> Iterator[None]:
        whole = Tally(1)
        for count in counts:
            part = tally_of(mode, count, self._patch(mode))
            whole.vertices += part.vertices
            whole.primitives += part.primitives
        self._count(whole)
        self._begin_query()
        yield
        self._end_query()

    def _patch(self, mode: int) -> int:
        """How many vertices a patch has now; 1 where none is drawn."""
        return max(self._gl.integer(_PATCH_VERTICES), 1) if mode == PATCHES else 1

    def glBeginTransformFeedback(self, mode: int) -> None:
        """GL is asked what it evaluates, and draws nothing."""
        self._asking = True
        self._gl.glBeginTransformFeedback(mode)

    def glEndTransformFeedback(self) -> None:
        """What comes now is drawn."""
        self._gl.glEndTransformFeedback()
        self._asking = False

    def _count(self, tally: Tally) -> None:
        if self._asking:
            return
        drawn = tally.generated or tally.primitives
        if self._given is not None:
            tally.primitives, tally.cut = self._given.primitives, self._given.cut
        if self.doing:
            self.owners[self._bound] = self.doing
        if self._listing is not None:
            self._listing.add(tally)
            self._listing.generated += drawn
            if self._mode != _COMPILE_AND_EXECUTE:
                return
        self.tallies[self._bound].add(tally)
        if self._gl.legacy:  # no query, and no shader that makes others of them
            self.tallies[self._bound].generated += drawn

    def _begin_query(self) -> None:
        if self._listing is not None or self._asking or self._gl.legacy:
            return
        if not self._query:
            query = c_uint()
            self._gl.glGenQueries(1, query)
            self._query = query.value
        self._gl.glBeginQuery(_PRIMITIVES_GENERATED, self._query)

    def _end_query(self) -> None:
        if self._listing is not None or self._asking or self._gl.legacy:
            return
        self._gl.glEndQuery(_PRIMITIVES_GENERATED)
        found = c_uint()
        self._gl.glGetQueryObjectuiv(self._query, _QUERY_RESULT, found)
        self.tallies[self._bound].generated += found.value
