"""What the corpus's page says of a program's figures."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))

from corpus_page import Row, page, remark, table

from domeshim.measure.reference import StockPicture

STOCK = StockPicture(np.zeros((1, 1, 3), np.uint8), 1, 1, False, "a renderer", "4.5 of GL")
RIGHT = Row("a.py", stock=STOCK, on_screen="", monitor=0.0, dome=0.001)
FLAT = replace(RIGHT, path="flat.py", stock=replace(STOCK, perspectives=0, viewports=0), dome=None)
REFUSED = Row("old.py", native="SyntaxError: a < b | c")
MODULE = Row("part.py", is_program=False)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({}, ""),
        ({"dome": 0.3, "fine": 0.001}, "thin lines"),
        ({"dome": 0.3, "fine": 0.2}, "**to do**"),
        ({"dome": 0.3, "fine": 0.2, "stock": replace(STOCK, fog=True)}, "fog"),
        ({"dome": 0.001, "stock": replace(STOCK, fog=True)}, ""),
        ({"dome": 0.3, "fine": 0.2, "repeats": False}, "another picture at each run"),
        ({"dome": "ValueError: no"}, "**to do**"),
        ({"monitor": 0.3}, "**to do**"),
        ({"on_screen": "ValueError: no"}, "**to do**"),
        ({"dome": None, "stock": replace(STOCK, viewports=2)}, "several viewports"),
        ({"dome": None, "unjudged": "no reference: ValueError: no"}, "no reference: ValueError: no"),
        ({"dome": "no", "stock": FLAT.stock}, "flat, **to do**"),
    ],
)
def test_the_remark_follows_from_the_figures(changes, said):
    assert remark(replace(RIGHT, **changes)) == said


def test_the_table_holds_what_runs_natively():
    lines = list(table([RIGHT, FLAT, REFUSED, MODULE]))[2:]
    assert lines == ["| `a.py` | yes | 0.0010 |  | 0.0000 |  |", "| `flat.py` | yes |  |  | 0.0000 | flat |"]


def test_the_page_counts_and_lists_all():
    over = replace(RIGHT, path="lines.py", dome=0.1, fine=0.0)
    broken = replace(RIGHT, path="broken.py", on_screen="KeyError: 1", dome="KeyError: 1", monitor=0.5)
    text = page([RIGHT, over, broken, FLAT, REFUSED, MODULE])
    assert "5 programs, 4 of which run natively" in text
    assert "3 of those 4 run with DOME=1" in text
    assert "3 of them set a perspective" in text
    assert "1 are\n  within the limit, and 1 more where lines" in text
    assert "3 of the 4 show stock" in text
    assert "| `old.py` | SyntaxError: a &lt; b \\| c |" in text
    assert "`part.py`." in text
    assert "GL 4.5 of GL on a renderer" in text
