"""Runs a program as Python itself would: its own __main__, arguments, path, exit status and traceback."""

from __future__ import annotations

import builtins
import os
import pkgutil
import sys
from collections.abc import Sequence
from importlib.machinery import ModuleSpec, SourceFileLoader, SourcelessFileLoader
from importlib.util import find_spec
from types import CodeType, ModuleType, TracebackType
from typing import Any

from domeshim.errors import DomeError, OptionError


def run_program(name: str, arguments: Sequence[str], *, module: bool = False) -> None:
    """Run `python NAME ARGUMENTS`, or `python -m NAME ARGUMENTS` with module=True, in this process.

    NAME is a file, or a folder or zip file with a __main__. Returns when the program's last line has run.
    What the program raises comes through, and Python reports it at the process's end as the program's.

    Raises OptionError where there is no such program.
    """
    main = ModuleType("__main__")
    former = sys.modules["__main__"]  # noqa: F841 - kept alive: its functions are still on the stack
    sys.argv[1:] = arguments
    try:
        namespace = _prepare_module(name) if module else _prepare_path(name)
        code = namespace.pop("code")
        vars(main).update(namespace, __builtins__=builtins)
        sys.modules["__main__"] = main
        exec(code, vars(main))
    except (SystemExit, DomeError):
        raise
    except BaseException:
        _report_as_its_own()
        raise


def _prepare_path(path: str) -> dict[str, Any]:
    """Set sys.argv[0] and sys.path as for `python PATH`; the names of its __main__, and "code"."""
    sys.argv[:1] = [path]
    full = os.path.abspath(path)
    importer = pkgutil.get_importer(full)
    if importer is not None:
        spec = importer.find_spec("__main__")
        if spec is None:
            raise OptionError(f"cannot run {path}: no __main__ module in it")
        # Also by -P, which is about folders that Python would search by itself.
        sys.path[: not sys.flags.safe_path] = [full]
        return _names_of(spec)
    _set_first_path(os.path.dirname(os.path.realpath(full)))
    loader = (SourcelessFileLoader if full.endswith(".pyc") else SourceFileLoader)("__main__", full)
    try:
        source = loader.get_data(full)
    except OSError as error:
        raise OptionError(f"cannot run {path}: {error.strerror}") from None
    if isinstance(loader, SourcelessFileLoader):
        code = loader.get_code("__main__")
    else:
        code = compile(source, full, "exec", dont_inherit=True)
    nothing = dict.fromkeys(("__package__", "__spec__", "__cached__"))
    return {"__file__": full, "__loader__": loader, **nothing, "code": code}


def _prepare_module(name: str) -> dict[str, Any]:
    """The same for `python -m NAME`."""
    sys.argv[:1] = ["-m"]
    _set_first_path(os.getcwd())
    try:
        spec = find_spec(name)
        if spec is not None and spec.submodule_search_locations is not None:
            spec = find_spec(f"{name}.__main__")
    except ModuleNotFoundError as error:
        if error.name is None or not f"{name}.".startswith(f"{error.name}."):
            raise
        spec = None
    if spec is None or spec.loader is None:
        raise OptionError(f"cannot run -m {name}: no such module, or a package without __main__")
    names = _names_of(spec)
    sys.argv[:1] = [names["__file__"]]
    return names


def _names_of(spec: ModuleSpec) -> dict[str, Any]:
    get_code = getattr(spec.loader, "get_code", None)
    code: CodeType | None = get_code and get_code(spec.name)
    if code is None:
        raise OptionError(f"cannot run {spec.name}: not Python code")
    names = {
        "__file__": spec.origin,
        "__loader__": spec.loader,
        "__package__": spec.parent,
        "__spec__": spec,
        "__cached__": spec.cached,
    }
    return {**names, "code": code}


def _set_first_path(folder: str) -> None:
    """Put the program's folder where Python put that of the command that started us."""
    if not sys.flags.safe_path:
        sys.path[:1] = [folder]


def _report_as_its_own() -> None:
    """Let the traceback that is about to be shown begin where the program does."""
    shown_by = sys.excepthook

    def show(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        error.__traceback__ = _program_part(trace)
        shown_by(kind, error, error.__traceback__)

    sys.excepthook = show


def _program_part(trace: TracebackType | None) -> TracebackType | None:
    """The traceback without what led to the program's first line."""
    while trace is not None and trace.tb_frame.f_code is not run_program.__code__:
        trace = trace.tb_next
    while trace is not None and trace.tb_frame.f_globals.get("__name__") in (
        __name__,
        "importlib.util",
        "importlib._bootstrap",
        "importlib._bootstrap_external",
    ):
        trace = trace.tb_next
    return trace
