"""One scene in every toolkit: captured, and on a display, the picture is GLUT's."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

import pytest

from tests.displays import needs_xvfb
from tests.intercept.toolkits import program_runs as runs
from tests.lens.test_surfaces import bourke


def qt(source: str, binding: str, kind: str) -> object:
    missing = pytest.mark.skipif(find_spec(binding) is None, reason=f"{binding} is not installed")
    return pytest.param(source.replace("BINDING", binding), marks=missing, id=f"{binding} {kind}")


OF_QT5 = runs.QT_WIDGET.replace("QtOpenGLWidgets", "QtWidgets")
OLDEST = runs.QT_WIDGET.replace("QtOpenGLWidgets", "QtOpenGL").replace("QOpenGLWidget", "QGLWidget")
MISNAMED = OF_QT5.replace("super().__init__(parent)", "QMainWindow.__init__(self, parent)")
"""Another class's __init__ is called, which PyQt lets pass."""

PROGRAMS = [
    pytest.param(
        runs.PYGAME,
        id="pygame",
        marks=pytest.mark.skipif(find_spec("pygame") is None, reason="pygame is not installed"),
    ),
    pytest.param(runs.GLFW, id="glfw"),
    *(qt(runs.QT_WIDGET, binding, "widget") for binding in ("PySide6", "PyQt6")),
    *(qt(runs.QT_WINDOW, binding, "window") for binding in ("PySide6", "PyQt6")),
    qt(OF_QT5, "PyQt5", "widget"),
    qt(OLDEST, "PyQt5", "QGLWidget"),
    qt(MISNAMED, "PyQt5", "misnamed"),
]


@pytest.mark.parametrize("mode", ["monitor", "dome"])
@pytest.mark.parametrize("source", PROGRAMS)
def test_a_capture_is_glut_s(source, mode, tmp_path, captured_by_glut):
    result = runs.capture(tmp_path, source, "--mode", mode)
    assert result.returncode == 0, result.stderr
    assert "domeshim:" not in result.stderr
    assert (runs.picture(tmp_path) == captured_by_glut[mode]).all()


@needs_xvfb
@pytest.mark.parametrize("source", PROGRAMS)
def test_on_a_display_the_toolkits_own_window_shows_the_dome(source, tmp_path, seen_by_glut):
    seen, stderr = runs.photograph(tmp_path, source, lambda seen: runs.alike(seen, seen_by_glut))
    assert "domeshim:" not in stderr
    skip_without_plugin(stderr)
    assert runs.alike(seen, seen_by_glut)


def skip_without_plugin(stderr: str) -> None:
    if "could not connect" in stderr or "Could not load the Qt platform plugin" in stderr:
        pytest.skip("Qt's plugin for X11 lacks libraries here (Debian: libxcb-cursor0)")


WAYS = [
    {"DOME_METHOD": "cubemap"},
    {"DOME_SURFACE": "mesh.data", "DOME_FADE": "20"},
    {"DOME_SURFACE": "keystone:0.1,0.05,0.95,0,0.9,1,0,0.9", "DOME_TILT": "20"},
    {"DOME_STEREO": "top-bottom", "DOME_MIRROR": "horizontal"},
]


@needs_xvfb
@pytest.mark.parametrize("source", PROGRAMS[2:3])
@pytest.mark.parametrize("way", WAYS, ids=lambda way: ",".join(way.values()))
def test_each_way_to_the_dome_is_glut_s_in_qt(source: str, way: dict[str, str], tmp_path: Path):
    (tmp_path / "mesh.data").write_text(bourke(place=lambda u, v: ((2 * u - 1) * (1 - 0.2 * v), v - 0.5)))
    glut, stderr = runs.photograph(tmp_path, runs.GLUT, runs.begun, **way)
    assert runs.begun(glut), stderr
    seen, stderr = runs.photograph(tmp_path, source, lambda seen: runs.alike(seen, glut), **way)
    assert "domeshim:" not in stderr
    skip_without_plugin(stderr)
    assert runs.alike(seen, glut)
