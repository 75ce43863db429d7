"""The intercepted calls on display lists."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from domeshim.intercept.dome import Dome
from domeshim.record.lists import DisplayLists
from domeshim.state.context import DomeContext

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
            dome.context.say_once("a display list that ends between glBegin and glEnd loses what it draws there")
        result = original()
        context, lists = dome.context, dome.lists
        if context is not None and lists is not None and lists.building is not None:
            context.compiling = False
            dome.building = None
            built = lists.end()
            if built.execute:
                dome.drawing()
                _run(context, lists, built.name)
        return result

    return call


def call_list(dome: Dome, original: Call) -> Call:
    """glCallList."""

    def call(name: int) -> Any:
        if dome.context is None or dome.lists is None:
            return original(name)
        dome.drawing()
        _run(dome.context, dome.lists, int(name))
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
            context.dress()
            return original(*args)
        base = context.driver.integer(_LIST_BASE)
        for offset in _offsets(args[-1]):
            _run(context, lists, base + offset)
        return None

    return call


def delete_lists(dome: Dome, original: Call) -> Call:
    """glDeleteLists."""

    def call(name: int, count: int) -> Any:
        if dome.lists is not None:
            dome.lists.forget(int(name), int(count))
        return original(name, count)

    return call


def _run(context: DomeContext, lists: DisplayLists, name: int) -> None:
    with lists.one_deeper() as too_deep:
        for part in () if too_deep else lists.parts(name):
            if isinstance(part, int):
                context.dress()
                context.driver.glCallList(part)
            else:
                part()


def _offsets(names: Any) -> Iterator[int]:
    if isinstance(names, str):
        names = names.encode("latin-1")
    yield from (int(n) for n in (names if isinstance(names, bytes) else np.asarray(names).ravel()))
