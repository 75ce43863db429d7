"""Many workers make the same files as one process, whatever happens to them."""

from __future__ import annotations

import pytest

from domeshim.render.show import Alone, render
from tests.render.conftest import contents
from tests.render.programs import CHANCE, CLEARS, KILLS

pytest.importorskip("distributed")
from domeshim.render.farm import Farm


def test_workers_make_the_same_files_in_any_order(make_plan, progress):
    alone, farmed = make_plan(1, 9, "alone"), make_plan(1, 9, "farmed")
    render(alone, Alone(), progress)
    manifest = render(farmed, Farm(2, chunk=2, seed=1), progress)
    assert contents(farmed) == contents(alone)
    assert len(contents(alone)) == 9
    assert not manifest.notes


def test_worker_with_several_threads_runs_a_program_in_each(make_plan, progress, tmp_path, monkeypatch):
    from dask.system import CPU_COUNT
    from distributed import LocalCluster

    threads = tmp_path / "threads"
    writes = CLEARS + f"\nopen({str(threads)!r}, 'a').write(os.environ.get('LP_NUM_THREADS', '-') + ' ')\n"
    monkeypatch.delenv("LP_NUM_THREADS", raising=False)
    alone, farmed = (make_plan(1, 12, name, writes) for name in ("alone", "farmed"))
    render(alone, Alone(), progress)
    with LocalCluster(n_workers=1, threads_per_worker=2, dashboard_address=":0") as cluster:
        manifest = render(farmed, Farm(0, cluster.scheduler_address, chunk=2), progress)
    assert not manifest.failed
    assert contents(farmed) == contents(alone)
    assert len(contents(alone)) == 12
    first, *others = threads.read_text().split()
    assert (first, set(others)) == ("-", {str(max(CPU_COUNT // 2, 1))})
    assert len(others) >= 2


def test_lost_worker_loses_nothing(make_plan, progress, tmp_path):
    mark = tmp_path / "killed"
    expected = render(make_plan(1, 8, "alone"), Alone(), progress)
    manifest = render(make_plan(1, 8, "farmed", KILLS, (str(mark),)), Farm(2, chunk=3), progress)
    assert mark.exists()
    assert not manifest.failed
    assert manifest.hashes == expected.hashes
    assert len(manifest.hashes) == 8


def test_program_that_goes_by_chance_is_found(make_plan, progress):
    manifest = render(make_plan(1, 4, does=CHANCE), Farm(1, chunk=2), progress)
    assert "picture 3 came out differently" in manifest.notes[0]


def test_workers_share_the_cores(monkeypatch):
    from dask.system import CPU_COUNT

    from domeshim.render.farm import shared_cores

    monkeypatch.delenv("LP_NUM_THREADS", raising=False)
    assert shared_cores(1) == {"LP_NUM_THREADS": str(CPU_COUNT)}
    assert shared_cores(CPU_COUNT + 1) == {"LP_NUM_THREADS": "1"}
    monkeypatch.setenv("LP_NUM_THREADS", "3")
    assert shared_cores(1) == {}


def test_unknown_scheduler_is_one_clear_error(make_plan, progress):
    from domeshim.errors import DomeError

    with pytest.raises(DomeError, match="no scheduler answers"):
        render(make_plan(1, 2, does=CLEARS), Farm(0, "tcp://127.0.0.1:9", patience=1), progress)
