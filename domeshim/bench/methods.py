"""Which ways to draw on the dome the bench holds against each other."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from domeshim.errors import OptionError
from domeshim.options import Options

_FACES = (0.5, 1, 2)
"""Sizes of a cube's faces, in the picture's."""
_PLAIN = ("paper", "vertex", "tessellate", "geometry", "cpu")
_BOUNDED = ("auto", "tessellate", "geometry", "cpu")
"""Those that the tolerance means something to."""


@dataclass(frozen=True)
class Method:
    """A method, with the tolerance in pixels where it heeds one."""

    name: str
    """As DOME_METHOD has it."""
    tolerance: float | None = None

    @property
    def family(self) -> str:
        """What is one curve of the plot."""
        return self.name.partition(":")[0]

    @property
    def detail(self) -> str:
        """What sets it apart within the family, if anything does."""
        return f"{self.tolerance:g} px" if self.tolerance is not None else self.name.partition(":")[2]

    def __str__(self) -> str:
        """In few words."""
        return f"{self.family} {self.detail}".strip()

    @property
    def settings(self) -> dict[str, str]:
        """As Options' fields have them, in words."""
        heeded = {} if self.tolerance is None else {"tolerance": f"{self.tolerance:g}"}
        return {"method": self.name, **heeded}

    def options(self, like: Options, scale: int = 1) -> Options:
        """The Options. scale: in a picture so many times as large, drawn no finer than the small one."""
        tolerance = like.tolerance if self.tolerance is None else self.tolerance
        return replace(like, enabled=True, method=self.name, tolerance=scale * tolerance)


def usual(size: int, tolerances: tuple[float, ...]) -> list[Method]:
    """All of them for a picture of so many pixels each way; auto with each of the tolerances, pixels."""
    cubes = [Method(f"cubemap:{round(share * size)}") for share in _FACES]
    plain = [Method(name, 0.5 if name in _BOUNDED else None) for name in _PLAIN]
    return [*plain, *cubes, *(Method("auto", tolerance) for tolerance in tolerances)]


def asked(texts: Iterable[str], size: int, tolerances: tuple[float, ...]) -> list[Method]:
    """The methods of these names, with each tolerance where they heed one; cubemap alone: at three sizes.

    Raises OptionError.
    """
    found: list[Method] = []
    for text in texts:
        name = Options.from_environment({}, {"method": text}).method
        if name in _BOUNDED:
            found += [Method(name, tolerance) for tolerance in tolerances]
        elif name == "cubemap":
            found += [Method(f"cubemap:{round(share * size)}") for share in _FACES]
        else:
            found.append(Method(name))
    return found


def tolerances_of(text: str) -> tuple[float, ...]:
    """Pixels from a list such as 0.1,0.5,2.

    Raises OptionError.
    """
    try:
        return tuple(Options.from_environment({}, {"tolerance": part}).tolerance for part in text.split(","))
    except OptionError:
        raise OptionError(f"--tolerance={text}: accepted: pixels of at least 0.01, as in 0.1,0.5,2") from None
