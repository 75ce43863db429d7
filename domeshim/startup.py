"""How domeshim gets into a process: asked for? then the finder is armed, once.

Light on purpose: with DOME=1 every Python of that environment passes here, whether it draws or not.
"""

from __future__ import annotations

import gc
import os
import sys
import threading
from collections import deque
from contextlib import contextmanager, suppress
from dataclasses import replace
from typing import TYPE_CHECKING

from domeshim.errors import DomeError, OptionError
from domeshim.intercept import toolkits
from domeshim.intercept.finder import EXTENSIONS, ImportFinder
from domeshim.intercept.inner import PUBLIC
from domeshim.session import Session, begin, current

if TYPE_CHECKING:
    from collections.abc import Iterator
    from types import ModuleType, TracebackType

    from domeshim.intercept.overlay import Overlay

WATCHED = ("OpenGL.GL", "OpenGL.GLU", "OpenGL.GLUT", *PUBLIC, *toolkits.WATCHED)
"""The modules under domeshim, by name: a program may carry its own copy of PyOpenGL."""


def say(line: str) -> None:
    """Print one line for the user on stderr, where there is one."""
    if sys.stderr is not None:
        sys.stderr.write(f"domeshim: {line}\n")
        sys.stderr.flush()


class Installation:
    """One session's hold on the process: the finder, the overlay, and the one-line printing of DomeErrors."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._overlay: Overlay | None = None
        self._arrived: deque[tuple[str, ModuleType]] = deque()
        self._busy = threading.Lock()
        self._finder = ImportFinder(WATCHED, self._imported, EXTENSIONS)
        self._former_hook = sys.excepthook
        self._hook = self._show  # one bound method, to be known again by identity
        sys.excepthook = self._hook
        self._finder.arm()

    def remove(self) -> None:
        """Let the process go as it was found."""
        self._finder.disarm()
        if sys.excepthook is self._hook:
            sys.excepthook = self._former_hook
        if self._overlay is not None:
            self._overlay.remove()

    def _imported(self, name: str, module: ModuleType) -> None:
        """Hand the module to the overlay.

        The overlay's own imports come back here, and other threads may, holding import locks: whoever finds
        the overlay at work leaves the module to it instead of waiting, so nothing can wait in a circle.
        """
        self._arrived.append((name, module))
        while self._arrived and self._busy.acquire(blocking=False):
            try:
                with _nothing_collected():
                    while self._arrived:
                        self._the_overlay().module_imported(*self._arrived.popleft())
            finally:
                self._busy.release()

    def _the_overlay(self) -> Overlay:
        if self._overlay is None:
            from domeshim.intercept.overlay import Overlay  # noqa: PLC0415 - only a program with GL pays for it

            self._overlay = Overlay(self._session)
        return self._overlay

    def _show(self, kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        if isinstance(error, DomeError):
            say(str(error))
        else:
            self._former_hook(kind, error, trace)


@contextmanager
def _nothing_collected() -> Iterator[None]:
    """Within it Python does not look for garbage: imports leave next to none, and looking takes long."""
    collecting = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collecting:
            gc.enable()


def install(dome: bool = True) -> None:
    """See domeshim.install."""
    session = current()
    if session.installation is not None:
        if session.options.enabled == dome:
            return
        uninstall()
    session.options = replace(session.options, enabled=dome)
    session.installation = Installation(session)


def run_under(session: Session) -> None:
    """Make this the process's session and install it, in place of one that the start-up hook began."""
    with suppress(OptionError):  # then the hook began none
        uninstall()
    begin(session)
    install(session.options.enabled)


def uninstall() -> None:
    """See domeshim.uninstall."""
    session = current()
    if session.installation is not None:
        session.installation.remove()
        session.installation = None


def arm_if_asked() -> None:
    """Install the dome if DOME is on.

    Raises OptionError for a malformed DOME* variable.
    """
    if current().options.enabled:
        install()


def arm_at_start() -> None:
    """Install the dome if DOME is on, while Python is still starting.

    A malformed option ends the process here: a SystemExit from a start-up hook would be reported as a fatal
    error of Python itself.
    """
    try:
        arm_if_asked()
    except OptionError as error:
        say(str(error))
        os._exit(error.exit_status)
