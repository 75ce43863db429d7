"""moderngl in the window's own context, for passes over whole pictures; imported by those alone."""

from __future__ import annotations

from typing import Any

import moderngl

from domeshim.driver import Driver

_SEAMLESS = 0x884F


class _Loader:
    """Where moderngl finds GL's functions: where the dome's own calls do."""

    def __init__(self, driver: Driver) -> None:
        self._driver = driver

    def load_opengl_function(self, name: str) -> int:
        """A function's address; 0 where this GL has none of that name."""
        return self._driver.address(name)

    def release(self) -> None:
        """Nothing is held."""


OLDEST_GL = (3, 3)
"""moderngl's own."""


def attached(driver: Driver, what: str = "a pass over whole pictures") -> Any:
    """A moderngl context over the one that is current; what: needs it, in an error's words.

    Raises DriverError where this GL is too old for it.
    """
    driver.require(OLDEST_GL, what)
    seamless = driver.glIsEnabled(_SEAMLESS)
    moderngl.init_context(loader=_Loader(driver))
    if not seamless:
        driver.glDisable(_SEAMLESS)  # which moderngl enables, and Mesa's attribute stack leaves out
    return moderngl.get_context()
