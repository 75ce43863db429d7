"""A mesh of a display list: kept on the GPU in one piece, and in smaller ones once the view asks for them."""

from __future__ import annotations

from functools import cached_property, partial
from typing import TYPE_CHECKING

from domeshim.draw.primitives import Parts, extent_of, parts_of
from domeshim.draw.subdivide import Making, filled, manner, stippled, subdivide

if TYPE_CHECKING:
    from domeshim.draw.extent import Extent
    from domeshim.draw.submit import Submitter
    from domeshim.record.lists import DisplayLists
    from domeshim.record.runs import Run
    from domeshim.state.context import DomeContext
    from domeshim.state.subdivision import Subdivision


class ListedDraw:
    """A draw in a display list that is made once for each of several views, or is a curve."""

    def __init__(self, context: DomeContext, name: int, *, at_raster: bool, curve: bool) -> None:
        """name: of GL's own list that holds it, and nothing beside it; curve: it is drawn as lines."""
        self._context = context
        self._name = name
        self._at_raster = at_raster
        self._curve = curve

    def __call__(self) -> None:
        """Make it."""
        if self._at_raster:
            self._context.draw_at_raster(partial(self._context.driver.glCallList, self._name))
        else:
            patch = self._context.subdividing.line_patch if self._curve else None
            self._context.draw_list(self._name, patch)

    def names(self) -> list[int]:
        """The GL list, to be deleted with it."""
        return [self._name]


class ListedMesh:
    """One run in a display list, drawn in whichever way this call's view needs."""

    def __init__(self, run: Run, context: DomeContext, submitter: Submitter, lists: DisplayLists) -> None:
        self._run = run
        self._context = context
        self._submitter = submitter
        self._lists = lists
        self._whole = lists.compile(lambda: submitter.draw_whole(run))
        self._patches: dict[tuple[object, bool], Kept] = {}
        """By what draws them, for any view that needs no split."""
        self._in_view: Kept | None = None
        """For one view, which was the last, and what is shown there."""
        self._view: object = None

    def __call__(self) -> None:
        """Draw it, and leave its last attributes current."""
        context = self._context
        self._draw(context.subdividing.subdivision(self._extent) if self._extent is not None else None)
        self._submitter.make_current(self._run)

    def names(self) -> list[int]:
        """The GL lists that it has made, to be deleted with it."""
        kept = [*self._patches.values(), *([self._in_view] if self._in_view is not None else [])]
        parts = vars(self).get("_meshes", ())
        return [
            self._whole,
            *(name for k in kept for name in k.names()),
            *(name for part in parts for name in part.names()),
        ]

    def _draw(self, subdivision: Subdivision | None) -> None:
        context = self._context
        if subdivision is None:
            context.draw_list(self._whole)
        elif self._parts is not None and filled(context):
            for part, of_part in zip(
                self._meshes, context.subdividing.subdivisions(self._parts.boxes), strict=True
            ):
                part._draw(of_part)
        elif not self._draw_pieces(subdivision):
            context.draw_list(self._whole)

    @cached_property
    def _extent(self) -> Extent | None:
        return extent_of(self._run)

    @cached_property
    def _parts(self) -> Parts | None:
        return parts_of(self._run)

    @cached_property
    def _meshes(self) -> list[ListedMesh]:
        """One for each part."""
        parts = self._parts
        runs = [parts.joined(k, k + 1) for k in range(len(parts.boxes.longest))] if parts is not None else []
        return [ListedMesh(run, self._context, self._submitter, self._lists) for run in runs]

    def _draw_pieces(self, subdivision: Subdivision) -> bool:
        """Draw it subdivided; False where that cannot show what the program asked for.

        What was split for a view is kept as soon as the same view is asked for again.
        """
        context = self._context
        if not subdivision.split and filled(context) and not stippled(context):
            manner_of = (subdivision.method, subdivision.lengthened)
            if manner_of not in self._patches:
                self._patches[manner_of] = self._keep(subdivision)
            return self._patches[manner_of].draw()
        view = (subdivision, manner(context), context.subdividing.to_eye.tobytes())
        if view != self._view:
            self._view = view
            if self._in_view is not None:
                self._in_view.delete()
                self._in_view = None
            return subdivide(self._run, context, self._submitter, subdivision, None)
        self._in_view = self._in_view or self._keep(subdivision)
        return self._in_view.draw()

    def _keep(self, subdivision: Subdivision) -> Kept:
        kept = Kept(self._context, self._submitter, self._lists)
        kept.shown = subdivide(self._run, self._context, kept, subdivision, None)
        return kept


class Kept:
    """Pieces in GL lists: what draws a run is handed, to draw it again later."""

    def __init__(self, context: DomeContext, submitter: Submitter, lists: DisplayLists) -> None:
        self._context = context
        self._submitter = submitter
        self._lists = lists
        self._draws: list[tuple[int, Making]] = []
        self.shown = False
        """The pieces show what the program asked for."""

    def draw_all(self, mode: int, run: Run, made: Making) -> None:
        """Keep all of a run's vertices, to be drawn by one mode."""
        self._draws.append((self._lists.compile(lambda: self._submitter.draw_all(mode, run)), made))

    def draw_whole(self, run: Run, made: Making) -> None:
        """Keep a run's blocks."""
        self._draws.append((self._lists.compile(lambda: self._submitter.draw_whole(run)), made))

    def completed(self, run: Run) -> Run:
        """The run itself: in a display list every attribute of every vertex is known."""
        return run

    def draw(self) -> bool:
        """Draw what was kept; False where it would not show what the program asked for."""
        for name, made in self._draws:
            made(partial(self._context.driver.glCallList, name))
        return self.shown

    def names(self) -> list[int]:
        """The GL lists."""
        return [name for name, _ in self._draws]

    def delete(self) -> None:
        """Give the GL lists back."""
        for name in self.names():
            self._context.driver.glDeleteLists(name, 1)
