"""A mesh that stays as it is: judged in each view, and kept in pieces while the view stays as well."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property, partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from domeshim.draw.order import order_shows
from domeshim.draw.patches import Indices
from domeshim.draw.primitives import Primitives, extent_of, many_primitives
from domeshim.draw.subdivide import Making, filled, in_strips, manner, subdivide

if TYPE_CHECKING:
    from domeshim.draw.extent import Extent
    from domeshim.draw.submit import Submitter
    from domeshim.record.lists import DisplayLists
    from domeshim.record.runs import Run
    from domeshim.state.context import DomeContext
    from domeshim.state.subdivision import Subdivision

ByNumber = Callable[[int, NDArray[np.uint32]], object]
"""Draws vertices of a mesh that GL has already, by a mode and their numbers in the run."""


class Standing:
    """One run that does not change."""

    def __init__(
        self,
        read: Callable[[], Run],
        context: DomeContext,
        submitter: Submitter,
        lists: DisplayLists,
        by_number: ByNumber,
    ) -> None:
        """read: gives the run; it is kept once it is needed in pieces."""
        self._read = read
        self._context = context
        self._lists = lists
        self._submitter = submitter
        self._by_number = by_number
        self._patches: dict[tuple[object, bool], Kept] = {}
        """By what draws them, for any view that needs no split."""
        self._in_view: Kept | None = None
        """For one view, which was the last, and what is shown there."""
        self._view: object = None

    def draw(self) -> bool:
        """Draw it in pieces where this view needs that; False where it is to be drawn whole.

        What was cut for a view is kept as soon as the same view is asked for again.
        """
        subdivision = self._context.subdividing.subdivision(self.extent) if self.extent else None
        if subdivision is None:
            return False
        context = self._context
        alike = self._primitives is None and not subdivision.split
        if alike and filled(context) and not in_strips(context):
            manner_of = (subdivision.method, subdivision.lengthened)
            if manner_of not in self._patches:
                self._patches[manner_of] = self._keep(subdivision)
            return self._patches[manner_of].draw()
        view = (
            subdivision,
            manner(context),
            order_shows(context.driver),
            context.subdividing.tolerance,
            context.subdividing.to_eye.tobytes(),
        )
        if view != self._view:
            self._view = view
            if self._in_view is not None:
                self._in_view.delete()
                self._in_view = None
            at_once = AtOnce(self._submitter, self._by_number)
            return subdivide(self._run, context, at_once, subdivision, self._primitives)
        self._in_view = self._in_view or self._keep(subdivision)
        return self._in_view.draw()

    def names(self) -> list[int]:
        """The GL lists that it has made, to be deleted with it."""
        return [name for kept in self._kept for name in kept.names()]

    def delete(self) -> None:
        """Give them back."""
        for kept in self._kept:
            kept.delete()

    @property
    def _kept(self) -> list[Kept]:
        return [*self._patches.values(), *([self._in_view] if self._in_view is not None else [])]

    @cached_property
    def extent(self) -> Extent | None:
        """How large the run is; None where it has no edges."""
        return extent_of(self._read())

    @cached_property
    def _run(self) -> Run:
        return self._read()

    @cached_property
    def _primitives(self) -> Primitives | None:
        return many_primitives(self._run)

    def _keep(self, subdivision: Subdivision) -> Kept:
        kept = Kept(self._context, self._submitter, self._lists, self._by_number)
        kept.shown = subdivide(self._run, self._context, kept, subdivision, self._primitives)
        return kept


class AtOnce:
    """Draws a run that GL has already: uploads its pieces alone."""

    def __init__(self, submitter: Submitter, by_number: ByNumber) -> None:
        self._by_number = by_number
        self.draw_all = submitter.draw_all
        self.draw_whole = submitter.draw_whole
        self.completed = submitter.completed

    def draw_some(self, mode: int, run: Run, indices: Indices, made: Making) -> None:  # noqa: ARG002
        """Draw those vertices by one mode."""
        made(partial(self._by_number, mode, indices.ravel().astype(np.uint32)))


class Kept:
    """Pieces in GL lists: what draws a run is handed, to draw it again later."""

    def __init__(
        self, context: DomeContext, submitter: Submitter, lists: DisplayLists, by_number: ByNumber
    ) -> None:
        self._context = context
        self._submitter = submitter
        self._lists = lists
        self._by_number = by_number
        self._names: list[int] = []
        self._draws: list[tuple[Callable[[], object], Making]] = []
        self.shown = False
        """The pieces show what the program asked for."""

    def draw_all(self, mode: int, run: Run, made: Making) -> None:
        """Keep all of a run's vertices, to be drawn by one mode."""
        self._compile(lambda: self._submitter.draw_all(mode, run), made)

    def draw_whole(self, run: Run, made: Making) -> None:
        """Keep a run's blocks."""
        self._compile(lambda: self._submitter.draw_whole(run), made)

    def draw_some(self, mode: int, run: Run, indices: Indices, made: Making) -> None:  # noqa: ARG002
        """Keep which vertices to draw by one mode."""
        self._draws.append((partial(self._by_number, mode, indices.ravel().astype(np.uint32)), made))

    def completed(self, run: Run) -> Run:
        """The run with every attribute of every vertex known."""
        return self._submitter.completed(run)

    def draw(self) -> bool:
        """Draw what was kept; False where it would not show what the program asked for."""
        for draw, made in self._draws:
            made(draw)
        return self.shown

    def names(self) -> list[int]:
        """The GL lists."""
        return self._names

    def delete(self) -> None:
        """Give the GL lists back."""
        for name in self._names:
            self._context.driver.glDeleteLists(name, 1)

    def _compile(self, draw: Callable[[], None], made: Making) -> None:
        name = self._lists.compile(draw)
        self._names.append(name)
        self._draws.append((partial(self._context.driver.glCallList, name), made))
