"""What this GLUT says on stderr: fatal misuse ends the program as freeglut would, the rest is only said."""

from __future__ import annotations

import os
import sys
import traceback
from types import TracebackType
from typing import NoReturn

_OURS = os.path.dirname(os.path.dirname(os.path.abspath(__file__))) + os.sep


def fatal(program: str, text: str) -> NoReturn:
    """Say it and end the program with status 1."""
    print(f"domeshim ({program}): ERROR: {text}", file=sys.stderr)
    raise SystemExit(1)


def warn(program: str, text: str) -> None:
    """Say it and go on."""
    print(f"domeshim ({program}): {text}", file=sys.stderr)


def print_program_traceback(error: BaseException) -> None:
    """Print the error as Python does at a program's end, with the program's own frames alone."""
    report = traceback.TracebackException(type(error), error, _program_part(error.__traceback__))
    seen: traceback.TracebackException | None = report
    while seen is not None:
        theirs = [frame for frame in seen.stack if not frame.filename.startswith(_OURS)]
        seen.stack = traceback.StackSummary.from_list(theirs)
        seen = seen.__cause__ or seen.__context__
    print("".join(report.format()), end="", file=sys.stderr, flush=True)


def _program_part(trace: TracebackType | None) -> TracebackType | None:
    """Leave out the frames that lead from our main loop to the program's callback."""
    while trace is not None and trace.tb_frame.f_code.co_filename.startswith(_OURS):
        trace = trace.tb_next
    return trace
