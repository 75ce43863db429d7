from __future__ import annotations

import copy
import importlib
import importlib.util
import pickle
import sys
import threading
from collections.abc import Iterator
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import ModuleType

import pytest

from domeshim.intercept.finder import ImportFinder
from tests.waiting import PATIENCE

NAME = "watched_pkg.inner"


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    folder = tmp_path / "watched_pkg"
    folder.mkdir()
    (folder / "__init__.py").write_text("")
    (folder / "inner.py").write_text("loader_while_loading = __spec__.loader\ndef f(): return 1\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    yield folder
    for name in ("watched_pkg", NAME, "watched_pkg.other"):
        sys.modules.pop(name, None)


@pytest.fixture
def heard() -> list[tuple[str, ModuleType]]:
    return []


@pytest.fixture
def finder(package: Path, heard: list[tuple[str, ModuleType]]) -> Iterator[ImportFinder]:
    finder = ImportFinder([NAME], lambda name, module: heard.append((name, module)))
    finder.arm()
    yield finder
    finder.disarm()


def test_the_module_is_reported_complete_and_only_the_watched_one(finder, heard, package):
    (package / "other.py").write_text("")
    importlib.import_module("watched_pkg.other")
    module = importlib.import_module(NAME)
    importlib.import_module(NAME)
    assert heard == [(NAME, module)]
    assert module.f() == 1


def test_the_modules_loader_and_spec_are_the_real_ones(finder, heard):
    module = importlib.import_module(NAME)
    assert type(module.__loader__) is SourceFileLoader
    assert module.__spec__.loader is module.__loader__
    assert module.loader_while_loading is module.__loader__
    assert module.__cached__ == importlib.util.cache_from_source(module.__file__)
    assert pickle.loads(pickle.dumps(module.f)) is module.f


def test_a_spec_that_is_only_looked_at_serves_as_the_real_one(finder, heard):
    spec = importlib.util.find_spec(NAME)
    assert spec.loader.get_filename(NAME) == spec.origin
    assert "def f" in spec.loader.get_source(NAME)
    assert type(pickle.loads(pickle.dumps(spec)).loader) is SourceFileLoader
    assert type(copy.deepcopy(spec).loader) is SourceFileLoader
    assert heard == []
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    assert module.f() == 1


def test_reload_reports_again(finder, heard, package):
    module = importlib.import_module(NAME)
    (package / "inner.py").write_text("def f(): return 'second'\n")
    importlib.invalidate_caches()
    assert importlib.reload(module) is module
    assert module.f() == "second"
    assert heard == [(NAME, module)] * 2
    assert type(module.__loader__) is SourceFileLoader


def test_arming_reports_what_is_there_already(package, heard):
    module = importlib.import_module(NAME)
    finder = ImportFinder([NAME], lambda name, module: heard.append((name, module)))
    finder.arm()
    finder.arm()
    assert heard == [(NAME, module)]
    assert sys.meta_path.count(finder) == 1
    finder.disarm()
    assert finder not in sys.meta_path
    importlib.reload(module)
    assert len(heard) == 1


def test_disarmed_in_the_middle_of_an_import_it_is_silent(finder, heard, package):
    spec = importlib.util.find_spec(NAME)
    finder.disarm()
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    assert module.f() == 1
    assert heard == []


def test_a_module_that_fails_is_not_reported_and_fails_as_itself(finder, heard, package):
    (package / "inner.py").write_text("raise OSError('its own')")
    with pytest.raises(OSError, match="its own"):
        importlib.import_module(NAME)
    assert heard == []
    assert NAME not in sys.modules


def test_a_missing_module_is_missing(finder, package):
    (package / "inner.py").unlink()
    with pytest.raises(ModuleNotFoundError, match=NAME):
        importlib.import_module(NAME)


def test_a_finder_of_the_old_kind_behind_it_is_passed_over(finder, heard, monkeypatch):
    class OldKind:
        def find_module(self, name, path=None):
            return None

    monkeypatch.setattr(sys, "meta_path", [sys.meta_path[0], OldKind(), *sys.meta_path[1:]])
    assert importlib.import_module(NAME).f() == 1
    assert len(heard) == 1


def test_many_threads_import_it_once(finder, heard, package):
    (package / "inner.py").write_text("import time\ntime.sleep(0.1)\ndef f(): return 1\n")
    results: list[int] = []
    threads = [
        threading.Thread(target=lambda: results.append(importlib.import_module(NAME).f())) for _ in range(8)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(PATIENCE)
    assert results == [1] * 8
    assert len(heard) == 1
