"""The GLSL snippets: where they lie, and their text."""

from __future__ import annotations

from functools import cache
from pathlib import Path


@cache
def glsl_folder() -> Path:
    """The folder of snippets: inside the installed package, or beside it in a checkout."""
    package = Path(__file__).resolve().parent.parent
    installed = package / "glsl"
    return installed if installed.is_dir() else package.parent / "glsl"


@cache
def snippet(name: str) -> str:
    """The text of one snippet by its name, as in "lens/equidistant"."""
    return (glsl_folder() / f"{name}.glsl").read_text(encoding="utf-8")
