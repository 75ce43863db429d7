"""The page that says how the programs of PyOpenGL-Demo fare on the dome."""

from __future__ import annotations

import datetime
import importlib.metadata
import math
import platform
from collections.abc import Iterator
from dataclasses import dataclass

from domeshim import __version__
from domeshim.measure.reference import StockPicture

SIZE = 768
FRAME = 1
LIMIT = 0.02
FINE_SIZE = round(SIZE * math.pi / 2)
"""So many pixels across, the dome's middle has pixels as wide as those in the middle of a SIZE pixel face."""
ON_SCREEN = 5.0
"""Seconds for which a program must run with DOME=1 on a screen without an error."""

PAGE = f"""\
# The corpus: PyOpenGL-Demo on the dome

Written by `make corpus`; do not edit. Every program of the package PyOpenGL-Demo, unchanged.

{{versions}}
Pictures of {SIZE} x {SIZE} pixels, number {FRAME} of each program; limit {LIMIT}.

- {{programs}} programs, {{run}} of which run natively on this Python.
- {{on_screen}} of those {{run}} run with DOME=1.
- {{judged}} of them set a perspective in one viewport, so that the reference can judge them: {{within}} are
  within the limit, and {{lines}} more where lines are as wide in both pictures (*thin lines* below).
- {{same}} of the {{run}} show stock PyOpenGL's picture under `--mode monitor`.

## How to read the table

- **DOME=1**: `DOME=1 python PROGRAM` on a screen, for {ON_SCREEN:g} seconds: yes, or what went wrong.
- **dome**: the share of wrong pixels of `domeshim capture --hud off` against a reference in which nothing is
  domeshim's: the program by stock PyOpenGL and freeglut, six times, along the faces of a cube, resampled in
  numpy to an equidistant picture (`domeshim/measure/reference.py`). Wrong is a pixel that shows something in
  either picture, in a colour that the other does not show within 2 pixels (`domeshim/measure/match.py`).
- **dome at {FINE_SIZE}**: for programs over the limit, the same where our picture is taken at {FINE_SIZE}
  pixels and scaled down to {SIZE}. A line is a pixel wide on a face and on the dome alike, but in the middle
  of the view the dome's pixels are pi/2 times as wide as a face's: so lines are, at any size that both
  pictures have in common, pi/2 times as wide as the reference's. At {FINE_SIZE} pixels they are alike.
  Where that settles the difference, the remark says *thin lines*.
- **monitor**: the same share for `--mode monitor` against the program's own picture by stock PyOpenGL and
  freeglut.
- *flat*: it sets no perspective by gluPerspective or glFrustum, so that the cube's faces say nothing of it;
  the dome column is empty, or says why there was no picture.
- *several viewports*: it shows several perspectives side by side; a cube's face has room for one.
- *fog*: stock GL reckons fog by depth, which differs from face to face; the dome by distance.
- *another picture at each run*: two native runs differ, so there is nothing to hold ours against.

## Programs

{{table}}

## Programs that do not run natively on this Python

| program | the last that it says |
|---|---|
{{refused}}

## No programs

Modules that the others import, of which some try themselves when they are started, but wait for no window:
{{modules}}.
"""


@dataclass(frozen=True)
class Row:
    """What was found of one program; None is what was not measured."""

    path: str
    native: str | None = None
    """Why it does not run natively; None where it does."""
    is_program: bool = True
    stock: StockPicture | None = None
    on_screen: str | None = None
    """What went wrong with DOME=1 on a screen; empty where nothing did."""
    monitor: float | str | None = None
    """The share of wrong pixels, or why there is no picture."""
    dome: float | str | None = None
    unjudged: str = ""
    """Why the program fails along a face of the cube, where it does."""
    fine: float | str | None = None
    """The dome's share where our picture was taken at FINE_SIZE."""
    repeats: bool = True
    """Two native runs show the same picture; looked at only where a share is over the limit."""

    @property
    def flat(self) -> bool:
        """It sets no perspective, so that the cube's faces say nothing."""
        return self.stock is not None and not self.stock.perspectives

    @property
    def split(self) -> bool:
        """It sets perspectives in several viewports, of which the cube's faces know nothing."""
        return self.stock is not None and self.stock.viewports > 1

    @property
    def fails(self) -> bool:
        """It runs natively, and not on the dome, or its picture is wrong."""
        shares = (self.monitor, self.dome)
        wrong = any(isinstance(share, str) or (share or 0.0) > LIMIT for share in shares)
        return self.native is None and (bool(self.on_screen) or wrong)


def brief(row: Row) -> str:
    """One program's result for the progress's line."""
    if not row.is_program:
        return "no program"
    if row.native is not None:
        return f"does not run natively: {row.native}"
    return f"screen {row.on_screen or 'ok'}, dome {cell(row.dome)}, monitor {cell(row.monitor)}"


def cell(share: float | str | None) -> str:
    """A share as the table has it."""
    return "" if share is None else share if isinstance(share, str) else f"{share:.4f}"


def remark(row: Row) -> str:
    """What explains a program's figures, by rule."""
    over = isinstance(row.dome, float) and row.dome > LIMIT
    remarks = []
    if row.flat:
        remarks.append("flat")
    if row.split:
        remarks.append("several viewports")
    if row.unjudged:
        remarks.append(plain(row.unjudged))
    if not row.repeats:
        remarks.append("another picture at each run")
    elif over and isinstance(row.fine, float) and row.fine <= LIMIT:
        remarks.append("thin lines")
    elif over and row.stock is not None and row.stock.fog:
        remarks.append("fog")
    elif row.fails:
        remarks.append("**to do**")
    return ", ".join(remarks)


def table(rows: list[Row]) -> Iterator[str]:
    """The lines of the table of the programs that run natively."""
    yield f"| program | DOME=1 | dome | dome at {FINE_SIZE} | monitor | remark |"
    yield "|---|---|---|---|---|---|"
    for row in rows:
        if row.is_program and row.native is None:
            shares = map(cell, (row.dome, row.fine, row.monitor))
            cells = [f"`{row.path}`", plain(row.on_screen or "yes"), *map(plain, shares), remark(row)]
            yield f"| {' | '.join(cells)} |"


def plain(words: str) -> str:
    """Words that a table's cell can hold."""
    return words.replace("|", "\\|").replace("<", "&lt;")


def versions(rows: list[Row]) -> str:
    """What the figures were measured with."""
    stock = next(row.stock for row in rows if row.stock is not None)
    packages = ("PyOpenGL", "PyOpenGL-Demo", "numpy")
    numbers = [f"{name} {importlib.metadata.version(name)}" for name in packages]
    ours = f"domeshim {__version__}"
    python = f"Python {platform.python_version()}"
    date = datetime.datetime.now(datetime.UTC).date().isoformat()
    return f"{date}; {ours}, {python}, {', '.join(numbers)}; GL {stock.version} on {stock.renderer}."


def page(rows: list[Row]) -> str:
    """The whole page."""
    programs = [row for row in rows if row.is_program]
    run = [row for row in programs if row.native is None]
    judged = [row for row in run if not (row.flat or row.split or row.unjudged)]
    within = [row for row in judged if isinstance(row.dome, float) and row.dome <= LIMIT]
    lines = [row for row in judged if remark(row) == "thin lines"]
    same = [row for row in run if isinstance(row.monitor, float) and row.monitor <= LIMIT]
    on_screen = [row for row in run if not row.on_screen and not isinstance(row.dome, str)]
    refused = [row for row in programs if row.native is not None]
    modules = ", ".join(f"`{row.path}`" for row in rows if not row.is_program)
    return PAGE.format(
        versions=versions(rows),
        programs=len(programs),
        run=len(run),
        on_screen=len(on_screen),
        judged=len(judged),
        within=len(within),
        lines=len(lines),
        same=len(same),
        table="\n".join(table(rows)),
        refused="\n".join(f"| `{row.path}` | {plain(row.native or '')} |" for row in refused),
        modules=modules,
    )
