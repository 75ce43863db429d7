"""A mesh of a display list: kept on the GPU in one piece, and in smaller ones once the view asks for them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.own_patches import draw_parts, own_parts
from domeshim.draw.standing import Standing
from domeshim.draw.upload import Upload

if TYPE_CHECKING:
    from domeshim.draw.submit import Submitter
    from domeshim.record.lists import DisplayLists
    from domeshim.record.runs import Run
    from domeshim.state.context import DomeContext


class ListedDraw:
    """A draw in a display list that is not made as the rest of the list is."""

    def __init__(self, name: int, made: Callable[[int], object]) -> None:
        """name: of GL's own list that holds it, and nothing beside it; made: draws such a list."""
        self._name = name
        self._made = made

    def __call__(self) -> None:
        """Make it."""
        self._made(self._name)

    def names(self) -> list[int]:
        """The GL list, to be deleted with it."""
        return [self._name]

    def delete(self) -> None:
        """Nothing: it has no more of GL."""


class ListedMesh:
    """One run in a display list, drawn in whichever way this call's view needs."""

    def __init__(self, run: Run, context: DomeContext, submitter: Submitter, lists: DisplayLists) -> None:
        self._run = run
        self._context = context
        self._submitter = submitter
        self._whole = lists.compile(lambda: submitter.draw_whole(run))
        self._standing = Standing(lambda: run, context, submitter, lists, self._by_number)
        self._upload: Upload | None = None
        """The run in a buffer, once some of its primitives are to be drawn."""

    def __call__(self) -> None:
        """Draw it, and leave its last attributes current."""
        parts = own_parts(self._context, self._run.blocks, lambda: self._standing.extent)
        if parts is not None:
            draw_parts(self._context, parts, self._by_number)
        elif not self._standing.draw():
            self._context.draw_list(self._whole)
        self._submitter.make_current(self._run)

    def names(self) -> list[int]:
        """The GL lists that it has made, to be deleted with it."""
        return [self._whole, *self._standing.names()]

    def delete(self) -> None:
        """Give back what it has of GL beside the lists."""
        if self._upload is not None:
            self._upload.delete()

    def _by_number(self, mode: int, numbers: NDArray[np.uint32]) -> None:
        first = self._upload is None
        self._upload = self._upload or Upload(self._context.driver)
        self._submitter.set_constant(self._run)
        with self._upload.bound(self._run if first else None):
            self._upload.draw_some(mode, numbers)
