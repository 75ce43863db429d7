"""The work-precision plot: time against error, a panel a scene, a curve a method. Needs matplotlib."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from domeshim.bench.results import Results, Row

_COLUMNS = 3
_MARKS = ("o", "s", "^", "D", "v", "P", "X", "*")
_Error = Callable[[Row], float | None]


def work_precision(results: Results, output: Path) -> None:
    """Write the plot as PNG, SVG or PDF, by the name's ending. Raises OSError, ValueError."""
    from matplotlib.figure import Figure  # noqa: PLC0415 - large, and an extra

    panels = list(_panels(results))
    columns = min(_COLUMNS, len(panels))
    rows = -(-len(panels) // columns)
    figure = Figure(figsize=(4.2 * columns, 3.4 * rows + 0.6), layout="constrained")
    axes = figure.subplots(rows, columns, squeeze=False, sharey=True).ravel()
    families = list(dict.fromkeys(row.family for row in results.rows))
    marks = {family: (_MARKS[k % len(_MARKS)], f"C{k % 10}") for k, family in enumerate(families)}
    handles: dict[str, Any] = {}
    for panel, (title, unit, chosen, error) in zip(axes, panels, strict=False):
        _draw(panel, chosen, error, marks, handles)
        panel.set_title(title, fontsize="medium")
        panel.set_xlabel(unit)
        panel.set_ylabel("time / stock monitor's")
    for panel in axes[len(panels) :]:
        panel.set_axis_off()
    figure.legend(handles.values(), handles.keys(), loc="outside lower center", ncols=len(handles))
    figure.savefig(output, dpi=80)


def _panels(results: Results) -> list[tuple[str, str, list[Row], _Error]]:
    """(title, what the error is, rows, error of a row) of each panel that has something to show."""
    found: list[tuple[str, str, list[Row], _Error]] = []
    for title, size, rows in results.scenes():
        if any(_largest(row) is not None for row in rows):
            found.append((f"{title}\n{size}x{size}", "largest error of an edge, pixels", rows, _largest))
        if any(row.seen is not None and row.seen.moved is not None for row in rows):
            found.append((f"{title}\n{size}x{size}", "largest displacement, pixels", rows, _moved))
        if any(row.colour is not None for row in rows):
            found.append((f"{title}\n{size}x{size}: colour", "RMS error, of 255", rows, _colour))
    return found


def _largest(row: Row) -> float | None:
    return row.edges.largest if row.edges is not None and row.edges.largest < float("inf") else None


def _moved(row: Row) -> float | None:
    return row.seen.moved if row.seen is not None else None


def _colour(row: Row) -> float | None:
    return row.colour


def _draw(
    panel: Any, rows: Sequence[Row], error: _Error, marks: dict[str, tuple[str, str]], handles: dict[str, Any]
) -> None:
    for family in dict.fromkeys(row.family for row in rows):
        points = [(error(row), row.cost.ratio, row.detail) for row in rows if row.family == family]
        drawn = [(x, y, detail) for x, y, detail in points if x is not None]
        if not drawn:
            continue
        mark, colour = marks[family]
        x, y, _ = zip(*drawn, strict=True)
        width = 2.0 if family == "auto" else 1.0
        (handles[family],) = panel.loglog(
            x, y, marker=mark, color=colour, linewidth=width, markersize=5, label=family
        )
        for each in drawn if len(drawn) > 1 else ():
            panel.annotate(
                each[2], each[:2], xytext=(4, 3), textcoords="offset points", fontsize=6, color=colour
            )
    panel.axhline(1.0, color="0.4", linewidth=0.8)
    for axis in (panel.xaxis, panel.yaxis):
        _label_plainly(axis)
    panel.grid(visible=True, which="major", alpha=0.3)
    panel.margins(0.12)


def _label_plainly(axis: Any) -> None:
    """Numbers such as 0.2 and 50 along a logarithmic axis."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: PLC0415 - as above

    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0), numticks=8))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())
