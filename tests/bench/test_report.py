"""What the report's page makes of the bench's figures."""

from __future__ import annotations

import sys
from ctypes.util import find_library
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "benchmarks"))

import report
import shim_cost

from domeshim.bench.edge_error import EdgeError
from domeshim.bench.results import Cost, Results, Row
from tests.displays import needs_xvfb

needs_freeglut = pytest.mark.skipif(find_library("glut") is None, reason="freeglut is not installed")
SOON = {"stock, not installed": (0.5, 0.2), "DOME=1": (0.9, 0.6)}


def row(family: str, detail: str, ratio: float, largest: float) -> Row:
    cost = Cost(9.0, ratio, 10.0, 8.0, 5)
    return Row("lines", "Lines", 1024, family, detail, cost, EdgeError(0.1, largest, 0.0))


@pytest.mark.parametrize(("ratio", "verdict"), [(1.4, "reached"), (1.6, "not reached")])
def test_a_goal_goes_by_the_processors_time(ratio, verdict):
    text = report.goals(Results({}, [row("auto", "0.5 px", ratio, 0.5)]))
    assert f"| 1.50 | 9.00 | {ratio:.2f} | {verdict} |" in text


def test_a_rival_is_held_against_what_is_as_exact():
    rows = [
        row("auto", "0.1 px", 4.0, 0.2),
        row("auto", "0.5 px", 2.0, 0.9),
        row("cubemap", "1024", 12.0, 0.3),
        row("VTK panoramic", "1024", 8.0, 0.01),
    ]
    assert "| Lines, 1024 | 3.0 (0.1 px) | no auto as exact |" in report.rivals(Results({}, rows))


def test_of_what_is_measured_twice_the_later_counts():
    parts = [Results({"renderer": "a"}, [row("auto", "", ratio, 0.5)]) for ratio in (1.0, 2.0)]
    assert [each.cost.processor_ratio for each in report.merged(parts).rows] == [2.0]


def test_the_page_has_everything():
    results = Results({"renderer": "a GL"}, [row("auto", "0.5 px", 1.0, 0.5)], ["VTK was not measured"])
    text = report.page(results, SOON, {"glVertex3f": (500.0, 150.0)})
    for words in (
        "a GL",
        "| DOME=1 | 0.90 | 0.60 |",
        "at most 0.25 s more than stock; it takes 0.40 s, or 0.40 s of the processor",
        "| glVertex3f | 500 | 150 |",
        "stability.md",
        "corpus.md",
    ):
        assert words in text
    assert "- VTK was not measured" in text
    assert "(report/bench.png)" in text


@needs_xvfb
@needs_freeglut
def test_what_is_measured_is_written(tmp_path, monkeypatch):
    run = ("--size=64", "--rounds=3", "--edges=1", "--scene=room", "--method=vertex")
    for module, name, value in (
        (report, "RUNS", (run,)),
        (report, "ROUNDS", 1),
        (report, "PAGE", tmp_path / "report.md"),
        (report, "PLOTS", tmp_path / "plots"),
        (shim_cost, "CALLS", 100),
    ):
        monkeypatch.setattr(module, name, value)
    report.main([])
    written = (tmp_path / "report.md").read_text()
    for name in ("Textured room, six quads", "vertex", "stock, not installed", "DOME=1", *shim_cost.KINDS):
        assert f"| {name} |" in written or f"**{name}**" in written, name
    assert (tmp_path / "plots" / "bench.png").stat().st_size > 0
