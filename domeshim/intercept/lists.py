"""The intercepted calls on display lists."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from domeshim.driver import Driver
from domeshim.intercept.dome import Dome
from domeshim.record.bitmaps import Bitmap

Call = Callable[..., Any]

_COMPILE, _COMPILE_AND_EXECUTE = 0x1300, 0x1301
_LIST_BASE, _MATRIX_MODE = 0x0B32, 0x0BA0


def new_list(dome: Dome, original: Call) -> Call:
    """glNewList: compiled only, whatever the mode; GL_COMPILE_AND_EXECUTE runs it at glEndList."""

    def call(name: int, mode: int) -> Any:
        context, lists = dome.context, dome.lists
        if context is None or lists is None or mode not in (_COMPILE, _COMPILE_AND_EXECUTE):
            return original(name, mode)
        context.undress()
        result = original(name, _COMPILE)
        mode_now = context.driver.integer(_MATRIX_MODE)
        lists.begin(int(name), execute=mode == _COMPILE_AND_EXECUTE, matrix_mode=mode_now)
        context.compiling = True
        dome.building = lists.building
        return result

    return call


def end_list(dome: Dome, original: Call) -> Call:
    """glEndList."""

    def call() -> Any:
        if dome.recorder.block is not None and dome.context is not None:
            dome.recorder.end()
            dome.recorder.clear()
            dome.context.say_once(
                "a display list that ends between glBegin and glEnd loses what it draws there"
            )
        result = original()
        context, lists = dome.context, dome.lists
        if context is not None and lists is not None and lists.building is not None:
            context.compiling = False
            dome.building = None
            built = lists.end()
            if built.execute:
                dome.drawing()
                lists.run(built.name, context.draw_list)
        return result

    return call


def call_list(dome: Dome, original: Call) -> Call:
    """glCallList."""

    def call(name: int, *_more: object) -> Any:
        if dome.context is None or dome.lists is None:
            return original(name)
        dome.drawing()
        dome.lists.run(int(name), dome.context.draw_list)
        return None

    return call


def call_lists(dome: Dome, original: Call) -> Call:
    """glCallLists: in one call where every list is GL's own, else one by one."""

    def call(*args: Any) -> Any:
        context, lists = dome.context, dome.lists
        if context is None or lists is None:
            return original(*args)
        dome.drawing()
        if lists.all_plain:
            return context.draw(partial(original, *args))
        for name in _names(context.driver, args):
            lists.run(name, context.draw_list)
        return None

    return call


def written_list(dome: Dome, original: Call) -> Call:
    """glCallList of a list that is nothing but bitmaps, as a font's are: they are recorded like others."""

    def call(*args: Any) -> Any:
        lists = dome.lists
        if lists is not None and dome.building is None and len(args) == 1:
            bitmaps = lists.bitmaps(int(args[0]))
            if bitmaps is not None and dome.write(bitmaps):
                return None
        return original(*args)

    return call


def written_lists(dome: Dome, original: Call) -> Call:
    """glCallLists of such lists."""

    def call(*args: Any) -> Any:
        context, lists = dome.context, dome.lists
        if context is None or lists is None or dome.building is not None or lists.all_plain:
            return original(*args)
        bitmaps: list[Bitmap] = []
        for name in _names(context.driver, args):
            more = lists.bitmaps(name)
            if more is None:
                return original(*args)
            bitmaps += more
        return None if dome.write(bitmaps) else original(*args)

    return call


def delete_lists(dome: Dome, original: Call) -> Call:
    """glDeleteLists."""

    def call(name: int, count: int) -> Any:
        if dome.lists is not None:
            dome.lists.forget(int(name), int(count))
        return original(name, count)

    return call


def _names(driver: Driver, args: tuple[Any, ...]) -> list[int]:
    """The lists that a glCallLists calls."""
    base = driver.integer(_LIST_BASE)
    names = args if len(args) == 1 else (args[2], int(args[1]), int(args[0]))
    return [base + offset for offset in _offsets(*names)]


_BYTES = {0x1407: 2, 0x1408: 3, 0x1409: 4}
"""GL_2_BYTES, GL_3_BYTES, GL_4_BYTES: how many bytes, the highest first, make one name."""


def _offsets(names: Any, kind: int | None = None, count: int | None = None) -> list[int]:
    """The names that a glCallLists gives, above the list base.

    kind, count: GL's type, and how many names, where the program gives them.
    """
    if isinstance(names, str):
        names = names.encode("latin-1")
    values = np.frombuffer(names, np.uint8) if isinstance(names, bytes) else np.asarray(names).ravel()
    if kind in _BYTES:
        size = _BYTES[kind]
        groups = values.view(np.uint8)[: size * (len(values) // size)].reshape(-1, size).astype(int)
        values = groups @ (256 ** np.arange(size)[::-1])
    return [int(np.floor(value)) for value in values[:count]]
