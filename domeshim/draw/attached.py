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


def attached(driver: Driver) -> Any:
    """A moderngl context over the one that is current."""
    seamless = driver.glIsEnabled(_SEAMLESS)
    moderngl.init_context(loader=_Loader(driver))
    if not seamless:
        driver.glDisable(_SEAMLESS)  # which moderngl enables, and Mesa's attribute stack leaves out
    return moderngl.get_context()
