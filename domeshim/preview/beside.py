"""The virtual dome beside a running program, in a process of its own.

    python -m domeshim.preview.beside NAME PROGRAM DOME VIEWER

NAME is the board's that the pictures come through, PROGRAM the process that puts them there, DOME and VIEWER
the JSON of a VirtualDome and a Viewer.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence

from domeshim.errors import DomeError
from domeshim.preview.dome import VirtualDome
from domeshim.preview.pictures import Live
from domeshim.preview.viewer import Viewer
from domeshim.startup import say

SIZE = (960, 640)


def main(arguments: Sequence[str]) -> None:
    """Show the program's pictures until it ends, or the user closes the window."""
    from domeshim.preview.window import show_dome  # noqa: PLC0415 - glfw and GL, once the arguments are read

    name, program, dome, viewer = arguments
    try:
        pictures = Live(name, int(program))
    except FileNotFoundError:  # the program has ended, and its board with it
        return
    try:
        show_dome(pictures, VirtualDome.from_json(dome), Viewer.from_json(viewer), SIZE)
    except DomeError as error:
        say(f"the virtual dome cannot be shown: {error}")
        raise SystemExit(1) from None


if __name__ == "__main__":
    main(sys.argv[1:])
