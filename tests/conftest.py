"""All tests draw off screen, and none may leave a GL error behind."""

from __future__ import annotations

import os

os.environ["PYOPENGL_PLATFORM"] = "egl"  # before any test imports OpenGL
for name in [name for name in os.environ if name in ("DOME", "PYTHONSAFEPATH") or name.startswith("DOME_")]:
    del os.environ[name]

import sys  # noqa: E402
from collections.abc import Iterator  # noqa: E402

import hypothesis  # noqa: E402
import pytest  # noqa: E402

hypothesis.settings.register_profile(
    "any machine",
    deadline=None,  # a busy one is no failure
    suppress_health_check=[hypothesis.HealthCheck.too_slow],
    derandomize=True,  # what fails fails by a change, not by chance, nor by what an earlier run left
    database=None,
)
hypothesis.settings.load_profile("any machine")


@pytest.fixture(autouse=True)
def same_environment() -> Iterator[None]:
    """What a command sets for its own process stays with its test."""
    before = dict(os.environ)
    yield
    if dict(os.environ) != before:
        os.environ.clear()
        os.environ.update(before)


@pytest.fixture(autouse=True)
def no_gl_error() -> Iterator[None]:
    yield
    platform = sys.modules.get("OpenGL.platform")
    if platform is not None and platform.PLATFORM.GetCurrentContext():
        # Asked of the driver itself: PyOpenGL may have been told not to look.
        assert platform.PLATFORM.GL.glGetError() == 0, "the test left a GL error behind"
