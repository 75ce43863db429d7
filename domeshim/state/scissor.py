"""The program's scissor rectangle as edges in its own view, which clip distances can keep on the dome."""

from __future__ import annotations

from dataclasses import dataclass

from domeshim.window.frame import Rectangle

WHOLE = (-1.0, 1.0, -1.0, 1.0)


@dataclass(frozen=True)
class Edges:
    """What a draw may reach of a viewport."""

    bounds: tuple[float, float, float, float] = WHOLE
    """Left, right, bottom, top in the viewport's normalised device coordinates."""
    inner: tuple[int, ...] = ()
    """Those of the four that lie inside the viewport: the scissor's own."""

    @property
    def empty(self) -> bool:
        """Nothing can be reached."""
        left, right, bottom, top = self.bounds
        return left >= right or bottom >= top


def edges_of(scissor: Rectangle | None, viewport: Rectangle) -> Edges:
    """The edges that a scissor rectangle, or none, gives a viewport."""
    if scissor is None:
        return Edges()
    left, right, bottom, top = in_view(scissor, viewport)
    bounds = (max(left, -1.0), min(right, 1.0), max(bottom, -1.0), min(top, 1.0))
    return Edges(bounds, tuple(i for i in range(4) if bounds[i] != WHOLE[i]))


def in_view(rectangle: Rectangle, viewport: Rectangle) -> tuple[float, float, float, float]:
    """Left, right, bottom, top of a rectangle of the window in a viewport's normalised device coordinates."""
    x, y, w, h = rectangle
    vx, vy, vw, vh = viewport
    if vw == 0 or vh == 0:
        return WHOLE
    return 2 * (x - vx) / vw - 1, 2 * (x + w - vx) / vw - 1, 2 * (y - vy) / vh - 1, 2 * (y + h - vy) / vh - 1
