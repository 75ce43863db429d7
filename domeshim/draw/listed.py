"""A mesh of a display list: kept on the GPU in one piece, and in patches once the view asks for them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from domeshim.draw.extent import Extent
from domeshim.draw.subdivide import extent_of, filled, patches, subdivide

if TYPE_CHECKING:
    from domeshim.draw.patches import Kind
    from domeshim.draw.submit import Submitter
    from domeshim.record.immediate import Run
    from domeshim.record.lists import DisplayLists
    from domeshim.state.context import DomeContext


class ListedMesh:
    """One run in a display list, drawn in whichever way this call's view needs."""

    def __init__(self, run: Run, context: DomeContext, submitter: Submitter, lists: DisplayLists) -> None:
        self._run = run
        self._context = context
        self._submitter = submitter
        self._lists = lists
        self._extent: Extent | None = extent_of(run)
        self._whole = lists.compile(lambda: submitter.draw_whole(run))
        self._patches: list[tuple[Kind, int]] | None = None

    def __call__(self) -> None:
        """Draw it, and leave its last attributes current."""
        context = self._context
        subdivision = context.subdivision(self._extent) if self._extent is not None else None
        if subdivision == "split" or (subdivision and not filled(context)):
            if not subdivide(self._run, context, self._submitter, subdivision):
                context.call_list(self._whole)
        elif subdivision:
            for kind, name in self._in_patches():
                context.call_list(name, None if kind == "points" else kind)
        else:
            context.call_list(self._whole)
        self._submitter.make_current(self._run)

    def names(self) -> list[int]:
        """The GL lists that it has made, to be deleted with it."""
        return [self._whole, *(name for _, name in self._patches or ())]

    def _in_patches(self) -> list[tuple[Kind, int]]:
        if self._patches is None:
            self._patches = [
                (kind, self._lists.compile(self._drawing(mode, piece)))
                for kind, mode, piece in patches(self._run)
            ]
        return self._patches

    def _drawing(self, mode: int, piece: Run) -> Callable[[], None]:
        return lambda: self._submitter.draw_all(mode, piece)
