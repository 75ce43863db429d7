"""Packages that only some commands need: what is missing is one line, with what to install."""

from __future__ import annotations

from importlib.util import find_spec

from domeshim.errors import DomeError


class MissingExtraError(DomeError):
    """A package that a command needs is not installed; names the extra that brings it."""

    exit_status = 2


def require(module: str, extra: str, purpose: str) -> None:
    """Raise MissingExtraError where the module is not installed."""
    if find_spec(module) is None:
        raise MissingExtraError(f"{purpose} needs {module}: pip install 'domeshim[{extra}]'")
