"""A mesh of a display list: kept on the GPU in one piece, and in patches once the view asks for them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from domeshim.draw.extent import Extent
from domeshim.draw.subdivide import extent_of, filled, primitives_of, stippled, subdivide, taken
from domeshim.shading.recipe import Patch, PatchMethod

if TYPE_CHECKING:
    from domeshim.draw.submit import Submitter
    from domeshim.record.immediate import Run
    from domeshim.record.lists import DisplayLists
    from domeshim.state.context import DomeContext
    from domeshim.state.subdivision import Subdivision

_POINTS = 0x0000


class ListedMesh:
    """One run in a display list, drawn in whichever way this call's view needs."""

    def __init__(self, run: Run, context: DomeContext, submitter: Submitter, lists: DisplayLists) -> None:
        self._run = run
        self._context = context
        self._submitter = submitter
        self._lists = lists
        self._extent: Extent | None = extent_of(run)
        self._whole = lists.compile(lambda: submitter.draw_whole(run))
        self._patches: list[tuple[Patch | None, int]] | None = None

    def __call__(self) -> None:
        """Draw it, and leave its last attributes current."""
        context = self._context
        subdivision = context.subdivision(self._extent) if self._extent is not None else None
        if subdivision is None:
            context.draw_list(self._whole)
        elif subdivision.split or not filled(context) or stippled(context):
            if not subdivide(self._run, context, self._submitter, subdivision):
                context.draw_list(self._whole)
        else:
            for patch, name in self._in_patches(subdivision):
                context.draw_list(name, patch)
        self._submitter.make_current(self._run)

    def names(self) -> list[int]:
        """The GL lists that it has made, to be deleted with it."""
        return [self._whole, *(name for _, name in self._patches or ())]

    def _in_patches(self, subdivision: Subdivision) -> list[tuple[Patch | None, int]]:
        if self._patches is None:
            self._patches = []
            method: PatchMethod = "geometry" if subdivision.method == "geometry" else "tessellate"
            for kind, indices in primitives_of(self._run):
                patch = None if kind == "points" else Patch(kind, method)
                piece = taken(self._run, indices)
                name = self._lists.compile(self._drawing(patch.mode if patch else _POINTS, piece))
                self._patches.append((patch, name))
        return self._patches

    def _drawing(self, mode: int, piece: Run) -> Callable[[], None]:
        return lambda: self._submitter.draw_all(mode, piece)
