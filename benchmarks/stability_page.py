"""The page that benchmarks/stability.py writes: docs/stability.md."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from domeshim.measure.formulas import FormulaError
from domeshim.measure.room import RoomError
from domeshim.measure.stability import METHODS, SIZES, TOLERANCES, Row

TOLERANCE = 0.5
"""At which the methods beside auto are measured, pixels."""
BROKEN = "**{}**"
"""How a figure above the tolerance is shown."""
_ALMOST = 1e-3

HEAD = """# Numbers under stress

Written by `make stability`, on {renderer}.

Each case is drawn by the dome's own pipeline; the vertices that go to the rasteriser, in single precision,
are caught by transform feedback and joined as it would join them, clip distances included. What they make is
held in double precision against the great circles that it stands for. A figure is the largest distance in
pixels, of any drawn place of a line or of a surface's outline from where it belongs, and of anything that
should be seen from what is drawn. So it also counts what is torn, missing, inside out, or ends short of the
rim. Bold figures are above the tolerance.
"""


def page(
    rows: Sequence[Row], formulas: Sequence[FormulaError], rooms: Sequence[RoomError], renderer: str
) -> str:
    """The whole page, in Markdown."""
    parts = [
        HEAD.format(renderer=renderer),
        "## Method auto at every tolerance\n",
        *_auto([row for row in rows if row.method == "auto"]),
        "## Every method at a tolerance of 0.5 pixels\n",
        "Frames of " + ", ".join(f"{size}x{size}" for size in SIZES) + " pixels, one figure each.\n",
        *_methods(rows),
        "## The formula\n",
        *_formulas(formulas),
        "## A textured room\n",
        *_rooms(rooms),
    ]
    return "\n".join(parts)


def _auto(rows: Sequence[Row]) -> Iterable[str]:
    columns = [(tolerance, size) for tolerance in TOLERANCES for size in SIZES]
    yield from _head("case", *(f"{tolerance:g} px, {size}" for tolerance, size in columns), "inside")
    kept = total = 0
    for row in rows:
        cells = []
        for tolerance, size in columns:
            off = row.pixels(size, tolerance).edges
            cells.append(_figure(off, tolerance))
            total, kept = total + 1, kept + (off <= tolerance)
        inside = max(row.pixels(size, tolerance).inside / tolerance for tolerance, size in columns)
        yield _line(row.case.name, *cells, f"{inside:.1f}" if inside else "")
    yield (
        f"\n{kept} of {total} figures are within the tolerance. *Inside*: how far places inside a surface, "
        "away from its outline, are off at most, as a multiple of the tolerance.\n"
    )


def _methods(rows: Sequence[Row]) -> Iterable[str]:
    yield from _head("case", *METHODS)
    for name in dict.fromkeys(row.case.name for row in rows):
        found = {row.method: row for row in rows if row.case.name == name}
        cells = []
        for method in METHODS:
            offs = [found[method].pixels(size, TOLERANCE).edges for size in SIZES]
            cells.append(", ".join(_figure(off, TOLERANCE) for off in offs))
        yield _line(name, *cells)
    yield (
        "\nMethod cubemap draws no geometry onto the disc, and is judged by its picture below. Methods paper "
        "and vertex do not subdivide: they are as exact as the program's own edges are short.\n"
    )


def _formulas(errors: Sequence[FormulaError]) -> Iterable[str]:
    yield (
        "The place on an equidistant disc of 180 degrees in single precision on the GPU, for angles from\n"
        "the axis (phi) of 1e-8 to pi: the largest error in radii of the disc, and the phi where it is. The\n"
        "first three are the usual forms with acos and asin, of the kind of E. Durand's \"Spherical\n"
        'projection through GLSL"; they lose half their digits where the slope is infinite.\n'
    )
    distances = list(dict.fromkeys(error.distance for error in errors))
    yield from _head("formula", *(f"at a distance of {distance:g}" for distance in distances))
    for name in dict.fromkeys(error.formula for error in errors):
        found = {error.distance: error for error in errors if error.formula == name}
        yield _line(name, *(_formula(found[distance]) for distance in distances))
    yield ""


def _formula(error: FormulaError) -> str:
    if error.radii == float("inf"):
        return f"no number, phi = {error.phi:.4g}"
    return f"{error.radii:.2g}, phi = {error.phi:.6g}"


def _rooms(rooms: Sequence[RoomError]) -> Iterable[str]:
    yield (
        "Six textured quads around the viewer at 1024x1024 pixels, against rays cast in double precision, "
        "16 a pixel. The texture is smooth, so that its filter makes no difference.\n"
    )
    yield from _head("method", "RMS difference, of 255", "pixels off by more than 8 of 255")
    for room in rooms:
        yield _line(room.method, f"{room.rms:.2f}", f"{100 * room.wrong:.2f} %")


def _figure(off: float, tolerance: float) -> str:
    if off == float("inf"):
        shown = "not drawn"
    elif off < _ALMOST:
        shown = "0"
    else:
        shown = f"{off:.2f}" if off < 100 else f"{off:.0f}"
    return BROKEN.format(shown) if off > tolerance else shown


def _head(*names: str) -> Iterable[str]:
    yield _line(*names)
    yield _line("---", *("---:" for _ in names[1:]))


def _line(*cells: str) -> str:
    return "| " + " | ".join(cells) + " |"
