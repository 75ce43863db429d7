"""GLUT's pictures, which those of the other toolkits must equal."""

from __future__ import annotations

import numpy as np
import pytest

from tests.intercept.toolkits import program_runs as runs


@pytest.fixture(scope="session")
def captured_by_glut(tmp_path_factory: pytest.TempPathFactory) -> dict[str, np.ndarray]:
    pictures = {}
    for mode in ("monitor", "dome"):
        folder = tmp_path_factory.mktemp("glut")
        result = runs.capture(folder, runs.GLUT, "--mode", mode)
        assert result.returncode == 0, result.stderr
        pictures[mode] = runs.picture(folder)
    return pictures


@pytest.fixture(scope="session")
def seen_by_glut(tmp_path_factory: pytest.TempPathFactory) -> np.ndarray:
    seen, stderr = runs.photograph(tmp_path_factory.mktemp("glut"), runs.GLUT, runs.begun)
    assert runs.begun(seen), stderr
    return seen
