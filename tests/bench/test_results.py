"""What the bench says and writes."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image

from domeshim.bench.edge_error import EdgeError
from domeshim.bench.files import write
from domeshim.bench.results import Cost, Results, Row

COST = Cost(1.25, 1.5, 10.0, 8.0, 5)
ROWS = [
    Row("room", "Room", 512, "auto", "0.5 px", COST, EdgeError(0.1, 0.4, 0.0), 1.9),
    Row("room", "Room", 512, "paper", "", COST, EdgeError(3.0, 12.0, 0.386), 113.7),
    Row("room", "Room", 1024, "auto", "0.5 px", COST, EdgeError(float("inf"), float("inf"), 1.0)),
]


def bench(*arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "domeshim", "bench", *arguments]
    return subprocess.run(command, capture_output=True, text=True)


def test_the_table_has_every_figure():
    text = Results({"renderer": "a GL"}, ROWS, ["something was left out"]).markdown()
    assert "a GL" in text
    assert "| paper | 1.25 | 1.50 | 10.0 | 3 | 12 | 38.6% | 113.7 |" in text
    assert text.count("**Room**") == 2
    assert "- something was left out" in text


def test_files_hold_table_json_and_plot(tmp_path):
    write(Results({"renderer": "a GL"}, ROWS), tmp_path / "new")
    read = json.loads((tmp_path / "new" / "bench.json").read_text())
    assert read["machine"] == {"renderer": "a GL"}
    assert read["rows"][1]["edges"]["largest"] == 12.0
    with Image.open(tmp_path / "new" / "bench.png") as plot:
        assert len(plot.convert("RGB").getcolors(1 << 20)) > 20
    assert "113.7" in (tmp_path / "new" / "bench.md").read_text()


def test_json_knows_no_infinity(tmp_path):
    write(Results({}, ROWS), tmp_path)
    text = (tmp_path / "bench.json").read_text()
    assert json.loads(text, parse_constant=pytest.fail)["rows"][2]["edges"]["largest"] is None


def test_json_is_read_back():
    results = Results({"renderer": "a GL"}, ROWS, ["a note"])
    assert Results.from_json(json.loads(json.dumps(results.as_json()))) == results


def test_the_command_measures_what_it_is_asked_for(tmp_path):
    ended = bench("--quick", "--scene=lines", "--method=vertex", f"--output={tmp_path}", "--json")
    assert ended.returncode == 0, ended.stderr
    (row,) = json.loads(ended.stdout)["rows"]
    assert (row["scene"], row["family"], row["size"]) == ("lines", "vertex", 512)
    assert row["edges"]["largest"] > 10
    assert Path(tmp_path / "bench.png").exists()


@pytest.mark.parametrize(
    "wrong",
    ["--scene=moon", "--method=magic", "--size=512x256", "--tolerance=0.1,x", "--rounds=1", "--size=big"],
)
def test_what_is_malformed_is_one_line(wrong):
    ended = bench(wrong)
    assert ended.returncode == 2
    assert len(ended.stderr.splitlines()) == 1
