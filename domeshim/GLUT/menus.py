"""Pop-up menus: making them, changing them, and hanging them on mouse buttons."""

from __future__ import annotations

from typing import Any

from domeshim.GLUT.arguments import callback, integer, text
from domeshim.GLUT.popup import close_open_menu
from domeshim.GLUT.state import Menu, current_window, glut_state, initialised_state


def glutCreateMenu(func: Any) -> int:
    """Make an empty menu, make it the current one, and return its number; func(value) hears of choices."""
    state = initialised_state("glutCreateMenu")
    chosen = callback("glutCreateMenu", func)
    menu = Menu(state.next_menu, chosen if chosen is not None else lambda value: None)  # noqa: ARG005
    state.next_menu += 1
    state.menus[menu.number] = menu
    state.menu = menu
    return menu.number


def glutDestroyMenu(menu: Any, *_more: object) -> None:
    """Forget a menu, and take it off the buttons and out of the menus that it is in."""
    state = initialised_state("glutDestroyMenu")
    gone = state.menus.pop(integer("glutDestroyMenu", "menu", menu), None)
    if gone is None:
        return
    close_open_menu(state)
    for window in state.windows.values():
        window.menus = {button: number for button, number in window.menus.items() if number != gone.number}
    for other in state.menus.values():
        other.items = [item for item in other.items if not (item[2] and item[1] == gone.number)]
    if state.menu is gone:
        state.menu = None
    if gone.destroyed is not None:
        gone.destroyed()


def glutSetMenu(menu: Any, *_more: object) -> None:
    """Make the menu of that number current."""
    state = initialised_state("glutSetMenu")
    state.menu = state.menus.get(integer("glutSetMenu", "menu", menu), state.menu)


def glutGetMenu(*_more: object) -> int:
    """Return the current menu's number, 0 where there is none."""
    menu = initialised_state("glutGetMenu").menu
    return menu.number if menu else 0


def glutAddMenuEntry(label: Any, value: Any, *_more: object) -> None:
    """Put an entry at the current menu's end."""
    _put("glutAddMenuEntry", None, label, value, False)


def glutAddSubMenu(label: Any, subMenu: Any, *_more: object) -> None:
    """Put an entry that opens another menu at the current menu's end."""
    _put("glutAddSubMenu", None, label, subMenu, True)


def glutChangeToMenuEntry(item: Any, label: Any, value: Any, *_more: object) -> None:
    """Make the current menu's item of that number (1 the first) this entry."""
    _put("glutChangeToMenuEntry", item, label, value, False)


def glutChangeToSubMenu(item: Any, label: Any, value: Any, *_more: object) -> None:
    """Make the current menu's item of that number (1 the first) open another menu."""
    _put("glutChangeToSubMenu", item, label, value, True)


def _put(function: str, item: Any, label: Any, value: Any, opens: bool) -> None:
    state = initialised_state(function)
    entry = (text(function, "label", label), integer(function, "value", value), opens)
    if state.menu is None:
        state.warn(f"{function}() called with no current menu")
    elif item is None:
        state.menu.items.append(entry)
    else:
        number = integer(function, "item", item)
        if 1 <= number <= len(state.menu.items):
            state.menu.items[number - 1] = entry


def glutRemoveMenuItem(item: Any, *_more: object) -> None:
    """Take the current menu's item of that number (1 the first) out."""
    state = initialised_state("glutRemoveMenuItem")
    number = integer("glutRemoveMenuItem", "item", item)
    if state.menu is not None and 1 <= number <= len(state.menu.items):
        del state.menu.items[number - 1]


def glutAttachMenu(button: Any, *_more: object) -> None:
    """Open the current menu when that mouse button is pressed in the current window."""
    number = integer("glutAttachMenu", "button", button)
    window = current_window("glutAttachMenu")
    menu = glut_state().menu
    if menu is not None and number >= 0:
        window.menus[number] = menu.number


def glutDetachMenu(button: Any, *_more: object) -> None:
    """Give that mouse button of the current window back to the mouse callback."""
    current_window("glutDetachMenu").menus.pop(integer("glutDetachMenu", "button", button), None)


def glutMenuStatusFunc(function: Any) -> Any:
    """Tell function(status, x, y) of a menu opening and closing."""
    initialised_state("glutMenuStatusFunc").menu_status = callback("glutMenuStatusFunc", function)
    return function


def glutMenuStateFunc(function: Any) -> Any:
    """Tell function(status) of a menu opening and closing."""
    initialised_state("glutMenuStateFunc").menu_state = callback("glutMenuStateFunc", function)
    return function


def glutMenuDestroyFunc(function: Any) -> Any:
    """Tell function() when the current menu is destroyed."""
    menu = initialised_state("glutMenuDestroyFunc").menu
    if menu is not None:
        menu.destroyed = callback("glutMenuDestroyFunc", function)
    return function


def glutSetMenuData(data: Any) -> None:
    """Keep something of the program's with the current menu."""
    menu = initialised_state("glutSetMenuData").menu
    if menu is not None:
        menu.data = data


def glutGetMenuData(*_more: object) -> Any:
    """Return what the program kept with the current menu, or None."""
    menu = initialised_state("glutGetMenuData").menu
    return menu.data if menu else None
