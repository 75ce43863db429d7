"""The dome's numbers under stress: writes docs/stability.md, in some ten minutes.

    python benchmarks/stability.py [WORD ...]

With words it measures only the cases whose names have one of them, and prints the page instead.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

os.environ["PYOPENGL_PLATFORM"] = "egl"  # before anything imports OpenGL

from stability_page import TOLERANCE, page

from domeshim.measure.extremes import EXTREMES
from domeshim.measure.formulas import formula_errors
from domeshim.measure.room import room_errors
from domeshim.measure.stability import METHODS, RATIOS, SIZES, Row, measure, ratio

OUTPUT = Path(__file__).parents[1] / "docs" / "stability.md"


def told(row: Row) -> None:
    """Say on stderr how far it has come."""
    print(f"{row.case.name}: {row.method}", file=sys.stderr)


def main(words: list[str]) -> None:
    """Measure and write; words: of the cases that are wanted, all if none."""
    at_half = [ratio(size, TOLERANCE) for size in SIZES]
    methods = {method: RATIOS if method == "auto" else at_half for method in METHODS}
    cases = [case for case in EXTREMES if not words or any(word in case.name for word in words)]
    rows, renderer = measure(cases, methods, told)
    written = page(rows, formula_errors(), room_errors(), renderer)
    if words:
        print(written)
    else:
        OUTPUT.write_text(written, encoding="utf-8")
        print(f"wrote {OUTPUT}")


if __name__ == "__main__":
    main(sys.argv[1:])
