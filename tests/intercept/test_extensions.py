"""The modules of GL's extensions are covered whenever they are imported, and let go again."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator

import OpenGL.GL
import pytest

from domeshim.intercept.finder import EXTENSIONS, ImportFinder
from domeshim.intercept.overlay import Overlay
from domeshim.options import Options
from domeshim.session import Session

LATE = "OpenGL.GL.ARB.window_pos"
"""No other test imports it: PyOpenGL's modules cannot be loaded twice."""


@pytest.fixture
def overlay() -> Iterator[Overlay]:
    overlay = Overlay(Session(Options(enabled=True)))
    yield overlay
    overlay.remove()


def is_ours(function: object) -> bool:
    return getattr(function, "__module__", "").startswith("domeshim.")


def test_an_extension_that_was_there_is_covered_with_gl(overlay: Overlay):
    early = importlib.import_module("OpenGL.GL.ARB.vertex_program")
    before = dict(vars(early))
    assert not is_ours(early.glVertexAttrib3fARB)
    overlay.module_imported("OpenGL.GL", OpenGL.GL)
    assert is_ours(early.glVertexAttrib3fARB)
    overlay.remove()
    assert vars(early) == before


def test_an_extension_imported_later_is_covered_then(overlay: Overlay):
    assert LATE not in sys.modules
    finder = ImportFinder(["OpenGL.GL"], overlay.module_imported, EXTENSIONS)
    finder.arm()
    try:
        late = importlib.import_module(LATE)
    finally:
        finder.disarm()
    assert is_ours(late.glWindowPos3fARB)


def test_an_extension_waits_for_gl(overlay: Overlay):
    early = importlib.import_module("OpenGL.GL.ARB.vertex_program")
    overlay.module_imported(early.__name__, early)
    assert not is_ours(early.glVertexAttrib3fARB)


def test_a_name_that_gl_has_too_leads_to_the_same_function(overlay: Overlay):
    views = importlib.import_module("OpenGL.GL.ARB.viewport_array")
    assert views.glViewportArrayv is OpenGL.GL.glViewportArrayv
    overlay.module_imported("OpenGL.GL", OpenGL.GL)
    assert is_ours(views.glViewportArrayv)
    assert views.glViewportArrayv is OpenGL.GL.glViewportArrayv
