"""What a program asks of GL that means something else on a dome: counted as it passes to GL."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from functools import partial, wraps
from typing import Any

_MATRICES = {0x0BA6: "MODELVIEW", 0x0BA7: "PROJECTION"}
_COUNTED = ("glReadPixels", "glCopyTexImage2D", "glCopyTexSubImage2D", "glCopyPixels", "glBindFramebuffer")
_OF_GLU = ("gluProject",)


class Calls:
    """Counts calls in a picture; those of before the first picture count too."""

    def __init__(self) -> None:
        self._counts: Counter[str] = Counter()
        self._viewports: set[tuple[int, ...]] = set()

    def begin_picture(self) -> None:
        """Count from the start; viewports are kept, for a program may set its own but once."""
        self._counts.clear()

    def seen(self) -> dict[str, Any]:
        """What was seen, for JSON."""
        return {"counts": dict(self._counts), "viewports": sorted(self._viewports)}

    def watch(self, gl: Any, glu: Any) -> None:
        """Look at the calls of these modules from now on."""
        for module, names in ((gl, _COUNTED), (glu, _OF_GLU)):
            for name in names:
                self._put(module, name, partial(self._called, name))
        for name in ("glGetDoublev", "glGetFloatv", "glGetDouble", "glGetFloat"):
            self._put(gl, name, self._asked)
        self._put(gl, "glViewport", self._viewport)

    def _called(self, name: str, _args: tuple[Any, ...]) -> None:
        self._counts.update([name])

    def _asked(self, args: tuple[Any, ...]) -> None:
        if args and int(args[0]) in _MATRICES:
            self._counts.update([_MATRICES[int(args[0])]])

    def _viewport(self, args: tuple[Any, ...]) -> None:
        if len(args) == 4:
            self._viewports.add(tuple(int(value) for value in args))

    @staticmethod
    def _put(module: Any, name: str, note: Callable[[tuple[Any, ...]], None]) -> None:
        original = getattr(module, name, None)
        if original is None:
            return

        @wraps(original)
        def call(*args: Any, **named: Any) -> Any:
            note(args)
            return original(*args, **named)

        setattr(module, name, call)
